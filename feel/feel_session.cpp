// SPDX-License-Identifier: Apache-2.0
#include "feel/feel_session.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/assertion.h"

namespace hapticell::feel {

namespace {

constexpr double kTick = 0.001;
constexpr double kAfterChange = 0.05;  // s after a change of contacts that are left out: true impacts.
constexpr double kLeastDepth = 0.3e-3;

double percentile(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

std::unique_ptr<RenderingWay> wayOf(const SessionSetup& setup) {
  if (setup.classic) return std::make_unique<ClassicWay>(setup.renderer);
  return std::make_unique<ProxyWay>(setup.renderer);
}

}  // namespace

FeelSession::FeelSession(const FeelScene& scene, const SessionSetup& setup)
    : scene_(scene),
      hand_(setup.hand.value_or(scene.hand())),
      client_(setup.seen != nullptr ? *setup.seen : scene, setup.rate),
      device_(setup.device),
      way_(wayOf(setup)),
      exact_(setup.renderer) {
  device_.hand().setOptions(hand_);
  HAPTICELL_DEMAND(device_.open().has_value());
}

void FeelSession::begin(const dvec3& start) {
  const Pose X_DS = Pose::translation(start);
  device_.place(X_DS);
  way_->reset(X_DS);
  exact_.reset(X_DS);
  follow([&](double) { return start; }, 1.2, false);
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
  balance_.clear();
}

void FeelSession::tick(bool measured) {
  const dvec3 before = device_.truePose().p;
  device_.advance(kTick);
  const dvec3 force_before = result_.force_D;
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
  input.v_DS = result_.v_DS;
  input.enabled = true;
  safety_result_ = safety_.tick(input);
  way_->noteApplied(safety_result_.force_D);
  device_.write(safety_result_.force_D, dvec3(0.0));
  readings_.push_back(reading.X_DS.p);
  if (exact_result_.active_rows != exact_rows_) last_change_ = time_;
  exact_rows_ = exact_result_.active_rows;
  if (measured) {
    accountEnergy(device_.truePose().p - before);
    measure(reading, force_before);
  }
  time_ += kTick;
}

void FeelSession::accountEnergy(const dvec3& moved) {
  // What a moving obstacle does to the hand is none of the renderer's making.
  work_ -= glm::dot(device_.motorForce(), moved - kTick * result_.v_DO);
  const double stiffness = std::max(result_.stiffness, 1.0);
  const double acting = glm::length(safety_result_.force_D), spring = glm::length(result_.spring_D);
  balance_.push_back(work_ - haptic::storedEnergy(spring, stiffness, acting));
}

void FeelSession::measure(const haptic::DeviceReading& reading, const dvec3& force_before) {
  figures_.force_max = std::max(figures_.force_max, glm::length(safety_result_.force_D));
  figures_.penetration = std::max(figures_.penetration, scene_.penetration(result_.X_DP, time_));
  if (exact_result_.active_rows == 0 && glm::length(result_.offset_D) == 0.0 && result_.active_rows == 0) {
    ++figures_.free_ticks;
    figures_.free_force_max = std::max(figures_.free_force_max, glm::length(result_.force_D));
  }
  if (time_ - last_change_ <= kAfterChange) return;
  figures_.step_n = std::max(figures_.step_n, glm::length(result_.force_D - force_before));
  const dvec3 exact_depth = exact_result_.X_DP.p - reading.X_DS.p;
  const double depth = glm::length(exact_depth);
  if (exact_result_.active_rows == 0 || depth < kLeastDepth) return;
  ++figures_.contact_ticks;
  const double rendered = glm::length(result_.spring_D) / result_.stiffness;
  figures_.depth_error_max = std::max(figures_.depth_error_max, std::abs(rendered - depth));
  figures_.depth_excess_max = std::max(figures_.depth_excess_max, rendered - depth);
  depth_errors_.push_back(std::abs(rendered - depth) / depth);
  const double cosine =
      glm::dot(exact_depth, result_.spring_D) / (depth * std::max(glm::length(result_.spring_D), 1e-9));
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
  // The least of balance[j] - balance[i], i < j < i + 1000.
  for (std::size_t i = 0; i < balance_.size(); ++i) {
    for (std::size_t j = i + 1; j < std::min(i + 1000, balance_.size()); ++j) {
      result.energy_min = std::min(result.energy_min, balance_[j] - balance_[i]);
    }
  }
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
