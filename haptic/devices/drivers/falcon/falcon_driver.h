// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "haptic/devices/command_steps.h"
#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/falcon/falcon_packets.h"
#include "haptic/devices/drivers/falcon/ftdi_port.h"

namespace hapticell::driver {

/// The motor values that exert `force_F` (N) with the grip at `p_F`. If one saturates, all are scaled together, so the
/// direction stays. `saturated`, if given, is set to whether that happened.
std::array<std::int16_t, 3> falconMotors(const dvec3& p_F, const dvec3& force_F, bool* saturated = nullptr);

/// A Falcon whose firmware runs. write() sends a packet; the Falcon answers each with one packet, which read() takes.
/// The user does the homing: pull the grip out to its stop and push it in again. Until then the ring is red and there
/// is no force.
class FalconDevice final : public Device {
 public:
  explicit FalconDevice(std::unique_ptr<FtdiPort> port);
  ~FalconDevice();
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override;
  Status write(const Command& command) noexcept override;
  const Problem& problem() const noexcept override { return problem_; }
  const char* calibrationText(std::uint32_t step) const noexcept override;

  /// Reads of a millisecond without an answer before a packet counts as lost (20 ms as kFreshFor), and lost packets
  /// before the device does: 0.2 s. Half: a busy bus loses it; twice: unplugging is reported after 0.4 s.
  static constexpr int kPatience = 20, kMostLost = 10;

 private:
  Status lost() noexcept;

  std::unique_ptr<FtdiPort> port_;
  Capabilities capabilities_;
  FalconReader reader_;
  Problem problem_;
  dvec3 p_F_;
  CommandSteps steps_;
  bool homed_ = false, waiting_ = false;
  bool pushed_ = false;  // In the last packet sent.
  int empty_reads_ = 0, lost_packets_ = 0;
  std::size_t garbled_ = 0;
};

/// Novint Falcon over USB. Setting: `firmware`, the path of Novint's file.
class FalconDriver final : public Driver {
 public:
  using Scan = std::function<std::vector<UsbDevice>()>;
  using Open = std::function<std::unique_ptr<FtdiPort>(const UsbDevice&, Problem&)>;
  FalconDriver(Scan scan, Open open, const char* library);
  const Information& information() const noexcept override { return information_; }
  void configure(const char* key, const char* value) noexcept override;
  std::uint32_t find(Found* found, std::uint32_t room, Problem& problem) noexcept override;
  /// `id` as returned by find(): the serial number, else the USB port.
  Device* open(const char* id, Problem& problem) noexcept override;
  void close(Device* device) noexcept override;
  std::uint64_t presence() noexcept override { return presenceByFind(*this); }

 private:
  std::vector<UsbDevice> falcons() const;
  Problem start(FtdiPort& port) const;

  Information information_;
  Scan scan_;
  Open open_;
  std::string firmware_;
};

}  // namespace hapticell::driver
