#include "mrpt_ext/filter/integrity/filter_verdict.h"

#include <gtest/gtest.h>

#include <limits>

namespace mrpt_ext
{
namespace
{
Mode mode(double weight, double std_xy = 0.1, double std_phi = 0.02)
{
  const Vector3d variance(square(std_xy), 0, square(std_phi));
  return {{{}, variance.asDiagonal()}, weight};
}

VerdictWithReason verdictOn(const std::vector<Mode>& modes, bool lost = false, double explained = 0.95)
{
  return judge({modes, {}}, {explained, lost}, {});
}
}  // namespace

TEST(FilterVerdict, OneSharpPlaceIsOk)
{
  const VerdictWithReason verdict = verdictOn({mode(0.97), mode(0.03)});
  EXPECT_EQ(verdict.verdict, Verdict::ok);
  EXPECT_NE(verdict.reason.find("weight 0.97"), std::string::npos) << verdict.reason;
  EXPECT_NE(verdict.reason.find("0.100 m"), std::string::npos) << verdict.reason;
  EXPECT_NE(verdict.reason.find("95 %"), std::string::npos) << verdict.reason;
}

TEST(FilterVerdict, SeveralPlacesAreAmbiguous)
{
  const VerdictWithReason verdict = verdictOn({mode(0.5), mode(0.5)});
  EXPECT_EQ(verdict.verdict, Verdict::ambiguous);
  EXPECT_NE(verdict.reason.find("2 places"), std::string::npos) << verdict.reason;
  EXPECT_NE(verdict.reason.find("0.50"), std::string::npos) << verdict.reason;
}

TEST(FilterVerdict, AVaguePlaceIsAmbiguous)
{
  EXPECT_EQ(verdictOn({mode(1, 0.6)}).verdict, Verdict::ambiguous);
  EXPECT_EQ(verdictOn({mode(1, 0.1, degToRad(16))}).verdict, Verdict::ambiguous);
  EXPECT_NE(verdictOn({mode(1, 0.6)}).reason.find("0.60 m"), std::string::npos);
}

TEST(FilterVerdict, UnexplainedDetectionsMeanLostHoweverSharp)
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

TEST(FilterVerdict, NoParticlesMeanLost) { EXPECT_EQ(verdictOn({}).verdict, Verdict::lost); }

TEST(FilterVerdict, WhatIsNotANumberIsNeverOk)
{
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(verdictOn({mode(kNaN)}).verdict, Verdict::ok);
  EXPECT_NE(verdictOn({mode(1, kNaN)}).verdict, Verdict::ok);
}
}  // namespace mrpt_ext
