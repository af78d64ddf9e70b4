#include "mrpt_ext/maps/landmark_scene.h"

#include <mrpt/math/CMatrixFixed.h>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/observations/mrpt_scene.h"

namespace mrpt_ext
{
namespace
{
constexpr float kBallRadius = 0.06f;  ///< [m]

MrptSceneObject::Ptr ball(const Landmark& landmark)
{
  auto sphere = scenes::CSphere::Create(kBallRadius);
  sphere->setColor(0.85f, 0.2f, 0.1f);
  sphere->setLocation(landmark.position.x(), landmark.position.y(), landmark.position.z());
  return sphere;
}

MrptSceneObject::Ptr nameTag(const Landmark& landmark)
{
  auto text = scenes::CText::Create(landmark.id == kNoId ? landmark.category : std::to_string(landmark.id));
  text->setLocation(landmark.position.x(), landmark.position.y(), landmark.position.z() + 2.5 * kBallRadius);
  return text;
}

MrptSceneObject::Ptr uncertainty(const Landmark& landmark)
{
  auto ellipse = scenes::CEllipsoid2D::Create();
  mrpt::math::CMatrixDouble22 covariance;
  covariance.setDiagonal(std::vector<double>{square(landmark.stddev.x()), square(landmark.stddev.y())});
  ellipse->setCovMatrix(covariance);
  ellipse->setQuantiles(3.0f);
  ellipse->setLocation(landmark.position.x(), landmark.position.y(), landmark.position.z());
  return ellipse;
}
}  // namespace

void addLandmarks(scenes::CSetOfObjects& scene, const LandmarkTable& landmarks)
{
  for (const Landmark& landmark : landmarks.all())
  {
    scene.insert(ball(landmark));
    scene.insert(nameTag(landmark));
    if (landmark.stddev.minCoeff() > 0) scene.insert(uncertainty(landmark));
  }
}
}  // namespace mrpt_ext
