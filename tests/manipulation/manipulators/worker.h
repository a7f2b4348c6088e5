// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "geometry/shapes/shapes.h"
#include "manipulation/scene/prepared_scene.h"
#include "mannequin/shape/figure_model.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation::test {

/// A median man in a posture of the library; all of them share one model.
inline workcell::Entity worker(const char* posture) {
  static const workcell::Entity loaded = [] {
    Diagnostics diagnostics;
    return *workcell::EntityLoader(".").load("mannequin:male:50", 1.0, diagnostics);
  }();
  workcell::Entity entity = loaded;
  entity.id = 7;
  entity.name = "worker";
  const auto model = mannequin::toModel(*entity.figure(), *mannequin::libraryPosture(*entity.figure(), posture));
  entity.X_WE = model.X_WE;
  entity.setJoints(model.joints);
  return entity;
}

inline workcell::Entity box(workcell::EntityId id, const char* name, const dvec3& size, const dvec3& p_W) {
  workcell::Entity entity;
  entity.id = id;
  entity.name = name;
  entity.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(geometry::makeBox(size))};
  entity.X_WE.p = p_W;
  return entity;
}

/// A cell with worker() and others, whose meshes are prepared once a program: they take seconds.
inline std::shared_ptr<const PreparedScene> workerScene(std::vector<workcell::Entity> entities,
                                                        workcell::PairPolicy pairs = {}) {
  static const auto prepared = PreparedScene::prepare({worker("standing")}, {}, {});
  return PreparedScene::prepare(std::move(entities), std::move(pairs), {}, prepared.get());
}

}  // namespace hapticell::manipulation::test
