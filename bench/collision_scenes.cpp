// SPDX-License-Identifier: Apache-2.0
#include "bench/collision_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "collision/queries/proximity_query.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::bench {

namespace {

using geometry::TriangleMesh;

constexpr double kStep = 3.1e-3;
constexpr double kTurn = 0.5 * std::numbers::pi / 180.0;

/// A bolt (shank and hexagonal head), a piece of pipe or a dome, standing on the origin.
TriangleMesh feature(int kind, int triangles, double size) {
  TriangleMesh mesh;
  if (kind % 3 == 0) {
    append(mesh, geometry::makeCylinder(0.35 * size, size, std::max(6, triangles / 4)),
           Pose::translation({0, 0, 0.5 * size}));
    append(mesh, geometry::makeCylinder(0.7 * size, 0.3 * size, 6), Pose::translation({0, 0, 1.15 * size}));
  } else if (kind % 3 == 1) {
    const int around = std::max(8, static_cast<int>(std::sqrt(triangles / 4.0)));
    append(mesh, geometry::makeTorus(1.5 * size, 0.4 * size, 2 * around, around),
           Pose::translation({0, 0, 0.4 * size}));
  } else {
    mesh = geometry::makeSphere(size, std::max(6, static_cast<int>(std::sqrt(triangles))));
  }
  return mesh;
}

/// Points of a mesh moved in and out.
template <typename Height>
TriangleMesh bumpy(TriangleMesh mesh, const Height& height) {
  for (dvec3& vertex : mesh.vertices) vertex = height(vertex);
  return mesh;
}

double bumps(const dvec3& p) {
  return 0.5 * std::sin(17.0 * p.x + 3.0 * p.y) + 0.3 * std::sin(29.0 * p.y - 11.0 * p.z + 1.0) +
         0.2 * std::sin(53.0 * p.z + 37.0 * p.x);
}

/// Leads one mesh over another: tangentially towards a heading, kept at a gap that swings from 1 to 10 mm.
class Slider {
 public:
  Slider(const TriangleMesh& moved, const TriangleMesh& standing)
      : query_(collision::MeshCollider::build(moved), collision::MeshCollider::build(standing)) {}

  std::vector<Pose> walk() {
    const geometry::Bounds& ground = query_.b().bounds();
    const double reach = 0.3 * std::max(ground.size().x, ground.size().y);
    Pose X = {ground.center() + dvec3(reach, 0, 0.5 * ground.size().z + 1.05 * query_.a().radius()), dquat(1, 0, 0, 0)};
    X.p -= query_.a().center();
    while (query_.distance(X, {}).distance > 0.006) X.p.z -= 0.5 * query_.distance(X, {}).distance;
    std::vector<Pose> slide;
    for (int i = 0; i < kSlide; ++i) {
      X = next(X, i, ground.center(), reach);
      slide.push_back(X);
    }
    std::vector<Pose> result;
    for (int i = kApproach; i > 0; --i) result.push_back(lifted(slide.front(), i));
    result.insert(result.end(), slide.begin(), slide.end());
    for (int i = 1; i <= kApproach; ++i) result.push_back(lifted(slide.back(), i));
    return result;
  }

 private:
  Pose turned(const Pose& X, const dvec3& axis, double angle) const {
    const dvec3 middle = X * query_.a().center();
    const dquat q = glm::normalize(quaternionFromRotationVector(angle * axis) * X.q);
    return {middle - q * query_.a().center(), q};
  }

  Pose lifted(const Pose& X, int steps) const {
    Pose up = turned(X, {0, 0, 1}, steps * kTurn);
    up.p.z += steps * kStep;
    return up;
  }

  Pose next(const Pose& X, int i, const dvec3& center, double reach) {
    const auto here = query_.distance(X, {});
    const dvec3 out = (X * query_.a().center() - center) / reach;
    dvec3 heading =
        glm::normalize(dvec3(-out.y, out.x, 0.0) + 0.5 * dvec3(out.x, out.y, 0.0) * (1.0 - std::hypot(out.x, out.y)));
    const double gap = 5.5e-3 + 4.0e-3 * std::sin(0.07 * i);
    const dvec3& n = here.nhat_BA_W;
    heading -= n * std::min(0.0, glm::dot(heading, n));
    if (glm::length(heading) < 0.2) heading = dvec3(0, 0, 1) - n * n.z;
    const double correction = std::clamp((gap - here.distance) / kStep, -0.7, 0.7);
    const dvec3 way = glm::normalize(glm::normalize(heading) * (1.0 - std::abs(correction)) + n * correction -
                                     dvec3(0, 0, here.distance > 2.0 * gap ? 0.5 : 0.0));
    const dvec3 axis = glm::normalize(dvec3(std::sin(0.03 * i), std::cos(0.021 * i), 0.6));
    Pose X_next = turned({X.p + kStep * way, X.q}, axis, kTurn);
    for (int tries = 0; tries < 20; ++tries) {
      const auto there = query_.distance(X_next, {});
      if (there.distance > 1e-3) return X_next;
      const dvec3 away = there.colliding ? dvec3(0, 0, 1) : there.nhat_BA_W;
      X_next.p += away * (there.colliding ? kStep : 1.5e-3 - there.distance);
    }
    return X_next;
  }

  collision::ProximityQuery query_;
};

}  // namespace

TriangleMesh cadPart(int triangles) {
  constexpr int kFeatures = 24;
  TriangleMesh mesh = geometry::makeBox({0.26, 0.16, 0.06});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < kFeatures; ++i) {
    Pose X = Pose::translation({0.11 * unit(random), 0.06 * unit(random), 0.03});
    if (i % 2 == 1) X = Pose{{X.p.x, X.p.y, -0.03}, dquat(0, 1, 0, 0)};
    append(mesh, feature(i, triangles / kFeatures, 0.008 + 0.02 * std::abs(unit(random))), X);
  }
  return mesh;
}

TriangleMesh cadPlate(int triangles) {
  constexpr int kEach = 8;
  TriangleMesh mesh = geometry::makeBox({2.0, 2.0, 0.02});
  for (int i = 0; i < 6; ++i) {
    append(mesh, geometry::makeBox({2.0, 0.008, 0.04}), Pose::translation({0, -0.75 + 0.3 * i, 0.03}));
  }
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < kEach * kEach; ++i) {
    const int column = i % kEach;
    const int row = i / kEach;
    const dvec3 at(0.24 * (column - 3.5) + 0.05 * unit(random), 0.24 * (row - 3.5) + 0.05 * unit(random), 0.01);
    append(mesh, feature(i, triangles / (kEach * kEach), 0.01 + 0.05 * unit(random)), Pose::translation(at));
  }
  return mesh;
}

TriangleMesh scanPart(int triangles) {
  const int segments = static_cast<int>(std::sqrt(triangles)) + 1;
  return bumpy(geometry::makeSphere(0.15, segments), [](const dvec3& p) { return p * (1.0 + 0.12 * bumps(2.0 * p)); });
}

TriangleMesh scanTerrain(int triangles) {
  const int cells = static_cast<int>(std::sqrt(triangles / 2.0));
  TriangleMesh mesh;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const dvec3 p(2.0 * i / cells - 1.0, 2.0 * j / cells - 1.0, 0.0);
      mesh.vertices.emplace_back(p.x, p.y, 0.03 * bumps(p));
    }
  }
  const auto row = static_cast<std::uint32_t>(cells + 1);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(cells); ++i) {
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(cells); ++j) {
      const std::uint32_t v = i * row + j;
      mesh.triangles.push_back({v, v + row, v + row + 1});
      mesh.triangles.push_back({v, v + row + 1, v + 1});
    }
  }
  return mesh;
}

Scene makeScene(const std::string& name, TriangleMesh moved, TriangleMesh standing) {
  std::vector<Pose> walk = Slider(moved, standing).walk();
  return {name, std::move(moved), std::move(standing), std::move(walk)};
}

std::vector<Pose> hapticSteps(const std::vector<Pose>& walk, int first, int steps, int pieces) {
  std::vector<Pose> result;
  for (int i = first; i < first + steps; ++i) {
    for (int k = 0; k < pieces; ++k) {
      result.push_back(interpolate(walk[static_cast<std::size_t>(i)], walk[static_cast<std::size_t>(i) + 1],
                                   static_cast<double>(k) / pieces));
    }
  }
  return result;
}

Chain makeChain(int steps) {
  constexpr int kLinks = 7;
  Chain chain;
  for (int i = 0; i < kLinks; ++i) {
    TriangleMesh link;
    append(link, geometry::makeCylinder(0.06, 0.26, 400), Pose::translation({0, 0, 0.13}));
    append(link, geometry::makeTorus(0.07, 0.02, 110, 50), Pose::translation({0, 0, 0.24}));
    append(link, geometry::makeSphere(0.08, 58), {});
    chain.links.push_back(std::move(link));
  }
  for (int step = 0; step < steps; ++step) {
    std::vector<double> angles;
    for (int i = 0; i < kLinks; ++i) {
      angles.push_back((i % 2 == 0 ? 3.0 : 1.0) * kTurn * 30.0 * std::sin(step / 30.0 + 1.3 * i));
    }
    chain.X_WL.push_back(chainPoses(angles));
  }
  return chain;
}

Pose chainJoint(std::size_t link, double angle) {
  const double cosine = std::cos(0.5 * angle), sine = std::sin(0.5 * angle);
  const dquat turn = link % 2 == 0 ? dquat(cosine, 0, 0, sine) : dquat(cosine, 0, sine, 0);
  return {{0, 0, link == 0 ? 0.0 : 0.26}, turn};
}

std::vector<Pose> chainPoses(const std::vector<double>& angles) {
  std::vector<Pose> poses;
  Pose X = {};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    X = X * chainJoint(i, angles[i]);
    poses.push_back(X);
  }
  return poses;
}

std::vector<PlacedPart> partsAround(const Chain& chain, int parts, int triangles) {
  const auto shape = cadPart(triangles);
  const auto part = collision::MeshCollider::build(shape);
  std::vector<std::shared_ptr<const collision::MeshCollider>> links;
  for (const TriangleMesh& link : chain.links) links.push_back(collision::MeshCollider::build(link));
  const auto isNear = [&](const Pose& X_WP) {
    for (std::size_t i = 0; i < links.size(); ++i) {
      collision::ProximityQuery query(links[i], part);
      for (std::size_t step = 0; step < chain.X_WL.size(); step += 4) {
        if (query.within(chain.X_WL[step][i], X_WP, 0.006)) return true;
      }
    }
    return false;
  };
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<PlacedPart> result;
  while (static_cast<int>(result.size()) < parts) {
    const double around = std::numbers::pi * unit(random), away = 0.5 + 0.35 * unit(random) + 0.02 * parts / 8.0;
    Pose X = {{away * std::cos(around), away * std::sin(around), 1.0 + 1.0 * unit(random)},
              glm::normalize(dquat(unit(random), unit(random), unit(random), unit(random)))};
    if (!isNear(X)) result.push_back({shape, X});
  }
  return result;
}

}  // namespace hapticell::bench
