// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/camera.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/constants.hpp>

namespace hapticell::app {
namespace {

constexpr ViewSize kSize{1280.0, 720.0};

Camera someCamera(int seed) {
  Camera camera;
  camera.target_W = dvec3(0.1 * (seed % 7), -0.2 * (seed % 5), 0.05 * (seed % 11));
  camera.azimuth = 0.31 * (seed % 19);
  camera.elevation = -1.4 + 0.14 * (seed % 20);
  camera.distance = 0.5 + 0.7 * (seed % 9);
  camera.perspective = seed % 2 == 0;
  return camera;
}

/// Projection by the matrices that the renderer uses: the second method.
glm::dvec2 throughMatrices(const Camera& camera, const dvec3& p_WQ) {
  geometry::Bounds bounds;
  bounds.add(p_WQ);
  bounds.add(camera.target_W);
  bounds.add(camera.target_W + dvec3(1.0));
  const glm::dvec4 clip = camera.projectionMatrix(kSize, bounds) * camera.viewMatrix() * glm::dvec4(p_WQ, 1.0);
  return {0.5 * kSize.width * (1.0 + clip.x / clip.w), 0.5 * kSize.height * (1.0 - clip.y / clip.w)};
}

RC_GTEST_PROP(Camera, ProjectsAsItsMatricesDo, ()) {
  const Camera camera = someCamera(*rc::gen::inRange(0, 10000));
  const dvec3 p_WQ = camera.target_W + 0.2 * camera.distance * dvec3(0.3, -0.4, 0.5);
  const auto pixel = camera.project(p_WQ, kSize);
  RC_ASSERT(pixel.has_value());
  RC_ASSERT(glm::length(*pixel - throughMatrices(camera, p_WQ)) < 1e-6);
}

RC_GTEST_PROP(Camera, RayGoesThroughThePointThatItsPixelShows, ()) {
  const Camera camera = someCamera(*rc::gen::inRange(0, 10000));
  const dvec3 p_WQ = camera.target_W + 0.2 * camera.distance * dvec3(-0.3, 0.7, 0.1);
  const Ray ray = camera.rayThrough(*camera.project(p_WQ, kSize), kSize);
  const dvec3 offset = p_WQ - ray.origin_W;
  RC_ASSERT(glm::length(offset - glm::dot(offset, ray.direction_W) * ray.direction_W) < 1e-9 * (1.0 + camera.distance));
}

RC_GTEST_PROP(Camera, OrbitKeepsItsPivotInThePicture, ()) {
  Camera camera = someCamera(*rc::gen::inRange(0, 10000));
  const dvec3 pivot_W = camera.target_W + 0.15 * camera.distance * dvec3(0.5, 0.2, -0.3);
  const auto before = camera.project(pivot_W, kSize);
  camera.orbit({*rc::gen::inRange(-200, 200) * 1.0, *rc::gen::inRange(-80, 80) * 1.0}, pivot_W);
  RC_ASSERT(glm::length(*camera.project(pivot_W, kSize) - *before) < 1e-6);
}

RC_GTEST_PROP(Camera, ZoomKeepsThePointUnderTheCursor, ()) {
  Camera camera = someCamera(*rc::gen::inRange(0, 10000));
  const dvec3 p_WQ = camera.target_W + 0.1 * camera.distance * dvec3(0.5, 0.2, -0.3);
  const auto before = camera.project(p_WQ, kSize);
  camera.zoom(0.01 * *rc::gen::inRange(50, 200), p_WQ);
  RC_ASSERT(glm::length(*camera.project(p_WQ, kSize) - *before) < 1e-6);
}

TEST(Camera, PanMovesAPointWithTheCursor) {
  Camera camera = someCamera(4);
  const dvec3 p_WQ = camera.target_W + dvec3(0.1, 0.1, 0.0);
  const auto before = camera.project(p_WQ, kSize);
  camera.pan({30.0, -12.0}, p_WQ, kSize);
  const glm::dvec2 moved = *camera.project(p_WQ, kSize) - *before;
  EXPECT_NEAR(moved.x, 30.0, 1e-6);
  EXPECT_NEAR(moved.y, -12.0, 1e-6);
}

TEST(Camera, FittedBoxIsInsideAndFillsTheView) {
  geometry::Bounds box;
  box.add(dvec3(-1.0, 0.2, 0.0));
  box.add(dvec3(2.5, 1.4, 3.0));
  for (int seed = 0; seed < 40; ++seed) {
    const Camera camera = someCamera(seed).fitted(box, kSize);
    double least_room = 1e9;
    for (int i = 0; i < 8; ++i) {
      const dvec3 corner((i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
                         (i & 4) ? box.max.z : box.min.z);
      const glm::dvec2 p = *camera.project(corner, kSize);
      EXPECT_GE(p.x, 0.0);
      EXPECT_LE(p.x, kSize.width);
      EXPECT_GE(p.y, 0.0);
      EXPECT_LE(p.y, kSize.height);
      least_room = std::min({least_room, p.x, kSize.width - p.x, p.y, kSize.height - p.y});
    }
    EXPECT_LT(least_room, 0.25 * kSize.height) << "the box is lost in the view, seed " << seed;
  }
}

TEST(Camera, FittedPointsTouchTheMarginOnTwoOppositeSides) {
  const std::vector<dvec3> points{
      {0.3, -1.0, 0.0}, {2.0, 0.4, 0.1}, {-0.5, 1.7, 2.2}, {0.9, 0.8, 3.0}, {1.0, 0.0, 0.5}};
  for (int seed = 0; seed < 40; ++seed) {
    const Camera camera = someCamera(seed).fitted(points, kSize);
    double left = 1e9, right = 1e9, top = 1e9, bottom = 1e9;
    for (const dvec3& point : points) {
      const glm::dvec2 p = *camera.project(point, kSize);
      left = std::min(left, p.x);
      right = std::min(right, kSize.width - p.x);
      top = std::min(top, p.y);
      bottom = std::min(bottom, kSize.height - p.y);
    }
    const double margin_x = 0.5 * kSize.width * (1.0 - 1.0 / 1.12), margin_y = 0.5 * kSize.height * (1.0 - 1.0 / 1.12);
    EXPECT_GE(std::min(left, right), margin_x - 1e-6);
    EXPECT_GE(std::min(top, bottom), margin_y - 1e-6);
    const bool wide = std::abs(left - margin_x) < 1e-6 && std::abs(right - margin_x) < 1e-6;
    const bool high = std::abs(top - margin_y) < 1e-6 && std::abs(bottom - margin_y) < 1e-6;
    EXPECT_TRUE(wide || high) << "the eye could stand nearer, seed " << seed;
  }
}

TEST(Camera, LooksFromASavedEyeToItsTarget) {
  const dvec3 eye(2.0, -2.5, 1.5), target(0.1, 0.2, 0.6);
  const Camera camera = someCamera(1).looking(eye, target);
  EXPECT_LT(glm::length(camera.eye_W() - eye), 1e-12);
  EXPECT_LT(glm::length(camera.target_W - target), 1e-12);
  EXPECT_EQ(someCamera(1).looking(eye, eye).distance, someCamera(1).distance);
}

TEST(Camera, EmptyBoxChangesNothing) {
  const Camera camera = someCamera(3);
  EXPECT_EQ(camera.fitted(geometry::Bounds{}, kSize).distance, camera.distance);
}

TEST(Camera, StandardViewsLookAlongTheAxes) {
  const Camera camera;
  EXPECT_LT(glm::length(camera.turnedTo(StandardView::kFront).forward_W() - dvec3(0, 1, 0)), 1e-9);
  EXPECT_LT(glm::length(camera.turnedTo(StandardView::kRight).forward_W() - dvec3(-1, 0, 0)), 1e-9);
  const Camera top = camera.turnedTo(StandardView::kTop);
  EXPECT_LT(glm::length(top.forward_W() - dvec3(0, 0, -1)), 1e-6);
  EXPECT_LT(glm::length(top.up_W() - dvec3(0, 1, 0)), 1e-6) << "north is up";
}

TEST(Camera, WhatIsBehindTheEyeHasNoPixel) {
  const Camera camera;
  EXPECT_FALSE(camera.project(camera.eye_W() - camera.forward_W(), kSize).has_value());
}

TEST(Camera, InterpolationTurnsTheShortWayAndEndsExactly) {
  Camera a, b;
  a.azimuth = 3.0;
  b.azimuth = -3.0;
  EXPECT_NEAR(std::abs(interpolate(a, b, 0.5).azimuth), std::numbers::pi, 1e-9);
  EXPECT_NEAR(interpolate(a, b, 1.0).azimuth, b.azimuth, 1e-12);
  EXPECT_EQ(eased(0.0), 0.0);
  EXPECT_EQ(eased(1.0), 1.0);
  EXPECT_EQ(eased(7.0), 1.0);
}

}  // namespace
}  // namespace hapticell::app
