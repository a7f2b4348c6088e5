// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/spacemouse/space_mouse_driver.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "haptic/devices/device_node.h"
#include "haptic/devices/driver_support.h"

namespace hapticell::driver {

namespace {

// Reports of one read(): a burst is taken as a whole. Half: two reads; twice: nothing changes, more never come in a
// millisecond.
constexpr int kMostReports = 32;

std::string idOf(const HidInfo& info) {
  return info.serial.empty() ? info.path : info.serial;
}

}  // namespace

SpaceMouseDevice::SpaceMouseDevice(std::unique_ptr<HidPort> port, const char* name, const SpaceMouseModel* model,
                                   HidLayout layout)
    : port_(std::move(port)), model_(model), layout_(std::move(layout)) {
  capabilities_.kind = Kind::kSpaceMouse;
  copyText(capabilities_.name, name);
  capabilities_.measured_axes = 6;
  capabilities_.buttons = std::min(model != nullptr ? model->buttons : 2u, 32u);
  capabilities_.rate_hz = 125.0;
  setLight(true);
}

SpaceMouseDevice::~SpaceMouseDevice() {
  setLight(false);
}

bool SpaceMouseDevice::setLight(bool on) {
  light_ = on;
  return port_->write(std::to_array<std::uint8_t>({4, static_cast<std::uint8_t>(on ? 1 : 0)}));
}

Status SpaceMouseDevice::read(State& state) noexcept {
  std::array<std::uint8_t, 64> report{};
  Status status = Status::kNothingNew;
  for (int i = 0; i < kMostReports; ++i) {
    const int length = port_->read(report, i == 0 ? 1 : 0);
    if (length < 0) return refuse(problem_, Status::kVanished, "it was unplugged", "Plug it in again.");
    if (length == 0) break;
    const Status taken =
        takeSpaceMouseReport(std::span(report).first(static_cast<std::size_t>(length)), state_, model_, &layout_);
    if (taken == Status::kGarbled) {
      status = refuse(problem_, Status::kGarbled, "a report of " + std::to_string(length) + " bytes is too short");
    } else if (taken == Status::kOk) {
      status = Status::kOk;
    }
    if (state_.moved) empty_reads_ = 0;
  }
  const bool deflected = std::any_of(state_.motion, state_.motion + 6, [](double m) { return m != 0.0; });
  if (status == Status::kNothingNew && deflected && ++empty_reads_ >= kPatience) {
    std::fill_n(state_.motion, 6, 0.0);
    status = Status::kOk;
  }
  std::copy_n(state_.motion, 6, state.motion);
  state.buttons = state_.buttons;
  state.flags = kCalibrated;
  return status;
}

Status SpaceMouseDevice::write(const Command& command) noexcept {
  if (command.light != light_) setLight(command.light);
  return Status::kOk;
}

std::vector<HidInfo> SpaceMouseDriver::mice() {
  std::vector<HidInfo> all = hid_->list();
  std::erase_if(all, [](const HidInfo& info) {
    if (isOtherThanSpaceMouse(info.vendor, info.product)) return true;
    // A multi-axis controller (usage 8 of the generic desktop) where the report descriptor is told, else by the ids.
    const bool axes = info.usage_page == 1 && info.usage == 8;
    const bool untold = info.usage_page == 0;
    const bool known = findSpaceMouseModel(info.vendor, info.product) != nullptr;
    return !((known && (axes || untold)) || (info.vendor == 0x256f && axes));
  });
  return all;
}

std::uint32_t SpaceMouseDriver::find(Found* found, std::uint32_t room, Problem&) noexcept {
  const std::vector<HidInfo> seen = mice();
  if (daemon_ != nullptr && daemon_->isRunning()) {
    // What it has open is not offered a second time; one that only it can see, on a serial line, it tells itself.
    const std::string own = seen.empty() ? daemon_->deviceName() : std::string();
    if (seen.empty() && own.empty()) return 0;
    if (room == 0) return 1;
    const SpaceMouseModel* const model =
        seen.empty() ? nullptr : findSpaceMouseModel(seen.front().vendor, seen.front().product);
    found[0].kind = Kind::kSpaceMouse;
    copyText(found[0].id, kSpacenavId);
    if (model != nullptr)
      copyText(found[0].name, model->name);
    else
      copyText(found[0].name, seen.empty() ? own : seen.front().name);
    copyText(found[0].place, daemon_->place());
    return 1;
  }
  std::uint32_t count = 0;
  for (const HidInfo& info : seen) {
    if (count < room) {
      Found& entry = found[count];
      const SpaceMouseModel* const model = findSpaceMouseModel(info.vendor, info.product);
      entry.kind = Kind::kSpaceMouse;
      copyText(entry.id, idOf(info));
      copyText(entry.name, model != nullptr ? model->name : info.name);
      copyText(entry.place, info.path);
      entry.problem = nodeProblem(info.path);
    }
    ++count;
  }
  return count;
}

/// The daemon's, wherever it runs: what was chosen by its serial number before is among what it reads.
Device* SpaceMouseDriver::open(const char* id, Problem& problem) noexcept {
  if (daemon_ != nullptr && daemon_->isRunning()) {
    if (auto port = daemon_->open(problem)) {
      problem = {};
      return new SpacenavDevice(std::move(port));
    }
    if (std::string_view(id) == kSpacenavId) return nullptr;
  }
  return openDirect(std::string_view(id) == kSpacenavId ? std::string_view() : std::string_view(id), problem);
}

Device* SpaceMouseDriver::openDirect(std::string_view wanted, Problem& problem) {
  const std::vector<HidInfo> all = mice();
  // One without a serial number is known by its file, which has another name when it was plugged in again.
  const bool is_there = std::any_of(all.begin(), all.end(),
                                    [&](const HidInfo& info) { return wanted == idOf(info) || wanted == info.path; });
  if (!is_there && wanted.starts_with('/')) wanted = {};
  for (const HidInfo& info : all) {
    if (!wanted.empty() && wanted != idOf(info) && wanted != info.path) continue;
    auto port = hid_->open(info.path, problem);
    if (port == nullptr) {
      if (wanted.empty()) continue;
      return nullptr;
    }
    problem = {};
    const SpaceMouseModel* const model = findSpaceMouseModel(info.vendor, info.product);
    return new SpaceMouseDevice(std::move(port), model != nullptr ? model->name : info.name.c_str(), model,
                                HidLayout::parse(hid_->descriptor(info.path)));
  }
  if (problem.status == Status::kOk) {
    refuse(problem, Status::kNotFound, "no 3-D mouse is plugged in", "Plug it in, or charge it and switch it on.");
  }
  return nullptr;
}

void SpaceMouseDriver::close(Device* device) noexcept {
  delete static_cast<OwnedMouse*>(device);
}

std::uint64_t SpaceMouseDriver::presence() noexcept {
  PresenceNumber number;
  if (daemon_ != nullptr) number.add(daemon_->trace());
  for (const HidInfo& info : mice()) {
    number.add(idOf(info));
    number.add(info.path);
    number.add(static_cast<std::uint32_t>(nodeProblem(info.path).status));
  }
  return number.value();
}

}  // namespace hapticell::driver
