// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay/view_cube.h"

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

TEST(ViewCube, WhatIsLitIsWhatAClickMeans) {
  const Camera camera;
  const ViewCube cube({100, 100}, 31);
  int lit = 0;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const dvec3 spot(x, y, z);
        for (const auto& patch : cube.patches(spot, camera)) {
          const glm::dvec2 middle = 0.25 * (patch[0] + patch[1] + patch[2] + patch[3]);
          const auto picked = cube.pick(middle, camera);
          ASSERT_TRUE(picked);
          EXPECT_LT(glm::length(*picked - spot), 1e-9);
          ++lit;
        }
      }
  EXPECT_EQ(lit, 27) << "three visible faces of nine fields";
}

}  // namespace
}  // namespace hapticell::app
