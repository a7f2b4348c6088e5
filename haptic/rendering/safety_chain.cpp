// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/safety_chain.h"

#include <algorithm>
#include <cmath>

namespace hapticell::haptic {

namespace {

constexpr double kImplausible = 1e4;     // N; nothing on a desk makes such a force.
constexpr double kLongestTick = 0.1;     // s that one call can stand for.
constexpr double kSlewTick = 0.001;      // s; a late tick does not earn a larger step.
constexpr double kDeratingBegins = 0.8;  // Motor temperature.

bool isPlausible(const dvec3& v) {
  return std::abs(v.x) < kImplausible && std::abs(v.y) < kImplausible && std::abs(v.z) < kImplausible;
}

dvec3 insideBall(const dvec3& v, double radius) {
  const double length = glm::length(v);
  if (length <= radius) return v;
  const dvec3 shrunk = v * (radius / length);
  // Rounding can leave it outside by a few units of the last place.
  return glm::length(shrunk) <= radius ? shrunk : shrunk * (1.0 - 1e-15);
}

dvec3 walk(const dvec3& from, const dvec3& to, double step) {
  const dvec3 way = to - from;
  return glm::length(way) <= step ? to : from + insideBall(way, step);
}

double saneOr(double value, double fallback) {
  return std::isfinite(value) && value > 0.0 ? value : fallback;
}

SafetyOptions sane(const SafetyOptions& wanted) {
  const SafetyOptions defaults;
  SafetyOptions options = wanted;
  options.peak_force = saneOr(wanted.peak_force, defaults.peak_force);
  options.continuous_force = std::min(saneOr(wanted.continuous_force, defaults.continuous_force), options.peak_force);
  options.slew = saneOr(wanted.slew, defaults.slew);
  options.thermal_time = saneOr(wanted.thermal_time, defaults.thermal_time);
  options.gate_force = saneOr(wanted.gate_force, defaults.gate_force);
  options.ramp_time = saneOr(wanted.ramp_time, defaults.ramp_time);
  options.silence_limit = saneOr(wanted.silence_limit, defaults.silence_limit);
  options.silence_decay = saneOr(wanted.silence_decay, defaults.silence_decay);
  options.close_decay = saneOr(wanted.close_decay, defaults.close_decay);
  if (!std::isfinite(wanted.ramp_damping) || wanted.ramp_damping < 0.0) options.ramp_damping = defaults.ramp_damping;
  return options;
}

}  // namespace

SafetyChain::SafetyChain(const SafetyOptions& options) : options_(sane(options)) {}

void SafetyChain::reset() noexcept {
  last_D_ = slewed_D_ = dvec3(0.0);
  gate_ = GateState::kClosed;
  small_ticks_ = 0;
  ramp_ = 0.0;
  fade_ = 1.0;
  needs_new_enable_ = false;
}

void SafetyChain::trip() noexcept {
  needs_new_enable_ = true;
}

SafetyResult SafetyChain::tick(const SafetyInput& input) noexcept {
  const double dt = std::clamp(std::isfinite(input.dt) ? input.dt : kSlewTick, 0.0, kLongestTick);
  const double step = options_.slew * std::min(dt, kSlewTick);
  SafetyResult result;

  result.input_fault = !isPlausible(input.force_D);
  const dvec3 wanted = result.input_fault ? dvec3(0.0) : input.force_D;
  result.slew_limited = glm::length(wanted - slewed_D_) > step;
  slewed_D_ = insideBall(walk(slewed_D_, wanted, step), options_.peak_force);
  const double thermal_limit = thermalLimit();
  result.derated = glm::length(slewed_D_) > thermal_limit;
  dvec3 force = insideBall(slewed_D_, thermal_limit);

  stepFade(input, dt);
  stepGate(input, !result.input_fault && glm::length(wanted) < options_.gate_force, dt);
  force *= ramp_ * fade_;
  if (gate_ == GateState::kRamping && isPlausible(input.v_DS)) {
    force -= (options_.ramp_damping * (1.0 - ramp_) * fade_) * input.v_DS;
  }
  last_D_ = insideBall(walk(last_D_, insideBall(force, options_.peak_force), step), options_.peak_force);
  stepTemperature(input.reported_temperature, dt);

  result.force_D = last_D_;
  result.gate = gate_;
  result.ramp = ramp_;
  result.fade = fade_;
  result.temperature = temperature_;
  result.force_limit = thermalLimit();
  return result;
}

void SafetyChain::stepFade(const SafetyInput& input, double dt) noexcept {
  // A silence that is no number is no sign of life.
  const bool silent = !(input.link_silence <= options_.silence_limit);
  if (silent) {
    fade_ = std::max(0.0, fade_ - dt / options_.silence_decay);
    return;
  }
  fade_ = gate_ == GateState::kClosed || gate_ == GateState::kWaiting ? 1.0
                                                                      : std::min(1.0, fade_ + dt / options_.ramp_time);
}

void SafetyChain::stepGate(const SafetyInput& input, bool small_force, double dt) noexcept {
  if (!input.enabled) needs_new_enable_ = false;
  if (!input.link_open && input.enabled) needs_new_enable_ = true;
  const bool shut = !input.enabled || !input.link_open || needs_new_enable_;
  const bool pushes = gate_ == GateState::kRamping || gate_ == GateState::kOpen;
  if (shut && pushes) gate_ = GateState::kClosing;
  // Once a silent link has faded everything, its return begins with the small-force state again.
  if (!shut && pushes && fade_ <= 0.0) {
    gate_ = GateState::kWaiting;
    ramp_ = 0.0;
    small_ticks_ = 0;
  }
  switch (gate_) {
    case GateState::kClosed:
      small_ticks_ = 0;
      if (!shut) gate_ = GateState::kWaiting;
      break;
    case GateState::kWaiting:
      small_ticks_ = small_force && fade_ > 0.0 ? small_ticks_ + 1 : 0;
      if (shut)
        gate_ = GateState::kClosed;
      else if (small_ticks_ > options_.gate_ticks)
        gate_ = GateState::kRamping;
      break;
    case GateState::kRamping:
      ramp_ = std::min(1.0, ramp_ + dt / options_.ramp_time);
      if (ramp_ >= 1.0) gate_ = GateState::kOpen;
      break;
    case GateState::kOpen:
      break;
    case GateState::kClosing:
      ramp_ = std::max(0.0, ramp_ - dt / options_.close_decay);
      if (ramp_ <= 0.0) gate_ = GateState::kClosed;
      break;
  }
}

double SafetyChain::thermalLimit() const noexcept {
  const double room = std::clamp((1.0 - temperature_) / (1.0 - kDeratingBegins), 0.0, 1.0);
  return options_.continuous_force + (options_.peak_force - options_.continuous_force) * room;
}

void SafetyChain::stepTemperature(double reported, double dt) noexcept {
  const double load = glm::dot(last_D_, last_D_) / (options_.continuous_force * options_.continuous_force);
  temperature_ += (load - temperature_) * (1.0 - std::exp(-dt / options_.thermal_time));
  if (reported > temperature_ && reported <= 2.0) temperature_ = reported;
}

}  // namespace hapticell::haptic
