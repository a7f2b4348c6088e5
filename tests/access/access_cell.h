// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "access/removal_scene.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::access {

/// A cell made of solids, for tests.
class AccessCell {
 public:
  workcell::Entity& add(const std::string& name, geometry::TriangleMesh mesh, const dvec3& p_WE, bool locked = false) {
    workcell::Entity entity;
    entity.id = entities_.size() + 1;
    entity.name = name;
    entity.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(std::move(mesh))};
    entity.X_WE.p = p_WE;
    entity.locked = locked;
    entities_.push_back(std::move(entity));
    return entities_.back();
  }
  workcell::Entity& box(const std::string& name, const dvec3& size, const dvec3& p_WE, bool locked = false) {
    return add(name, geometry::makeBox(size), p_WE, locked);
  }

  std::shared_ptr<const manipulation::PreparedScene> scene(std::vector<workcell::PairRule> rules = {}) const {
    return manipulation::PreparedScene::prepare(entities_, workcell::PairPolicy({}, std::move(rules)), {});
  }
  RemovalScene removal(const std::string& part, double tolerance = 1e-4) const {
    auto made = RemovalScene::make(scene(), part, "", tolerance);
    EXPECT_TRUE(made) << made.error().message();
    return std::move(*made);
  }

 private:
  std::vector<workcell::Entity> entities_;
};

/// A block in a box without a lid, open at the top: floor and four walls, locked, with `gap` (m) around a cube of 0.1 m at
/// the origin, and a lid that lies on the walls.
inline AccessCell boxedIn(double gap, bool with_lid) {
  AccessCell cell;
  const double half = 0.05 + gap, wall = 0.02;
  cell.box("block", {0.1, 0.1, 0.1}, {0.0, 0.0, 0.0});
  cell.box("floor", {0.3, 0.3, wall}, {0.0, 0.0, -0.05 - 0.5 * wall}, true);
  cell.box("wall left", {wall, 0.3, 0.1}, {-half - 0.5 * wall, 0.0, 0.0}, true);
  cell.box("wall right", {wall, 0.3, 0.1}, {half + 0.5 * wall, 0.0, 0.0}, true);
  cell.box("wall front", {2.0 * half, wall, 0.1}, {0.0, -half - 0.5 * wall, 0.0}, true);
  cell.box("wall back", {2.0 * half, wall, 0.1}, {0.0, half + 0.5 * wall, 0.0}, true);
  if (with_lid) cell.box("lid", {0.3, 0.3, 0.01}, {0.0, 0.0, 0.055});
  return cell;
}

}  // namespace hapticell::access
