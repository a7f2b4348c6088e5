// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "workcell/entity/entity.h"

namespace hapticell::app {

/// The name of the icon that stands for an entity in lists.
inline const char* entityIcon(const workcell::Entity& entity) {
  switch (entity.kind()) {
    case workcell::EntityKind::kAssembly:
      return "folder";
    case workcell::EntityKind::kMannequin:
      return "mannequin";
    case workcell::EntityKind::kFrame:
      return "frame";
    case workcell::EntityKind::kRobot:
    case workcell::EntityKind::kMechanism:
      return "robot";
    case workcell::EntityKind::kSolid:
      break;
  }
  return "cube";
}

}  // namespace hapticell::app
