// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/safety_chain.h"

#include <algorithm>
#include <cmath>

#include "haptic/rendering/constraint_set.h"
#include "haptic/rendering/positive_or.h"

namespace hapticell::haptic {

namespace {

// Of these three half and twice pass the tests of this folder.
constexpr double kImplausible = 1e4;     // N; nothing on a desk makes such a force.
constexpr double kLongestTick = 0.1;     // s that one call can stand for.
constexpr double kShortestLever = 1e-3;  // m: an implausible torque.
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

SafetyOptions sane(const SafetyOptions& wanted) {
  const SafetyOptions defaults;
  SafetyOptions options = wanted;
  options.peak_force = positiveOr(wanted.peak_force, defaults.peak_force);
  options.continuous_force =
      std::min(positiveOr(wanted.continuous_force, defaults.continuous_force), options.peak_force);
  options.peak_torque = positiveOr(wanted.peak_torque, 0.0);
  options.slew = positiveOr(wanted.slew, defaults.slew);
  options.thermal_time = positiveOr(wanted.thermal_time, defaults.thermal_time);
  options.gate_force = positiveOr(wanted.gate_force, defaults.gate_force);
  options.ramp_time = positiveOr(wanted.ramp_time, defaults.ramp_time);
  options.silence_limit = positiveOr(wanted.silence_limit, defaults.silence_limit);
  options.silence_decay = positiveOr(wanted.silence_decay, defaults.silence_decay);
  options.set_silence_limit = positiveOr(wanted.set_silence_limit, defaults.set_silence_limit);
  options.set_silence_decay = positiveOr(wanted.set_silence_decay, defaults.set_silence_decay);
  options.close_decay = positiveOr(wanted.close_decay, defaults.close_decay);
  options.speed_limit = positiveOr(wanted.speed_limit, defaults.speed_limit);
  options.speed_ticks = std::max(1, wanted.speed_ticks);
  if (!std::isfinite(wanted.ramp_damping) || wanted.ramp_damping < 0.0) options.ramp_damping = defaults.ramp_damping;
  return options;
}

}  // namespace

SafetyChain::SafetyChain(const SafetyOptions& options) : options_(sane(options)) {
  force_.peak = options_.peak_force;
  force_.slew = options_.slew;
  torque_.peak = options_.peak_torque;
  torque_.slew = options_.slew * kRotationLever;
}

void SafetyChain::cut() noexcept {
  force_.last = force_.slewed = torque_.last = torque_.slewed = dvec3(0.0);
  gate_ = GateState::kClosed;
  small_ticks_ = 0;
  ramp_ = 0.0;
}

void SafetyChain::reset() noexcept {
  cut();
  fade_ = 1.0;
  needs_new_enable_ = false;
}

void SafetyChain::trip() noexcept {
  needs_new_enable_ = true;
}

void SafetyChain::slewTowards(Channel& channel, const dvec3& wanted, double dt, SafetyResult& result) noexcept {
  const double step = channel.slew * std::min(dt, kSlewTick);
  if (glm::length(wanted - channel.slewed) > step && channel.peak > 0.0) result.slew_limited = true;
  channel.slewed = insideBall(walk(channel.slewed, wanted, step), channel.peak);
  if (glm::length(channel.slewed) > thermalShare() * channel.peak) result.derated = true;
}

void SafetyChain::finish(Channel& channel, const dvec3& wanted, double dt) noexcept {
  const double step = channel.slew * std::min(dt, kSlewTick);
  channel.last = insideBall(walk(channel.last, insideBall(wanted, channel.peak), step), channel.peak);
}

SafetyResult SafetyChain::tick(const SafetyInput& input) noexcept {
  const double dt = std::clamp(std::isfinite(input.dt) ? input.dt : kSlewTick, 0.0, kLongestTick);
  SafetyResult result;

  result.input_fault = !isPlausible(input.force_D) || !isPlausible(input.torque_D / kShortestLever);
  const dvec3 wanted = result.input_fault ? dvec3(0.0) : input.force_D;
  const dvec3 wanted_torque = result.input_fault ? dvec3(0.0) : input.torque_D;
  result.too_fast = isTooFast(input.v_DS);
  if (result.too_fast) trip();
  slewTowards(force_, wanted, dt, result);
  slewTowards(torque_, wanted_torque, dt, result);
  stepFade(input, dt);
  const bool small = glm::length(wanted) < options_.gate_force &&
                     (torque_.peak <= 0.0 || glm::length(wanted_torque) < options_.gate_force * kRotationLever);
  stepGate(input, !result.input_fault && small, dt);
  // A ceiling that rises: a share that grows would let motors give back what a hand never put in, pressing meanwhile.
  const double share = ramp_ * thermalShare();
  dvec3 force = fade_ * insideBall(force_.slewed, share * force_.peak);
  if (gate_ == GateState::kRamping && isPlausible(input.v_DS)) {
    force -= (options_.ramp_damping * (1.0 - ramp_) * fade_) * input.v_DS;
  }
  finish(force_, force, dt);
  finish(torque_, fade_ * insideBall(torque_.slewed, share * torque_.peak), dt);
  stepTemperature(input.reported_temperature, dt);

  result.force_D = force_.last;
  result.torque_D = torque_.last;
  result.gate = gate_;
  result.ramp = ramp_;
  result.fade = fade_;
  result.temperature = temperature_;
  result.force_limit = (ramp_ > 0.0 ? ramp_ : 1.0) * thermalShare() * options_.peak_force;
  return result;
}

/// One tick that is faster is a sample that has slipped through; a speed that is no number is no speed of a hand.
bool SafetyChain::isTooFast(const dvec3& v_DS) noexcept {
  fast_ticks_ = glm::length(v_DS) <= options_.speed_limit ? 0 : std::min(fast_ticks_ + 1, options_.speed_ticks);
  return fast_ticks_ >= options_.speed_ticks;
}

void SafetyChain::stepFade(const SafetyInput& input, double dt) noexcept {
  const bool quick = input.silence_limit > 0.0 && input.silence_limit < options_.silence_limit;
  // A silence that is no number is no sign of life.
  const bool silent = !(input.link_silence <= (quick ? input.silence_limit : options_.silence_limit));
  const bool stalled = !(input.set_silence <= options_.set_silence_limit);
  if (silent || stalled) {
    const double silence_decay =
        quick ? std::min(options_.close_decay, options_.silence_decay) : options_.silence_decay;
    fade_ = std::max(0.0, fade_ - dt / (silent ? silence_decay : options_.set_silence_decay));
    return;
  }
  fade_ = gate_ == GateState::kClosed || gate_ == GateState::kWaiting ? 1.0
                                                                      : std::min(1.0, fade_ + dt / options_.ramp_time);
}

void SafetyChain::stepGate(const SafetyInput& input, bool small_force, double dt) noexcept {
  if (!input.enabled) needs_new_enable_ = false;
  if (!input.link_open && input.enabled) needs_new_enable_ = true;
  const bool shut = !input.enabled || !input.link_open || needs_new_enable_ || !input.device_ready;
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

double SafetyChain::thermalShare() const noexcept {
  const double room = std::clamp((1.0 - temperature_) / (1.0 - kDeratingBegins), 0.0, 1.0);
  const double continuous = options_.continuous_force / options_.peak_force;
  return continuous + (1.0 - continuous) * room;
}

void SafetyChain::stepTemperature(double reported, double dt) noexcept {
  double load = glm::dot(force_.last, force_.last) / (options_.continuous_force * options_.continuous_force);
  if (torque_.peak > 0.0) {
    const double continuous = torque_.peak * options_.continuous_force / options_.peak_force;
    load = std::max(load, glm::dot(torque_.last, torque_.last) / (continuous * continuous));
  }
  temperature_ += (load - temperature_) * (1.0 - std::exp(-dt / options_.thermal_time));
  const double plausible = reported >= 0.0 && reported <= 2.0 ? reported : 0.0;
  // What one report alone says is not believed: it would hold the force down for a minute.
  temperature_ = std::max(temperature_, std::min({plausible, reported_[0], reported_[1]}));
  reported_ = {plausible, reported_[0]};
}

}  // namespace hapticell::haptic
