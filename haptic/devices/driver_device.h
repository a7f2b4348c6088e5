// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "haptic/devices/device.h"
#include "haptic/devices/driver_session.h"

namespace hapticell::haptic {

/// How a driver's calls are run.
enum class DriverCalls : std::uint8_t {
  kOwnThread,  ///< In a thread of their own: whatever they do, read() and write() return at once.
  kInline,     ///< In read() and write() themselves: for virtual time, where nothing may depend on a machine's speed.
};

struct DriverDeviceOptions {
  DriverCalls calls = DriverCalls::kOwnThread;
  DriverSessionOptions session{};
  double open_patience_s = 20.0;  ///< A driver that has not opened its device by then is left to itself.
};

/// A plug-in's device as the force loop's Device.
///
/// The driver's calls run in a thread of their own; between it and the force loop go only values, newest wins. A driver
/// that has not answered for kPatience ticks is a fault: the force loop trips its safety chain, and the thread commands
/// zero force as soon as its call comes back. A driver that never comes back is left to itself at close(). The other
/// way round, to a force loop that has not commanded for kSilentLoop the device gets zero force until it has begun
/// anew. A 3-D mouse is a stylus too: its wanted motion moves the tip through a workspace of 16 x 16 x 16 cm, without
/// force.
class DriverDevice final : public Device {
 public:
  /// Ticks without an answer until the device counts as faulty.
  static constexpr int kPatience = 20;
  /// s without a command: the force loop has stalled.
  static constexpr double kSilentLoop = 0.025;

  DriverDevice(driver::Driver& driver, std::string id, DriverDeviceOptions options = {});
  ~DriverDevice() override;

  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  /// What the driver itself says of the open device.
  const driver::Capabilities& driverCapabilities() const { return driver_capabilities_; }
  /// Starts the thread and waits for the driver to open the device.
  Expected<void> open() override;
  DeviceStatus read(DeviceReading& reading) noexcept override;
  DeviceStatus write(const dvec3& force_D, const dvec3& torque_D) noexcept override;
  void setMotors(bool on) noexcept override;
  void setEngaged(bool engaged) noexcept override;
  void close() noexcept override;
  DeviceCare* care() noexcept override { return care_.get(); }

 private:
  struct Worker;
  void takeAnswer(const DriverAnswer& answer, DeviceReading& reading) noexcept;

  driver::Driver& driver_;
  std::string id_;
  DriverDeviceOptions options_;
  DeviceCapabilities capabilities_;
  driver::Capabilities driver_capabilities_;
  std::shared_ptr<Worker> worker_;          // kOwnThread; shared with its thread, which may outlive this.
  std::unique_ptr<DriverSession> session_;  // kInline.
  std::shared_ptr<DeviceCare> care_ = std::make_shared<DeviceCare>();
  driver::Command command_;
  DeviceReading reading_;
  driver::Status status_ = driver::Status::kVanished;
  std::uint64_t measurements_ = 0;  // Of the answer that was taken last.
  std::int64_t turns_ns_ = 0;       // kInline: the time, a tick a turn.
  int silent_ticks_ = 0;
  bool heard_ = false;  // The thread has answered since open().
  bool motors_ = true;
  bool engaged_ = false;
};

/// A driver's capabilities in the server's words.
DeviceCapabilities toCapabilities(const driver::Capabilities& from);

}  // namespace hapticell::haptic
