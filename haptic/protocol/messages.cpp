// SPDX-License-Identifier: Apache-2.0
#include "haptic/protocol/messages.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace hapticell::haptic {

namespace {

/// All finite and none greater, whatever the sign.
bool allWithin(std::initializer_list<double> values, double most) {
  return std::all_of(values.begin(), values.end(), [most](double value) { return std::abs(value) <= most; });
}

bool allUpTo(std::initializer_list<double> values, double most) {
  return std::all_of(values.begin(), values.end(), [most](double value) { return value >= 0.0 && value <= most; });
}

bool isWithin(const dvec3& v, double most) {
  return allWithin({v.x, v.y, v.z}, most);
}

}  // namespace

bool isWellFormed(const HapticControl& control) {
  const LoadOptions& load = control.load;
  return allUpTo({control.stiffness}, bound::kStiffness) && allUpTo({control.damping, load.damping}, bound::kDamping) &&
         allUpTo({load.mass, load.friction}, bound::kForce) && isWithin(load.weight_D, bound::kForce);
}

bool isWellFormed(const HandTarget& target) {
  return target.X_DH.isValid() && isWithin(target.X_DH.p, bound::kLength);
}

bool isWellFormed(const HapticState& state) {
  return state.X_DS.isValid() && state.X_DP.isValid() && isWithin(state.X_DS.p, bound::kLength) &&
         isWithin(state.X_DP.p, bound::kLength) && isWithin(state.v_DS, bound::kSpeed) &&
         isWithin(state.force_D, bound::kForce) && isWithin(state.torque_D, bound::kForce) &&
         allUpTo({state.force_ramp}, 1.0) && allUpTo({state.motor_temperature}, bound::kForce);
}

bool isWellFormed(const ServerStatistics& s) {
  return allUpTo({s.rate_hz, s.late_p50_ms, s.late_p99_ms, s.late_max_ms}, bound::kTime) &&
         allWithin({s.round_trip_ms, s.set_age_p50_ms, s.set_age_p99_ms, s.clock_offset_ms.value_or(0.0)},
                   bound::kTime);
}

bool isWellFormed(const DeviceDescription& device) {
  const dvec3 size = device.workspace_max - device.workspace_min;
  return isWithin(device.workspace_min, bound::kLength) && isWithin(device.workspace_max, bound::kLength) &&
         size.x >= 0.0 && size.y >= 0.0 && size.z >= 0.0 && allUpTo({device.resolution}, bound::kLength) &&
         allUpTo({device.peak_force, device.continuous_force, device.peak_torque}, bound::kForce) &&
         allUpTo({device.stiffness}, bound::kStiffness) && allUpTo({device.damping}, bound::kDamping) &&
         device.measured_axes >= 0 && device.measured_axes <= 6 && device.driven_axes >= 0 && device.driven_axes <= 6 &&
         device.buttons >= 0 && device.buttons <= 32;
}

}  // namespace hapticell::haptic
