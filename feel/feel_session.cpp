// SPDX-License-Identifier: Apache-2.0
#include "feel/feel_session.h"

#include "feel/stop_of_thread.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/system/assertion.h"
#include "geometry/system/percentile.h"

namespace hapticell::feel {

namespace {

constexpr double kTick = 0.001;
// s after a change of contacts that are left out of the steps: true impacts, of three quarters of a swing (0.145 kg on
// 1.3 N/mm: 66 ms). Half: impacts count as steps; twice: steps at seams are not seen.
constexpr double kAfterChange = 0.05;
// m: 15 steps of the encoders, so that rounding is under 7 % of a depth and under 4 deg of a direction. Half: twice of
// that; twice: light touches (0.3 to 0.6 N) are not judged.
constexpr double kLeastDepth = 0.3e-3;

std::unique_ptr<RenderingWay> wayOf(const SessionSetup& setup) {
  if (setup.classic) return std::make_unique<ClassicWay>(setup.renderer);
  return std::make_unique<ProxyWay>(setup.renderer);
}

SessionSetup withTorque(SessionSetup setup) {
  if (setup.device.driven_axes == 6) setup.renderer.peak_torque = setup.device.peak_torque;
  return setup;
}

haptic::SafetyOptions limitsOf(const SessionSetup& setup) {
  haptic::SafetyOptions options;
  options.peak_torque = setup.renderer.peak_torque;
  // What becomes unstable is to be seen, not to be stopped; and a conveyor's session begins beyond the arm's reach,
  // from where the arm is thrown.
  options.speed_limit = 1e9;
  return options;
}

haptic::MetricVector together(const dvec3& force_D, const dvec3& torque_D) {
  return {force_D, torque_D / haptic::kRotationLever};
}

}  // namespace

FeelSession::FeelSession(const FeelScene& scene, const SessionSetup& wanted)
    : scene_(scene),
      setup_(withTorque(wanted)),
      hand_(setup_.hand.value_or(scene.hand())),
      client_(setup_.seen != nullptr ? *setup_.seen : scene, setup_.rate),
      device_(setup_.device),
      way_(wayOf(setup_)),
      exact_(setup_.renderer),
      safety_(limitsOf(setup_)),
      energy_(setup_.device.electronics.delay_ticks) {
  device_.hand().setOptions(hand_);
  HAPTICELL_DEMAND(device_.open().has_value());
}

void FeelSession::begin(const dvec3& start, double rest) {
  const Pose X_DS = Pose::translation(start);
  device_.place(X_DS);
  way_->reset(X_DS);
  exact_.reset(X_DS);
  X_DSBefore_ = X_DS;
  follow([&](double) { return start; }, rest, false);
}

void FeelSession::follow(const std::function<dvec3(double)>& path, double duration, bool measured) {
  const auto count = static_cast<int>(std::lround(duration / kTick));
  for (int i = 1; i <= count; ++i) {
    device_.hand().hold(Pose::translation(path(i * kTick)));
    tick(measured);
  }
}

void FeelSession::followTurning(const std::function<dvec3(double)>& path, double duration) {
  const auto count = static_cast<int>(std::lround(duration / kTick));
  for (int i = 1; i <= count; ++i) {
    device_.hand().hold({path(i * kTick), scene_.turnAt(i * kTick)});
    tick(true);
  }
}

void FeelSession::letGo(double duration) {
  device_.hand().release();
  for (int i = 0; i < static_cast<int>(std::lround(duration / kTick)); ++i) tick(false);
}

void FeelSession::forgetFigures() {
  figures_ = {};
  depth_errors_.clear();
  direction_errors_.clear();
  energy_.forgetLoss();
}

void FeelSession::tick(bool measured) {
  endWhereStopped();
  device_.advance(kTick);
  const haptic::MetricVector force_before = wantedForce();
  const dvec3 load_before = result_.load_D;
  // What pulls do is theirs: the account is of the coupling (docs/dev/feel.md, Energy account).
  const double wanted = glm::length(result_.force_D);
  const double share = wanted > 0.0 ? std::min(1.0, glm::length(safety_result_.force_D) / wanted) : 1.0;
  const haptic::MetricVector commanded_before =
      together(safety_result_.force_D - share * result_.load_D, safety_result_.torque_D);
  haptic::DeviceReading reading;
  device_.read(reading);
  client_.step(time_, *way_);
  result_ = way_->tick(reading.X_DS, kTick);
  ConstraintSet exact = scene_.setAt(exact_.proxy(), time_);
  exact.sequence = ++ticks_;
  exact_.adopt(exact);
  exact_result_ = exact_.tick(reading.X_DS, kTick);
  haptic::SafetyInput input;
  input.force_D = result_.force_D;
  input.torque_D = result_.torque_D;
  input.v_DS = result_.v_DS;
  input.enabled = true;
  safety_result_ = safety_.tick(input);
  way_->setForceLimit(safety_result_.force_limit);
  way_->noteApplied(safety_result_.force_D, safety_result_.torque_D);
  device_.write(safety_result_.force_D, safety_result_.torque_D);
  readings_.push_back(reading.X_DS.p);
  if (exact_result_.active_rows != exact_rows_) last_change_ = time_;
  exact_rows_ = exact_result_.active_rows;
  // What a moving obstacle does to the hand is not caused by the renderer.
  const haptic::MetricVector step = exact_.way(reading.X_DS, X_DSBefore_) - together(kTick * result_.v_DO, dvec3(0.0));
  energy_.add(step, commanded_before, result_.stiffness);
  X_DSBefore_ = reading.X_DS;
  if (measured) {
    energy_.note(time_);
    measure(reading, force_before, load_before);
  }
  time_ += kTick;
}

haptic::MetricVector FeelSession::wantedForce() const {
  return together(result_.force_D, result_.torque_D);
}

void FeelSession::measure(const haptic::DeviceReading& reading, const haptic::MetricVector& force_before,
                          const dvec3& load_before) {
  figures_.pull_step_n = std::max(figures_.pull_step_n, glm::length(result_.load_D - load_before));
  figures_.force_max = std::max(figures_.force_max, glm::length(safety_result_.force_D));
  figures_.penetration = std::max(figures_.penetration, scene_.penetration(result_.X_DP, time_));
  figures_.round_penetration = std::max(figures_.round_penetration, scene_.roundPenetration(result_.X_DP, time_));
  if (exact_result_.active_rows == 0 && glm::length(result_.offset_D) == 0.0 && result_.active_rows == 0) {
    ++figures_.free_ticks;
    figures_.free_force_max = std::max(figures_.free_force_max, haptic::length(wantedForce()));
  }
  if (time_ - last_change_ <= kAfterChange) return;
  figures_.step_n = std::max(figures_.step_n, haptic::length(wantedForce() - force_before));
  const haptic::MetricVector exact_depth = exact_.way(exact_result_.X_DP, reading.X_DS);
  const double depth = haptic::length(exact_depth);
  if (exact_result_.active_rows == 0 || depth < kLeastDepth) return;
  ++figures_.contact_ticks;
  const haptic::MetricVector spring = together(result_.spring_D, result_.spring_torque_D);
  const double rendered = haptic::length(spring) / result_.stiffness;
  figures_.depth_error_max = std::max(figures_.depth_error_max, std::abs(rendered - depth));
  figures_.depth_excess_max = std::max(figures_.depth_excess_max, rendered - depth);
  depth_errors_.push_back(std::abs(rendered - depth) / depth);
  const double cosine = haptic::dot(exact_depth, spring) / (depth * std::max(haptic::length(spring), 1e-9));
  direction_errors_.push_back(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi);
}

double FeelSession::wobble(double seconds) const {
  const auto count = std::min(readings_.size(), static_cast<std::size_t>(seconds / kTick));
  dvec3 low(1e9), high(-1e9);
  for (auto it = readings_.end() - static_cast<std::ptrdiff_t>(count); it != readings_.end(); ++it) {
    low = glm::min(low, *it);
    high = glm::max(high, *it);
  }
  return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

FeelFigures FeelSession::figures() const {
  FeelFigures result = figures_;
  result.depth_error_p95 = percentile(depth_errors_, 0.95);
  result.direction_p95_deg = percentile(direction_errors_, 0.95);
  result.energy_min = energy_.worst();
  return result;
}

void touchAndSlide(FeelSession& session, const FeelScene& scene, double duration) {
  const dvec3 outside = scene.start();
  const double press = pressDepth(session.hand());
  const dvec3 touch = scene.handAt(0.0, press) - 0.5 * scene.drift();
  session.begin(outside);
  session.follow([&](double t) { return glm::mix(outside, touch, std::min(1.0, t / 0.3)) + t * scene.drift(); }, 0.5);
  session.followTurning([&](double t) { return scene.handAt(t, press); }, duration);
}

void pressAtRest(FeelSession& session, const FeelScene& scene) {
  const dvec3 outside = scene.start();
  const dvec3 goal = scene.rest() + pressDepth(session.hand()) * scene.pressDirection();
  session.begin(outside);
  session.follow([&](double t) { return glm::mix(outside, goal, std::min(1.0, t / 0.3)); }, 2.0);
}

}  // namespace hapticell::feel
