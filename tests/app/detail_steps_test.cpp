// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/detail_steps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/viewport/item_batches.h"
#include "geometry/shapes.h"

namespace hapticell::app {
namespace {

TEST(DetailSteps, EachIsAQuarterAndAsNearAsItSays) {
  DisplayMesh display = makeDisplayMesh(geometry::makeSphere(1.0, 160));
  const std::size_t whole = display.indices.size();
  addDetailSteps(display);
  ASSERT_GE(display.steps.size(), 4u);
  EXPECT_EQ(display.steps[0].count, whole);
  EXPECT_EQ(display.steps[0].error, 0.0);
  for (std::size_t k = 0; k < display.steps.size(); ++k) {
    const DetailStep& step = display.steps[k];
    ASSERT_LE(step.first + step.count, display.indices.size());
    if (k > 0) {
      EXPECT_LE(step.count, 6 * display.steps[k - 1].count / 10);
      EXPECT_GT(step.error, display.steps[k - 1].error);
    }
    double deepest = 0.0;
    for (std::size_t i = step.first; i < step.first + step.count; i += 3) {
      fvec3 middle(0.0f);
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_LT(display.indices[i + c], display.vertices.size());
        middle += display.vertices[display.indices[i + c]].position / 3.0f;
      }
      deepest = std::max(deepest, 1.0 - static_cast<double>(glm::length(middle)));
    }
    // Quadrics measure about, and the sphere itself has facets.
    EXPECT_LT(deepest, 2.0 * step.error + 1e-3) << k;
  }
  EXPECT_LT(display.steps.back().count / 3, 800u);
}

TEST(DetailSteps, AFenceThatCannotBeCollapsedGetsCoarseAllTheSame) {
  // Boxes that touch nobody: 2,000 bars of 12 triangles.
  geometry::TriangleMesh fence;
  for (int i = 0; i < 2000; ++i) {
    geometry::TriangleMesh bar = geometry::makeBox({0.005, 0.005, 1.0});
    const auto first = static_cast<std::uint32_t>(fence.vertices.size());
    for (const dvec3& p : bar.vertices) fence.vertices.push_back(p + dvec3(0.02 * i, 0.0, 0.0));
    for (const auto& t : bar.triangles) fence.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  DisplayMesh display = makeDisplayMesh(fence);
  addDetailSteps(display);
  ASSERT_GE(display.steps.size(), 2u);
  EXPECT_LT(display.steps.back().count / 3, 4000u);
  EXPECT_GT(display.steps.back().count, 0u);
}

TEST(DetailSteps, TheChoiceIsTheCoarsestThatIsNotSeen) {
  const std::vector<DetailStep> steps{{0, 300, 0.0}, {300, 90, 0.001}, {390, 30, 0.01}};
  EXPECT_EQ(detailStepFor(steps, 0.0, 0.5), 0u) << "the eye is in it";
  EXPECT_EQ(detailStepFor(steps, 0.001, 0.5), 0u);
  EXPECT_EQ(detailStepFor(steps, 0.002, 0.5), 1u);
  EXPECT_EQ(detailStepFor(steps, 1.0, 0.5), 2u);
  EXPECT_EQ(detailStepFor({}, 1.0, 0.5), 0u);
}

TEST(DetailSteps, WhatIsLeftOutIsOutsideOfTheView) {
  Camera camera;
  camera.distance = 5.0;
  const ViewSize size{800, 500};
  geometry::Bounds reach;
  reach.add(dvec3(-9));
  reach.add(dvec3(9));
  for (const bool perspective : {true, false}) {
    camera.perspective = perspective;
    const glm::dmat4 clip_from_world = camera.projectionMatrix(size, reach) * camera.viewMatrix();
    int outside = 0;
    for (int i = 0; i < 4000; ++i) {
      const dvec3 p(8.0 * std::sin(1.7 * i), 8.0 * std::sin(2.3 * i + 1.0), 8.0 * std::sin(3.1 * i + 2.0));
      const double radius = 0.1 + 0.5 * std::abs(std::sin(0.7 * i));
      if (!isOutside(clip_from_world, p, radius)) continue;
      ++outside;
      // No point of the sphere is in the picture.
      for (int k = 0; k < 60; ++k) {
        const dvec3 d(std::sin(1.3 * k), std::sin(2.1 * k + 1.0), std::sin(3.7 * k + 2.0));
        const auto pixel = camera.project(p + radius * glm::normalize(d), size);
        if (!pixel) continue;
        const bool seen = pixel->x >= 0 && pixel->x <= size.width && pixel->y >= 0 && pixel->y <= size.height;
        EXPECT_FALSE(seen);
      }
    }
    EXPECT_GT(outside, 500);
    EXPECT_FALSE(isOutside(clip_from_world, camera.target_W, 0.01));
  }
}

}  // namespace
}  // namespace hapticell::app
