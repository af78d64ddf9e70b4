#include "mrpt_ext/filter/integrity/stray_detections.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_stray_detections
{
namespace
{
constexpr double kUnlikely = -50, kNeutral = 0;  // log-likelihood ratios

SensorModel declaring(double clutter)
{
  SensorModel model;
  model.clutter_probability = clutter;
  return model;
}
}  // namespace

TEST(StrayDetections, TheFirstCountsWithTheDeclaredShare)
{
  EXPECT_NEAR(StrayDetections().counted(kUnlikely, declaring(0.1)), std::log(0.1), 1e-9);
  EXPECT_NEAR(StrayDetections().counted(3, declaring(0.1)), std::log(0.1 + 0.9 * std::exp(3)), 1e-9);
  EXPECT_EQ(StrayDetections().counted(kNeutral, declaring(0.1)), 0) << "both hypotheses expect it alike";
}

TEST(StrayDetections, TheMoreThereWereTheLessTheyCount)
{
  StrayDetections strays;
  for (int k = 0; k < 30; ++k)
    EXPECT_NEAR(strays.counted(kUnlikely, declaring(0.1)), std::log((1.0 + k) / (10 + k)), 1e-9);
}

TEST(StrayDetections, WhatFitsMakesThemRare)
{
  StrayDetections strays;
  for (int k = 0; k < 90; ++k) (void)strays.counted(20, declaring(0.1));
  EXPECT_NEAR(strays.counted(kUnlikely, declaring(0.1)), std::log(1.0 / 100), 1e-6);
}

TEST(StrayDetections, StayFinite)
{
  StrayDetections strays;
  for (const double log_ratio : {-1e6, 1e6})
    for (const double clutter : {0.0, 1.0})
      EXPECT_TRUE(std::isfinite(strays.counted(log_ratio, declaring(clutter)))) << log_ratio << ' ' << clutter;
}
}  // namespace mrpt_ext::test_stray_detections
