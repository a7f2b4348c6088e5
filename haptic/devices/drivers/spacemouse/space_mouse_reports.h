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
  kToUserAndDown,  ///< Y to the user, Z down: all current models.
  kUpAndAway,      ///< Y up, Z away from the user: Plus XT, Classic and NuLOOQ.
};

/// How a mouse numbers its keys.
enum class MouseKeys : std::uint8_t {
  kAsReported,  ///< Usage n is button n - 1.
  kPro,         ///< 15 keys with gaps,
  kEnterprise,  ///< 31 keys, nine of which are sent as a list: report 28.
};

/// A model's name and how many buttons it has.
struct SpaceMouseModel {
  std::uint16_t vendor, product;
  const char* name;
  std::uint32_t buttons;
  MouseAxes axes = MouseAxes::kToUserAndDown;
  MouseKeys keys = MouseKeys::kAsReported;
};

/// State of a 3D mouse after its reports so far, in D's axes.
struct SpaceMouseState {
  double motion[6] = {};  ///< Share of full deflection, -1 .. 1: right, away, up; rotation about the same axes.
  std::uint32_t buttons = 0;
  bool moved = false;                  ///< The last report contained motion.
  std::bitset<256> keys, listed_keys;  ///< By usage: from bits, and from a list.
};

/// Takes one report, its id first. If `layout` (the device's report descriptor) has all six axes, it defines the
/// positions of the values and full deflection. Else the layouts of PySpaceMouse and VRPN are used: id 1 with 13 bytes
/// or more is all six axes, id 1 and 2 with 7 or more are translation and rotation, id 3 button bits, id 28 a list of
/// six usages of keys; axes are int16, little-endian, 350 at full deflection. The `model` defines the directions of the
/// axes and the numbers of the keys (null: as current models). Unknown ids are ignored. Returns kOk, kNothingNew for an
/// ignored report, or kGarbled for a report that is too short; the state is then unchanged.
Status takeSpaceMouseReport(std::span<const std::uint8_t> report, SpaceMouseState& state,
                            const SpaceMouseModel* model = nullptr, const HidLayout* layout = nullptr);

/// The model, or null. Devices with the maker's ids that are not 3D mice (CadMouse, keyboards, receivers) are not
/// listed.
const SpaceMouseModel* findSpaceMouseModel(std::uint16_t vendor, std::uint16_t product);

/// True for a device of a maker of 3D mice that is not one itself.
bool isOtherThanSpaceMouse(std::uint16_t vendor, std::uint16_t product);

}  // namespace hapticell::driver
