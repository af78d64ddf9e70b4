#include "mrpt_ext/files/tum.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "error_message.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_tum
{
using testing::messageOf;
using testing::ScratchFolder;

TEST(Tum, WritesTheAgreedForm)
{
  const ScratchFolder folder;
  writeTum(folder.path() / "t.tum", {{1248444187.886, {1.5, -2, kPi / 2}, true}, {1248444188.0, {0, -1e-9, 0}, false}});
  EXPECT_EQ(readTextFile(folder.path() / "t.tum"),
            "1248444187.886000 1.500000 -2.000000 0 0 0 0.707106781 0.707106781\n"
            "1248444188.000000 0.000000 0.000000 0 0 0 0 0\n");
}

TEST(Tum, ReadsYawOfAnyUnitQuaternionAndUnknownHeading)
{
  const ScratchFolder folder;
  const Trajectory read =
      readTum(folder.write("t.tum", "# note\n1 0 0 0.3 0 0 -1 0\n2\t4 5 0  0 0 0 0\n3 0 0 0 0 0 -0.7071 -0.7071\n"));
  ASSERT_EQ(read.size(), 3u);
  EXPECT_NEAR(std::abs(wrap(read[0].pose.phi - kPi)), 0, 1e-9);
  EXPECT_TRUE(read[0].heading_known);
  EXPECT_FALSE(read[1].heading_known);
  EXPECT_EQ(read[1].pose.y, 5);
  EXPECT_NEAR(read[2].pose.phi, kPi / 2, 1e-4);
}

TEST(Tum, MistakesAreNamedWithTheirLine)
{
  const ScratchFolder folder;
  const auto read = [&](const std::string& content)
  { return messageOf<InputError>([&] { (void)readTum(folder.write("t.tum", content)); }); };
  EXPECT_NE(read("1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n").find("t.tum:2: time 1 is not after"), std::string::npos);
  EXPECT_NE(read("1 0 0 0 0 0 0 0.5\n").find("t.tum:1: quaternion has length 0.5"), std::string::npos);
  EXPECT_NE(read("1 0 0 0 0 0 0\n").find("t.tum:1: 7 fields, expected 8"), std::string::npos);
  EXPECT_NE(read("1 0 x 0 0 0 0 1\n").find("t.tum:1: 'x' is not a number, expected ty"), std::string::npos);
}

RC_GTEST_PROP(Tum, WhatIsWrittenIsReadBack, ())
{
  const auto coordinate = [] { return *rc::gen::inRange(-100000000, 100000000) * 1e-6; };
  const Trajectory written{{1, {coordinate(), coordinate(), coordinate()}, *rc::gen::arbitrary<bool>()}};
  const ScratchFolder folder;
  const auto path = folder.path() / "round_trip.tum";
  writeTum(path, written);
  const Trajectory read = readTum(path);
  RC_ASSERT(read.size() == 1u);
  RC_ASSERT(read[0].heading_known == written[0].heading_known);
  RC_ASSERT((read[0].pose.position() - written[0].pose.position()).norm() < 1e-6);
  if (read[0].heading_known) RC_ASSERT(std::abs(wrap(read[0].pose.phi - written[0].pose.phi)) < 1e-8);
}
}  // namespace mrpt_ext::test_tum
