// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/force_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/system/assertion.h"
#include "haptic/devices/simulated_device.h"

namespace hapticell::haptic {

namespace {

constexpr double kBeyondWorkspace = 0.5;   // m that a stylus may be outside of what its device states.
constexpr double kUnknownWorkspace = 2.0;  // m, of one that states nothing.
constexpr double kShortDoubt = 0.0025;     // s of refused samples while nothing pushes.
constexpr double kDoubtFades = 0.25;       // Of a refused sample for each that is believed.

double reachOf(const DeviceCapabilities& c) {
  const double half = 0.5 * glm::length(c.workspace_max - c.workspace_min);
  return std::isfinite(half) && half > 0.0 ? half + kBeyondWorkspace : kUnknownWorkspace;
}

}  // namespace

ForceLoopOptions optionsFor(const Device& device, double rate_hz) {
  const DeviceCapabilities& capabilities = device.capabilities();
  ForceLoopOptions options;
  options.rate_hz = rate_hz;
  options.renderer.stiffness = capabilities.stiffness;
  options.renderer.damping = capabilities.damping;
  options.renderer.peak_force = capabilities.peak_force;
  options.renderer.tick = 1.0 / rate_hz;
  options.safety.peak_force = capabilities.peak_force;
  if (capabilities.driven_axes == 6) {
    options.renderer.peak_torque = options.safety.peak_torque = capabilities.peak_torque;
  }
  options.safety.continuous_force = capabilities.continuous_force;
  // A killed client's socket is closed some milliseconds late, and 50 ms are promised from the kill.
  options.safety.close_decay = 0.02;
  options.renderer.delay = capabilities.delay_ticks / rate_hz;
  options.safety.thermal_time = capabilities.thermal_time;
  return options;
}

DeviceDescription describe(const Device& device) {
  const DeviceCapabilities& c = device.capabilities();
  DeviceDescription description;
  description.name = c.name;
  description.simulated = c.simulated;
  description.workspace_min = c.workspace_min;
  description.workspace_max = c.workspace_max;
  description.resolution = c.resolution;
  description.peak_force = c.peak_force;
  description.continuous_force = c.continuous_force;
  description.stiffness = c.stiffness;
  description.damping = c.damping;
  description.measured_axes = c.measured_axes;
  description.driven_axes = c.driven_axes;
  description.peak_torque = c.peak_torque;
  description.buttons = c.buttons;
  return description;
}

ForceLoop::ForceLoop(Device& device, const Clock& clock, const ForceLoopOptions& options)
    : device_(device),
      simulated_(device.simulated()),
      clock_(clock),
      options_(options),
      period_(1.0 / options.rate_hz),
      renderer_(options.renderer),
      safety_(options.safety),
      statistics_(options.rate_hz),
      log_(options.log_ticks),
      pushes_(device.capabilities().driven_axes > 0),
      middle_D_(0.5 * (device.capabilities().workspace_min + device.capabilities().workspace_max)),
      reach_(reachOf(device.capabilities())) {
  HAPTICELL_DEMAND(options.rate_hz >= 1.0 && options.rate_hz <= 1e5);
  readDevice(period_);
  renderer_.reset(reading_.X_DS);
}

void ForceLoop::openLink() noexcept {
  heard();
  silence_limit_.store(0.0, std::memory_order_relaxed);
  session_.store(++last_session_, std::memory_order_release);
}

void ForceLoop::closeLink() noexcept {
  session_.store(0, std::memory_order_release);
}

template <typename T>
void ForceLoop::put(Inbox<T>& inbox, const T& value) noexcept {
  Incoming<T>& slot = inbox.buffer.writeSlot();
  slot.session = last_session_;
  slot.value = value;
  inbox.buffer.publish();
}

void ForceLoop::submit(const ConstraintSet& set) noexcept {
  put(sets_, set);
}

void ForceLoop::submit(const HapticControl& control) noexcept {
  put(controls_, control);
}

void ForceLoop::submit(const HandTarget& target) noexcept {
  put(targets_, target);
}

void ForceLoop::tick(const TickTiming& timing) noexcept {
  if (!running_) return;
  const std::int64_t now = clock_.now();
  const double dt = period_ * (1.0 + timing.skipped);
  tick_ += 1 + timing.skipped;
  takeMessages(now);
  watchStalls(timing);
  if (simulated_ != nullptr) simulated_->advance(dt);
  readDevice(dt);
  // A weight must not keep the gate shut that opens only on a small force.
  const bool pushes = safety_result_.gate == GateState::kRamping || safety_result_.gate == GateState::kOpen;
  renderer_.setLoad(pushes ? control_.load : LoadOptions{});
  render_ = renderer_.tick(reading_.X_DS, dt);
  if (render_.dropped) {
    statistics_.addDroppedSet();
    faults_.trigger(FaultKind::kInput);
  }
  guardAndWrite(now, dt);
  record(now, timing);
  publish(now, timing);
}

void ForceLoop::shutDown() noexcept {
  if (!running_) return;
  running_ = false;
  publishFigures(clock_.now());
  device_.write(dvec3(0.0), dvec3(0.0));
  device_.close();
}

template <typename T>
const T* ForceLoop::take(Inbox<T>& inbox) noexcept {
  if (inbox.buffer.update()) inbox.waiting = true;
  // One of a session that the loop has not seen yet waits for the next tick.
  if (!inbox.waiting || inbox.buffer.value().session != rendered_session_) return nullptr;
  inbox.waiting = false;
  return &inbox.buffer.value().value;
}

bool ForceLoop::changeSession() noexcept {
  const std::uint64_t session = session_.load(std::memory_order_acquire);
  if (session == 0 && safety_result_.gate == GateState::kClosed && render_.adopted_set != 0) {
    renderer_.reset(reading_.X_DS);  // The force has faded: nothing of the last client is left.
  }
  if (session == 0 || session == rendered_session_) return false;
  rendered_session_ = session;
  renderer_.setOptions(options_.renderer);
  renderer_.reset(reading_.X_DS);
  control_ = {};
  last_set_ns_ = clock_.now();
  return true;
}

void ForceLoop::takeMessages(std::int64_t now) noexcept {
  // A new session's messages wait one tick: the safety chain must have seen its forces off once.
  if (changeSession()) return;
  if (const HapticControl* control = take(controls_)) {
    control_ = *control;
    RendererOptions wanted = options_.renderer;
    if (control_.stiffness > 0.0) wanted.stiffness = control_.stiffness;
    if (control_.damping > 0.0) wanted.damping = control_.damping;
    renderer_.setOptions(wanted);
  }
  if (const ConstraintSet* set = take(sets_)) {
    // What moves has gone on since: the client's stamp is in this loop's clock.
    const double age = set->stamp_ns != 0 ? kSecondsPerNanosecond * static_cast<double>(now - set->stamp_ns) : 0.0;
    // One that is refused is none: what is rendered only grows older.
    if (renderer_.adopt(*set, age) == Adoption::kAdopted) {
      last_set_ns_ = now;
      if (set->stamp_ns != 0) statistics_.addSetAge(now - set->stamp_ns);
    } else {
      statistics_.addRefusedSet();
    }
  }
  takeHandTarget();
}

void ForceLoop::takeHandTarget() noexcept {
  if (simulated_ == nullptr) return;
  const bool open = session_.load(std::memory_order_acquire) != 0;
  if (const HandTarget* target = open ? take(targets_) : nullptr) {
    if (target->holding) {
      simulated_->hand().hold(target->X_DH, target->buttons);
    } else {
      simulated_->hand().release();
    }
    hand_from_link_ = true;
  } else if (hand_from_link_ && !open) {
    simulated_->hand().release();  // Whoever moved it is gone.
    hand_from_link_ = false;
  }
}

void ForceLoop::watchStalls(const TickTiming& timing) noexcept {
  if (timing.skipped >= kStall) {
    ++stalls_;
    if (simulated_ == nullptr && !motors_off_) {
      faults_.trigger(FaultKind::kMissedTicks);
      motors_off_ = true;
      safety_.trip();
      device_.setMotors(false);
    }
  }
  // Re-armed: the client has taken its enable back.
  if (motors_off_ && !control_.forces_enabled) {
    motors_off_ = false;
    device_.setMotors(true);
  }
}

void ForceLoop::record(std::int64_t now, const TickTiming& timing) noexcept {
  if (safety_result_.input_fault && !input_fault_) faults_.trigger(FaultKind::kInput);
  input_fault_ = safety_result_.input_fault;
  if (safety_result_.too_fast && !too_fast_) faults_.trigger(FaultKind::kSpeed);
  too_fast_ = safety_result_.too_fast;
  FaultSample sample;
  sample.tick = tick_;
  sample.stamp_ns = now;
  sample.X_DS = reading_.X_DS;
  sample.X_DP = render_.X_DP;
  sample.wanted_D = render_.force_D;
  sample.commanded_D = safety_result_.force_D;
  sample.adopted_set = render_.adopted_set;
  sample.rows = static_cast<std::uint32_t>(render_.active_rows);
  sample.skipped = timing.skipped;
  sample.buttons = reading_.buttons;
  sample.forces_on = safety_result_.gate == GateState::kOpen;
  faults_.add(sample);
}

/// Whether a measurement is one that a hand can have made; a first one, or the first after the motors went off, is.
bool ForceLoop::believes(const DeviceReading& reading) noexcept {
  if (!reading.fresh) return false;
  const Pose& X_DS = reading.X_DS;
  bool follows = false;
  if (!X_DS.isValid() || glm::distance(X_DS.p, middle_D_) > reach_) {
    faults_.trigger(FaultKind::kInput);
  } else {
    if (anew_) {
      gate_.restart();
      renderer_.noteJump();
    }
    anew_ = false;
    follows = gate_.judge(X_DS, std::exchange(judged_, 0.0)) == SampleGate::Verdict::kFollows;
  }
  doubt_ = follows ? std::max(0.0, doubt_ - kDoubtFades * period_) : doubt_ + period_;
  if (!follows) statistics_.addRefusedSample();
  return follows;
}

void ForceLoop::readDevice(double dt) noexcept {
  DeviceReading reading;
  const bool fault = device_.read(reading) != DeviceStatus::kOk;
  age_ += dt;
  judged_ += dt;
  if (!fault) {
    if (believes(reading)) {
      age_ = 0.0;
      measured_ = true;
    } else {
      reading.X_DS = reading_.X_DS;  // Nobody is told of a pose that is none, or that is not believed.
    }
    reading_ = reading;
  }
  const GateState gate = safety_result_.gate;
  const bool pushing = pushes_ && gate != GateState::kClosed && gate != GateState::kWaiting;
  const bool doubted = doubt_ >= (pushing ? kStale : kShortDoubt);
  const bool failing = fault || (measured_ && pushes_ && (age_ >= kStale || (doubted && pushing)));
  // Nothing pushes: what is measured next counts, wherever it is (calibration moves it, somebody plugs it in).
  if (failing || doubted || !reading_.takes_force) {
    anew_ = true;
    doubt_ = 0.0;
  }
  if (failing && !device_fault_) {
    safety_.trip();
    faults_.trigger(FaultKind::kDevice);
  }
  device_fault_ = failing;
}

void ForceLoop::guardAndWrite(std::int64_t now, double dt) noexcept {
  SafetyInput input;
  input.force_D = render_.force_D;
  input.torque_D = render_.torque_D;
  input.v_DS = render_.v_DS;
  input.dt = dt;
  input.enabled = control_.forces_enabled;
  input.link_open = session_.load(std::memory_order_acquire) != 0;
  input.device_ready = isReady();
  input.silence_limit = silence_limit_.load(std::memory_order_relaxed);
  const std::int64_t silence = now - last_heard_.load(std::memory_order_relaxed);
  input.link_silence = input.link_open ? std::max(0.0, kSecondsPerNanosecond * static_cast<double>(silence)) : 0.0;
  const double without_set = kSecondsPerNanosecond * static_cast<double>(now - last_set_ns_);
  input.set_silence = input.link_open ? std::max(0.0, without_set) : 0.0;
  state_.client_stalled = control_.forces_enabled && input.set_silence > options_.safety.set_silence_limit;
  input.reported_temperature = reading_.motor_temperature;
  safety_result_ = safety_.tick(input);
  if (device_fault_ || motors_off_ || !isReady()) {
    safety_.cut();
    safety_result_.force_D = safety_result_.torque_D = dvec3(0.0);
    safety_result_.gate = GateState::kClosed;
    safety_result_.ramp = 0.0;
  }
  const bool engaged = safety_result_.gate != GateState::kClosed && !device_fault_;
  if (engaged != engaged_) device_.setEngaged(engaged_ = engaged);
  const dvec3 command_D = safety_result_.force_D;
  if (device_.write(command_D, safety_result_.torque_D) != DeviceStatus::kOk && !device_fault_) safety_.trip();
  renderer_.noteApplied(command_D, safety_result_.torque_D);
  renderer_.setForceLimit(safety_result_.force_limit);
  log_.add({tick_, now, command_D, input.link_open, input.link_silence, safety_result_.gate == GateState::kOpen});
}

void ForceLoop::publish(std::int64_t now, const TickTiming& timing) noexcept {
  state_.tick = tick_;
  state_.server_stamp_ns = now;
  state_.X_DS = reading_.X_DS;
  state_.X_DP = render_.X_DP;
  state_.v_DS = render_.v_DS;
  state_.force_D = safety_result_.force_D;
  state_.torque_D = safety_result_.torque_D;
  state_.buttons = reading_.buttons;
  state_.adopted_set = render_.adopted_set;
  state_.forces_on = safety_result_.gate == GateState::kOpen || safety_result_.gate == GateState::kRamping;
  state_.force_ramp = safety_result_.ramp;
  state_.motor_temperature = safety_result_.temperature;
  state_.device_fault = device_fault_;
  states_.write(state_);
  statistics_.addTick(now, timing.late_ns, timing.skipped);
  if (statistics_.due()) publishFigures(now);
}

void ForceLoop::publishFigures(std::int64_t now) noexcept {
  LoopFigures& figures = figures_.writeSlot();
  statistics_.collect(now, figures);
  report_.write(figures);
  figures_.publish();
}

}  // namespace hapticell::haptic
