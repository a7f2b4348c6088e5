// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/force_loop.h"

#include <algorithm>

#include "geometry/system/assertion.h"

namespace hapticell::haptic {

ForceLoop::ForceLoop(Device& device, const Clock& clock, const ForceLoopOptions& options)
    : device_(device),
      clock_(clock),
      options_(options),
      output_(options.rate_hz),
      reader_(device, 1.0 / options.rate_hz),
      stalls_(device),
      hand_(device),
      renderer_(options.renderer),
      safety_(options.safety),
      recorder_(options.log_ticks) {
  HAPTICELL_DEMAND(options.rate_hz >= 1.0 && options.rate_hz <= 1e5);
  readDevice(period());
  renderer_.reset(reader_.reading().X_DS);
}

void ForceLoop::tick(const TickTiming& timing) noexcept {
  if (!running_) return;
  const std::int64_t now = clock_.now();
  const double dt = period() * (1.0 + timing.skipped);
  tick_ += 1 + timing.skipped;
  takeMessages(now);
  if (stalls_.note(timing.skipped, control_.forces_enabled)) {
    recorder_.faults().trigger(FaultKind::kMissedTicks);
    safety_.trip();
  }
  hand_.advance(dt);
  readDevice(dt);
  // A weight must not keep the gate shut that opens only on a small force.
  const bool pushes = safety_result_.gate == GateState::kRamping || safety_result_.gate == GateState::kOpen;
  renderer_.setLoad(pushes ? control_.load : LoadOptions{});
  render_ = renderer_.tick(reader_.reading().X_DS, dt);
  if (render_.dropped) {
    output_.statistics().addDroppedSet();
    recorder_.faults().trigger(FaultKind::kInput);
  }
  guardAndWrite(now, dt);
  record(now, timing);
  publish(now, timing);
}

void ForceLoop::shutDown() noexcept {
  if (!running_) return;
  running_ = false;
  output_.publishFigures(clock_.now());
  device_.write(dvec3(0.0), dvec3(0.0));
  device_.close();
}

bool ForceLoop::changeSession() noexcept {
  if (!inbox_.isOpen() && safety_result_.gate == GateState::kClosed && render_.adopted_set != 0) {
    renderer_.reset(reader_.reading().X_DS);  // The force has faded: nothing of the last client is left.
  }
  if (!inbox_.beginSession()) return false;
  renderer_.setOptions(options_.renderer);
  renderer_.reset(reader_.reading().X_DS);
  control_ = {};
  last_set_ns_ = clock_.now();
  return true;
}

void ForceLoop::takeMessages(std::int64_t now) noexcept {
  // A new session's messages wait one tick: the safety chain must have seen its forces off once.
  if (changeSession()) return;
  if (const HapticControl* control = inbox_.takeControl()) {
    control_ = *control;
    RendererOptions wanted = options_.renderer;
    if (control_.stiffness > 0.0) wanted.stiffness = control_.stiffness;
    if (control_.damping > 0.0) wanted.damping = control_.damping;
    renderer_.setOptions(wanted);
  }
  if (const GroupedSet* set = inbox_.takeSet()) {
    // What moves has gone on since: the client's stamp is in this loop's clock.
    const double age = set->stamp_ns != 0 ? kSecondsPerNanosecond * static_cast<double>(now - set->stamp_ns) : 0.0;
    // A refused set does not count: the rendered one only grows older.
    if (renderer_.adopt(*set, age) == Adoption::kAdopted) {
      last_set_ns_ = now;
      if (set->stamp_ns != 0) output_.statistics().addSetAge(now - set->stamp_ns);
    } else {
      output_.statistics().addRefusedSet();
    }
  }
  hand_.follow(inbox_);
}

void ForceLoop::record(std::int64_t now, const TickTiming& timing) noexcept {
  FaultSample sample;
  sample.tick = tick_;
  sample.stamp_ns = now;
  sample.X_DS = reader_.reading().X_DS;
  sample.X_DP = render_.X_DP;
  sample.wanted_D = render_.force_D;
  sample.commanded_D = safety_result_.force_D;
  sample.adopted_set = render_.adopted_set;
  sample.rows = static_cast<std::uint32_t>(render_.active_rows);
  sample.skipped = timing.skipped;
  sample.buttons = reader_.reading().buttons;
  sample.forces_on = safety_result_.gate == GateState::kOpen;
  recorder_.record(safety_result_, sample);
}

void ForceLoop::readDevice(double dt) noexcept {
  const GateState gate = safety_result_.gate;
  const StylusReader::Outcome outcome = reader_.read(dt, gate != GateState::kClosed && gate != GateState::kWaiting);
  if (outcome.impossible) recorder_.faults().trigger(FaultKind::kInput);
  if (outcome.jumped) renderer_.noteJump();
  if (outcome.refused) output_.statistics().addRefusedSample();
  if (outcome.fails) {
    safety_.trip();
    recorder_.faults().trigger(FaultKind::kDevice);
  }
}

void ForceLoop::guardAndWrite(std::int64_t now, double dt) noexcept {
  SafetyInput input;
  input.force_D = render_.force_D;
  input.torque_D = render_.torque_D;
  input.v_DS = render_.v_DS;
  input.dt = dt;
  input.enabled = control_.forces_enabled;
  input.link_open = inbox_.isOpen();
  input.device_ready = reader_.isReady();
  input.silence_limit = inbox_.silenceLimit();
  input.link_silence = input.link_open ? inbox_.silence(now) : 0.0;
  const double without_set = kSecondsPerNanosecond * static_cast<double>(now - last_set_ns_);
  input.set_silence = input.link_open ? std::max(0.0, without_set) : 0.0;
  state_.client_stalled = control_.forces_enabled && input.set_silence > options_.safety.set_silence_limit;
  input.reported_temperature = reader_.reading().motor_temperature;
  safety_result_ = safety_.tick(input);
  if (reader_.failing() || stalls_.motorsOff() || !reader_.isReady()) {
    safety_.cut();
    safety_result_.force_D = safety_result_.torque_D = dvec3(0.0);
    safety_result_.gate = GateState::kClosed;
    safety_result_.ramp = 0.0;
  }
  const bool engaged = safety_result_.gate != GateState::kClosed && !reader_.failing();
  if (engaged != engaged_) device_.setEngaged(engaged_ = engaged);
  const dvec3 command_D = safety_result_.force_D;
  if (device_.write(command_D, safety_result_.torque_D) != DeviceStatus::kOk && !reader_.failing()) safety_.trip();
  renderer_.noteApplied(command_D, safety_result_.torque_D);
  renderer_.setForceLimit(safety_result_.force_limit);
  recorder_.log({tick_, now, command_D, input.link_open, input.link_silence, safety_result_.gate == GateState::kOpen});
}

void ForceLoop::publish(std::int64_t now, const TickTiming& timing) noexcept {
  state_.tick = tick_;
  state_.server_stamp_ns = now;
  state_.X_DS = reader_.reading().X_DS;
  state_.X_DP = render_.X_DP;
  state_.v_DS = render_.v_DS;
  state_.force_D = safety_result_.force_D;
  state_.torque_D = safety_result_.torque_D;
  state_.buttons = reader_.reading().buttons;
  state_.adopted_set = render_.adopted_set;
  state_.forces_on = safety_result_.gate == GateState::kOpen || safety_result_.gate == GateState::kRamping;
  state_.force_ramp = safety_result_.ramp;
  state_.motor_temperature = safety_result_.temperature;
  state_.device_fault = reader_.failing();
  output_.publish(state_, timing.late_ns, timing.skipped);
}

}  // namespace hapticell::haptic
