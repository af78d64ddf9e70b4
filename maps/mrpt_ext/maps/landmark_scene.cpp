#include "mrpt_ext/maps/landmark_scene.h"

#include <mrpt/math/CMatrixFixed.h>
#include <mrpt/opengl/CEllipsoid2D.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CSphere.h>
#include <mrpt/opengl/CText.h>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr float kBallRadius = 0.06f;  ///< [m]

mrpt::opengl::CRenderizable::Ptr ball(const Landmark& landmark)
{
  auto sphere = mrpt::opengl::CSphere::Create(kBallRadius);
  sphere->setColor(0.85f, 0.2f, 0.1f);
  sphere->setLocation(landmark.position.x(), landmark.position.y(), landmark.position.z());
  return sphere;
}

mrpt::opengl::CRenderizable::Ptr nameTag(const Landmark& landmark)
{
  auto text = mrpt::opengl::CText::Create(landmark.id == kNoId ? landmark.category : std::to_string(landmark.id));
  text->setLocation(landmark.position.x(), landmark.position.y(), landmark.position.z() + 2.5 * kBallRadius);
  return text;
}

mrpt::opengl::CRenderizable::Ptr uncertainty(const Landmark& landmark)
{
  auto ellipse = mrpt::opengl::CEllipsoid2D::Create();
  mrpt::math::CMatrixDouble22 covariance;
  covariance.setDiagonal(std::vector<double>{square(landmark.stddev.x()), square(landmark.stddev.y())});
  ellipse->setCovMatrix(covariance);
  ellipse->setQuantiles(3.0f);
  ellipse->setLocation(landmark.position.x(), landmark.position.y(), landmark.position.z());
  return ellipse;
}
}  // namespace

void addLandmarks(mrpt::opengl::CSetOfObjects& scene, const LandmarkTable& landmarks)
{
  for (const Landmark& landmark : landmarks.all())
  {
    scene.insert(ball(landmark));
    scene.insert(nameTag(landmark));
    if (landmark.stddev.minCoeff() > 0) scene.insert(uncertainty(landmark));
  }
}
}  // namespace mrpt_ext
