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

/// The motor numbers that exert a force at a place of the grip, all scaled together where one saturates: the direction
/// stays. `force_F` in N; `saturated`, where given, tells whether they were.
std::array<std::int16_t, 3> falconMotors(const dvec3& p_F, const dvec3& force_F, bool* saturated = nullptr);

/// A Falcon whose firmware runs. Each packet out is answered by one packet in; the one is sent by write(), the other
/// taken by read(). Homing is the user's: the grip pulled out to its stop and pushed in again; its ring is red until
/// then, and there is no force.
class FalconDevice final : public Device {
 public:
  explicit FalconDevice(std::unique_ptr<FtdiPort> port);
  ~FalconDevice();
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override;
  Status write(const Command& command) noexcept override;
  const Problem& problem() const noexcept override { return problem_; }
  const char* calibrationText(std::uint32_t step) const noexcept override;

  /// Reads of a millisecond without an answer until the packet counts as lost, and such packets until it is gone.
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
  bool pushed_ = false;  // By the packet that was sent last.
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
  /// `id` as find() tells it: the serial number, else the USB port.
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
