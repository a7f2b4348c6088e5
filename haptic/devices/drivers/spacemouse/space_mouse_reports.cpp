// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/spacemouse/space_mouse_reports.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hapticell::driver {

namespace {

constexpr double kFull = 350.0;  // Counts of full deflection.
constexpr double kDead = 3.0;    // Counts at rest that are no motion.

constexpr std::array<SpaceMouseModel, 22> kModels{{
    {0x046d, 0xc603, "SpaceMouse Plus XT", 11},
    {0x046d, 0xc605, "CADman", 4},
    {0x046d, 0xc606, "SpaceMouse Classic", 11},
    {0x046d, 0xc621, "SpaceBall 5000", 12},
    {0x046d, 0xc623, "SpaceTraveler", 8},
    {0x046d, 0xc625, "SpacePilot", 21},
    {0x046d, 0xc626, "SpaceNavigator", 2},
    {0x046d, 0xc627, "SpaceExplorer", 15},
    {0x046d, 0xc628, "SpaceNavigator for Notebooks", 2},
    {0x046d, 0xc629, "SpacePilot Pro", 31},
    {0x046d, 0xc62b, "SpaceMouse Pro", 15},
    {0x046d, 0xc640, "NuLOOQ", 5},
    {0x256f, 0xc62e, "SpaceMouse Wireless (cable)", 2},
    {0x256f, 0xc62f, "SpaceMouse Wireless", 2},
    {0x256f, 0xc631, "SpaceMouse Pro Wireless (cable)", 15},
    {0x256f, 0xc632, "SpaceMouse Pro Wireless", 15},
    {0x256f, 0xc633, "SpaceMouse Enterprise", 31},
    {0x256f, 0xc635, "SpaceMouse Compact", 2},
    {0x256f, 0xc636, "SpaceMouse Module", 2},
    {0x256f, 0xc638, "SpaceMouse Pro Wireless Bluetooth", 15},
    {0x256f, 0xc63a, "SpaceMouse Wireless Bluetooth", 2},
    {0x256f, 0xc652, "3Dconnexion universal receiver", 15},
}};

constexpr std::array<std::uint16_t, 11> kOthers{0xc650, 0xc651, 0xc654, 0xc655, 0xc656, 0xc657,
                                                0xc658, 0xc664, 0xc665, 0xc668, 0xc62c};

/// Axis `i` of those that begin behind the report's id.
double axis(std::span<const std::uint8_t> report, std::size_t i) {
  const auto raw = static_cast<std::int16_t>(report[1 + 2 * i] | (report[2 + 2 * i] << 8));
  if (std::abs(raw) <= kDead) return 0.0;
  return std::clamp(raw / kFull, -1.0, 1.0);
}

/// Half a turn about x: the mouse's y is to the user and its z down, D's away and up.
void takeAxes(std::span<const std::uint8_t> report, std::size_t from, double* to) {
  to[0] = axis(report, from);
  to[1] = -axis(report, from + 1);
  to[2] = -axis(report, from + 2);
  for (int i = 0; i < 3; ++i) to[i] += 0.0;  // No minus zero.
}

}  // namespace

Status takeSpaceMouseReport(std::span<const std::uint8_t> report, SpaceMouseState& state) {
  state.moved = false;
  if (report.empty()) return Status::kGarbled;
  switch (report[0]) {
    case 1:
    case 2: {
      if (report.size() < 7) return Status::kGarbled;
      const bool six = report[0] == 1 && report.size() >= 13;
      takeAxes(report, 0, report[0] == 2 ? state.motion + 3 : state.motion);
      if (six) takeAxes(report, 3, state.motion + 3);
      state.moved = true;
      return Status::kOk;
    }
    case 3: {
      if (report.size() < 2) return Status::kGarbled;
      state.buttons = 0;
      for (std::size_t i = 1; i < std::min<std::size_t>(report.size(), 5); ++i) {
        state.buttons |= static_cast<std::uint32_t>(report[i]) << (8 * (i - 1));
      }
      return Status::kOk;
    }
    default:
      return Status::kNothingNew;
  }
}

const SpaceMouseModel* findSpaceMouseModel(std::uint16_t vendor, std::uint16_t product) {
  const auto* const found = std::find_if(kModels.begin(), kModels.end(), [&](const SpaceMouseModel& model) {
    return model.vendor == vendor && model.product == product;
  });
  return found != kModels.end() ? found : nullptr;
}

bool isOtherThanSpaceMouse(std::uint16_t vendor, std::uint16_t product) {
  return vendor == 0x256f && std::find(kOthers.begin(), kOthers.end(), product) != kOthers.end();
}

}  // namespace hapticell::driver
