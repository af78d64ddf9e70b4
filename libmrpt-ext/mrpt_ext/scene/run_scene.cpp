#include "mrpt_ext/scene/run_scene.h"

#include <mrpt/poses/CPosePDFParticles.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>

#include "mrpt_ext/files/staged_file.h"
#include "mrpt_ext/maps/CLandmarkMap2D.h"

namespace mrpt_ext
{
namespace
{
constexpr double kHeight = 0.02;  // [m] above the grid, so that neither hides the other

/// Extent of the landmarks with a metre around them.
struct Ground
{
  float x_min, x_max, y_min, y_max;
  [[nodiscard]] float size() const { return std::max(x_max - x_min, y_max - y_min); }
};

Ground groundOf(const LandmarkTable& map)
{
  const auto [low, high] = map.boundingBox();
  return {static_cast<float>(std::floor(low.x()) - 1), static_cast<float>(std::ceil(high.x()) + 1),
          static_cast<float>(std::floor(low.y()) - 1), static_cast<float>(std::ceil(high.y()) + 1)};
}

scenes::CSetOfObjects::Ptr particleCloud(const std::vector<Pose2>& particles)
{
  mrpt::poses::CPosePDFParticles pdf(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i)
    pdf.m_particles[i].d = {particles[i].x, particles[i].y, particles[i].phi};
  return pdf.getAs3DObject<scenes::CSetOfObjects::Ptr>();
}

scenes::CEllipsoid2D::Ptr ellipse(const ModeSummary& mode)
{
  auto shape = scenes::CEllipsoid2D::Create();
  mrpt::math::CMatrixDouble22 covariance;
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 2; ++c) covariance(r, c) = mode.pose.covariance(r, c);
  shape->setCovMatrix(covariance);
  shape->setQuantiles(2.45F);  // 95 % of a Gaussian in the plane
  shape->setLocation(mode.pose.mean.x, mode.pose.mean.y, kHeight);
  shape->setColor(0.9F, 0.4F, 0.0F);
  return shape;
}

scenes::CDisk::Ptr ring(double x, double y, double radius)
{
  auto circle = scenes::CDisk::Create();
  circle->setDiskRadius(static_cast<float>(radius + 0.02), static_cast<float>(std::max(0.0, radius - 0.02)));
  circle->setLocation(x, y, kHeight);
  circle->setColor(0.0F, 0.45F, 0.7F);
  return circle;
}

/// Detections from `robot`; `far` [m] is the length of a ray without a range.
scenes::CSetOfObjects::Ptr measurements(const std::vector<DrawnDetection>& detections, const Pose2& robot,
                                        const LandmarkTable& map, double far)
{
  auto shapes = scenes::CSetOfObjects::Create();
  auto rays = scenes::CSetOfLines::Create();
  rays->setName("rays");
  rays->setColor(0.0F, 0.45F, 0.7F);
  for (const DrawnDetection& seen : detections)
  {
    const Pose2 sensor = compose(robot, seen.T_robot_sensor);
    const Landmark* landmark = nullptr;
    if (const auto index = map.indexOf(seen.id); index && seen.fix) landmark = &map[*index];
    if (seen.bearing)
    {
      const double direction = sensor.phi + *seen.bearing, length = seen.range.value_or(far);
      rays->appendLine(sensor.x, sensor.y, kHeight, sensor.x + length * std::cos(direction),
                       sensor.y + length * std::sin(direction), kHeight);
    }
    else if (seen.range && landmark)
      shapes->insert(ring(landmark->position.x(), landmark->position.y(), *seen.range));
    else if (seen.range)
      shapes->insert(ring(sensor.x, sensor.y, *seen.range));
  }
  shapes->insert(rays);
  return shapes;
}
}  // namespace

MrptScene::Ptr runScene(const LandmarkTable& map, const PlaybackStep& step)
{
  auto scene = MrptScene::Create();
  const Ground ground = groundOf(map);
  scene->insert(scenes::CGridPlaneXY::Create(ground.x_min, ground.x_max, ground.y_min, ground.y_max, 0.0F, 1.0F));
  auto landmarks = scenes::CSetOfObjects::Create();
  CLandmarkMap2D(map).getVisualizationInto(*landmarks);
  scene->insert(landmarks);
  if (!step.particles.empty()) scene->insert(particleCloud(step.particles));
  for (const ModeSummary& mode : step.modes) scene->insert(ellipse(mode));
  if (!step.modes.empty())
  {
    const Pose2& best = step.modes.front().pose.mean;
    auto robot = scenes::stock_objects::CornerXYZSimple(0.5F, 3.0F);
    robot->setPose(mrpt::poses::CPose3D(best.x, best.y, 0, best.phi, 0, 0));
    scene->insert(robot);
    scene->insert(measurements(step.detections, best, map, double{ground.size()}));
  }
  scenes::CCamera& camera = scene->getViewport()->getCamera();
  camera.setPointingAt((ground.x_min + ground.x_max) / 2, (ground.y_min + ground.y_max) / 2, 0.0F);
  camera.setZoomDistance(1.5F * ground.size());
  camera.setElevationDegrees(60);
  camera.setAzimuthDegrees(-90);
  return scene;
}

void writeScene(const std::filesystem::path& path, const LandmarkTable& map, const PlaybackStep& step)
{
  StagedFile staged(path);
  if (!runScene(map, step)->saveToFile(staged.path().string())) staged.fail(errno);
  staged.commit();
}
}  // namespace mrpt_ext
