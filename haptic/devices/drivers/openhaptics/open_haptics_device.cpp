// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/openhaptics/open_haptics_device.h"

#include <algorithm>
#include <cmath>

#include "haptic/devices/driver_support.h"

namespace hapticell::driver {

namespace {

constexpr double kMetre = 1e-3;  // HDAPI counts millimetres.
/// Ticks without a command before the force is let go of. The host acts first, at 25 ms (kSilentLoop). Half: both at
/// once; twice: an old force acts 0.1 s if the host dies.
constexpr int kHostPatience = 50;
/// Reads, a millisecond apart, without a tick of the vendor's scheduler before the device counts as unplugged. Our
/// choice. Half: a busy machine loses it; twice: reported after 0.4 s.
constexpr int kSchedulerPatience = 200;
/// Such reads after which the scheduler is not waited for: the amplifiers go off within kFreshFor. Half: a late
/// scheduler costs the force; twice: the last force acts for over 20 ms.
constexpr int kStandsStill = 15;
/// Ticks without force after one was refused (force, impulse or speed): a contact is over by then. Our choice. Half:
/// the same contact may be refused again; twice: half a second without force.
constexpr int kQuiet = 250;
/// Ticks that a warning of warm motors is reported, as the vendor says it once. Our choice. Half: full force comes back
/// sooner, and the next warning; twice: 2 s of reduced force for each.
constexpr int kWarm = 1000;
/// Of the stiffness that the maker states, which is for its own rendering: a margin of a fifth. Our choice, on no real
/// device. Half: soft walls; twice: over the maker's limit, it trembles.
constexpr double kOfNominalStiffness = 0.8;
constexpr double kPremiumTorque = 0.188;  // N m of the Premium 6DOF, the only such device.
constexpr unsigned short kPriority = 65535;

bool isExceeded(unsigned code) {
  return code == hd::kExceededMaxForce || code == hd::kExceededImpulse || code == hd::kExceededVelocity;
}

/// Worse errors have a higher rank; a warning has none.
int rank(unsigned code) {
  if (code == 0 || code == hd::kWarmMotors || isExceeded(code)) return 0;
  return code >= hd::kDeviceFault && code <= hd::kTimerError ? 2 : 1;
}

}  // namespace

dvec3 HdFrame::position(const double* p) const {
  const dvec3 from_middle = kMetre * (dvec3(p[0], p[1], p[2]) - middle_hd);
  return {from_middle.x, -from_middle.z, from_middle.y};
}

dquat HdFrame::orientation(const double* m) {
  const dmat3 R_hd(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]);  // Column by column.
  const dmat3 R_DH(1, 0, 0, 0, 0, 1, 0, -1, 0);                             // x to x, y up to z, z to -y.
  return glm::normalize(glm::quat_cast(R_DH * R_hd * glm::transpose(R_DH)));
}

dvec3 HdFrame::toHd(const dvec3& v_D) {
  return {v_D.x, v_D.z, -v_D.y};
}

OpenHapticsDevice::OpenHapticsDevice(const HdLibrary& hd, unsigned handle) : hd_(hd), handle_(handle) {
  readCapabilities();
}

OpenHapticsDevice::~OpenHapticsDevice() {
  if (scheduled_) hd_.hdUnschedule(callback_);
  hd_.hdMakeCurrentDevice(handle_);
  hd_.hdDisable(hd::kForceOutput);
  hd_.hdDisableDevice(handle_);
}

void OpenHapticsDevice::readCapabilities() {
  const auto number = [this](unsigned what, double otherwise) {
    double values[6] = {};
    hd_.hdGetDoublev(what, values);
    return hd_.hdGetError().code == 0 && std::isfinite(values[0]) && values[0] > 0.0 ? values[0] : otherwise;
  };
  const auto text = [this](unsigned what) {
    const char* const words = hd_.hdGetString(what);
    return hd_.hdGetError().code == 0 && words != nullptr ? std::string(words) : std::string();
  };
  const std::string model = text(hd::kModelType);
  copyText(capabilities_.name, model.empty() ? "OpenHaptics device" : model);
  copyText(capabilities_.firmware, text(hd::kFirmwareVersion));
  double box[6] = {-80, -60, -35, 80, 60, 35};
  hd_.hdGetDoublev(hd::kUsableWorkspace, box);
  if (hd_.hdGetError().code != 0) std::copy_n(std::to_array<double>({-80, -60, -35, 80, 60, 35}).begin(), 6, box);
  const dvec3 low(box[0], box[1], box[2]), high(box[3], box[4], box[5]);
  frame_.middle_hd = 0.5 * (low + high);
  const dvec3 half = 0.5 * kMetre * (high - low);
  const dvec3 half_D(half.x, half.z, half.y);
  for (int i = 0; i < 3; ++i) {
    capabilities_.workspace_min[i] = -half_D[i];
    capabilities_.workspace_max[i] = half_D[i];
  }
  int axes = 3, style = 0;
  hd_.hdGetIntegerv(hd::kOutputAxes, &axes);
  if (hd_.hdGetError().code != 0) axes = 3;
  hd_.hdGetIntegerv(hd::kCalibrationStyle, &style);
  calibration_style_ = hd_.hdGetError().code == 0 ? static_cast<unsigned>(style) : 0;
  capabilities_.measured_axes = 6;
  capabilities_.driven_axes = axes >= 6 ? 6 : 3;
  capabilities_.peak_torque = capabilities_.driven_axes == 6 ? kPremiumTorque : 0.0;
  capabilities_.buttons = 2;
  capabilities_.peak_force = number(hd::kMaxForce, 3.3);
  capabilities_.continuous_force = std::min(capabilities_.peak_force, number(hd::kMaxContinuousForce, 0.88));
  capabilities_.stiffness = kOfNominalStiffness * 1000.0 * number(hd::kMaxStiffness, 0.5);
  capabilities_.damping = 2.0;
  capabilities_.resolution = 0.055e-3;
  capabilities_.rate_hz = 1000.0;
}

void OpenHapticsDevice::schedule() {
  if (scheduled_) return;
  callback_ = hd_.hdScheduleAsynchronous([](void* self) { return static_cast<OpenHapticsDevice*>(self)->tick(); }, this,
                                         kPriority);
  scheduled_ = true;
}

unsigned OpenHapticsDevice::tick() {
  Sample& sample = samples_.writeSlot();
  sample = {};
  hd_.hdMakeCurrentDevice(handle_);
  hd_.hdBeginFrame(handle_);
  measure(sample);
  calibrateIfAsked(sample);
  command();
  hd_.hdEndFrame(handle_);
  collectErrors(sample);
  samples_.publish();
  return hd::kContinue;
}

void OpenHapticsDevice::measure(Sample& sample) {
  double position[3] = {}, transform[16] = {}, temperature[6] = {};
  int buttons = 0, inkwell = 0;
  hd_.hdGetDoublev(hd::kCurrentPosition, position);
  hd_.hdGetDoublev(hd::kCurrentTransform, transform);
  hd_.hdGetDoublev(hd::kMotorTemperature, temperature);
  hd_.hdGetIntegerv(hd::kCurrentButtons, &buttons);
  hd_.hdGetIntegerv(hd::kCurrentInkwell, &inkwell);
  State& state = sample.state;
  const dvec3 p_D = frame_.position(position);
  const dquat q_D = HdFrame::orientation(transform);
  for (int i = 0; i < 3; ++i) state.position[i] = p_D[i];
  state.orientation[0] = q_D.w, state.orientation[1] = q_D.x;
  state.orientation[2] = q_D.y, state.orientation[3] = q_D.z;
  state.buttons = static_cast<unsigned>(buttons) & 3u;
  state.motor_temperature = *std::max_element(temperature, temperature + 6);
  if (quiet_ticks_ > 0 || let_go_) state.flags |= kForceless;
  if (inkwell != 0) state.flags |= kDocked;
  if (force_output_) state.flags |= kMotorsOn;
}

void OpenHapticsDevice::calibrateIfAsked(Sample& sample) {
  const unsigned calibration = hd_.hdCheckCalibration();
  if (calibration == hd::kCalibrationOk) sample.state.flags |= kCalibrated;
  const bool asked = asked_to_calibrate_.exchange(false);
  const unsigned style = calibration_style_ != 0 ? calibration_style_ : hd::kStyleInkwell;
  const bool docked = (sample.state.flags & kDocked) != 0 && (style & hd::kStyleInkwell) != 0;
  // "Needs update": the device has found its reference by itself (its inkwell, its stops) and waits to be told so.
  const bool found = calibration == hd::kCalibrationUpdate || (calibration != hd::kCalibrationOk && docked);
  if (!found && !asked) return;
  // The styles are bits: the device names those that it knows, and takes one.
  unsigned taken = style;
  if ((style & hd::kStyleInkwell) != 0)
    taken = hd::kStyleInkwell;
  else if ((style & hd::kStyleAuto) != 0)
    taken = hd::kStyleAuto;
  hd_.hdUpdateCalibration(taken);
}

void OpenHapticsDevice::command() {
  ticks_without_command_ = commands_.update() ? 0 : ticks_without_command_ + 1;
  if (quiet_ticks_ > 0) --quiet_ticks_;
  const Command& wanted = commands_.value();
  // What was let go of stays so until the host knows and restarts: force never comes back in one step.
  let_go_ = wanted.motors && (let_go_ || ticks_without_command_ >= kHostPatience || quiet_ticks_ > 0);
  const bool on = wanted.motors && !let_go_;
  if (on != force_output_) {
    on ? hd_.hdEnable(hd::kForceOutput) : hd_.hdDisable(hd::kForceOutput);
    force_output_ = on;
  }
  const Command now = steps_.next(on ? wanted : Command{});
  const dvec3 force = HdFrame::toHd({now.force[0], now.force[1], now.force[2]});
  hd_.hdSetDoublev(hd::kCurrentForce, &force.x);
  if (capabilities_.driven_axes < 6) return;
  const dvec3 torque = HdFrame::toHd({now.torque[0], now.torque[1], now.torque[2]});
  const dvec3 torque_mnm = 1000.0 * torque;  // HDAPI: mN m.
  hd_.hdSetDoublev(hd::kCurrentTorque, &torque_mnm.x);
}

void OpenHapticsDevice::collectErrors(Sample& sample) {
  if (warm_ticks_ > 0) --warm_ticks_;
  for (int i = 0; i < 16; ++i) {  // The stack is as deep as the vendor likes.
    const HdError error = hd_.hdGetError();
    if (error.code == 0) break;
    if (error.code == hd::kWarmMotors) warm_ticks_ = kWarm;
    if (isExceeded(error.code)) quiet_ticks_ = kQuiet;
    if (rank(error.code) > rank(sample.error)) sample.error = error.code, sample.internal = error.internal;
  }
  if (warm_ticks_ > 0) sample.state.motor_temperature = 1.0;
}

Status OpenHapticsDevice::statusOf(const Sample& sample) noexcept {
  if (rank(sample.error) == 0) return Status::kOk;
  const char* const words = hd_.hdGetErrorString(sample.error);
  problem_ = hdProblem(sample.error, sample.internal, words != nullptr ? words : "");
  return problem_.status;
}

Status OpenHapticsDevice::read(State& state) noexcept {
  if (!samples_.update()) {
    if (++reads_without_sample_ < kSchedulerPatience) return Status::kNothingNew;
    return refuse(problem_, Status::kVanished, "the vendor's scheduler has stopped",
                  "Unplug the device and plug it in again.");
  }
  reads_without_sample_ = 0;
  switched_off_ = false;
  const Sample& sample = samples_.value();
  if (const Status status = statusOf(sample); status != Status::kOk) return status;
  state = sample.state;
  return Status::kOk;
}

Status OpenHapticsDevice::write(const Command& command) noexcept {
  commands_.write(command);
  // A scheduler that stands still passes nothing on: the amplifiers are switched off past it.
  if (!command.motors && reads_without_sample_ >= kStandsStill && !switched_off_) {
    switched_off_ = true;
    hd_.hdMakeCurrentDevice(handle_);
    hd_.hdDisable(hd::kForceOutput);
  }
  return Status::kOk;
}

const char* OpenHapticsDevice::calibrationText(std::uint32_t step) const noexcept {
  if (step > 0) return nullptr;
  const bool inkwell = calibration_style_ == 0 || (calibration_style_ & hd::kStyleInkwell) != 0;
  return inkwell ? "Put the stylus into its inkwell and hold it still." : "Move every joint slowly to both its stops.";
}

Status OpenHapticsDevice::calibrate(std::uint32_t) noexcept {
  asked_to_calibrate_ = true;
  return Status::kOk;
}

Problem hdProblem(unsigned code, int internal, const std::string& text) {
  char number[48];
  std::snprintf(number, sizeof number, " (HD error %#x, internal %d)", code, internal);
  const std::string found = (text.empty() ? "the vendor's library reports a fault" : text) + number;
  Problem problem;
  const auto say = [&](Status status, const char* fix) { refuse(problem, status, found, fix); };
  switch (code) {
    case hd::kAlreadyInitiated:
      say(Status::kInUse, "Close the other program that uses the device.");
      break;
    case hd::kCommError:
    case hd::kCommConfig:
      say(Status::kVanished, "Check cable and power; for a Touch over Ethernet, pair it anew with the vendor's setup.");
      break;
    case hd::kDeviceFault:
      say(Status::kVanished, "Switch the device off and on again.");
      break;
    case hd::kForceError:
      say(Status::kFault, "Switch the device off, let it cool, and switch it on again.");
      break;
    case hd::kInvalidLicense:
      say(Status::kFault, "Install the vendor's licence.");
      break;
    default:
      say(Status::kFault, "Start the haptic server again.");
  }
  return problem;
}

}  // namespace hapticell::driver
