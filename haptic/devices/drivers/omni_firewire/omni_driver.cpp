// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/omni_firewire/omni_driver.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "haptic/devices/device_node.h"
#include "haptic/devices/driver_support.h"

namespace hapticell::driver {

namespace {

constexpr std::uint64_t kIdentity = 0x1006000C, kSerial = 0x10060010;
constexpr std::uint32_t kOmni = 0x000B9900;
constexpr std::uint64_t kChannelOut = 0x1000, kChannelIn = 0x1001, kSwitch = 0x1087, kUnknown = 0x20010;
constexpr std::uint64_t kVendor = 0x000B99;  // Upper 24 bits of the GUID.
constexpr double kLever = 0.135;             // m: a joint's in the middle of the workspace.

std::string guidText(std::uint64_t guid) {
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(guid));
  return text;
}

}  // namespace

std::string startOmni(FireWirePort& port, Problem& problem) {
  const auto identity = port.readQuadlet(kIdentity);
  const auto serial = port.readQuadlet(kSerial);
  if (!identity || !serial || *identity != kOmni) {
    refuse(problem, Status::kGarbled, "it does not answer as a Phantom Omni does", "Switch its power off and on.");
    return {};
  }
  std::uint8_t out = 0, in = 0;
  const bool streams = port.startStreams(out, in);
  constexpr std::array<std::uint8_t, 4> kNeeded{0xF8, 0x0F, 0x00, 0x00};
  const bool told = streams && port.write(kChannelOut, std::array{out}) && port.write(kChannelIn, std::array{in}) &&
                    port.write(kUnknown, kNeeded) && port.write(kSwitch, std::array<std::uint8_t, 1>{0x08});
  if (!told) {
    refuse(problem, Status::kFault, "its streams cannot be started", "Unplug other FireWire devices and try again.");
    return {};
  }
  return omniSerial(*serial);
}

OmniDevice::OmniDevice(std::unique_ptr<FireWirePort> port, const std::string& serial, double newton_metres_per_unit)
    : port_(std::move(port)), newton_metres_per_unit_(newton_metres_per_unit) {
  copyText(capabilities_.name, "Phantom Omni " + serial);
  const double half[3]{0.080, 0.035, 0.060};
  for (int i = 0; i < 3; ++i) {
    capabilities_.workspace_min[i] = -half[i];
    capabilities_.workspace_max[i] = half[i];
  }
  const bool measured = newton_metres_per_unit > 0.0;
  capabilities_.resolution = 0.055e-3;
  capabilities_.measured_axes = 6;
  capabilities_.driven_axes = measured ? 3 : 0;
  capabilities_.buttons = 2;
  capabilities_.peak_force = measured ? std::min(3.3, kMostUsed * newton_metres_per_unit / kLever) : 0.0;
  capabilities_.continuous_force = std::min(0.88, capabilities_.peak_force);
  capabilities_.stiffness = 300.0;
  capabilities_.damping = 2.0;
  capabilities_.rate_hz = 1000.0;
  capabilities_.experimental = true;
}

OmniDevice::~OmniDevice() {
  port_->send(makeOmniPacket(dvec3(0.0), false, false));
  port_->write(kSwitch, std::array<std::uint8_t, 1>{0x00});
}

const char* OmniDevice::calibrationText(std::uint32_t step) const noexcept {
  return step == 0 ? "Put the stylus into its inkwell." : nullptr;
}

void OmniDevice::average(OmniReading& reading) {
  gimbal_[gimbal_count_++ % kMean] = reading.gimbal_ratios;
  const std::size_t count = std::min(gimbal_count_, kMean);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += gimbal_[i][axis];
    reading.gimbal_ratios[axis] = sum / static_cast<double>(count);
  }
}

Status OmniDevice::read(State& state) noexcept {
  const auto packet = port_->receive(1);
  if (!packet)
    return refuse(problem_, Status::kVanished, "it was unplugged, or the bus was reset", "Plug it in again.");
  if (packet->empty()) {
    if (++empty_reads_ < kPatience) return Status::kNothingNew;
    return refuse(problem_, Status::kVanished, "its stream has stopped", "Plug it in again.");
  }
  empty_reads_ = 0;
  auto reading = readOmniPacket(*packet);
  if (!reading) return refuse(problem_, Status::kGarbled, "it sends what is no packet", "Switch its power off and on.");
  average(*reading);
  if (reading->docked) arm_.home(reading->encoders);
  joints_ = arm_.joints(reading->encoders);
  const Pose X_DS = arm_.X_DS(*reading);
  for (int i = 0; i < 3; ++i) state.position[i] = X_DS.p[i];
  state.orientation[0] = X_DS.q.w, state.orientation[1] = X_DS.q.x;
  state.orientation[2] = X_DS.q.y, state.orientation[3] = X_DS.q.z;
  state.buttons = (reading->button1 ? 1u : 0u) | (reading->button2 ? 2u : 0u);
  state.flags = (arm_.isHomed() ? kCalibrated : 0u) | (reading->docked ? kDocked : 0u);
  return Status::kOk;
}

Status OmniDevice::write(const Command& command) noexcept {
  const bool may = command.motors && arm_.isHomed() && newton_metres_per_unit_ > 0.0;
  // The maker's driver switches the motors on, off and on again to arm them.
  arming_ = may ? std::min(arming_ + 1, 3) : 0;
  const bool motors = arming_ == 1 || arming_ == 3;
  dvec3 commands(0.0);
  if (arming_ == 3) {
    const dvec3 torques = arm_.torques(joints_, {command.force[0], command.force[1], command.force[2]});
    commands = kMostUsed * omniCommands(torques, kMostUsed * newton_metres_per_unit_);
  }
  port_->send(makeOmniPacket(commands, motors, command.light));
  return Status::kOk;
}

void OmniDriver::configure(const char* key, const char* value) noexcept {
  if (std::string_view(key) != "newtons_per_unit") return;
  double newtons = 0.0;
  const char* const end = value + std::strlen(value);
  if (std::from_chars(value, end, newtons).ptr == end && newtons > 0.0 && newtons < 20.0) newtons_per_unit_ = newtons;
}

std::uint32_t OmniDriver::find(Found* found, std::uint32_t room, Problem& problem) noexcept {
  std::uint32_t count = 0;
  for (const FireWireNode& node : bus_->nodes(problem)) {
    if (node.guid >> 40 != kVendor) continue;
    if (count < room) {
      Found& entry = found[count];
      copyText(entry.id, guidText(node.guid));
      copyText(entry.name, "Phantom Omni (FireWire)");
      copyText(entry.place, node.place);
      entry.problem = nodeProblem(node.place);
    }
    ++count;
  }
  return count;
}

Device* OmniDriver::open(const char* id, Problem& problem) noexcept {
  for (const FireWireNode& node : bus_->nodes(problem)) {
    if (node.guid >> 40 != kVendor || (*id != '\0' && guidText(node.guid) != id)) continue;
    auto port = bus_->open(node, problem);
    if (port == nullptr) return nullptr;
    const std::string serial = startOmni(*port, problem);
    if (serial.empty()) return nullptr;
    return new OmniDevice(std::move(port), serial, newtons_per_unit_ * kLever);
  }
  if (problem.status == Status::kOk) {
    refuse(problem, Status::kNotFound, "no Phantom Omni is on a FireWire bus",
           "Plug it in; its power comes over the cable or an adapter.");
  }
  return nullptr;
}

void OmniDriver::close(Device* device) noexcept {
  delete static_cast<OmniDevice*>(device);
}

}  // namespace hapticell::driver
