// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "haptic/devices/device.h"
#include "haptic/devices/driver_session.h"

namespace hapticell::haptic {

/// In which thread a driver's calls run.
enum class DriverCalls : std::uint8_t {
  kOwnThread,  ///< In a separate thread; read() and write() always return at once.
  kInline,     ///< In read() and write() themselves: for virtual time, which must not depend on the machine's speed.
};

struct DriverDeviceOptions {
  DriverCalls calls = DriverCalls::kOwnThread;
  DriverSessionOptions session{};
  double open_patience_s = 20.0;  ///< A driver that has not opened its device by then is abandoned.
};

/// A plug-in's device as the force loop's Device.
///
/// The driver's calls run in a separate thread. Only values pass between it and the force loop; the newest wins. If a
/// driver does not answer for kPatience ticks, that is a fault: the force loop trips its safety chain, and the thread
/// commands zero force as soon as its call returns. A driver whose call never returns is abandoned at close(). If the
/// force loop does not command for kSilentLoop, the device gets zero force until the loop starts again from zero. A 3D
/// mouse also works as a stylus: its motion moves the tip through a workspace of 16 x 16 x 16 cm, without force.
class DriverDevice final : public Device {
 public:
  /// Ticks without an answer until the device counts as faulty: 20 ms as kFreshFor. Half: a busy machine trips; twice:
  /// an old force acts 40 ms.
  static constexpr int kPatience = 20;
  /// s without a command: the force loop has stalled. Just over its own 20 ms (StallWatch), so that the loop acts
  /// first. Half: it would not; twice: an old force acts 50 ms.
  static constexpr double kSilentLoop = 0.025;

  DriverDevice(driver::Driver& driver, std::string id, DriverDeviceOptions options = {});
  ~DriverDevice() override;

  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  /// The open device's capabilities as the driver reports them.
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
  std::shared_ptr<Worker> worker_;          // kOwnThread; shared with its thread, which may outlive this object.
  std::unique_ptr<DriverSession> session_;  // kInline.
  std::shared_ptr<DeviceCare> care_ = std::make_shared<DeviceCare>();
  driver::Command command_;
  DeviceReading reading_;
  driver::Status status_ = driver::Status::kVanished;
  std::uint64_t measurements_ = 0;  // Of the last answer that was used.
  std::int64_t turns_ns_ = 0;       // kInline: the time, one tick per turn.
  int silent_ticks_ = 0;
  bool heard_ = false;  // The thread has answered since open().
  bool motors_ = true;
  bool engaged_ = false;
};

/// Converts a driver's capabilities to the server's type.
DeviceCapabilities toCapabilities(const driver::Capabilities& from);

}  // namespace hapticell::haptic
