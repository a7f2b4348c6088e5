// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/view_cube.h"

#include <gtest/gtest.h>

namespace hapticell::app {
namespace {

const ViewCube kCube({100.0, 80.0}, 30.0);

TEST(ViewCube, MiddleOfAFaceMeansThatFace) {
  const Camera camera = Camera().turnedTo(StandardView::kFront);
  const auto spot = kCube.pick(kCube.center(), camera);
  ASSERT_TRUE(spot);
  EXPECT_EQ(*spot, dvec3(0, -1, 0));
}

TEST(ViewCube, PickFindsWhatIsProjectedThere) {
  for (const bool perspective : {true, false}) {
    Camera camera;
    camera.perspective = perspective;
    camera.azimuth = 0.6;
    camera.elevation = 0.5;
    // The near corner: front, right, top.
    const auto corner = kCube.pick(kCube.project(dvec3(0.97, -0.97, 0.97), camera), camera);
    ASSERT_TRUE(corner);
    EXPECT_EQ(*corner, dvec3(1, -1, 1));
    const auto edge = kCube.pick(kCube.project(dvec3(0.0, -0.99, 0.9), camera), camera);
    ASSERT_TRUE(edge);
    EXPECT_EQ(*edge, dvec3(0, -1, 1));
    const auto face = kCube.pick(kCube.project(dvec3(1.0, 0.1, 0.1), camera), camera);
    ASSERT_TRUE(face);
    EXPECT_EQ(*face, dvec3(1, 0, 0));
  }
}

TEST(ViewCube, OutsideIsNothing) {
  EXPECT_FALSE(kCube.pick({300.0, 80.0}, Camera()));
}

TEST(ViewCube, AtMostThreeFacesAreSeenAndTheyFaceTheEye) {
  for (int i = 0; i < 60; ++i) {
    Camera camera;
    camera.azimuth = 0.37 * i;
    camera.elevation = -1.5 + 0.05 * i;
    const auto faces = kCube.visibleFaces(camera);
    EXPECT_GE(faces.size(), 1u);
    EXPECT_LE(faces.size(), 3u);
    for (const ViewCubeFace& face : faces) EXPECT_GT(face.facing, 0.0);
  }
}

TEST(ViewCube, ClickOnAFaceGivesItsStandardView) {
  const Camera turned = Camera().turnedTo(-dvec3(1, 0, 0));
  EXPECT_LT(glm::length(turned.forward_W() - Camera().turnedTo(StandardView::kRight).forward_W()), 1e-9);
}

}  // namespace
}  // namespace hapticell::app
