// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/falcon/falcon_driver.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/falcon/falcon_arm.h"
#include "haptic/devices/drivers/falcon/falcon_firmware.h"

namespace hapticell::driver {

namespace {

constexpr double kMotorPerTorque = -10000.0;  // Motor numbers a N m, and the motors' sense.
constexpr double kMostMotor = 4096.0;
constexpr std::uint16_t kVendor = 0x0403, kProduct = 0xCB48;
/// m: Novint states a cube of 4 inches. Half: more clutching; twice: its stops come first.
constexpr double kHalfWorkspace = 0.05;

std::string idOf(const UsbDevice& device) {
  return device.serial.empty() ? device.place : device.serial;
}

/// The grip's four buttons in the house's order: the middle one first, it takes and lets go.
std::uint32_t buttonsOf(std::uint8_t bits) {
  const auto bit = [&](unsigned from, unsigned to) { return (bits >> from & 1u) << to; };
  return bit(2, 0) | bit(0, 1) | bit(1, 2) | bit(3, 3);
}

}  // namespace

std::array<std::int16_t, 3> falconMotors(const dvec3& p_F, const dvec3& force_F, bool* saturated) {
  const auto J = FalconArm::jacobian(p_F);
  dvec3 motors = J ? kMotorPerTorque * FalconArm::torques(*J, force_F) : dvec3(0.0);
  const double most = std::max({std::abs(motors.x), std::abs(motors.y), std::abs(motors.z)});
  if (saturated != nullptr) *saturated = most > kMostMotor;
  if (most > kMostMotor) motors *= kMostMotor / most;
  std::array<std::int16_t, 3> result{};
  for (int i = 0; i < 3; ++i) result[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(std::lround(motors[i]));
  return result;
}

FalconDevice::FalconDevice(std::unique_ptr<FtdiPort> port) : port_(std::move(port)), p_F_(FalconArm::middle()) {
  copyText(capabilities_.name, "Novint Falcon");
  for (int i = 0; i < 3; ++i) {
    capabilities_.workspace_min[i] = -kHalfWorkspace;
    capabilities_.workspace_max[i] = kHalfWorkspace;
  }
  capabilities_.resolution = 63e-6;  // 400 a inch.
  capabilities_.measured_axes = 3;
  capabilities_.driven_axes = 3;
  capabilities_.buttons = 4;
  capabilities_.peak_force = 8.9;
  capabilities_.continuous_force = 2.0;
  capabilities_.stiffness = 600.0;
  capabilities_.damping = 2.0;
  capabilities_.rate_hz = 1000.0;
}

FalconDevice::~FalconDevice() {
  port_->write(encodeFalcon({{0, 0, 0}, kFalconRed}));
}

const char* FalconDevice::calibrationText(std::uint32_t step) const noexcept {
  return step == 0 ? "Pull the grip out as far as it goes, then push it straight in, until its ring turns blue."
                   : nullptr;
}

Status FalconDevice::lost() noexcept {
  if (++empty_reads_ < kPatience) return Status::kNothingNew;
  empty_reads_ = 0;
  waiting_ = false;  // Its answer will not come: the next write() sends another.
  if (++lost_packets_ < kMostLost) return Status::kNothingNew;
  return refuse(problem_, Status::kVanished, "it does not answer any more", "Check its cable and its power.");
}

Status FalconDevice::read(State& state) noexcept {
  if (!waiting_) return Status::kNothingNew;
  std::array<std::uint8_t, 64> bytes{};
  const int count = port_->read(bytes, 1);
  if (count < 0) return refuse(problem_, Status::kVanished, "it was unplugged", "Plug it in again.");
  const auto packet = reader_.take(std::span(bytes).first(static_cast<std::size_t>(count)));
  const bool garbled = reader_.garbled() > garbled_;
  garbled_ = reader_.garbled();
  if (!packet && garbled) {
    waiting_ = false;
    return refuse(problem_, Status::kGarbled, "it sends what is no packet", "Switch its power off and on.");
  }
  if (!packet) return lost();
  waiting_ = false;
  empty_reads_ = lost_packets_ = 0;
  dvec3 angles(0.0);
  for (int i = 0; i < 3; ++i) angles[i] = FalconArm::angleOf(packet->values[static_cast<std::size_t>(i)]);
  homed_ = (packet->bits & kFalconHomed) == kFalconHomed;
  auto p_F = FalconArm::position(angles, p_F_);
  if (!p_F) p_F = FalconArm::position(angles, FalconArm::middle());
  if (!p_F && homed_)
    return refuse(problem_, Status::kGarbled, "its encoders tell a place that it cannot be at", "Home it anew.");
  if (p_F && homed_) p_F_ = *p_F;
  const dvec3 p_D = falconToDevice(p_F_);
  for (int i = 0; i < 3; ++i) state.position[i] = p_D[i];
  state.buttons = buttonsOf(packet->bits);
  state.flags = homed_ ? kCalibrated | kMotorsOn : 0;
  return Status::kOk;
}

Status FalconDevice::write(const Command& command) noexcept {
  const bool pushes = homed_ && command.motors;
  // Zero does not wait for the answer to the packet before: it may never come.
  if (waiting_ && (pushes || !pushed_)) return Status::kOk;
  FalconPacket packet;
  packet.bits = homed_ ? kFalconBlue : kFalconRed | kFalconHoming;
  const Command now = steps_.next(pushes ? command : Command{});
  if (pushes) packet.values = falconMotors(p_F_, deviceToFalcon({now.force[0], now.force[1], now.force[2]}));
  pushed_ = pushes;
  if (!port_->write(encodeFalcon(packet)))
    return refuse(problem_, Status::kVanished, "it was unplugged", "Plug it in again.");
  waiting_ = true;
  return Status::kOk;
}

FalconDriver::FalconDriver(Scan scan, Open open, const char* library)
    : information_{"falcon", "Novint Falcon", "1.0", library,
                   "Its firmware is Novint's and is supplied by the user. Tested against a model of it, not on a real "
                   "device."},
      scan_(std::move(scan)),
      open_(std::move(open)) {}

void FalconDriver::configure(const char* key, const char* value) noexcept {
  if (std::string_view(key) == "firmware") firmware_ = value;
}

std::vector<UsbDevice> FalconDriver::falcons() const {
  std::vector<UsbDevice> all = scan_();
  std::erase_if(all, [](const UsbDevice& device) { return device.vendor != kVendor || device.product != kProduct; });
  return all;
}

std::uint32_t FalconDriver::find(Found* found, std::uint32_t room, Problem&) noexcept {
  std::uint32_t count = 0;
  for (const UsbDevice& device : falcons()) {
    if (count < room) {
      Found& entry = found[count];
      copyText(entry.id, idOf(device));
      copyText(entry.name, "Novint Falcon");
      copyText(entry.place, device.place);
      if (!device.bus_node.empty()) entry.problem = nodeProblem(device.bus_node);
    }
    ++count;
  }
  return count;
}

Problem FalconDriver::start(FtdiPort& port) const {
  Problem problem;
  if (setFalconRunning(port) && falconAnswers(port)) return problem;
  if (firmware_.empty()) {
    refuse(problem, Status::kMissingFile, "the Falcon needs Novint's firmware, which HaptiCell may not ship",
           "Set firmware = \"/path/novint.bin\" in [driver.falcon]; it comes with Novint's or libnifalcon's software.");
    return problem;
  }
  std::ifstream file(firmware_, std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (bytes.empty()) {
    refuse(problem, Status::kMissingFile, "the firmware " + firmware_ + " cannot be read",
           "Correct firmware in [driver.falcon].");
    return problem;
  }
  return uploadFalconFirmware(port, bytes);
}

Device* FalconDriver::open(const char* id, Problem& problem) noexcept {
  const std::string_view wanted(id);
  for (const UsbDevice& device : falcons()) {
    if (!wanted.empty() && wanted != idOf(device)) continue;
    auto port = open_(device, problem);
    if (port == nullptr) return nullptr;
    problem = start(*port);
    return problem.status == Status::kOk ? new FalconDevice(std::move(port)) : nullptr;
  }
  refuse(problem, Status::kNotFound, "no Falcon is plugged in", "Plug it in and switch its power on.");
  return nullptr;
}

void FalconDriver::close(Device* device) noexcept {
  delete static_cast<FalconDevice*>(device);
}

}  // namespace hapticell::driver
