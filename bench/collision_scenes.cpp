// SPDX-License-Identifier: Apache-2.0
#include "bench/collision_scenes.h"

#include <cmath>
#include <random>

#include "collision/motion_check.h"
#include "geometry/shapes.h"

namespace hapticell::bench {

namespace {

using geometry::TriangleMesh;

TriangleMesh gripper(int triangles) {
  const int segments = std::max(8, static_cast<int>(std::sqrt(triangles / 8.0)));
  TriangleMesh mesh;
  append(mesh, geometry::makeTorus(0.08, 0.02, 2 * segments, segments), {});
  append(mesh, geometry::makeSphere(0.05, segments), Pose::translation({0, 0, 0.05}));
  append(mesh, geometry::makeSphere(0.02, segments), Pose::translation({0.1, 0.05, -0.03}));
  append(mesh, geometry::makeCylinder(0.02, 0.2, segments), Pose::translation({0, 0, 0.1}));
  for (const double x : {-0.06, 0.06})
    append(mesh, geometry::makeBox({0.015, 0.03, 0.12}), Pose::translation({x, 0, -0.06}));
  append(mesh, geometry::makeSphere(0.03, segments), Pose::translation({-0.1, 0, 0.02}));
  return mesh;
}

TriangleMesh fixture(int triangles) {
  constexpr int kEach = 7;
  const int segments = std::max(6, static_cast<int>(std::sqrt(triangles / (kEach * kEach * 1.2))));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> height(0.02, 0.15);
  TriangleMesh mesh = geometry::makeBox({2.0, 2.0, 0.02});
  for (int i = 0; i < kEach * kEach; ++i) {
    const double h = height(random);
    const dvec3 at(0.27 * (i % kEach - kEach / 2), 0.27 * (i / kEach - kEach / 2), 0.01);
    switch (i % 4) {
      case 0:
        append(mesh, geometry::makeCylinder(0.03, h, 2 * segments), Pose::translation(at + dvec3(0, 0, 0.5 * h)));
        break;
      case 1:
        append(mesh, geometry::makeSphere(0.06, 2 * segments), Pose::translation(at));
        break;
      case 2:
        append(mesh, geometry::makeTorus(0.06, 0.015, 2 * segments, segments),
               Pose::translation(at + dvec3(0, 0, 0.015)));
        break;
      default:
        append(mesh, geometry::makeBox({0.2, 0.01, h}), Pose::translation(at + dvec3(0, 0, 0.5 * h)));
    }
  }
  return mesh;
}

/// A walk across the standing mesh: at every place the moved one is let down until it is a few millimetres away.
std::vector<Pose> walkOver(const TriangleMesh& moved, const TriangleMesh& standing) {
  constexpr int kApproach = 250, kSlide = 500;
  collision::ProximityQuery query(collision::MeshCollider::build(moved), collision::MeshCollider::build(standing));
  const geometry::Bounds ground = query.b().bounds();
  const double size = query.a().radius(), high = ground.max.z + 3.0 * size;
  const dvec3 reach = 0.35 * ground.size();
  std::vector<Pose> slide;
  for (int i = 0; i < kSlide; ++i) {
    const double t = static_cast<double>(i) / kSlide, turn = 4.0 * t;
    const dquat q = quaternionFromRotationVector({0.4 * std::sin(5 * turn), 0.3 * std::cos(4 * turn), turn});
    const dvec3 middle(ground.center().x + reach.x * std::sin(6.0 * t), ground.center().y + reach.y * std::cos(7.0 * t),
                       high);
    const Pose X_WUp{middle - q * query.a().center(), q};
    const Pose X_WDown{X_WUp.p - dvec3(0, 0, high - ground.min.z + size), q};
    const double gap = 0.02 * size * (1.2 + std::sin(40.0 * t));
    const auto stop = collision::advance(query, collision::straightMotion(X_WUp, X_WDown, query.a()),
                                         collision::standingStill({}), {gap});
    slide.push_back(interpolate(X_WUp, X_WDown, stop.s));
  }
  std::vector<Pose> walk;
  const auto raised = [&](const Pose& X, int step) {
    return Pose{X.p + dvec3(0, 0, 4.0 * size * step / kApproach), X.q};
  };
  for (int i = kApproach; i > 0; --i) walk.push_back(raised(slide.front(), i));
  walk.insert(walk.end(), slide.begin(), slide.end());
  for (int i = 1; i <= kApproach; ++i) walk.push_back(raised(slide.back(), i));
  return walk;
}

}  // namespace

Scene cadScene(const std::string& name, int triangles) {
  return fileScene(name, gripper(triangles), fixture(triangles));
}

Scene fileScene(const std::string& name, TriangleMesh moved, TriangleMesh standing) {
  std::vector<Pose> walk = walkOver(moved, standing);
  return {name, std::move(moved), std::move(standing), std::move(walk)};
}

}  // namespace hapticell::bench
