// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/meshes/detail_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "app/viewport/meshes/display_mesh_worker.h"
#include "app/viewport/drawing/item_batches.h"
#include "app/viewport/meshes/vertex_clusters.h"
#include "geometry/shapes/shapes.h"
#include "tests/app/viewport/meshes/detail_shapes.h"
#include "tests/app/viewport/meshes/surface_distance.h"

namespace hapticell::app {
namespace {

DisplayMesh withSteps(const geometry::TriangleMesh& mesh) {
  DisplayMesh display = makeDisplayMesh(mesh);
  addDetailSteps(display);
  return display;
}

/// Parts of all kinds; the last one is a fence of bars that touch nobody.
std::vector<std::pair<std::string, geometry::TriangleMesh>> parts() {
  geometry::TriangleMesh fence;
  for (int i = 0; i < 60; ++i)
    geometry::append(fence, geometry::makeBox({0.005, 0.005, 1.0}), Pose::translation({0.02 * i, 0.0, 0.0}));
  return {{"sphere", geometry::makeSphere(0.5, 60)},
          {"cylinder", geometry::makeCylinder(0.2, 0.6, 96)},
          {"plate with holes", test::platesWithHoles(0.5, 0.004, 5, 0.012, false)},
          {"plate with pockets", test::platesWithHoles(0.4, 0.03, 4, 0.03, true)},
          {"open sheet", test::openSheet()},
          {"fence", fence}};
}

TEST(DetailSteps, EachHasFewerTrianglesAndIsAsNearAsItSaysBothWays) {
  std::size_t coarser = 0;
  for (const auto& [name, mesh] : parts()) {
    const DisplayMesh display = withSteps(mesh);
    const std::vector<test::Corners> whole = test::cornersOf(display, 0);
    EXPECT_EQ(display.steps[0].count, 3 * mesh.triangles.size()) << name;
    EXPECT_EQ(display.steps[0].error, 0.0) << name;
    for (std::size_t k = 1; k < display.steps.size(); ++k, ++coarser) {
      const DetailStep& step = display.steps[k];
      ASSERT_LE(step.first + step.count, display.indices.size()) << name;
      EXPECT_LT(step.count, display.steps[k - 1].count) << name;
      EXPECT_GE(step.error, display.steps[k - 1].error) << name;
      const std::vector<test::Corners> drawn = test::cornersOf(display, k);
      // Other points than those that were measured may be off a little more.
      const double allowed = 1.2 * step.error + 1e-6;
      for (const dvec3& p : test::pointsOf(whole, 500))
        ASSERT_LE(glm::distance(p, test::nearestOf(p, drawn)), allowed) << name << ", step " << k;
      for (const dvec3& p : test::pointsOf(drawn, 500))
        ASSERT_LE(glm::distance(p, test::nearestOf(p, whole)), allowed) << name << ", step " << k;
    }
  }
  EXPECT_GE(coarser, 10u) << "and there is something to be won";
}

TEST(DetailSteps, WhatIsDrawnIsWithinThePixelsOfItsLevelAtTheCamera) {
  const ViewSize size{1200, 800};
  for (const auto& [name, mesh] : parts()) {
    const DisplayMesh display = withSteps(mesh);
    const std::vector<test::Corners> whole = test::cornersOf(display, 0);
    for (const double distance : {1.5, 4.0, 12.0}) {
      Camera camera;
      camera.target_W = dvec3(0.0);
      camera.distance = distance;
      const double nearest = distance - display.bounds.radius();
      const double metres_per_pixel = camera.metresPerPixel(camera.eye_W() + nearest * camera.forward_W(), size);
      for (const DetailLevel level : {DetailLevel::kFull, DetailLevel::kNoEdges, DetailLevel::kCoarse}) {
        const std::size_t step = detailStepFor(display.steps, metres_per_pixel, allowedPixels(level));
        const std::vector<test::Corners> drawn = test::cornersOf(display, step);
        for (const dvec3& p : test::pointsOf(whole, 100)) {
          const auto there = camera.project(p, size), here = camera.project(test::nearestOf(p, drawn), size);
          ASSERT_TRUE(there && here);
          ASSERT_LE(glm::distance(*there, *here), 1.2 * allowedPixels(level) + 0.01) << name << " at " << distance;
        }
      }
    }
  }
}

TEST(DetailSteps, OpenBordersAreKept) {
  const DisplayMesh display = withSteps(test::openSheet());
  ASSERT_GE(display.steps.size(), 3u);
  const auto borders = [&](std::size_t step) {
    std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int> uses;
    const auto place = [&](std::size_t i) {
      const fvec3& p = display.vertices[display.indices[i]].position;
      return std::array<float, 3>{p.x, p.y, p.z};
    };
    const DetailStep& drawn = display.steps[step];
    for (std::size_t i = drawn.first; i < drawn.first + drawn.count; i += 3)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto a = place(i + c), b = place(i + (c + 1) % 3);
        ++uses[std::minmax(a, b)];
      }
    std::erase_if(uses, [](const auto& edge) { return edge.second != 1; });
    return uses;
  };
  ASSERT_EQ(borders(0).size(), 2u * (64u + 40u));
  EXPECT_EQ(borders(1), borders(0));
  EXPECT_EQ(borders(2), borders(0));
}

TEST(DetailSteps, NormalsAreThoseOfTheStepAndSmearNothing) {
  // The floor of a plate has the normals of the whole plate, however large its triangles became.
  const DisplayMesh display = withSteps(test::platesWithHoles(0.4, 0.03, 4, 0.03, true));
  ASSERT_GE(display.steps.size(), 2u);
  for (const DetailStep& step : display.steps)
    for (std::size_t i = step.first; i < step.first + step.count; i += 3) {
      const auto at = [&](std::size_t c) { return display.vertices[display.indices[i + c]]; };
      const fvec3 face = glm::cross(at(1).position - at(0).position, at(2).position - at(0).position);
      if (!(glm::length(face) > 1e-10f) || std::abs(glm::normalize(face).z) < 0.999f) continue;
      for (std::size_t c = 0; c < 3; ++c) EXPECT_GT(glm::dot(at(c).normal, glm::normalize(face)), 0.95f);
    }
}

TEST(DetailSteps, NoLevelIsOffByMoreThanTheMost) {
  double before = 0.0;
  for (int level = 0; level <= static_cast<int>(DetailLevel::kCoarse); ++level) {
    const double pixels = allowedPixels(static_cast<DetailLevel>(level));
    EXPECT_GE(pixels, before);
    EXPECT_LE(pixels, kMostPixels);
    before = pixels;
  }
}

TEST(DetailSteps, GivenUpTheyEndAtOnce) {
  const std::atomic<bool> given_up{true};
  DisplayMesh display = makeDisplayMesh(geometry::makeSphere(1.0, 160));
  addDetailSteps(display, kPartCrease, &given_up);
  EXPECT_EQ(display.steps.size(), 1u);
  EXPECT_TRUE(makeDisplayMesh(geometry::makeSphere(1.0, 160), kPartCrease, &given_up).edges.empty());
}

TEST(VertexClusters, KeepWithinACellAndShowTheWholePart) {
  const geometry::TriangleMesh sphere = geometry::makeSphere(1.0, 300);
  const geometry::TriangleMesh rough = clustered(sphere, 64);
  ASSERT_FALSE(rough.triangles.empty());
  EXPECT_LT(rough.triangles.size(), sphere.triangles.size() / 3);
  for (const dvec3& p : rough.vertices) EXPECT_NEAR(glm::length(p), 1.0, std::sqrt(3.0) * 2.0 / 64);
  const geometry::Bounds bounds = rough.bounds();
  for (int i = 0; i < 3; ++i) EXPECT_GT(bounds.size()[i], 2.0 - 2.0 * 2.0 / 64);
  EXPECT_TRUE(clustered({}, 64).triangles.empty());
}

TEST(DisplayMeshWorker, ALargeMeshIsShownRoughlyUntilItIsReadyWhole) {
  std::atomic<int> shown{0};
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(geometry::makeSphere(1.0, 400));
  ASSERT_GT(mesh->triangles.size(), DisplayMeshWorker::kLargeMesh);
  DisplayMeshWorker worker([&shown] { ++shown; });
  const auto prepared = worker.prepare(mesh);
  worker.wait();
  ASSERT_TRUE(prepared->first_ready && prepared->ready);
  EXPECT_EQ(shown, 2);
  ASSERT_FALSE(prepared->first.steps.empty());
  EXPECT_LT(prepared->first.steps[0].count, prepared->mesh.steps[0].count / 2);
  EXPECT_EQ(prepared->mesh.steps[0].count, 3 * mesh->triangles.size());
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(prepared->first.bounds.size()[i], prepared->mesh.bounds.size()[i], 0.05);
  // A small one is whole from the first on, and then only gets its coarser steps.
  shown = 0;
  const auto small = worker.prepare(std::make_shared<const geometry::TriangleMesh>(geometry::makeSphere(1.0, 60)));
  worker.wait();
  EXPECT_EQ(shown, 1);
  EXPECT_EQ(small->first.steps[0].count, small->mesh.steps[0].count);
  EXPECT_EQ(small->first.steps.size(), 1u);
  EXPECT_GT(small->mesh.steps.size(), 1u);
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
