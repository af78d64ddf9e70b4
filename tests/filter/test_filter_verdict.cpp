#include "mrpt_ext/filter/integrity/filter_verdict.h"

#include <gtest/gtest.h>

#include <limits>

namespace mrpt_ext::test_filter_verdict
{
namespace
{
Mode mode(double weight, double std_xy = 0.1, double std_phi = 0.02)
{
  const Vector3d variance(square(std_xy), 0, square(std_phi));
  return {{{}, variance.asDiagonal()}, weight};
}

VerdictWithReason verdictOn(const std::vector<Mode>& modes, bool lost = false, double inlier_ratio = 0.95)
{
  return judge({modes, {}}, {inlier_ratio, lost}, {});
}
}  // namespace

TEST(FilterVerdict, OnePreciseModeIsOk)
{
  const VerdictWithReason verdict = verdictOn({mode(0.999), mode(0.001)});
  EXPECT_EQ(verdict.verdict, Verdict::ok);
  EXPECT_NE(verdict.reason.find("weight 1.00"), std::string::npos) << verdict.reason;
  EXPECT_NE(verdict.reason.find("0.100 m"), std::string::npos) << verdict.reason;
  EXPECT_NE(verdict.reason.find("95 %"), std::string::npos) << verdict.reason;
}

TEST(FilterVerdict, SeveralModesAreAmbiguous)
{
  const VerdictWithReason verdict = verdictOn({mode(0.5), mode(0.5)});
  EXPECT_EQ(verdict.verdict, Verdict::ambiguous);
  EXPECT_NE(verdict.reason.find("2 modes"), std::string::npos) << verdict.reason;
  EXPECT_NE(verdict.reason.find("0.50"), std::string::npos) << verdict.reason;
}

TEST(FilterVerdict, OneThatIsOnlyLikelierIsFollowedButNotOk)
{
  const ModeSet modes{{mode(0.97), mode(0.03)}, {}};
  EXPECT_EQ(judge(modes, {}, {}).verdict, Verdict::ambiguous);
  EXPECT_TRUE(isDominant(modes, {}));
  EXPECT_FALSE(isDominant({{mode(0.8), mode(0.2)}, {}}, {}));
  EXPECT_EQ(VerdictOptions{.min_best_weight = 0.7}.dominantWeight(), 0.7);
  const VerdictOptions lenient{.min_best_weight = 0.7};
  EXPECT_EQ(judge({{mode(0.8), mode(0.2)}, {}}, {}, lenient).verdict, Verdict::ok);
  EXPECT_TRUE(isDominant({{mode(0.8), mode(0.2)}, {}}, lenient));
}

TEST(FilterVerdict, AnImpreciseModeIsAmbiguous)
{
  EXPECT_EQ(verdictOn({mode(1, 0.6)}).verdict, Verdict::ambiguous);
  EXPECT_EQ(verdictOn({mode(1, 0.1, degToRad(16))}).verdict, Verdict::ambiguous);
  EXPECT_EQ(verdictOn({mode(1, 0.6)}).reason,
            "the pose is not precise yet: standard deviation 0.60 m and 1.1 deg, `ok` asks for 0.50 m and 15.0 deg "
            "(ok_max_std_m, ok_max_std_deg)");
  const VerdictOptions without_heading{.max_std_xy = 0.2, .max_std_phi = std::numeric_limits<double>::infinity()};
  EXPECT_EQ(judge({{mode(1, 0.6)}, {}}, {}, without_heading).reason,
            "the pose is not precise yet: standard deviation 0.60 m, heading unknown, `ok` asks for 0.20 m "
            "(ok_max_std_m)");
}

TEST(FilterVerdict, OutliersMeanLostHoweverPrecise)
{
  const VerdictWithReason verdict = verdictOn({mode(1)}, true, 0.12);
  EXPECT_EQ(verdict.verdict, Verdict::lost);
  EXPECT_NE(verdict.reason.find("12 %"), std::string::npos) << verdict.reason;
}

TEST(FilterVerdict, NoLongerOkBeforeItIsLost)
{
  const VerdictWithReason verdict = verdictOn({mode(1)}, false, 0.42);
  EXPECT_EQ(verdict.verdict, Verdict::ambiguous);
  EXPECT_NE(verdict.reason.find("only 42 %"), std::string::npos) << verdict.reason;
}

TEST(FilterVerdict, OkNeedsVerificationEnoughParticlesAndNoContradiction)
{
  const auto reason_of = [](const VerdictEvidence& evidence)
  {
    const VerdictWithReason verdict = judge({{mode(1)}, {}}, evidence, {});
    EXPECT_EQ(verdict.verdict, Verdict::ambiguous);
    return verdict.reason;
  };
  EXPECT_EQ(judge({{mode(1)}, {}}, {}, {}).verdict, Verdict::ok);
  EXPECT_EQ(reason_of({.log_odds = 3.25, .verified = false}),
            "one mode, not verified yet: log odds 3.2 against the null hypothesis, 9 needed");
  EXPECT_EQ(reason_of({.effective = 12}), "one mode, but only 12 effective particles");
  EXPECT_EQ(reason_of({.contradicted = true}), "one mode, but the recent trajectory fits another pose better");
  EXPECT_EQ(reason_of({.supported = false}),
            "one mode, but odometry alone led here from the last landmark, and what is seen does not prove it");
}

TEST(FilterVerdict, NoParticlesMeanLost) { EXPECT_EQ(verdictOn({}).verdict, Verdict::lost); }

TEST(FilterVerdict, NotANumberIsNeverOk)
{
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(verdictOn({mode(kNaN)}).verdict, Verdict::ok);
  EXPECT_NE(verdictOn({mode(1, kNaN)}).verdict, Verdict::ok);
}
}  // namespace mrpt_ext::test_filter_verdict
