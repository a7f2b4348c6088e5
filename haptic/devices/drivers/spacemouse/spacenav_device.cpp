// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/spacemouse/spacenav_device.h"

#include <algorithm>
#include <array>

#include "haptic/devices/driver_support.h"

namespace hapticell::driver {

namespace {

constexpr double kSpacenavFull = 500.0;  // What spacenavd brings every mouse's range to.
// Events of one read(): a burst is taken as a whole. Half: two reads; twice: nothing changes, more never come in a
// millisecond.
constexpr int kMostEvents = 64;

}  // namespace

SpacenavDevice::SpacenavDevice(std::unique_ptr<SpacenavPort> port) : port_(std::move(port)) {
  capabilities_.kind = Kind::kSpaceMouse;
  const std::string name = port_->deviceName();
  copyText(capabilities_.name, name.empty() ? std::string("3-D mouse (spacenavd)") : name);
  capabilities_.measured_axes = 6;
  capabilities_.buttons = std::min(port_->buttons(), 32u);
  capabilities_.rate_hz = 125.0;
  state_.flags = kCalibrated;
}

void SpacenavDevice::take(const SpacenavEvent& event) {
  if (event.motion) {
    constexpr std::array<std::size_t, 6> kFrom{0, 2, 1, 3, 5, 4};  // D: right, away, up.
    for (std::size_t i = 0; i < 6; ++i) state_.motion[i] = std::clamp(event.axes[kFrom[i]] / kSpacenavFull, -1.0, 1.0);
  } else if (event.button >= 0 && event.button < 32) {
    const std::uint32_t bit = 1u << event.button;
    state_.buttons = event.pressed ? state_.buttons | bit : state_.buttons & ~bit;
  }
}

Status SpacenavDevice::read(State& state) noexcept {
  Status status = Status::kNothingNew;
  for (int i = 0; i < kMostEvents; ++i) {
    SpacenavEvent event;
    const int got = port_->next(event, i == 0 ? 1 : 0);
    if (got < 0) return refuse(problem_, Status::kVanished, "spacenavd has ended", "Start spacenavd, or plug it in.");
    if (got == 0) break;
    take(event);
    status = Status::kOk;
  }
  std::copy_n(state_.motion, 6, state.motion);
  state.buttons = state_.buttons;
  state.flags = state_.flags;
  return status;
}

}  // namespace hapticell::driver
