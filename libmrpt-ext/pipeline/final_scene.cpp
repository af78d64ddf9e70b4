#include "mrpt_ext/pipeline/final_scene.h"

#include <mrpt/opengl/CEllipsoid2D.h>
#include <mrpt/opengl/CGridPlaneXY.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/stock_objects.h>
#include <mrpt/poses/CPosePDFParticles.h>

#include <cmath>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/maps/CLandmarkMap2D.h"

namespace mrpt_ext
{
namespace
{
mrpt::poses::CPosePDFParticles asMrptParticles(const ParticleSet& particles)
{
  mrpt::poses::CPosePDFParticles pdf(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const Pose2 pose = particles.pose(i);
    pdf.m_particles[i].d = {pose.x, pose.y, pose.phi};
    pdf.m_particles[i].log_w = double{particles.log_weight[i]};
  }
  return pdf;
}

mrpt::opengl::CEllipsoid2D::Ptr ellipse(const ModeSummary& mode)
{
  auto shape = mrpt::opengl::CEllipsoid2D::Create();
  mrpt::math::CMatrixDouble22 covariance;
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 2; ++c) covariance(r, c) = mode.pose.covariance(r, c);
  shape->setCovMatrix(covariance);
  shape->setQuantiles(2);
  shape->setLocation(mode.pose.mean.x, mode.pose.mean.y, 0.02);
  shape->setColor(0.9F, 0.4F, 0.0F);
  return shape;
}
}  // namespace

void writeFinalScene(const std::filesystem::path& path, const LandmarkTable& map, const TrialOutcome& outcome)
{
  mrpt::opengl::COpenGLScene scene;
  const auto [low, high] = map.boundingBox();
  scene.insert(mrpt::opengl::CGridPlaneXY::Create(
      static_cast<float>(std::floor(low.x()) - 1), static_cast<float>(std::ceil(high.x()) + 1),
      static_cast<float>(std::floor(low.y()) - 1), static_cast<float>(std::ceil(high.y()) + 1), 0.0F, 1.0F));
  auto landmarks = mrpt::opengl::CSetOfObjects::Create();
  CLandmarkMap2D(map).getVisualizationInto(*landmarks);
  scene.insert(landmarks);
  if (!outcome.particles.empty())
    scene.insert(asMrptParticles(outcome.particles).getAs3DObject<mrpt::opengl::CSetOfObjects::Ptr>());
  for (const ModeSummary& mode : outcome.record.filter.modes_at_end) scene.insert(ellipse(mode));
  if (!outcome.record.filter.modes_at_end.empty())
  {
    const Pose2& best = outcome.record.filter.modes_at_end.front().pose.mean;
    auto robot = mrpt::opengl::stock_objects::CornerXYZSimple(0.5F, 3.0F);
    robot->setPose(mrpt::poses::CPose3D(best.x, best.y, 0, best.phi, 0, 0));
    scene.insert(robot);
  }
  const std::filesystem::path temporary = path.string() + ".tmp";
  if (!scene.saveToFile(temporary.string())) throw dataError(path.string() + ": cannot be written");
  std::filesystem::rename(temporary, path);
}
}  // namespace mrpt_ext
