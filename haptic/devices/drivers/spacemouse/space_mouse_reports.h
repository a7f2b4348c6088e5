// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// What a 3-D mouse's reports have said so far, in D's axes.
struct SpaceMouseState {
  double motion[6] = {};  ///< Of full deflection, -1 .. 1: right, away, up; turning about the same.
  std::uint32_t buttons = 0;
  bool moved = false;  ///< The last report was one of motion.
};

/// Takes one report, its id first. Layouts (seen on the models of facts that PySpaceMouse and VRPN list): id 1 with 13
/// bytes or more is all six axes, id 1 and 2 with 7 or more are translation and rotation, id 3 button bits; axes are
/// int16, little-endian, about 350 at full deflection, x right, y to the user, z down. Ids that are not known are
/// ignored. kOk, kNothingNew for an ignored one, kGarbled for one that is too short; the state is then as it was.
Status takeSpaceMouseReport(std::span<const std::uint8_t> report, SpaceMouseState& state);

/// A model's name and how many buttons it has.
struct SpaceMouseModel {
  std::uint16_t vendor, product;
  const char* name;
  std::uint32_t buttons;
};

/// The model, or null. What shares the maker's ids and is no 3-D mouse (CadMouse, keyboards, receivers) is not listed.
const SpaceMouseModel* findSpaceMouseModel(std::uint16_t vendor, std::uint16_t product);

/// True for a device that is no 3-D mouse though its maker makes them.
bool isOtherThanSpaceMouse(std::uint16_t vendor, std::uint16_t product);

}  // namespace hapticell::driver
