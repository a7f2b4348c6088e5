// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// What hdGetError() returns, by value.
struct HdError {
  unsigned code = 0;
  int internal = 0;
  unsigned handle = 0;
};

/// The vendor's HDAPI (3D Systems OpenHaptics), loaded at run time. The signatures and numbers of its binary interface
/// come from public sources; we use no header of the vendor and ship none of its files.
struct HdLibrary {
  using Callback = unsigned (*)(void*);

  unsigned (*hdInitDevice)(const char*) = nullptr;
  void (*hdDisableDevice)(unsigned) = nullptr;
  void (*hdMakeCurrentDevice)(unsigned) = nullptr;
  void (*hdEnable)(unsigned) = nullptr;
  void (*hdDisable)(unsigned) = nullptr;
  void (*hdStartScheduler)() = nullptr;
  void (*hdStopScheduler)() = nullptr;
  void (*hdSetSchedulerRate)(unsigned long) = nullptr;
  unsigned long (*hdScheduleAsynchronous)(Callback, void*, unsigned short) = nullptr;
  void (*hdUnschedule)(unsigned long) = nullptr;
  void (*hdBeginFrame)(unsigned) = nullptr;
  void (*hdEndFrame)(unsigned) = nullptr;
  void (*hdGetDoublev)(unsigned, double*) = nullptr;
  void (*hdGetIntegerv)(unsigned, int*) = nullptr;
  const char* (*hdGetString)(unsigned) = nullptr;
  void (*hdSetDoublev)(unsigned, const double*) = nullptr;
  HdError (*hdGetError)() = nullptr;
  const char* (*hdGetErrorString)(unsigned) = nullptr;
  unsigned (*hdCheckCalibration)() = nullptr;
  void (*hdUpdateCalibration)(unsigned) = nullptr;

  std::string file;  ///< The library that was loaded.

  bool isLoaded() const { return hdInitDevice != nullptr; }
  /// Loads the first of `names` that exists, with all functions above; otherwise a problem that names the file and the
  /// function. Sets the locale to "C" first, because the library uses it to read numbers. The library is never
  /// unloaded.
  Problem load(const std::vector<std::string>& names);
};

/// Constants of HDAPI.
namespace hd {
inline constexpr unsigned kBadHandle = 0xFFFFFFFF;
inline constexpr unsigned kContinue = 1, kDone = 0;
inline constexpr unsigned kCurrentButtons = 0x2000, kCurrentInkwell = 0x2002;
inline constexpr unsigned kCurrentPosition = 0x2050, kCurrentTransform = 0x2052;
inline constexpr unsigned kModelType = 0x2501, kSerialNumber = 0x2504, kFirmwareVersion = 0x2505;
inline constexpr unsigned kUsableWorkspace = 0x2551, kOutputAxes = 0x2554, kCalibrationStyle = 0x2555;
inline constexpr unsigned kMaxStiffness = 0x2602, kMaxForce = 0x2603, kMaxContinuousForce = 0x2604;
inline constexpr unsigned kMotorTemperature = 0x2605;
inline constexpr unsigned kCurrentForce = 0x2700, kCurrentTorque = 0x2701;
inline constexpr unsigned kForceOutput = 0x4000;
inline constexpr unsigned kCalibrationOk = 0x5000, kCalibrationUpdate = 0x5001;
inline constexpr unsigned kStyleAuto = 2, kStyleInkwell = 4;
inline constexpr unsigned kInvalidEnum = 0x100;
inline constexpr unsigned kWarmMotors = 0x200, kExceededMaxForce = 0x201, kExceededImpulse = 0x202,
                          kExceededVelocity = 0x203, kForceError = 0x204;
inline constexpr unsigned kDeviceFault = 0x300, kAlreadyInitiated = 0x301, kCommError = 0x302, kCommConfig = 0x303,
                          kTimerError = 0x304;
inline constexpr unsigned kIllegalBegin = 0x400, kSchedulerFull = 0x501, kInvalidLicense = 0x600;
}  // namespace hd

}  // namespace hapticell::driver
