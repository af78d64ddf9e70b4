#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext::golden
{
using Json = nlohmann::json;

/// Cases of `<name>.json` in the folder LANDMARK_VECTORS (default: tests/data/vectors). A missing or empty file is a
/// test failure.
inline std::vector<Json> load(const std::string& name)
{
  const char* folder = std::getenv("LANDMARK_VECTORS");
  const std::string path =
      (folder ? std::string(folder) : std::string(MRPT_EXT_TEST_DATA) + "/vectors") + "/" + name + ".json";
  std::ifstream file(path);
  if (!file)
  {
    ADD_FAILURE() << path << ": cannot be read";
    return {};
  }
  const std::vector<Json> cases = Json::parse(file).at("cases").get<std::vector<Json>>();
  EXPECT_FALSE(cases.empty()) << path << ": no cases";
  return cases;
}

/// A number, or one of the strings that stand for numbers JSON cannot hold.
inline double number(const Json& value)
{
  if (!value.is_string()) return value.get<double>();
  const std::string text = value.get<std::string>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  throw std::runtime_error("not a number: " + text);
}

inline Vector2d point(const Json& value) { return {number(value.at(0)), number(value.at(1))}; }

inline std::vector<double> numbers(const Json& values)
{
  std::vector<double> result;
  for (const Json& v : values) result.push_back(number(v));
  return result;
}

inline std::vector<Vector2d> points(const Json& values)
{
  std::vector<Vector2d> result;
  for (const Json& v : values) result.push_back(point(v));
  return result;
}

inline void expectPoint(const Vector2d& actual, const Vector2d& expected, double tolerance)
{
  EXPECT_NEAR(actual.x(), expected.x(), tolerance);
  EXPECT_NEAR(actual.y(), expected.y(), tolerance);
}

inline void expectAngle(double actual, double expected, double tolerance)
{
  EXPECT_NEAR(std::abs(wrap(actual - expected)), 0.0, tolerance) << actual << " against " << expected;
}

/// Points in either order.
inline void expectSamePoints(const std::vector<Vector2d>& actual, const std::vector<Vector2d>& expected,
                             double tolerance)
{
  ASSERT_EQ(actual.size(), expected.size());
  std::vector<bool> taken(actual.size(), false);
  for (const Vector2d& wanted : expected)
  {
    std::size_t best = 0;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < actual.size(); ++i)
      if (!taken[i] && (actual[i] - wanted).norm() < distance)
      {
        distance = (actual[i] - wanted).norm();
        best = i;
      }
    taken[best] = true;
    expectPoint(actual[best], wanted, tolerance);
  }
}
}  // namespace mrpt_ext::golden
