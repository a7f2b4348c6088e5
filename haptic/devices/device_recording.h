// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "haptic/devices/device.h"

namespace hapticell::haptic {

/// One tick of a device: what it told and what it was commanded.
struct RecordedTick {
  std::uint32_t status = 0;  ///< A DeviceStatus, and the bits below.
  std::uint32_t buttons = 0;
  static constexpr std::uint32_t kNotFresh = 0x100;   ///< Bit of `status`: DeviceReading::fresh was false.
  static constexpr std::uint32_t kForceless = 0x200;  ///< Bit of `status`: DeviceReading::takes_force was false.
  Pose X_DS;
  double motor_temperature = 0.0;
  dvec3 force_D{0.0}, torque_D{0.0};  ///< Commanded.
};

/// A device's session: what the device could do, and every tick. Kept in a file *.hdev: the letters "HCELDEV1", the
/// length of a JSON text (32 bits) and that text (the capabilities), then 120 bytes a tick: status, buttons (32 bits
/// each; status 0 good, 1 not open, 2 fault, 3 vanished, plus 256 nothing new, plus 512 takes no force), pose (x, y, z,
/// w, x, y, z), temperature, force, torque as 64-bit IEEE numbers; little-endian. Every bit of every number is kept, so
/// that what is computed from a replay is bit-equal.
struct DeviceRecording {
  DeviceCapabilities capabilities;
  std::vector<RecordedTick> ticks;
};

/// Errors: it cannot be read, is no such file, holds nonsense (a pose that is none). An incomplete last tick (a power
/// cut) is left out.
Expected<DeviceRecording> readDeviceRecording(const std::filesystem::path& file);

/// A device that is recorded while it is used. The force loop's calls only copy a tick into a ring; a thread of its own
/// writes the file every tenth of a second. It has its name once finish() or close() has written the rest: until then
/// what stood there stands, and a recording that is killed or finds the disk full leaves nothing.
class RecordingDevice final : public Device {
 public:
  RecordingDevice(std::unique_ptr<Device> device, std::filesystem::path file);
  ~RecordingDevice() override;

  const DeviceCapabilities& capabilities() const override { return device_->capabilities(); }
  /// Opens the device and begins the file. Errors of either.
  Expected<void> open() override;
  DeviceStatus read(DeviceReading& reading) noexcept override;
  DeviceStatus write(const dvec3& force_D, const dvec3& torque_D) noexcept override;
  void setMotors(bool on) noexcept override { device_->setMotors(on); }
  void setEngaged(bool engaged) noexcept override { device_->setEngaged(engaged); }
  /// Ends the recording: the rest is written and the file gets its name. Error: it could not be written, at the end or
  /// before. Not while the force loop runs. After close(), which does it too, what came of that.
  Expected<void> finish();
  /// What keeps the recording from being written, if anything does. Not by the force loop's thread.
  std::optional<Error> fault() const;
  void close() noexcept override;
  SimulatedDevice* simulated() noexcept override { return device_->simulated(); }
  DeviceCare* care() noexcept override { return device_->care(); }

  /// Ticks that did not get into the file because the disk was too slow.
  std::uint64_t lost() const;

 private:
  class Writer;
  std::unique_ptr<Device> device_;
  std::filesystem::path file_;
  std::unique_ptr<Writer> writer_;
  Expected<void> finished_;
  RecordedTick tick_;
};

/// A recorded session as a device: tells again what was told, tick by tick, and takes any force. At the end it stays
/// where it was, with no button pressed.
class ReplayDevice final : public Device {
 public:
  explicit ReplayDevice(DeviceRecording recording);

  const DeviceCapabilities& capabilities() const override { return recording_.capabilities; }
  Expected<void> open() override;
  DeviceStatus read(DeviceReading& reading) noexcept override;
  DeviceStatus write(const dvec3& force_D, const dvec3& torque_D) noexcept override;
  void close() noexcept override { open_ = false; }

  /// True where everything has been told.
  bool ended() const { return next_ >= recording_.ticks.size(); }

 private:
  DeviceRecording recording_;
  std::size_t next_ = 0;
  bool open_ = false;
};

}  // namespace hapticell::haptic
