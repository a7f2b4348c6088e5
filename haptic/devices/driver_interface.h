// SPDX-License-Identifier: Apache-2.0
#pragma once

// The interface that a driver plug-in implements; docs/library/drivers.md explains how to write one. It needs only the C++
// standard library. Only plain data and virtual functions cross the interface, so a driver may be built separately from
// HaptiCell (same system, any g++ or clang with the same C++ ABI).

#include <cstdint>

namespace hapticell::driver {

/// Version of this file. A driver works only with the version that it was built with.
inline constexpr std::uint32_t kInterfaceVersion = 2;

/// Result of a call; kOk or the reason of the failure.
enum class Status : std::uint32_t {
  kOk,
  kNothingNew,      ///< read(): no new measurement. Not a fault, except after 20 ms for a device that exerts forces.
  kNotFound,        ///< The device does not exist.
  kInUse,           ///< Another program uses it.
  kNoPermission,    ///< The system does not let this user open it.
  kMissingLibrary,  ///< A vendor's library is not installed, or lacks a function.
  kMissingFile,     ///< A file that the user has to supply, such as firmware, is missing.
  kNotCalibrated,   ///< It must be calibrated before it may exert forces.
  kGarbled,         ///< Its answers violate the protocol.
  kFault,           ///< The device reports a fault; the problem names it.
  kVanished,        ///< It was unplugged, or its service ended: the host closes it and looks for it again.
};

/// What went wrong and how to fix it, in sentences for the user, UTF-8, zero-terminated.
struct Problem {
  Status status = Status::kOk;
  char found[256] = {};  ///< "/dev/ttyUSB0 may not be opened: Permission denied".
  char fix[256] = {};    ///< "Add the user to the group dialout: sudo usermod -aG dialout NAME"; may be empty.
};

enum class Kind : std::uint32_t {
  kStylus,      ///< Measures a pose and may exert forces.
  kGlove,       ///< Measures the angles of a hand.
  kSpaceMouse,  ///< Measures a wanted motion: a knob with six axes, a 3D mouse.
};

/// A device that a driver has seen, usable or not.
struct Found {
  char id[128] = {};       ///< Unique within the driver and stable across restarts where possible; opens it.
  char name[128] = {};     ///< Its maker's name for it.
  char place[128] = {};    ///< "/dev/hidraw3", "usb 1-4", "ws://localhost:10001".
  char firmware[64] = {};  ///< Empty if it is known only when the device is open.
  Kind kind = Kind::kStylus;
  Problem problem;  ///< Why it cannot be used; kOk if it can.
};

/// What an open device can do. Device frame D: origin in the middle of the workspace, x to the user's right, y away
/// from the user, z up. SI: metres, radians, newtons.
struct Capabilities {
  Kind kind = Kind::kStylus;
  char name[128] = {};
  char firmware[64] = {};
  double workspace_min[3] = {};
  double workspace_max[3] = {};
  double resolution = 0.0;          ///< Position step, m.
  std::uint32_t measured_axes = 0;  ///< 3 or 6 for a stylus, 6 for a 3D mouse, 0 for a glove.
  std::uint32_t driven_axes = 0;    ///< 0, 3 (force) or 6 (force and torque).
  std::uint32_t buttons = 0;
  std::uint32_t sensors = 0;      ///< Of a glove.
  std::uint32_t vibrators = 0;    ///< Of a glove, at most 6.
  double peak_force = 0.0;        ///< N; 0 if it cannot exert forces.
  double continuous_force = 0.0;  ///< N that the motors can exert permanently.
  double peak_torque = 0.0;       ///< N m about any axis; 0 unless driven_axes is 6.
  double stiffness = 0.0;         ///< N/m that is stable when nobody holds the stylus.
  double damping = 0.0;           ///< N s/m that belongs to that stiffness.
  double rate_hz = 0.0;           ///< Approximate rate of measurements.
  bool experimental = false;      ///< Its protocol was found by others, not published by the maker.
};

/// Flags of a State.
enum : std::uint32_t {
  kCalibrated = 1,  ///< If this is not set, the device exerts no force, whatever is commanded.
  kDocked = 2,      ///< The stylus is in its inkwell.
  kMotorsOn = 4,    ///< The device reports that its motors are powered.
  kForceless = 8,   ///< It exerts no force now, whatever is commanded: it protects itself, its power is off, a switch.
};

/// One measurement.
struct State {
  double position[3] = {};                       ///< Of the stylus's tip in D, m.
  double orientation[4] = {1.0, 0.0, 0.0, 0.0};  ///< Unit quaternion w, x, y, z, stylus in D.
  double motion[6] = {};                         ///< 3D mouse: wanted translation along and rotation about D's axes, -1
                                                 ///< .. 1.
  double sensors[32] = {};                       ///< Glove: raw readings, 0 .. 255; the host converts them to angles.
  std::uint32_t buttons = 0;                     ///< Bit i set while button i is pressed.
  std::uint32_t flags = 0;
  double motor_temperature = 0.0;  ///< 0 cold .. 1 at the limit; 0 if it does not report it.
};

/// What the device must do now. The values have passed the host's safety chain: finite, clamped, limited in slew.
struct Command {
  double force[3] = {};      ///< N, in D.
  double torque[3] = {};     ///< N m, in D.
  double vibration[6] = {};  ///< 0 .. 1, thumb to little finger and palm.
  bool motors = false;       ///< False: motors off, the force above is zero.
  bool light = true;         ///< Light of a 3D mouse or a glove.
};

/// An open device. The host calls it from one thread, never from the force loop, so a slow call blocks nothing else.
/// But after 20 ms without an answer or, for a device that exerts forces, without a new measurement, the force loop
/// treats the device as faulty and switches forces off. Nothing here may throw.
class Device {
 public:
  virtual const Capabilities& capabilities() const noexcept = 0;
  /// The newest measurement; waits for it about one millisecond at most. kOk, kNothingNew, or the error.
  virtual Status read(State& state) noexcept = 0;
  /// Called about a thousand times a second, after read(), also if that had nothing new. A command without motors must
  /// be sent to the device at once, even if the device has not answered.
  virtual Status write(const Command& command) noexcept = 0;
  /// The problem of the last status other than kOk and kNothingNew.
  virtual const Problem& problem() const noexcept = 0;

  /// What the user must do in calibration step `step`, counted from 0; null after the last step (also for step 0 if the
  /// device needs no help).
  virtual const char* calibrationText(std::uint32_t step) const noexcept {
    static_cast<void>(step);
    return nullptr;
  }
  /// Called when the user has done the step: measure. After the last step the driver stores the result.
  virtual Status calibrate(std::uint32_t step) noexcept {
    static_cast<void>(step);
    return Status::kOk;
  }

 protected:
  ~Device() = default;  // Ended by Driver::close() only.
};

/// Description of a driver. The texts live as long as the driver.
struct Information {
  const char* name = "";   ///< One word, as in `--device NAME`.
  const char* title = "";  ///< "Novint Falcon".
  const char* version = "";
  const char* library = "";  ///< What it talks through: "libusb 1.0.26"; empty where nothing.
  const char* note = "";     ///< One sentence that a user must know: "Untested on the real device."
};

/// The single object of a plug-in. Never deleted.
class Driver {
 public:
  virtual const Information& information() const noexcept = 0;
  /// A setting of hapticell.toml, [driver.NAME], as text; called before all other functions. Unknown keys are ignored.
  virtual void configure(const char* key, const char* value) noexcept {
    static_cast<void>(key);
    static_cast<void>(value);
  }
  /// Looks for devices, including those that cannot be used. Returns their number; fills at most `room` of them. If the
  /// search itself is impossible (a missing library), `problem` says why. Any thread; one call at a time.
  virtual std::uint32_t find(Found* found, std::uint32_t room, Problem& problem) noexcept = 0;
  /// Opens a device by its id (empty: the first that can be used); null and a problem if that fails. May take seconds.
  virtual Device* open(const char* id, Problem& problem) noexcept = 0;
  /// Sets the force to zero, switches the motors off, releases everything and deletes `device`.
  virtual void close(Device* device) noexcept = 0;
  /// A number that changes when the result of find() would change. Called every second or two: it must not open, load
  /// or disturb anything, nor take longer than a few milliseconds. 0: the driver cannot detect changes; the host then
  /// looks for its devices only when the user asks. Never called while find() runs.
  virtual std::uint64_t presence() noexcept { return 0; }

 protected:
  ~Driver() = default;
};

}  // namespace hapticell::driver

/// The only function that a driver exports. Null if the driver was built for another version of this file.
extern "C" {
using HapticellDriverEntry = hapticell::driver::Driver* (*)(std::uint32_t interface_version);
}
#define HAPTICELL_DRIVER(make)                                                                   \
  extern "C" __attribute__((visibility("default"))) hapticell::driver::Driver* hapticell_driver( \
      std::uint32_t interface_version) {                                                         \
    static hapticell::driver::Driver* const driver = make;                                       \
    return interface_version == hapticell::driver::kInterfaceVersion ? driver : nullptr;         \
  }
