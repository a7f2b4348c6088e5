// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "manipulation/manipulators/moved_by.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// Choices of the user that override the entity's own.
struct HoldOptions {
  MovedBy moved_by;
  workcell::OnContact on_contact = workcell::OnContact::kSlide;
  workcell::ForceClass force_class = workcell::ForceClass::kContact;
};

}  // namespace hapticell::manipulation
