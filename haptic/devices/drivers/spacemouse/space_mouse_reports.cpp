// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/spacemouse/space_mouse_reports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hapticell::driver {

namespace {

// Counts of full deflection (PySpaceMouse, spacenavd). Half: full speed at half of the way; twice: half speed at full.
constexpr double kFull = 350.0;
// Counts of full deflection that a descriptor may say: far above the 350 or 500 of mice, far below the 32,767 of
// emulations. Half and twice part them as well.
constexpr double kMostFull = 2000.0;
// Counts at rest that are no motion: 1 % of full. Half: a mouse that does not come back to zero drifts; twice: the
// gentlest push is not felt.
constexpr double kDead = 3.0;
constexpr std::uint8_t kListReport = 0x1C;

constexpr auto kOlder = MouseAxes::kUpAndAway;
constexpr auto kNewer = MouseAxes::kToUserAndDown;
constexpr auto kPro = MouseKeys::kPro;

constexpr std::array<SpaceMouseModel, 22> kModels{{
    {0x046d, 0xc603, "SpaceMouse Plus XT", 11, kOlder},
    {0x046d, 0xc605, "CADman", 4},
    {0x046d, 0xc606, "SpaceMouse Classic", 11, kOlder},
    {0x046d, 0xc621, "SpaceBall 5000", 12},
    {0x046d, 0xc623, "SpaceTraveler", 8},
    {0x046d, 0xc625, "SpacePilot", 21},
    {0x046d, 0xc626, "SpaceNavigator", 2},
    {0x046d, 0xc627, "SpaceExplorer", 15},
    {0x046d, 0xc628, "SpaceNavigator for Notebooks", 2},
    {0x046d, 0xc629, "SpacePilot Pro", 31},
    {0x046d, 0xc62b, "SpaceMouse Pro", 15, kNewer, kPro},
    {0x046d, 0xc640, "NuLOOQ", 5, kOlder},
    {0x256f, 0xc62e, "SpaceMouse Wireless (cable)", 2},
    {0x256f, 0xc62f, "SpaceMouse Wireless", 2},
    {0x256f, 0xc631, "SpaceMouse Pro Wireless (cable)", 15, kNewer, kPro},
    {0x256f, 0xc632, "SpaceMouse Pro Wireless", 15, kNewer, kPro},
    {0x256f, 0xc633, "SpaceMouse Enterprise", 31, kNewer, MouseKeys::kEnterprise},
    {0x256f, 0xc635, "SpaceMouse Compact", 2},
    {0x256f, 0xc636, "SpaceMouse Module", 2},
    {0x256f, 0xc638, "SpaceMouse Pro Wireless Bluetooth", 15, kNewer, kPro},
    {0x256f, 0xc63a, "SpaceMouse Wireless Bluetooth", 2},
    {0x256f, 0xc652, "3Dconnexion universal receiver", 15, kNewer, kPro},
}};

constexpr std::array<std::uint16_t, 11> kOthers{0xc650, 0xc651, 0xc654, 0xc655, 0xc656, 0xc657,
                                                0xc658, 0xc664, 0xc665, 0xc668, 0xc62c};

// Usages of the buttons by number, the numbers that spacenavd gives them, so that both ways in tell the same. 1 2 3 4
// menu fit T R F roll lock esc alt shift ctrl.
constexpr std::array<std::uint8_t, 15> kProKeys{13, 14, 15, 16, 1, 2, 3, 5, 6, 9, 27, 23, 24, 25, 26};
// 1 .. 12, menu fit T R F roll, esc alt shift ctrl lock, enter delete tab space, V1 V2 V3, ISO.
constexpr std::array<std::uint8_t, 31> kEnterpriseKeys{13, 14, 15, 16,  17,  18,  19,  20,  21, 22, 77,
                                                       78, 1,  2,  3,   5,   6,   9,   23,  24, 25, 26,
                                                       27, 36, 37, 175, 176, 103, 104, 105, 11};

std::uint32_t buttonsOf(const SpaceMouseState& state, MouseKeys numbering) {
  const std::bitset<256> keys = state.keys | state.listed_keys;
  std::uint32_t buttons = 0;
  const auto number = [&](std::span<const std::uint8_t> usages) {
    for (std::size_t i = 0; i < usages.size(); ++i) {
      if (keys[usages[i]]) buttons |= 1u << i;
    }
  };
  if (numbering == MouseKeys::kPro)
    number(kProKeys);
  else if (numbering == MouseKeys::kEnterprise)
    number(kEnterpriseKeys);
  else
    for (std::size_t usage = 1; usage <= 32; ++usage) buttons |= keys[usage] ? 1u << (usage - 1) : 0u;
  return buttons;
}

/// One axis as the mouse tells it, 0 .. 5, into D's axes.
void takeAxis(std::size_t axis, double counts, double full, MouseAxes axes, SpaceMouseState& state) {
  const double value = std::abs(counts) <= kDead * full / kFull ? 0.0 : std::clamp(counts / full, -1.0, 1.0);
  const std::size_t kind = axis / 3 * 3, i = axis % 3;
  if (axes == MouseAxes::kUpAndAway)
    state.motion[kind + (i == 0 ? 0 : 3 - i)] = value;
  else
    state.motion[axis] = i == 0 ? value : 0.0 - value;  // Half a turn about x. No minus zero.
}

std::int16_t word(std::span<const std::uint8_t> report, std::size_t at) {
  return static_cast<std::int16_t>(report[at] | (report[at + 1] << 8));
}

Status takeKnown(std::span<const std::uint8_t> report, MouseAxes axes, SpaceMouseState& state) {
  switch (report[0]) {
    case 1:
    case 2: {
      if (report.size() < 7) return Status::kGarbled;
      const std::size_t first = report[0] == 2 ? 3 : 0, count = report[0] == 1 && report.size() >= 13 ? 6 : 3;
      for (std::size_t i = 0; i < count; ++i) takeAxis(first + i, word(report, 1 + 2 * i), kFull, axes, state);
      state.moved = true;
      return Status::kOk;
    }
    case 3: {
      if (report.size() < 2) return Status::kGarbled;
      state.keys.reset();
      for (std::size_t usage = 1; usage <= 32 && (usage - 1) / 8 + 1 < report.size(); ++usage) {
        state.keys[usage] = (report[(usage - 1) / 8 + 1] >> ((usage - 1) % 8) & 1) != 0;
      }
      return Status::kOk;
    }
    case kListReport: {
      if (report.size() < 3) return Status::kGarbled;
      state.listed_keys.reset();
      for (std::size_t at = 1; at + 1 < report.size(); at += 2) {
        const auto usage = static_cast<std::uint16_t>(word(report, at));
        if (usage > 0 && usage < state.listed_keys.size()) state.listed_keys.set(usage);
      }
      return Status::kOk;
    }
    default:
      return Status::kNothingNew;
  }
}

double fullOf(const HidField& field) {
  return field.high > 0 && field.high <= kMostFull ? field.high : kFull;
}

Status takeByLayout(std::span<const std::uint8_t> report, const HidLayout& layout, MouseAxes axes,
                    SpaceMouseState& state) {
  SpaceMouseState next = state;
  const std::uint8_t id = layout.hasReportIds() ? report[0] : std::uint8_t{0};
  bool any = false, bits = false, list = false;
  for (const HidField& field : layout.fields()) {
    const bool axis = field.page == HidLayout::kDesktop && !field.array && field.usage >= HidLayout::kFirstAxis &&
                      field.usage < HidLayout::kFirstAxis + 6;
    const bool key = field.page == HidLayout::kButtons;
    if (field.report != id || !(axis || key)) continue;
    std::int32_t value = 0;
    if (!layout.read(field, report, value)) {
      // Of keys a device may tell only those that it has.
      if (axis || !any) return Status::kGarbled;
      continue;
    }
    any = true;
    if (axis) {
      takeAxis(field.usage - HidLayout::kFirstAxis, value, fullOf(field), axes, next);
      next.moved = true;
    } else if (field.array) {
      if (!std::exchange(list, true)) next.listed_keys.reset();
      const std::int64_t usage = std::int64_t{field.usage} + value - field.low;
      if (value != 0 && usage > 0 && usage < 256) next.listed_keys.set(static_cast<std::size_t>(usage));
    } else {
      if (!std::exchange(bits, true)) next.keys.reset();
      if (field.usage < 256) next.keys[field.usage] = value != 0;
    }
  }
  if (!any) return Status::kNothingNew;
  state = next;
  return Status::kOk;
}

}  // namespace

Status takeSpaceMouseReport(std::span<const std::uint8_t> report, SpaceMouseState& state, const SpaceMouseModel* model,
                            const HidLayout* layout) {
  state.moved = false;
  if (report.empty()) return Status::kGarbled;
  const MouseAxes axes = model != nullptr ? model->axes : MouseAxes::kToUserAndDown;
  const bool stated = layout != nullptr && layout->statesAxes();
  const Status status = stated ? takeByLayout(report, *layout, axes, state) : takeKnown(report, axes, state);
  if (status == Status::kOk) state.buttons = buttonsOf(state, model != nullptr ? model->keys : MouseKeys::kAsReported);
  return status;
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
