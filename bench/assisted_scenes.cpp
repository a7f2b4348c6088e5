// SPDX-License-Identifier: Apache-2.0
#include "bench/assisted_scenes.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <random>

#include "bench/chain_robot.h"
#include "bench/collision_scenes.h"
#include "config/program_folders.h"
#include "geometry/shapes/shapes.h"
#include "kinematics/model/robot_model.h"
#include "planning/free_space.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/format/document_io.h"

namespace hapticell::bench {

namespace {

using std::numbers::pi;

/// m of hand between start and goal, straight: less than half of a stylus workspace, which leaves room for detours.
constexpr double kHandWay = 0.05;

double scaleFor(const Pose& from, const Pose& to) {
  return std::max(1.0, glm::distance(from.p, to.p) / kHandWay);
}

AssistedScene sceneOf(const std::string& name, const std::string& entity, double clearance) {
  AssistedScene scene;
  scene.name = name;
  scene.entity = entity;
  scene.clearance = clearance;
  return scene;
}

workcell::Entity solidOf(workcell::EntityId id, const std::string& name, geometry::TriangleMesh mesh, const Pose& X_WE,
                         bool locked) {
  workcell::Entity entity;
  entity.id = id;
  entity.name = name;
  entity.X_WE = X_WE;
  entity.locked = locked;
  entity.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(std::move(mesh))};
  return entity;
}

template <typename T>
T orEnd(Expected<T> made) {
  if (made) return std::move(*made);
  std::fprintf(stderr, "%s\n", made.error().message().c_str());
  std::exit(2);
}

/// Quarter circle from the end of a straight piece, in steps of 10 degrees.
void bend(std::vector<dvec3>& line, const dvec3& along, const dvec3& towards, double radius) {
  const dvec3 from = line.back();
  for (int i = 1; i <= 9; ++i) {
    const double angle = i * pi / 18.0;
    line.push_back(from + radius * (std::sin(angle) * along + (1.0 - std::cos(angle)) * towards));
  }
}

/// A loop of 30 mm in the xy plane whose ends cross above each other at x = 0 and go on to -x.
geometry::TriangleMesh alphaWire() {
  constexpr double kLoop = 0.03, kWire = 0.004, kCrossing = 2.0 * kWire * 2.5, kLeg = 0.05;
  std::vector<dvec3> line;
  const auto at = [&](double s) {  // From -1 to 1 around the loop and over the crossing.
    const double angle = (1.0 - s) * pi;
    return dvec3(0.04 - kLoop * std::cos(angle), kLoop * std::sin(angle), 0.5 * kCrossing * s);
  };
  line.push_back(at(-1.0) + dvec3(-kLeg, -0.02, 0.0));
  for (int i = 0; i <= 48; ++i) line.push_back(at(-1.0 + i / 24.0));
  line.push_back(at(1.0) + dvec3(-kLeg, 0.02, 0.0));
  return tubeAlong(line, kWire, 12);
}

}  // namespace

geometry::TriangleMesh tubeAlong(const std::vector<dvec3>& middle, double radius, int segments) {
  geometry::TriangleMesh mesh;
  const auto count = static_cast<std::uint32_t>(segments);
  dvec3 side(0.0);
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const dvec3 before = middle[i > 0 ? i - 1 : 0], after = middle[std::min(i + 1, middle.size() - 1)];
    const dvec3 along = glm::normalize(after - before);
    if (i == 0) side = std::abs(along.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    side = glm::normalize(side - along * glm::dot(along, side));
    const dvec3 up = glm::cross(along, side);
    for (std::uint32_t k = 0; k < count; ++k) {
      const double angle = 2.0 * pi * k / count;
      mesh.vertices.push_back(middle[i] + radius * (std::cos(angle) * side + std::sin(angle) * up));
    }
    if (i == 0) continue;
    const auto a = static_cast<std::uint32_t>(i - 1) * count, b = a + count;
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t n = (k + 1) % count;
      mesh.triangles.push_back({a + k, a + n, b + n});
      mesh.triangles.push_back({a + k, b + n, b + k});
    }
  }
  const auto last = static_cast<std::uint32_t>(middle.size() - 1) * count;
  for (std::uint32_t k = 1; k + 1 < count; ++k) {
    mesh.triangles.push_back({0, k + 1, k});
    mesh.triangles.push_back({last, last + k, last + k + 1});
  }
  return mesh;
}

AssistedScene extractionScene() {
  AssistedScene scene = sceneOf("extraction exercise", "filter unit", 0.002);
  Diagnostics notes;
  const auto file = config::findShippedFile("exercises/extraction.hcell");
  const auto recording = config::findShippedFile("exercises/extraction-expert.htraj");
  if (!file || !recording) std::exit(2);
  const workcell::Document document = orEnd(workcell::loadDocument(*file, notes));
  scene.entities = document.snapshotEntities();
  scene.pairs = document.state().pairPolicy();
  const trajectory::Trajectory expert = orEnd(trajectory::readTrajectory(*recording));
  scene.X_WG = expert[expert.size() - 1].X_WT;
  scene.goal = planning::goal::ToPose{scene.X_WG};
  scene.scale = scaleFor(expert[0].X_WT, scene.X_WG);
  return scene;
}

AssistedScene wirePuzzleScene() {
  AssistedScene scene = sceneOf("wire puzzle", "wire", 0.0005);
  const dquat half(0.0, 0.0, 0.0, 1.0), quarter = quaternionFromRotationVector({0.5 * pi, 0.0, 0.0});
  const Pose X_WE{{0.11, 0.0, 0.0}, quarter * half};
  scene.entities = {solidOf(1, "fixed wire", alphaWire(), {}, true), solidOf(2, "wire", alphaWire(), X_WE, false)};
  scene.X_WG = {{0.25, 0.0, 0.0}, X_WE.q};
  scene.goal = planning::goal::ToPose{scene.X_WG};
  scene.scale = scaleFor(X_WE, scene.X_WG);
  return scene;
}

AssistedScene bentPipeScene() {
  AssistedScene scene = sceneOf("bent pipe", "pipe", 0.002);
  std::vector<dvec3> line{{-0.10, 0.0, 0.0}, {0.05, 0.0, 0.0}};
  bend(line, {1, 0, 0}, {0, 1, 0}, 0.04);
  line.push_back(line.back() + dvec3(0.0, 0.08, 0.0));
  bend(line, {0, 1, 0}, {0, 0, 1}, 0.04);
  line.push_back(line.back() + dvec3(0.0, 0.0, 0.06));
  const auto box = [&](const std::string& name, const dvec3& size, const dvec3& p) {
    scene.entities.push_back(solidOf(scene.entities.size() + 1, name, geometry::makeBox(size), Pose::translation(p), true));
  };
  box("floor", {0.50, 0.50, 0.02}, {0.0, 0.0, -0.05});
  box("left wall", {0.02, 0.50, 0.40}, {-0.26, 0.0, 0.14});
  box("right wall", {0.02, 0.50, 0.40}, {0.26, 0.0, 0.14});
  box("front wall", {0.54, 0.02, 0.40}, {0.0, -0.26, 0.14});
  box("back wall", {0.54, 0.02, 0.40}, {0.0, 0.26, 0.14});
  box("block", {0.20, 0.14, 0.16}, {-0.10, 0.14, 0.06});
  box("front strut", {0.50, 0.05, 0.04}, {0.0, -0.06, 0.14});
  box("back strut", {0.50, 0.05, 0.04}, {0.0, 0.22, 0.26});
  scene.entities.push_back(solidOf(9, "reservoir", geometry::makeCylinder(0.05, 0.24, 32), Pose::translation({0.19, -0.17, 0.10}), true));
  scene.entities.push_back(solidOf(10, "filter", geometry::makeCylinder(0.04, 0.20, 32), Pose::translation({-0.18, -0.17, 0.08}), true));
  const Pose X_WE = Pose::translation({0.03, -0.06, 0.04});
  scene.entities.push_back(solidOf(11, "pipe", tubeAlong(line, 0.015, 16), X_WE, false));
  scene.X_WG = Pose::translation({0.03, -0.06, 0.50});
  scene.goal = planning::goal::ToPose{scene.X_WG};
  scene.scale = scaleFor(X_WE, scene.X_WG);
  return scene;
}

AssistedScene robotScene(std::uint64_t seed) {
  AssistedScene scene = sceneOf("robot in 80 parts", "robot", 0.005);
  scene.rate_hz = 100.0;  // A step takes 10 ms of a core.
  static const Chain chain = makeChain(200);
  static const std::vector<workcell::Entity> cell = [] {
    std::vector<workcell::Entity> entities{chainRobot(chain)};
    const auto placed = partsAround(chain, 80, 20000);
    const auto mesh = std::make_shared<const geometry::TriangleMesh>(placed.front().mesh);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      entities.push_back(entities.front());
      workcell::Entity& part = entities.back();
      part = {};
      part.id = i + 2;
      part.name = "part" + std::to_string(part.id);
      part.X_WE = placed[i].X_WP;
      part.body = workcell::Solid{mesh};
    }
    return entities;
  }();
  static const auto prepared = manipulation::PreparedScene::prepare(cell, {}, {});
  scene.entities = cell;
  planning::FreeSpace space = orEnd(planning::FreeSpace::create(prepared, 1, {}));
  space.setClearance(scene.clearance);
  std::mt19937_64 random(seed);
  const auto freeJoints = [&] {
    for (;;) {
      planning::EntityConfiguration at = space.present();
      for (double& joint : at.joints) joint = 1.4 * (static_cast<double>(random() >> 11U) * 0x1.0p-52 - 1.0);
      if (space.isFree(at)) return at;
    }
  };
  // Half a metre to a metre and a half of the tool: what a hand would lead it by.
  for (;;) {
    const planning::EntityConfiguration from = freeJoints(), to = freeJoints();
    const Pose X_WT = space.toolAt(from), X_WG = space.toolAt(to);
    const double way = glm::distance(X_WT.p, X_WG.p);
    if (way < 0.5 || way > 1.5 || space.isFree(from, to)) continue;
    scene.entities.front().setJoints(from.joints);
    scene.X_WG = X_WG;
    scene.goal = planning::goal::ToPose{X_WG};
    scene.scale = scaleFor(X_WT, X_WG);
    return scene;
  }
}

}  // namespace hapticell::bench
