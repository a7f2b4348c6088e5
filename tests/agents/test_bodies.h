// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "agents/body/clearances.h"
#include "agents/body/moved_body.h"
#include "kinematics/model/robot_model.h"
#include "manipulation/scene/prepared_scene.h"
#include "workcell/import/entity_source.h"

namespace hapticell::agents::test {

inline workcell::Entity loaded(const std::string& what, workcell::EntityId id, const std::string& name,
                               const Pose& X_WE = {}) {
  workcell::EntityLoader loader("/");
  Diagnostics notes;
  workcell::Entity entity = *loader.load(what, 0.0, notes);
  entity.id = id;
  entity.name = name;
  entity.X_WE = X_WE;
  if (entity.robot() && entity.joints().empty()) entity.setJoints(kinematics::restPositions(*entity.robot()));
  return entity;
}

inline workcell::Entity arm() {
  workcell::Entity entity = loaded("library:ur5e", 1, "robot");
  entity.setJoints({0.3, -1.2, 1.4, -1.6, -1.3, 0.2});
  return entity;
}

inline std::unique_ptr<MovedBody> bodyOf(const workcell::Entity& entity, const std::string& moved_by = "") {
  return std::move(*MovedBody::create(entity, moved_by));
}

}  // namespace hapticell::agents::test
