// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "workcell/entity/entity.h"

namespace hapticell::app {

/// The name of the icon that stands for an entity in lists.
inline const char* entityIcon(const workcell::Entity& entity) {
  switch (entity.kind) {
    case workcell::EntityKind::kAssembly:
      return "folder";
    case workcell::EntityKind::kMannequin:
      return "mannequin";
    case workcell::EntityKind::kFrame:
      return "frame";
    case workcell::EntityKind::kSolid:
    case workcell::EntityKind::kRobot:
    case workcell::EntityKind::kMechanism:
      break;
  }
  return entity.robot ? "robot" : "cube";
}

}  // namespace hapticell::app
