#include <mrpt/obs/CObservationOdometry.h>
#include <sys/resource.h>

#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/rawlog/allocation_limit.h"
#include "rawlog_samples.h"

// Logs that once made the program crash, hang or take gigabytes, and what the reader refuses since.
namespace mrpt_ext::test_rawlog_limits
{
namespace
{
std::string faulty(const std::string& name) { return std::string(MRPT_EXT_TEST_DATA) + "/faults/" + name; }

void expectError(const ReadResult& result, const std::string& text)
{
  EXPECT_NE(result.error.find(text), std::string::npos) << "'" << result.error << "', expected '" << text << "'";
}

/// [MB] the most that the process has ever used.
long peakMemory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

mrpt::obs::CObservationOdometry::Ptr odometryAt(double time, double x)
{
  auto odometry = mrpt::obs::CObservationOdometry::Create();
  odometry->timestamp = timestampOf(time);
  odometry->sensorLabel = "odometry";
  odometry->odometry = {x, 0, 0};
  return odometry;
}

class RawlogLimits : public RawlogTest
{
 protected:
  [[nodiscard]] ReadResult readOdometry(const std::vector<std::pair<double, double>>& times_and_x) const
  {
    std::vector<mrpt::serialization::CSerializable::Ptr> objects;
    for (const auto& [time, x] : times_and_x) objects.push_back(odometryAt(time, x));
    writeObjects(inFolder("odometry.rawlog"), objects);
    return readLog(inFolder("odometry.rawlog"));
  }
};
}  // namespace

TEST_F(RawlogLimits, ACoordinateBeyondTheEarthIsRefused)
{
  expectError(readLog(faulty("crash_odometry_1e308.rawlog")), "odometry at ");
  for (const double x : {1e155, -1e308, 1.1e8})
    expectError(readOdometry({{0, 0}, {1, x}}), "odometry.rawlog: record 1: odometry at ");
  EXPECT_EQ(readOdometry({{0, 0}, {1, 9e7}}).error, "");
}

TEST_F(RawlogLimits, AStampFarAheadIsRefused)
{
  expectError(readLog(faulty("hang_future_stamp_room.rawlog")),
              "record 38: time 9.10693e+11 s, expected at most 1e+11 s either way");
  expectError(readLog(faulty("hang_future_stamp_goal-corners_100y.rawlog")),
              "record 65: its time 3153601002.500 s is 36500.0 days after that of an earlier record");
  expectError(readOdometry({{0, 0}, {31 * 86400, 0}}),
              "record 1: its time 2678400.000 s is 31.0 days after that of an earlier record");
}

TEST_F(RawlogLimits, ALongGapIsTold)
{
  EXPECT_EQ(readOdometry({{0, 0}, {9, 0}}).statistics.gaps.count, 0U);
  const LogGaps gaps = readOdometry({{10, 0}, {40, 0}, {41, 0}, {141, 0}}).statistics.gaps;
  EXPECT_EQ(gaps.count, 2U);
  EXPECT_EQ(gaps.begin, 41);
  EXPECT_EQ(gaps.longest, 100);
}

TEST_F(RawlogLimits, ADamagedLengthTakesNoMemory)
{
  const long before = peakMemory();
  for (const std::string name : {"memory_2.3GB.rawlog", "memory_4.2GB.rawlog"})
    expectError(readLog(faulty(name)), "it states a length of more bytes than the log has left");
  EXPECT_LT(peakMemory() - before, 200);
}

TEST_F(RawlogLimits, AnAllocationBeyondTheLimitFails)
{
  {
    const AllocationLimit limit(1 << 20);
    EXPECT_THROW(std::string(2 << 20, 'x'), std::bad_alloc);
    std::vector<double> doubles;  // of an unused one the compiler leaves the allocation out
    EXPECT_THROW(doubles.resize(1 << 18), std::bad_alloc);
    EXPECT_TRUE(doubles.empty());
    EXPECT_EQ(std::string(1 << 19, 'x').size(), 1U << 19);
    const AllocationLimit tighter(1 << 10);
    EXPECT_THROW(std::string(1 << 19, 'x'), std::bad_alloc);
  }
  EXPECT_EQ(std::string(2 << 20, 'x').size(), 2U << 20);
}

TEST_F(RawlogLimits, MrptWritesNoLinesOfItsOwn)
{
  ::testing::internal::CaptureStderr();
  const ReadResult result = readLog(faulty("multiline_abstract_class.rawlog"));
  const std::string written = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(result.error, "");
  EXPECT_EQ(result.error.find('\n'), std::string::npos);
  EXPECT_EQ(written, "");
  expectError(result, "record 46: not readable (no object can be of the class 'mrpt::obs::CObservation')");
}

TEST_F(RawlogLimits, AByteThatIsNoBoolIsDamage)
{
  expectError(readLog(faulty("ubsan_bool.rawlog")), "record 22: not readable (a flag of 64, expected 0 or 1)");
}
}  // namespace mrpt_ext::test_rawlog_limits
