// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/omni_firewire/fire_wire_port.h"
#include "haptic/devices/drivers/omni_firewire/omni_arm.h"

namespace hapticell::driver {

/// A started Omni. It homes whenever its stylus is in the inkwell. It exerts no force until the user has measured the
/// scale of the commands (`newton_metres_per_unit` above 0), and then at most 30 % of the range.
class OmniDevice final : public Device {
 public:
  OmniDevice(std::unique_ptr<FireWirePort> port, const std::string& serial, double newton_metres_per_unit);
  ~OmniDevice();  ///< Motors off, stream stopped.
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override;
  Status write(const Command& command) noexcept override;
  const Problem& problem() const noexcept override { return problem_; }
  const char* calibrationText(std::uint32_t step) const noexcept override;

  /// Reads of a millisecond without a packet before it counts as lost: 0.1 s, long after its force is zero. Half: a bus
  /// reset loses it; twice: reported after 0.2 s.
  static constexpr int kPatience = 100;
  /// Share of the commands' range that is used: the scale was never measured on a device, so most of the range stays
  /// closed. Half: half the force; twice: a wrong scale can strike with 60 % of the motors.
  static constexpr double kMostUsed = 0.3;
  /// Packets over which the noisy gimbal is averaged: 20 ms, noise to a quarter. Half: a third of it is left; twice:
  /// rotation lags by 20 ms.
  static constexpr std::size_t kMean = 20;

 private:
  void average(OmniReading& reading);

  std::unique_ptr<FireWirePort> port_;
  double newton_metres_per_unit_;
  Capabilities capabilities_;
  OmniArm arm_;
  dvec3 joints_{0.0};
  std::array<std::array<double, 3>, kMean> gimbal_{};
  std::size_t gimbal_count_ = 0;
  int arming_ = 0;
  int empty_reads_ = 0;
  Problem problem_;
};

/// SensAble Phantom Omni over FireWire, experimental. Setting: `newtons_per_unit`, the force at the tip (N) in the
/// middle of the workspace at full command; measured with a spring balance.
class OmniDriver final : public Driver {
 public:
  explicit OmniDriver(std::unique_ptr<FireWireBus> bus) : bus_(std::move(bus)) {}
  const Information& information() const noexcept override { return information_; }
  void configure(const char* key, const char* value) noexcept override;
  std::uint32_t find(Found* found, std::uint32_t room, Problem& problem) noexcept override;
  Device* open(const char* id, Problem& problem) noexcept override;
  void close(Device* device) noexcept override;
  std::uint64_t presence() noexcept override { return presenceByFind(*this); }

 private:
  Information information_{
      "omni_firewire", "SensAble Phantom Omni (FireWire)", "0.1", "libraw1394",
      "Experimental: its layout was found by others; no force before newtons_per_unit is measured."};
  std::unique_ptr<FireWireBus> bus_;
  double newtons_per_unit_ = 0.0;
};

/// Checks that it is an Omni, and starts its streams; its serial number, or a problem.
std::string startOmni(FireWirePort& port, Problem& problem);

}  // namespace hapticell::driver
