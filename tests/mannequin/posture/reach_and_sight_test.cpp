// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "geometry/shapes/mass_properties.h"

#include <numbers>
#include "mannequin/posture/reach_envelope.h"
#include "mannequin/posture/vision.h"

namespace hapticell::mannequin {
namespace {

TEST(Vision, ZonesAreThoseOfTheCones) {
  const Figure figure = *makeFigure({Sex::kMale, 1.755});
  const FigurePose pose = forwardKinematics(figure, *libraryPosture(figure, "zero"));
  const dvec3 eyes = sightOf(figure, pose, {1, 0, 1}).p_WEyes;
  EXPECT_NEAR(eyes.z, measuresOf(figure).at("eye_height"), 1e-9);
  const auto zone = [&](double azimuth_deg, double elevation_deg) {
    const double a = azimuth_deg * std::numbers::pi / 180.0, e = elevation_deg * std::numbers::pi / 180.0;
    const dvec3 target = eyes + 0.7 * dvec3(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
    return sightOf(figure, pose, target).zone;
  };
  EXPECT_EQ(zone(0, 0), VisionZone::kPreferred);
  EXPECT_EQ(zone(-14, 0), VisionZone::kPreferred);
  EXPECT_EQ(zone(34, 0), VisionZone::kEyes);
  EXPECT_EQ(zone(0, -39), VisionZone::kEyes);
  EXPECT_EQ(zone(0, 22), VisionZone::kHead);
  EXPECT_EQ(zone(-58, 0), VisionZone::kHead);
  EXPECT_EQ(zone(65, 0), VisionZone::kOutside);
  EXPECT_EQ(zone(180, 0), VisionZone::kOutside);
}

TEST(Vision, TheGazeBringsTheTargetToTheMiddleOfTheEyesCamera) {
  const Figure figure = *makeFigure({Sex::kFemale, 1.6});
  const FigurePose pose = forwardKinematics(figure, *libraryPosture(figure, "stooping"));
  const dvec3 eyes = sightOf(figure, pose, {1, 0, 1}).p_WEyes;
  const dvec3 target = eyes + pose[Segment::kHead].R_WS * dvec3(0.6, 0.15, -0.2);
  const Pose camera = eyePose(figure, pose, gazeAt(figure, pose, target));
  const dvec3 seen = camera.inverse() * target;
  EXPECT_NEAR(seen.x, 0.0, 1e-6);
  EXPECT_NEAR(seen.y, 0.0, 1e-6);
  EXPECT_LT(seen.z, -0.5);
}

TEST(ReachEnvelope, ShoulderAloneReachesAnArmsLengthAndTheTrunkAdds) {
  const Figure figure = *makeFigure({Sex::kMale, *statureOfPercentile(Sex::kMale, 50)});
  const Posture standing = *libraryPosture(figure, "standing");
  const dvec3 shoulder = forwardKinematics(figure, standing)[Segment::kRightUpperArm].p_WS;
  double volume[2] = {0.0, 0.0}, farthest[2] = {0.0, 0.0};
  for (const bool trunk : {false, true}) {
    const geometry::TriangleMesh mesh = reachEnvelope(figure, standing, Side::kRight, {trunk, 8});
    EXPECT_TRUE(geometry::isClosed(mesh));
    volume[trunk] = geometry::massProperties(mesh).volume;
    for (const dvec3& v : mesh.vertices) farthest[trunk] = std::max(farthest[trunk], glm::length(v - shoulder));
  }
  // The forward reach of the shoulder alone is the arm's length to the grip (men P50: 0.684 m from the acromion).
  EXPECT_GT(farthest[0], 0.60);
  EXPECT_LT(farthest[0], 0.80);
  EXPECT_GT(volume[0], 0.2);
  EXPECT_GT(volume[1], 1.2 * volume[0]);
}

}  // namespace
}  // namespace hapticell::mannequin
