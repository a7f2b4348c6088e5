// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/shapes/vector.h"
#include "geometry/system/error.h"

namespace hapticell::config {

/// How a stylus moves, as simulated. SI.
struct DeviceMechanics {
  double apparent_mass = 0.045;     ///< At the tip in the workspace's middle, kg.
  double coulomb_friction = 0.06;   ///< At the tip, N.
  double viscous_friction = 0.012;  ///< At the tip, N s/m.
  double weight = 0.04;             ///< What the counterweights leave of it, N.
  double upper_arm = 0.160;         ///< m.
  double forearm = 0.160;           ///< m.
  double stop_stiffness = 5000.0;   ///< Hard stops, N/m.
  double stop_damping = 10.0;       ///< N s/m.

  bool operator==(const DeviceMechanics&) const = default;
};

/// Electronics and motors of a stylus, as simulated. SI.
struct DeviceElectronics {
  double converter_range = 7.9;  ///< Tip force at the converter's full scale, N.
  int converter_bits = 12;
  int delay_ticks = 1;         ///< Ticks from write() to the force.
  double thermal_time = 30.0;  ///< Motors' time constant, s.

  bool operator==(const DeviceElectronics&) const = default;
};

/// The figures of a force-feedback stylus, as read from `config/devices/NAME.toml`. SI throughout.
///
/// The defaults are those of phantom_desktop.toml: the Phantom Desktop as its paper states it, simulated when no other
/// device is named.
struct DeviceProfile {
  std::string name = "Phantom Desktop (simulated)";

  // What the device can do.
  dvec3 workspace{0.160, 0.130, 0.130};  ///< Size of the box around D's origin, m: width, depth, height.
  double resolution = 0.02e-3;           ///< Tip position step of one encoder count, m.
  double rotation_resolution = 0.5e-3;   ///< Gimbal step, rad.
  int measured_axes = 6;
  int driven_axes = 3;
  int buttons = 1;
  double peak_force = 6.4;        ///< N.
  double continuous_force = 1.4;  ///< N.
  double peak_torque = 0.0;       ///< N m; above 0 exactly where driven_axes is 6.
  double stiffness = 1000.0;      ///< Recommended K, N/m.
  double damping = 2.0;           ///< Recommended B, N s/m.

  DeviceMechanics mechanics;
  DeviceElectronics electronics;

  bool operator==(const DeviceProfile&) const = default;
};

/// Reads a profile. Keys that are missing keep the default; an unknown key, a wrong type or a value out of range is an
/// error with line, key, found value and range.
Expected<DeviceProfile> readDeviceProfile(const std::filesystem::path& file);

/// The same of a text; errors use `name` as the file.
Expected<DeviceProfile> parseDeviceProfile(std::string_view text, const std::string& name);

}  // namespace hapticell::config
