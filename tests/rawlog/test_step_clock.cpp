#include "mrpt_ext/rawlog/step_clock.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservationBeaconRanges.h>
#include <mrpt/obs/CSensoryFrame.h>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/observations/timestamps.h"
#include "rawlog_samples.h"

namespace mrpt_ext::test_step_clock
{
namespace
{
using mrpt::serialization::CSerializable;
constexpr double kNoTime = -1e9;

CSerializable::Ptr forward(double metres)
{
  mrpt::obs::CActionRobotMovement2D move;
  move.computeFromOdometry({metres, 0, 0}, {});
  auto actions = mrpt::obs::CActionCollection::Create();
  actions->insert(move);
  return actions;
}

CSerializable::Ptr climb(double pitch)
{
  mrpt::obs::CActionRobotMovement3D move;
  move.poseChange.mean = mrpt::poses::CPose3D(1, 0, 0, 0, pitch, 0);
  auto actions = mrpt::obs::CActionCollection::Create();
  actions->insert(move);
  return actions;
}

CSerializable::Ptr frameAt(double time)
{
  auto beacons = mrpt::obs::CObservationBeaconRanges::Create();
  beacons->timestamp = time == kNoTime ? INVALID_TIMESTAMP : timestampOf(time);
  beacons->sensedData.resize(1);
  beacons->sensedData[0].sensedDistance = 2;
  auto frame = mrpt::obs::CSensoryFrame::Create();
  frame->insert(beacons);
  return frame;
}

/// A log that moves a metre between its frames.
class StepLog : public RawlogTest
{
 protected:
  [[nodiscard]] std::filesystem::path logWith(const std::vector<double>& times) const
  {
    std::vector<CSerializable::Ptr> objects;
    for (const double time : times)
    {
      if (!objects.empty()) objects.push_back(forward(1));
      objects.push_back(frameAt(time));
    }
    writeObjects(inFolder("steps.rawlog"), objects);
    return inFolder("steps.rawlog");
  }
};
}  // namespace

TEST_F(StepLog, PlausibleStampsAreTheClock)
{
  EXPECT_FALSE(stepClockOf(logWith({5, 6, 7.5, 8}), 1).step.has_value());
  EXPECT_FALSE(stepClockOf(logWith({5, 6, kNoTime, 8}), 1).step.has_value());
}

TEST_F(StepLog, StampsThatCannotBeAClockAreCounted)
{
  EXPECT_EQ(stepClockOf(logWith({5, 5, 5, 5}), 2).step, 2.0);
  EXPECT_EQ(stepClockOf(logWith({kNoTime, kNoTime, kNoTime}), 1).step, 1.0);
  EXPECT_EQ(stepClockOf(logWith({5, 7, 6, 8}), 1).step, 1.0);
  const StepClock dense = stepClockOf(logWith({5, 5.001, 5.002, 5.003}), 1);
  EXPECT_EQ(dense.step, 1.0);
  EXPECT_EQ(
      dense.reason,
      "one step of the log counts 1 s (step_s): the stamps of its 4 sensory frames span 0.003 s for 3.0 m of motion");
}

TEST_F(StepLog, EachFrameHasOneTimeOfItsOwn)
{
  RawlogSource counted(logWith({5, 5.001, 5.001, 5.002}), 0.5);
  for (const Record& record : readAll(counted))
    EXPECT_EQ(std::fmod(timeOf(record), 0.5), 0) << "a time that is no count of steps";
  EXPECT_EQ(counted.frameTimes(), (std::vector<double>{0, 0.5, 1, 1.5}));
  EXPECT_EQ(counted.stepTimes(), (std::vector<double>{0.5, 1, 1.5}));
  EXPECT_TRUE(counted.hasSensoryFrames());
  RawlogSource stamped(logWith({5, 6, 6, 7}), 1);
  static_cast<void>(readAll(stamped));
  ASSERT_EQ(stamped.frameTimes().size(), 4U);
  EXPECT_GT(stamped.frameTimes()[2], stamped.frameTimes()[1]);
  EXPECT_NEAR(stamped.frameTimes()[2], 6, 1e-5);
  EXPECT_EQ(stamped.clockNote(), "");
}

TEST_F(StepLog, ARobotThatLeavesThePlaneIsRefused)
{
  writeObjects(inFolder("3d.rawlog"), {frameAt(1), climb(0.1), frameAt(2), climb(0.1), frameAt(3)});
  const std::string error = readLog(inFolder("3d.rawlog")).error;
  EXPECT_NE(error.find("record 3: the robot moves in 3-D (CActionRobotMovement3D: pitch 11 deg"), std::string::npos)
      << error;
  writeObjects(inFolder("flat.rawlog"), {frameAt(1), climb(0.01), frameAt(2), climb(-0.01), frameAt(3)});
  EXPECT_EQ(readLog(inFolder("flat.rawlog")).error, "");
}
}  // namespace mrpt_ext::test_step_clock
