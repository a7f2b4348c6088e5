// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/virtual_desktop/devices/free_axes.h"
#include "manipulation/engine/manipulation_command.h"

namespace hapticell::app {

/// What the user chose in the Virtual Desktop panel. A value; the controller turns changes into commands.
struct VirtualDesktopSettings {
  workcell::EntityId entity = 0;   ///< 0: whatever the tip touches.
  manipulation::MovedBy moved_by;  ///< The way and its frame; HoldChoice has the other options.
  manipulation::AxesMode axes = manipulation::AxesMode::kScreen;
  manipulation::ScaleLevel scale = manipulation::ScaleLevel::kMedium;
  workcell::OnContact on_contact = workcell::OnContact::kSlide;
  workcell::ForceClass force_class = workcell::ForceClass::kContact;
  FreeAxes free;
  std::string axes_frame;  ///< For axes of kFrame: an entity's name.
  std::string against;     ///< The only pair set that applies; empty: all that are switched on.
};

}  // namespace hapticell::app
