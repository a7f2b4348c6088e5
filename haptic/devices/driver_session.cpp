// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/driver_session.h"

#include <chrono>
#include <cmath>

#include "haptic/devices/device.h"
#include "haptic/devices/driver_support.h"

namespace hapticell::haptic {

namespace {

constexpr std::uint32_t kMostCalibrationSteps = 16;
constexpr auto kFreshForNs = static_cast<std::int64_t>(1e9 * kFreshFor);

bool allFinite(const driver::State& state) {
  double sum = state.motor_temperature;
  for (const double value : state.position) sum += value;
  for (const double value : state.orientation) sum += value;
  for (const double value : state.motion) sum += value;
  for (const double value : state.sensors) sum += value;
  return std::isfinite(sum);
}

}  // namespace

DriverSession::DriverSession(driver::Driver& driver, std::string id, DriverSessionOptions options)
    : driver_(driver), id_(std::move(id)), options_(std::move(options)) {}

DriverSession::~DriverSession() {
  close();
}

driver::Problem DriverSession::open() {
  driver::Problem problem;
  if (device_ != nullptr) return problem;
  device_ = driver_.open(id_.c_str(), problem);
  if (device_ == nullptr) {
    if (problem.status == driver::Status::kOk) {
      driver::refuse(problem, driver::Status::kFault, "the driver opened nothing and did not say why");
    }
    return problem;
  }
  capabilities_ = device_->capabilities();
  answer_ = {};
  answer_.status = driver::Status::kOk;
  steps_ = {};
  measured_ns_ = commanded_ns_ = 0;
  held_ = false;
  garbled_ = 0;
  asked_for_calibration_ = false;
  condition_.calibration.clear();
  for (std::uint32_t step = 0; step < kMostCalibrationSteps; ++step) {
    const char* const text = device_->calibrationText(step);
    if (text == nullptr) break;
    condition_.calibration.emplace_back(text);
  }
  // Until the first measurement says so; a device that wants nothing is taken at its word.
  condition_.calibrated = condition_.calibration.empty();
  condition_.answers = true;
  sendCondition();
  return {};
}

void DriverSession::close() {
  if (device_ == nullptr) return;
  device_->write(driver::Command{});
  driver_.close(device_);
  device_ = nullptr;
  answer_.status = driver::Status::kVanished;
  answer_.takes_force = false;
}

std::int64_t DriverSession::now() const {
  if (options_.now) return options_.now();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

bool DriverSession::mayPush(std::int64_t now) const {
  const bool willing = (answer_.state.flags & (driver::kCalibrated | driver::kForceless)) == driver::kCalibrated;
  const bool fresh = answer_.measurements > 0 && now - measured_ns_ < kFreshForNs;
  return willing && (fresh || capabilities_.driven_axes == 0);
}

driver::Command DriverSession::allowed(const driver::Command& command) {
  const std::int64_t at = now();
  const bool may = mayPush(at);
  // Without a command for so long the device may have let go by itself.
  const bool late = capabilities_.driven_axes > 0 && commanded_ns_ != 0 && at - commanded_ns_ >= kFreshForNs;
  held_ = command.motors && (held_ || late || !may);
  answer_.takes_force = may && !held_;
  commanded_ns_ = at;
  driver::Command result = command;
  if (!command.motors || held_) {
    result.motors = false;
    for (int i = 0; i < 3; ++i) result.force[i] = result.torque[i] = 0.0;
  }
  return steps_.next(result);
}

const DriverAnswer& DriverSession::turn(const driver::Command& command) {
  if (device_ == nullptr) {
    tryAgain();
    return answer_;
  }
  driver::State state = answer_.state;
  driver::Status status = device_->read(state);
  if (status == driver::Status::kOk && !allFinite(state)) status = driver::Status::kGarbled;
  if (!keep(status, true)) return answer_;
  if (status == driver::Status::kOk) {
    measured_ns_ = now();
    answer_.state = state;
    ++answer_.measurements;
    askForCalibration();
    condition_.calibrated = (state.flags & driver::kCalibrated) != 0;
    condition_.docked = (state.flags & driver::kDocked) != 0;
    sendCondition();
  }
  calibrateIfAsked();
  keep(device_->write(allowed(command)), false);
  return answer_;
}

void DriverSession::askForCalibration() {
  if ((answer_.state.flags & driver::kCalibrated) != 0) {
    if (asked_for_calibration_) report(std::string(capabilities_.name) + ": it is calibrated.");
    asked_for_calibration_ = false;
  } else if (const char* const text = device_->calibrationText(0); text != nullptr && !asked_for_calibration_) {
    asked_for_calibration_ = true;
    report(std::string(capabilities_.name) + ": it is not calibrated, and exerts no force until it is. " + text);
  }
}

void DriverSession::calibrateIfAsked() {
  const auto step = options_.care ? options_.care->takeCalibration() : std::nullopt;
  if (!step || *step >= condition_.calibration.size()) return;
  const driver::Status status = device_->calibrate(*step);
  if (status == driver::Status::kOk || status == driver::Status::kNothingNew) return;
  const driver::Problem& problem = device_->problem();
  const std::string fix = problem.fix[0] != '\0' ? std::string(". ") + problem.fix : "";
  report(std::string(capabilities_.name) + ": it could not be calibrated: " + problem.found + fix);
}

void DriverSession::sendCondition() {
  if (!options_.care || condition_ == told_) return;
  told_ = condition_;
  options_.care->tell(condition_);
}

bool DriverSession::keep(driver::Status status, bool reading) {
  switch (status) {
    case driver::Status::kOk:
      if (reading) garbled_ = 0;
      [[fallthrough]];
    case driver::Status::kNothingNew:
    case driver::Status::kNotCalibrated:
      answer_.status = driver::Status::kOk;
      return true;
    case driver::Status::kGarbled:
      if (++garbled_ < options_.garbled_turns) return true;
      [[fallthrough]];
    default:
      lose(device_->problem());
      return false;
  }
}

void DriverSession::lose(const driver::Problem& problem) {
  const std::string why = problem.found[0] != '\0' ? problem.found : "it does not answer as it should";
  const std::string fix = problem.fix[0] != '\0' ? std::string(" ") + problem.fix : "";
  const driver::Status status = problem.status == driver::Status::kOk ? driver::Status::kFault : problem.status;
  close();
  answer_.status = status;
  turns_without_ = 0;
  condition_.answers = false;
  report(std::string(capabilities_.name) + ": " + why + ". Forces are off." + fix);
}

void DriverSession::tryAgain() {
  if (++turns_without_ < options_.reopen_turns) return;
  turns_without_ = 0;
  const driver::Status before = answer_.status;
  if (open().status != driver::Status::kOk) {
    answer_.status = before;
    return;
  }
  report(std::string(capabilities_.name) + ": it answers again. Forces stay off until they are switched on.");
}

void DriverSession::report(const std::string& sentence) {
  condition_.sentence = sentence;
  sendCondition();
  if (options_.report) options_.report(sentence);
}

}  // namespace hapticell::haptic
