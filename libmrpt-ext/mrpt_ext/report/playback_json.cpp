#include "mrpt_ext/report/playback_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "mrpt_ext/evaluation/scoring.h"
#include "mrpt_ext/report/json_number.h"
#include "mrpt_ext/report/packed_particles.h"

namespace mrpt_ext
{
namespace
{
using Json = nlohmann::ordered_json;
using Steps = std::vector<PlaybackStep>;
constexpr double kSameTime = 1e-6;  // [s]

void addPose(Json& list, const Pose2& pose, bool heading_known)
{
  list.push_back(rounded(pose.x, 3));
  list.push_back(rounded(pose.y, 3));
  list.push_back(heading_known ? rounded(pose.phi, 3) : Json(nullptr));
}

void addNoPose(Json& list)
{
  for (int i = 0; i < 3; ++i) list.push_back(nullptr);
}

Json truthAtSteps(const RunContext& context, const Steps& steps)
{
  Json list = Json::array();
  for (const PlaybackStep& step : steps)
    if (const auto pose = interpolate(context.truth, step.time, context.truth_is_sparse ? 60.0 : kMaxTruthGap))
      addPose(list, pose->pose, pose->heading_known);
    else
      addNoPose(list);
  return list;
}

Json posesAtSteps(const MethodTrajectory& trajectory, const Steps& steps)
{
  Json list = Json::array();
  auto point = trajectory.points.begin();
  for (const PlaybackStep& step : steps)
  {
    while (point != trajectory.points.end() && point->time < step.time - kSameTime) ++point;
    if (point != trajectory.points.end() && point->time <= step.time + kSameTime)
      addPose(list, point->pose.mean, point->heading_known);
    else
      addNoPose(list);
  }
  return list;
}

Json modesOf(const PlaybackStep& step)
{
  Json list = Json::array();
  for (const ModeSummary& mode : step.modes)
  {
    const Matrix3d& P = mode.pose.covariance;
    addPose(list, mode.pose.mean, true);
    list.push_back(rounded(mode.weight, 3));
    for (const double c : {P(0, 0), P(0, 1), P(1, 1)}) list.push_back(rounded(c, 6));
  }
  return list;
}

Json drawnDetections(const PlaybackStep& step, const LandmarkTable& map)
{
  Json list = Json::array();
  for (const DrawnDetection& s : step.detections)
  {
    addPose(list, s.T_robot_sensor, true);
    list.push_back(s.bearing ? rounded(*s.bearing, 4) : Json(nullptr));
    list.push_back(s.range ? rounded(*s.range, 3) : Json(nullptr));
    const auto index = map.indexOf(s.id);
    list.push_back(index ? static_cast<int>(*index) : -1);
    list.push_back(s.fix ? 1 : 0);
  }
  return list;
}

Json particlesOf(const Steps& steps)
{
  Json counts = Json::array(), boxes = Json::array();
  std::string bytes;
  for (const PlaybackStep& step : steps)
  {
    const PackedPoses packed = packPoses(step.particles);
    counts.push_back(step.particles.size());
    for (const double v : {packed.low.x(), packed.low.y(), packed.extent.x(), packed.extent.y()})
      boxes.push_back(rounded(v, 4));
    bytes += packed.bytes;
  }
  return {{"counts", counts}, {"boxes", boxes}, {"poses", base64(bytes)}};
}

/// Objects detected since the previous step, at each step.
void addObjects(Json& json, const RunRecord& record)
{
  std::vector<std::string> labels;
  Json per_step = Json::array();
  auto object = record.objects.begin();
  for (const PlaybackStep& step : record.playback)
  {
    Json list = Json::array();
    for (; object != record.objects.end() && object->time <= step.time + kSameTime; ++object)
    {
      auto label = std::find(labels.begin(), labels.end(), object->label);
      if (label == labels.end()) label = labels.insert(labels.end(), object->label);
      list.push_back(rounded(object->position.x(), 3));
      list.push_back(rounded(object->position.y(), 3));
      list.push_back(label - labels.begin());
    }
    per_step.push_back(std::move(list));
  }
  json["objects"] = per_step;
  json["object_labels"] = labels;
}
}  // namespace

Json playbackJson(const RunContext& context, const RunRecord& record)
{
  const Steps& steps = record.playback;
  Json json = {{"t", Json::array()}, {"truth", truthAtSteps(context, steps)}, {"methods", Json::object()}};
  for (const MethodTrajectory& trajectory : record.methods)
    json["methods"][trajectory.name] = posesAtSteps(trajectory, steps);
  json["modes"] = json["detections"] = Json::array();
  for (const PlaybackStep& step : steps)
  {
    json["t"].push_back(rounded(step.time - context.start_time, 3));
    json["modes"].push_back(modesOf(step));
    json["detections"].push_back(drawnDetections(step, context.map));
  }
  addObjects(json, record);
  json["particles"] = particlesOf(steps);
  return json;
}
}  // namespace mrpt_ext
