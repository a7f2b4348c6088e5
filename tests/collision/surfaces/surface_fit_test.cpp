// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/surface_fit.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "geometry/shapes/pose.h"

namespace hapticell::test {
namespace {

using collision::SurfaceShape;
using collision::SurfaceType;

/// A patch of points on a surface about z, placed at random, with the normals there.
struct Patch {
  SurfaceShape shape;
  std::vector<dvec3> points, normals;
};

Patch patchOf(SurfaceType type, std::mt19937& random, double side) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::normal_distribution<double> normal;
  const Pose X{dvec3(normal(random), normal(random), normal(random)),
               glm::normalize(dquat(normal(random), normal(random), normal(random), normal(random)))};
  Patch patch;
  patch.shape.type = type;
  patch.shape.p_M = X.p;
  patch.shape.axis_M = X.rotate({0, 0, 1});
  patch.shape.radius = 0.002 + 0.02 * uniform(random);
  patch.shape.major_radius = patch.shape.radius * (1.5 + 3.0 * uniform(random));
  patch.shape.half_angle = 0.2 + uniform(random);
  patch.shape.side = side;
  const double r = patch.shape.radius, R = patch.shape.major_radius;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 6; ++j) {
      const double a = 0.2 * i, b = 0.15 * j + 0.1;
      const dvec3 out(std::cos(a), std::sin(a), 0.0);
      dvec3 p(0.0);
      if (type == SurfaceType::kCylinder) p = r * out + dvec3(0, 0, 0.3 * r * j);
      if (type == SurfaceType::kSphere) p = r * (std::cos(b) * out + dvec3(0, 0, std::sin(b)));
      if (type == SurfaceType::kTorus) p = (R + r * std::cos(b)) * out + dvec3(0, 0, r * std::sin(b));
      if (type == SurfaceType::kCone) {
        const double along = r * (1.0 + 0.5 * j);
        p = along * (std::sin(patch.shape.half_angle) * out + dvec3(0, 0, std::cos(patch.shape.half_angle)));
      }
      patch.points.push_back(X * p);
      patch.normals.push_back(collision::viewFrom(patch.shape, X * p).nhat_M);
    }
  }
  return patch;
}

RC_GTEST_PROP(SurfaceFit, RecoversTheSurfaceOfItsPoints, (std::uint32_t seed, bool hollow)) {
  std::mt19937 random(seed);
  for (const auto type : {SurfaceType::kCylinder, SurfaceType::kCone, SurfaceType::kSphere, SurfaceType::kTorus}) {
    const Patch patch = patchOf(type, random, hollow ? -1.0 : 1.0);
    const auto found = collision::fitSurface(type, {patch.points, patch.points, patch.normals}, 1e-8);
    RC_ASSERT(found.has_value());
    RC_ASSERT(found->side == patch.shape.side);
    RC_ASSERT(collision::greatestDistance(*found, patch.points) < 1e-8);
    if (type != SurfaceType::kCone) RC_ASSERT(std::abs(found->radius - patch.shape.radius) < 1e-6);
    if (type == SurfaceType::kCone) RC_ASSERT(std::abs(found->half_angle - patch.shape.half_angle) < 1e-5);
    if (type == SurfaceType::kTorus) RC_ASSERT(std::abs(found->major_radius - patch.shape.major_radius) < 1e-6);
  }
}

TEST(SurfaceFit, RefusesWhatIsNoSuchSurface) {
  std::mt19937 random(3);
  const Patch sphere = patchOf(SurfaceType::kSphere, random, 1.0);
  EXPECT_FALSE(collision::fitSurface(SurfaceType::kCylinder, {sphere.points, sphere.points, sphere.normals}, 1e-6));
  EXPECT_FALSE(collision::fitSurface(SurfaceType::kCone, {sphere.points, sphere.points, sphere.normals}, 1e-6));
  EXPECT_FALSE(collision::fitSurface(SurfaceType::kPlane, {sphere.points, sphere.points, sphere.normals}, 1e-6));
  const std::vector<dvec3> one(10, dvec3(1.0)), ways(10, dvec3(0, 0, 1));
  for (const auto type : {SurfaceType::kCylinder, SurfaceType::kCone, SurfaceType::kSphere, SurfaceType::kTorus})
    EXPECT_FALSE(collision::fitSurface(type, {one, one, ways}, 1e-6));
}

/// Value and normal against finite differences and the definition.
RC_GTEST_PROP(SurfaceShape, NormalsAndCurvaturesAreThoseOfItsDistance, (std::uint32_t seed, bool hollow)) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const auto type : {SurfaceType::kCylinder, SurfaceType::kCone, SurfaceType::kSphere, SurfaceType::kTorus}) {
    const Patch patch = patchOf(type, random, hollow ? -1.0 : 1.0);
    const double r = patch.shape.radius;
    const dvec3 foot = patch.points[20];
    const auto at = collision::viewFrom(patch.shape, foot);
    const dvec3 p = foot + 0.3 * r * uniform(random) * at.nhat_M;
    const auto view = collision::viewFrom(patch.shape, p);
    RC_ASSERT(std::abs(view.value - collision::signedDistance(patch.shape, p)) < 1e-12);
    RC_ASSERT(glm::length(view.nhat_M - at.nhat_M) < 1e-6);
    RC_ASSERT(std::abs(glm::dot(view.t1_M, view.nhat_M)) < 1e-9);
    const double h = 1e-3 * r;
    const dvec3 t2 = glm::cross(at.nhat_M, at.t1_M);
    for (const auto& [t, k] : {std::pair{at.t1_M, at.k1}, std::pair{t2, at.k2}}) {
      const double bend =
          collision::signedDistance(patch.shape, foot + h * t) + collision::signedDistance(patch.shape, foot - h * t);
      RC_ASSERT(std::abs(bend / (h * h) - k) < 0.02 * (std::abs(k) + 1.0 / r));
    }
  }
}

}  // namespace
}  // namespace hapticell::test
