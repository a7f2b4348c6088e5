// SPDX-License-Identifier: Apache-2.0
#include "haptic/protocol/messages.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace hapticell::haptic {

namespace {

bool allFinite(std::initializer_list<double> values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

bool allNotNegative(std::initializer_list<double> values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value) && value >= 0.0; });
}

bool isFinite(const dvec3& v) {
  return allFinite({v.x, v.y, v.z});
}

}  // namespace

bool isWellFormed(const HapticControl& control) {
  return allNotNegative(
             {control.stiffness, control.damping, control.load.mass, control.load.damping, control.load.friction}) &&
         isFinite(control.load.weight_D);
}

bool isWellFormed(const HandTarget& target) {
  return target.X_DH.isValid();
}

bool isWellFormed(const HapticState& state) {
  return state.X_DS.isValid() && state.X_DP.isValid() && isFinite(state.v_DS) && isFinite(state.force_D) &&
         isFinite(state.torque_D) && allNotNegative({state.force_ramp, state.motor_temperature}) &&
         state.force_ramp <= 1.0;
}

bool isWellFormed(const ServerStatistics& s) {
  return allNotNegative({s.rate_hz, s.late_p50_ms, s.late_p99_ms, s.late_max_ms}) &&
         allFinite({s.round_trip_ms, s.set_age_p50_ms, s.set_age_p99_ms, s.clock_offset_ms.value_or(0.0)});
}

bool isWellFormed(const DeviceDescription& device) {
  const dvec3 size = device.workspace_max - device.workspace_min;
  return isFinite(device.workspace_min) && isFinite(device.workspace_max) && size.x >= 0.0 && size.y >= 0.0 &&
         size.z >= 0.0 &&
         allNotNegative({device.resolution, device.peak_force, device.continuous_force, device.stiffness,
                         device.damping, device.peak_torque}) &&
         device.measured_axes >= 0 && device.measured_axes <= 6 && device.driven_axes >= 0 && device.driven_axes <= 6 &&
         device.buttons >= 0 && device.buttons <= 32;
}

}  // namespace hapticell::haptic
