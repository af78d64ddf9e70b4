#include "mrpt_ext/filter/integrity/filter_diagnostics.h"

#include <cmath>
#include <cstdio>

namespace mrpt_ext
{
namespace
{
constexpr double kFewest = 10;  // named detections, to say anything
constexpr double kOften = 0.3;  // share of named detections that is false

const char* nameOf(BiasKind kind)
{
  switch (kind)
  {
    case BiasKind::range_offset:
      return "range_offset";
    case BiasKind::range_scale:
      return "range_scale";
    case BiasKind::bearing_offset:
      return "bearing_offset";
    case BiasKind::distance_scale:
      return "odometry_distance_scale";
    case BiasKind::rotation_scale:
      return "odometry_rotation_scale";
  }
  return "";
}

/// Of so many detections as many as are false where kOften of all are, and two standard deviations more.
double likelyAtMost(double named) { return kOften * named + 2 * std::sqrt(kOften * (1 - kOften) * named); }

void append(std::string& text, const std::string& more)
{
  if (!text.empty()) text += ", ";
  text += more;
}
}  // namespace

std::vector<BiasEstimate> estimateBiases(const ParticleSet& particles)
{
  std::vector<BiasEstimate> estimates;
  for (const std::vector<float>& column : particles.bias)
  {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < column.size(); ++i)
    {
      const double w = std::exp(double{particles.log_weight[i]}), value = double{column[i]};
      sum += w * value;
      squares += w * value * value;
    }
    estimates.push_back({sum, std::sqrt(std::max(0.0, squares - sum * sum))});
  }
  return estimates;
}

std::string biasName(const BiasState& bias)
{
  const char* unit = bias.kind == BiasKind::bearing_offset ? "_deg" : bias.kind == BiasKind::range_offset ? "_m" : "";
  return (bias.sensor.empty() ? "" : bias.sensor + ".") + nameOf(bias.kind) + unit;
}

double fileUnit(const BiasState& bias) { return bias.kind == BiasKind::bearing_offset ? radToDeg(1.0) : 1.0; }

std::string biasText(const BiasModel& biases, const std::vector<BiasEstimate>& estimates)
{
  std::string text;
  for (std::size_t k = 0; k < std::min(biases.size(), estimates.size()); ++k)
  {
    const bool angle = biases[k].kind == BiasKind::bearing_offset, length = biases[k].kind == BiasKind::range_offset;
    const double unit = angle ? radToDeg(1.0) : 1.0;
    char figures[80];
    std::snprintf(figures, sizeof(figures), " %.4f%s (std %.4f)", unit * estimates[k].mean,
                  angle    ? " deg"
                  : length ? " m"
                           : "",
                  unit * estimates[k].std);
    append(text, (biases[k].sensor.empty() ? "" : biases[k].sensor + " ") + nameOf(biases[k].kind) + figures);
  }
  return text;
}

std::vector<std::size_t> outlierLandmarks(const std::vector<LandmarkHistory>& histories)
{
  std::vector<std::size_t> found;
  for (std::size_t j = 0; j < histories.size(); ++j)
    if (histories[j].named >= kFewest && histories[j].false_named > likelyAtMost(histories[j].named))
      found.push_back(j);
  return found;
}

std::string outlierText(const LandmarkTable& map, const std::vector<LandmarkHistory>& histories)
{
  std::string text;
  for (const std::size_t j : outlierLandmarks(histories))
  {
    char figures[120];
    std::snprintf(figures, sizeof(figures), "landmark %d is often wrong (%.0f %% of its %.0f detections)", map[j].id,
                  100 * histories[j].false_named / histories[j].named, histories[j].named);
    append(text, figures);
  }
  return text;
}
}  // namespace mrpt_ext
