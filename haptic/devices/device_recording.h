// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "haptic/devices/device.h"

namespace hapticell::haptic {

/// One tick of a device: what it reported and what was commanded.
struct RecordedTick {
  std::uint32_t status = 0;  ///< A DeviceStatus, and the bits below.
  std::uint32_t buttons = 0;
  static constexpr std::uint32_t kNotFresh = 0x100;   ///< Bit of `status`: DeviceReading::fresh was false.
  static constexpr std::uint32_t kForceless = 0x200;  ///< Bit of `status`: DeviceReading::takes_force was false.
  Pose X_DS;
  double motor_temperature = 0.0;
  dvec3 force_D{0.0}, torque_D{0.0};  ///< Commanded.
};

/// A recorded session of a device: its capabilities and every tick. Stored in a file *.hdev: the letters "HCELDEV1",
/// the length of a JSON text (32 bits) and that text (the capabilities), then 120 bytes a tick: status, buttons (32
/// bits each; status 0 good, 1 not open, 2 fault, 3 vanished, plus 256 no new measurement, plus 512 takes no force),
/// pose (x, y, z, w, x, y, z), temperature, force, torque as 64-bit IEEE numbers; little-endian. Numbers keep every
/// bit, so results computed from a replay are bit-equal.
struct DeviceRecording {
  DeviceCapabilities capabilities;
  std::vector<RecordedTick> ticks;
};

/// Errors: the file cannot be read, is not a recording, or has invalid values (such as an invalid pose). An incomplete
/// last tick (a power cut) is left out.
Expected<DeviceRecording> readDeviceRecording(const std::filesystem::path& file);

/// Records a device while it is used. The force loop's calls only copy a tick into a ring; a separate thread writes the
/// file every tenth of a second. The file gets its name when finish() or close() has written the rest; until then an
/// older file of that name stays. If the program is killed or the disk is full, no file is left.
class RecordingDevice final : public Device {
 public:
  RecordingDevice(std::unique_ptr<Device> device, std::filesystem::path file);
  ~RecordingDevice() override;

  const DeviceCapabilities& capabilities() const override { return device_->capabilities(); }
  /// Opens the device and begins the file. Errors: those of both.
  Expected<void> open() override;
  DeviceStatus read(DeviceReading& reading) noexcept override;
  DeviceStatus write(const dvec3& force_D, const dvec3& torque_D) noexcept override;
  void setMotors(bool on) noexcept override { device_->setMotors(on); }
  void setEngaged(bool engaged) noexcept override { device_->setEngaged(engaged); }
  /// Ends the recording: writes the rest and gives the file its name. Error: writing failed, now or earlier. Do not
  /// call it while the force loop runs. After close(), which also finishes, it returns the result of that.
  Expected<void> finish();
  /// Why the recording cannot be written, if it cannot. Not for the force loop's thread.
  std::optional<Error> fault() const;
  void close() noexcept override;
  SimulatedDevice* simulated() noexcept override { return device_->simulated(); }
  DeviceCare* care() noexcept override { return device_->care(); }

  /// Ticks missing in the file because the disk was too slow.
  std::uint64_t lost() const;

 private:
  class Writer;
  std::unique_ptr<Device> device_;
  std::filesystem::path file_;
  std::unique_ptr<Writer> writer_;
  Expected<void> finished_;
  RecordedTick tick_;
};

/// A recorded session as a device: replays the readings tick by tick and accepts any force. After the end it keeps the
/// last pose, with no button pressed.
class ReplayDevice final : public Device {
 public:
  explicit ReplayDevice(DeviceRecording recording);

  const DeviceCapabilities& capabilities() const override { return recording_.capabilities; }
  Expected<void> open() override;
  DeviceStatus read(DeviceReading& reading) noexcept override;
  DeviceStatus write(const dvec3& force_D, const dvec3& torque_D) noexcept override;
  void close() noexcept override { open_ = false; }

  /// True after the last tick.
  bool ended() const { return next_ >= recording_.ticks.size(); }

 private:
  DeviceRecording recording_;
  std::size_t next_ = 0;
  bool open_ = false;
};

}  // namespace hapticell::haptic
