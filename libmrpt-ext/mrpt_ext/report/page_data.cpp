#include "mrpt_ext/report/page_data.h"

#include <nlohmann/json.hpp>

#include "mrpt_ext/evaluation/odometry_alignment.h"
#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/report/chart_data.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/json_number.h"
#include "mrpt_ext/report/landmark_quality.h"
#include "mrpt_ext/report/map_view.h"
#include "mrpt_ext/report/playback_json.h"

namespace mrpt_ext
{
namespace
{
using Json = nlohmann::ordered_json;

Json methodsOf(const RunScore& score)
{
  const std::vector<std::string> names = methodNames(score.methods);
  Json list = Json::array();
  for (const MethodScore& method : score.methods)
    list.push_back({{"name", method.name},
                    {"colour", methodClass(method.name, names)},
                    {"continuous", method.continuous},
                    {"oracle", method.oracle},
                    {"aligned", method.name != kOdometryMethod || !method.errors.empty()}});
  return list;
}

Json landmarksOf(const RunContext& context, const RunScore& score)
{
  Json list = Json::array();
  for (const Landmark& landmark : shownLandmarks(context.map, score.landmarks))
  {
    const std::string id = landmark.id == kNoId ? std::string() : std::to_string(landmark.id);
    const auto known = score.landmarks.find(id);
    const std::string warning = known == score.landmarks.end() ? std::string() : landmarkWarning(known->second);
    list.push_back(
        {rounded(landmark.position.x(), 3), rounded(landmark.position.y(), 3), id, landmark.category, warning});
  }
  return list;
}

/// Text that may stand in a script element: without "<".
std::string safeText(const Json& json)
{
  std::string safe;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
    safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return safe;
}
}  // namespace

std::string pageData(const RunContext& context, const RunRecord& record, const RunScore& score,
                     const std::vector<ErrorsByGeometry>& geometry)
{
  const auto [low, high] = mapExtent(context, judgedMethod(record));
  return safeText({{"duration", rounded(context.duration_s, 3)},
                   {"extent", {rounded(low.x(), 3), rounded(low.y(), 3), rounded(high.x(), 3), rounded(high.y(), 3)}},
                   {"judged", score.judged_method ? Json(*score.judged_method) : Json(nullptr)},
                   {"converged", score.converged_at_s ? rounded(*score.converged_at_s, 2) : Json(nullptr)},
                   {"limit_m", score.judged_method ? rounded(score.limits.within_m, 3) : Json(nullptr)},
                   {"limit_deg", score.judged_method ? rounded(score.limits.within_deg, 3) : Json(nullptr)},
                   {"methods", methodsOf(score)},
                   {"errors", errorData(context, score)},
                   {"confidence", confidenceData(context, record)},
                   {"nees", neesData(context, score)},
                   {"biases", biasData(context, record)},
                   {"geometry", geometryData(geometry, score)},
                   {"residuals", residualData(score)},
                   {"landmarks", landmarksOf(context, score)},
                   {"playback", playbackJson(context, record)}});
}

std::string mergedPageData(const RunScore& merged)
{
  Json data = Json::object();
  data["residuals"] = residualData(merged);
  return safeText(data);
}
}  // namespace mrpt_ext
