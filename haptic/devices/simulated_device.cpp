// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/simulated_device.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "geometry/shapes/vector.h"

namespace hapticell::haptic {

namespace {

/// s of integration: 150 steps in the quickest swing (45 g on 8 N/mm: 15 ms). Half: twice the time of a session; twice:
/// half as many steps.
constexpr double kStep = 1e-4;
/// Part of the linkage's stretch at which the stop begins: before the arm is straight, where its mass has no bound.
/// Half: most of the workspace is lost; 1: the arm can lock straight.
constexpr double kReachUsed = 0.97;
/// N m s/rad of a stylus that nobody holds: with its 1e-4 kg m2 a time constant of 0.05 s. Our choice. Half: it turns
/// on for 0.1 s; twice: for 0.025 s.
constexpr double kGimbalDamping = 2e-3;

double roundTo(double value, double step) {
  return step > 0.0 ? std::round(value / step) * step : value;
}

/// The orientation as gimbal encoders tell it: yaw, pitch and roll in whole steps. The error of the orientation is at
/// most three half steps, also where pitch is a right angle and the angles themselves are arbitrary.
dquat roundedByGimbal(const dquat& q, double step) {
  const dmat3 R = glm::mat3_cast(q);  // Column-major: R[c][r].
  const double pitch = std::asin(std::clamp(-R[0][2], -1.0, 1.0));
  const double yaw = std::atan2(R[0][1], R[0][0]);
  const double roll = std::atan2(R[1][2], R[2][2]);
  return glm::normalize(glm::angleAxis(roundTo(yaw, step), dvec3(0, 0, 1)) *
                        glm::angleAxis(roundTo(pitch, step), dvec3(0, 1, 0)) *
                        glm::angleAxis(roundTo(roll, step), dvec3(1, 0, 0)));
}

DeviceCapabilities capabilitiesOf(const config::DeviceProfile& profile) {
  DeviceCapabilities result;
  result.name = profile.name;
  result.workspace_min = -0.5 * profile.workspace;
  result.workspace_max = 0.5 * profile.workspace;
  result.resolution = profile.resolution;
  result.measured_axes = profile.measured_axes;
  result.driven_axes = profile.driven_axes;
  result.peak_force = profile.peak_force;
  result.continuous_force = profile.continuous_force;
  result.peak_torque = profile.peak_torque;
  result.stiffness = profile.stiffness;
  result.damping = profile.damping;
  result.buttons = profile.buttons;
  result.simulated = true;
  result.delay_ticks = profile.electronics.delay_ticks;
  result.thermal_time = profile.electronics.thermal_time;
  return result;
}

}  // namespace

SimulatedDevice::SimulatedDevice(const config::DeviceProfile& profile)
    : profile_(profile),
      capabilities_(capabilitiesOf(profile)),
      arm_(profile.mechanics.upper_arm, profile.mechanics.forearm) {
  const dmat3 J = arm_.jacobian(arm_.joints(dvec3(0.0)));
  // Inertia of each joint such that the tip has the stated apparent mass where the arm was measured, in the middle.
  for (int i = 0; i < 3; ++i) joint_inertia_[i] = profile_.mechanics.apparent_mass * glm::dot(J[i], J[i]);
  for (int i = 0; i < 3; ++i) lever_[i] = glm::length(J[i]);
  place(Pose::identity());
}

Expected<void> SimulatedDevice::open() {
  open_ = true;
  return {};
}

void SimulatedDevice::close() noexcept {
  open_ = false;
  commands_.fill({});
  motor_D_ = motor_torque_D_ = dvec3(0.0);
}

void SimulatedDevice::place(const Pose& X_DS) noexcept {
  X_DS_ = X_DS;
  v_DS_ = dvec3(0.0);
  w_DS_ = dvec3(0.0);
  updateMass();
}

DeviceStatus SimulatedDevice::read(DeviceReading& reading) noexcept {
  if (!open_) return DeviceStatus::kNotOpen;
  // Each encoder sees its own joint, so the tip's step is a little different everywhere.
  dvec3 joints = arm_.joints(X_DS_.p);
  for (int i = 0; i < 3; ++i) joints[i] = roundTo(joints[i], profile_.resolution / lever_[i]);
  reading.X_DS = {arm_.tip(joints), roundedByGimbal(X_DS_.q, profile_.rotation_resolution)};
  const auto mask = (1u << profile_.buttons) - 1u;
  reading.buttons = hand_.holding() ? hand_.buttons() & mask : 0u;
  reading.motor_temperature = temperature_;
  return DeviceStatus::kOk;
}

DeviceStatus SimulatedDevice::write(const dvec3& force_D, const dvec3& torque_D) noexcept {
  if (!open_) return DeviceStatus::kNotOpen;
  const bool good = isFinite(force_D) && isFinite(torque_D);
  commands_[0] = good ? Command{force_D, torque_D} : Command{};
  return good ? DeviceStatus::kOk : DeviceStatus::kFault;
}

void SimulatedDevice::updateMass() noexcept {
  const dmat3 J = arm_.jacobian(arm_.joints(X_DS_.p));
  dmat3 mobility(0.0);
  for (int i = 0; i < 3; ++i) mobility += glm::outerProduct(J[i], J[i]) / joint_inertia_[i];
  // Near a singularity the mobility loses rank; a hundredth of the nominal one bounds the mass to a hundred times.
  mobility += dmat3(0.01 / profile_.mechanics.apparent_mass);
  mass_ = glm::inverse(mobility);
  if (hand_.holding()) mass_ += dmat3(hand_.options().mass);
  inverse_mass_ = glm::inverse(mass_);
}

void SimulatedDevice::applyDelayedForce() noexcept {
  const auto delay =
      static_cast<std::size_t>(std::clamp(profile_.electronics.delay_ticks, 0, static_cast<int>(kMaxDelay) - 1));
  const Command command = open_ ? commands_[delay] : Command{};
  for (std::size_t i = kMaxDelay - 1; i > 0; --i) commands_[i] = commands_[i - 1];
  // Each motor's torque goes through its own converter; its range is the tip's force at the middle's lever.
  const dmat3 J = arm_.jacobian(arm_.joints(X_DS_.p));
  const double levels = std::ldexp(1.0, profile_.electronics.converter_bits - 1);
  dvec3 torque = glm::transpose(J) * shortenedTo(command.force_D, profile_.electronics.converter_range);
  for (int i = 0; i < 3; ++i) {
    const double full = profile_.electronics.converter_range * lever_[i];
    torque[i] = std::clamp(std::round(torque[i] / full * levels), -levels, levels - 1.0) * full / levels;
  }
  const dmat3 damped = J * glm::transpose(J) + dmat3(1e-6);
  motor_D_ = glm::inverse(damped) * (J * torque);
  // The gimbal's motors, about the axes of D.
  motor_torque_D_ = shortenedTo(command.torque_D, profile_.peak_torque);
  if (profile_.peak_torque > 0.0) {
    motor_torque_D_ = glm::round(motor_torque_D_ / profile_.peak_torque * levels) * profile_.peak_torque / levels;
  }
}

dvec3 SimulatedDevice::stopForce() const noexcept {
  dvec3 force(0.0);
  for (int i = 0; i < 3; ++i) {
    const double over = std::abs(X_DS_.p[i]) - 0.5 * profile_.workspace[i];
    if (over <= 0.0) continue;
    const double outward = X_DS_.p[i] > 0.0 ? 1.0 : -1.0;
    force[i] -= outward * std::max(0.0, profile_.mechanics.stop_stiffness * over +
                                            profile_.mechanics.stop_damping * outward * v_DS_[i]);
  }
  const dvec3 arm = X_DS_.p - arm_.shoulder();
  const double stretch = glm::length(arm);
  const double over = stretch - kReachUsed * arm_.reach();
  if (over > 0.0) {
    const dvec3 outward = arm / stretch;
    const double push =
        profile_.mechanics.stop_stiffness * over + profile_.mechanics.stop_damping * glm::dot(outward, v_DS_);
    force -= outward * std::max(0.0, push);
  }
  return force;
}

void SimulatedDevice::integrate(double h, double into_tick) noexcept {
  dvec3 force =
      motor_D_ + stopForce() - profile_.mechanics.viscous_friction * v_DS_ - dvec3(0.0, 0.0, profile_.mechanics.weight);
  hand_D_ = dvec3(0.0);
  HandIntent intent;
  if (hand_.holding()) {
    intent = hand_.intentAt(into_tick);
    const HandOptions& hand = hand_.options();
    hand_D_ =
        shortenedTo(hand.stiffness * (intent.X_DH.p - X_DS_.p) + hand.damping * (intent.v_DH - v_DS_), hand.max_force);
    force += hand_D_;
  }
  const dvec3 v = v_DS_ + inverse_mass_ * force * h;
  // Coulomb friction takes at most its impulse and never more than stops the motion: sticking.
  const double momentum = glm::length(mass_ * v);
  const double kept = momentum > 0.0 ? std::max(0.0, 1.0 - profile_.mechanics.coulomb_friction * h / momentum) : 0.0;
  v_DS_ = kept * v;
  X_DS_.p += v_DS_ * h;
  integrateRotation(h, intent);
}

void SimulatedDevice::integrateRotation(double h, const HandIntent& intent) noexcept {
  const HandOptions& hand = hand_.options();
  dvec3 torque = motor_torque_D_ - kGimbalDamping * w_DS_;
  if (hand_.holding()) {
    torque += hand.rotational_stiffness * difference(intent.X_DH, X_DS_).angular +
              hand.rotational_damping * (intent.w_DH - w_DS_);
  }
  w_DS_ += torque * (h / hand.inertia);
  X_DS_.q = glm::normalize(quaternionFromRotationVector(w_DS_ * h) * X_DS_.q);
}

void SimulatedDevice::advance(double dt) noexcept {
  if (!(dt > 0.0)) return;
  dt = std::min(dt, 0.1);
  hand_.beginTick(X_DS_, dt);
  updateMass();
  applyDelayedForce();
  const int steps = std::max(1, static_cast<int>(std::lround(dt / kStep)));
  const double h = dt / steps;
  for (int i = 0; i < steps; ++i) integrate(h, (i + 1) * h);
  // Motors warm with the square of the force and reach the limit at the continuous one.
  const double load = glm::dot(motor_D_, motor_D_) / (profile_.continuous_force * profile_.continuous_force);
  temperature_ += (load - temperature_) * (1.0 - std::exp(-dt / profile_.electronics.thermal_time));
}

}  // namespace hapticell::haptic
