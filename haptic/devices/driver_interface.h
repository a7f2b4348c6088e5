// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a driver plug-in implements; docs/library/drivers.md tells how to write one. Nothing but the C++ standard
// library is needed: all that crosses the border is plain data and virtual functions, so that a driver may be built
// apart from HaptiCell (same system, any g++ or clang with the same C++ ABI).

#include <cstdint>

namespace hapticell::driver {

/// Version of this file. A driver answers only to the version that it was built with.
inline constexpr std::uint32_t kInterfaceVersion = 2;

/// Why something did not work; kOk where it did.
enum class Status : std::uint32_t {
  kOk,
  kNothingNew,      ///< read(): no measurement since the last one; no fault, but for what exerts forces after 20 ms.
  kNotFound,        ///< There is no such device.
  kInUse,           ///< Another program has it.
  kNoPermission,    ///< The system does not let this user open it.
  kMissingLibrary,  ///< A vendor's library is not installed, or lacks a function.
  kMissingFile,     ///< Something that the user has to supply, such as firmware.
  kNotCalibrated,   ///< It must be calibrated before it may exert forces.
  kGarbled,         ///< It answers, but not as the protocol says.
  kFault,           ///< The device reports a fault of its own; the problem names it.
  kVanished,        ///< It was unplugged, or its service ended: the host closes it and looks for it again.
};

/// What went wrong and what mends it, in sentences for the user, UTF-8, zero-terminated.
struct Problem {
  Status status = Status::kOk;
  char found[256] = {};  ///< "/dev/ttyUSB0 may not be opened: Permission denied".
  char fix[256] = {};    ///< "Add the user to the group dialout: sudo usermod -aG dialout NAME"; may be empty.
};

enum class Kind : std::uint32_t {
  kStylus,      ///< Tells a pose and may exert forces.
  kGlove,       ///< Tells the angles of a hand.
  kSpaceMouse,  ///< Tells a wanted motion: a knob with six axes, a "3-D mouse".
};

/// A device that a driver has seen, usable or not.
struct Found {
  char id[128] = {};       ///< Unique within the driver and stable across restarts where possible; opens it.
  char name[128] = {};     ///< What its maker calls it.
  char place[128] = {};    ///< "/dev/hidraw3", "usb 1-4", "ws://localhost:10001".
  char firmware[64] = {};  ///< Empty where it is known only once the device is open.
  Kind kind = Kind::kStylus;
  Problem problem;  ///< Why it cannot be used; kOk where it can.
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
  std::uint32_t measured_axes = 0;  ///< 3 or 6 for a stylus, 6 for a 3-D mouse, 0 for a glove.
  std::uint32_t driven_axes = 0;    ///< 0, 3 (force) or 6 (force and torque).
  std::uint32_t buttons = 0;
  std::uint32_t sensors = 0;      ///< Of a glove.
  std::uint32_t vibrators = 0;    ///< Of a glove, at most 6.
  double peak_force = 0.0;        ///< N; 0 where no force can be exerted.
  double continuous_force = 0.0;  ///< N that the motors bear for ever.
  double peak_torque = 0.0;       ///< N m about any axis; 0 where driven_axes is not 6.
  double stiffness = 0.0;         ///< N/m that is stable with nobody holding it.
  double damping = 0.0;           ///< N s/m that belongs to that stiffness.
  double rate_hz = 0.0;           ///< How often it measures, about.
  bool experimental = false;      ///< Its layout was found by others and is not the maker's word.
};

/// Flags of a State.
enum : std::uint32_t {
  kCalibrated = 1,  ///< Where this is not set no force is exerted, whatever is commanded.
  kDocked = 2,      ///< The stylus is in its inkwell.
  kMotorsOn = 4,    ///< The device says that its motors are powered.
  kForceless = 8,   ///< It exerts no force now, whatever is commanded: it protects itself, its power is off, a switch.
};

/// One measurement.
struct State {
  double position[3] = {};                       ///< Of the stylus's tip in D, m.
  double orientation[4] = {1.0, 0.0, 0.0, 0.0};  ///< Unit quaternion w, x, y, z, stylus in D.
  double motion[6] = {};                         ///< 3-D mouse: wanted motion and turning about D's axes, -1 .. 1.
  double sensors[32] = {};                       ///< Glove: raw readings, 0 .. 255; the host makes angles of them.
  std::uint32_t buttons = 0;                     ///< Bit i set while button i is pressed.
  std::uint32_t flags = 0;
  double motor_temperature = 0.0;  ///< 0 cold .. 1 at the limit; 0 where it does not tell.
};

/// What the device shall do now. Already through the host's safety chain: finite, clamped, limited in slew.
struct Command {
  double force[3] = {};      ///< N, in D.
  double torque[3] = {};     ///< N m, in D.
  double vibration[6] = {};  ///< 0 .. 1, thumb to little finger and palm.
  bool motors = false;       ///< False: motors off, the force above is zero.
  bool light = true;         ///< Of a 3-D mouse or a glove.
};

/// An open device. The host calls it from one thread of its own, never from the force loop: a call that takes long
/// holds up nobody, but after 20 ms without an answer, or without a new measurement of what exerts forces, the force
/// loop takes the device for faulty and forces go off. Nothing here may throw.
class Device {
 public:
  virtual const Capabilities& capabilities() const noexcept = 0;
  /// The newest measurement; waits for it one millisecond or so at most. kOk, kNothingNew, or what is wrong.
  virtual Status read(State& state) noexcept = 0;
  /// Called about a thousand times a second, after read(), also where that had nothing new. A command without motors
  /// must reach the device at once, whether or not it has been heard.
  virtual Status write(const Command& command) noexcept = 0;
  /// What the last status other than kOk and kNothingNew was about.
  virtual const Problem& problem() const noexcept = 0;

  /// What the user shall do for calibration step `step`, counted from 0; null after the last (a device that needs no
  /// help has none).
  virtual const char* calibrationText(std::uint32_t step) const noexcept {
    static_cast<void>(step);
    return nullptr;
  }
  /// The user has done it: measure. After the last step the result is stored where the driver keeps such things.
  virtual Status calibrate(std::uint32_t step) noexcept {
    static_cast<void>(step);
    return Status::kOk;
  }

 protected:
  ~Device() = default;  // Ended by Driver::close() only.
};

/// What a driver is. The texts live as long as the driver.
struct Information {
  const char* name = "";   ///< One word, as in `--device NAME`.
  const char* title = "";  ///< "Novint Falcon".
  const char* version = "";
  const char* library = "";  ///< What it talks through: "libusb 1.0.26"; empty where nothing.
  const char* note = "";     ///< One sentence that a user must know: "Untested on the real device."
};

/// A plug-in's one object. Never deleted.
class Driver {
 public:
  virtual const Information& information() const noexcept = 0;
  /// A setting of hapticell.toml, [driver.NAME], as text; told before anything else is asked. Unknown keys are ignored.
  virtual void configure(const char* key, const char* value) noexcept {
    static_cast<void>(key);
    static_cast<void>(value);
  }
  /// Looks for devices, those that are seen but cannot be used included. Returns how many there are; fills at most
  /// `room` of them. `problem` says why none can be found at all (a missing library). Any thread; not while it runs.
  virtual std::uint32_t find(Found* found, std::uint32_t room, Problem& problem) noexcept = 0;
  /// Opens a device by its id (empty: the first that can be used); null and a problem where it cannot. May take
  /// seconds.
  virtual Device* open(const char* id, Problem& problem) noexcept = 0;
  /// Force zero, motors off, all given back; `device` is gone afterwards.
  virtual void close(Device* device) noexcept = 0;
  /// A number that is another one once find() would tell of other devices, asked every second or two: it must not open,
  /// load or disturb anything, nor take longer than some milliseconds. 0: this driver cannot tell, its devices are
  /// looked for only when the user asks. Never called while find() runs.
  virtual std::uint64_t presence() noexcept { return 0; }

 protected:
  ~Driver() = default;
};

}  // namespace hapticell::driver

/// The one function that a driver exports. Null where it was built for another version of this file.
extern "C" {
using HapticellDriverEntry = hapticell::driver::Driver* (*)(std::uint32_t interface_version);
}
#define HAPTICELL_DRIVER(make)                                                                   \
  extern "C" __attribute__((visibility("default"))) hapticell::driver::Driver* hapticell_driver( \
      std::uint32_t interface_version) {                                                         \
    static hapticell::driver::Driver* const driver = make;                                       \
    return interface_version == hapticell::driver::kInterfaceVersion ? driver : nullptr;         \
  }
