// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "manipulation/manipulators/moved_by.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// How an entity is held: choices of the user that override the entity's own.
struct HoldOptions {
  MovedBy moved_by;
  workcell::OnContact on_contact = workcell::OnContact::kSlide;
  workcell::ForceClass force_class = workcell::ForceClass::kContact;
  bool joints_move = false;  ///< Something else moves the entity's joints at the same time: a glove, another hand.
};

}  // namespace hapticell::manipulation
