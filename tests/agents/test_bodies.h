// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "agents/body/clearances.h"
#include "agents/body/moved_body.h"
#include "agents/runner/agent_cell.h"
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

/// A box before a wall that is wider than the box can see round: attraction alone cannot pass. The box, of 0.05 m, begins
/// at the origin; the wall, 0.05 by 0.6 by 0.6 m, is at x = 0.4 m.
inline std::shared_ptr<const AgentCell> boxBeforeWall(bool with_operator, const dvec3& goal = {0.8, 0.0, 0.0}) {
  const auto number = [](double value) { return std::to_string(value); };
  auto task = *AgentTask::parse("cell = \"c\"\nentity = \"box\"\ntime = 30.0\n[goal]\nposition = [" + number(goal.x) +
                                    ", " + number(goal.y) + ", " + number(goal.z) +
                                    "]\n[[agent]]\nwhat = \"goal\"\n" +
                                    (with_operator ? "[[agent]]\nwhat = \"operator\"\nweight = 3.0\n" : ""),
                                "/t.toml");
  auto scene = manipulation::PreparedScene::prepare(
      {loaded("box:0.05,0.05,0.05", 1, "box"),
       loaded("box:0.05,0.6,0.6", 2, "wall", Pose::translation({0.4, 0.0, 0.0}))},
      {}, {});
  return *AgentCell::create(std::move(task), std::move(scene), {});
}

}  // namespace hapticell::agents::test
