// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstdint>
#include <span>

#include "haptic/devices/driver_interface.h"
#include "haptic/devices/drivers/spacemouse/hid_layout.h"

namespace hapticell::driver {

/// Which way a mouse's second and third axis point; its first is to the user's right.
enum class MouseAxes : std::uint8_t {
  kToUserAndDown,  ///< Y to the user, Z down: all of today.
  kUpAndAway,      ///< Y up, Z away from the user: Plus XT, Classic and NuLOOQ.
};

/// How a mouse numbers its keys.
enum class MouseKeys : std::uint8_t {
  kAsTold,      ///< Usage n is button n - 1.
  kPro,         ///< 15 keys with gaps,
  kEnterprise,  ///< 31 of them, nine of which come in a list: report 28.
};

/// A model's name and how many buttons it has.
struct SpaceMouseModel {
  std::uint16_t vendor, product;
  const char* name;
  std::uint32_t buttons;
  MouseAxes axes = MouseAxes::kToUserAndDown;
  MouseKeys keys = MouseKeys::kAsTold;
};

/// What a 3-D mouse's reports have said so far, in D's axes.
struct SpaceMouseState {
  double motion[6] = {};  ///< Of full deflection, -1 .. 1: right, away, up; turning about the same.
  std::uint32_t buttons = 0;
  bool moved = false;                  ///< The last report was one of motion.
  std::bitset<256> keys, listed_keys;  ///< By usage, as bits and as a list have told them.
};

/// Takes one report, its id first. Where a `layout` states all six axes (the device's own report descriptor), it says
/// what stands where, and what full deflection is. Else by the layouts that PySpaceMouse and VRPN list: id 1 with 13
/// bytes or more is all six axes, id 1 and 2 with 7 or more are translation and rotation, id 3 button bits, id 28 a
/// list of six usages of keys; axes are int16, little-endian, 350 at full deflection. Which way axes point and how keys
/// are numbered is the `model`'s (null: as today's). Ids that are not known are ignored. kOk, kNothingNew for an
/// ignored one, kGarbled for one that is too short; the state is then as it was.
Status takeSpaceMouseReport(std::span<const std::uint8_t> report, SpaceMouseState& state,
                            const SpaceMouseModel* model = nullptr, const HidLayout* layout = nullptr);

/// The model, or null. What shares the maker's ids and is no 3-D mouse (CadMouse, keyboards, receivers) is not listed.
const SpaceMouseModel* findSpaceMouseModel(std::uint16_t vendor, std::uint16_t product);

/// True for a device that is no 3-D mouse though its maker makes them.
bool isOtherThanSpaceMouse(std::uint16_t vendor, std::uint16_t product);

}  // namespace hapticell::driver
