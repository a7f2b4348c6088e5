// SPDX-License-Identifier: Apache-2.0
#include "tests/haptic/rendering/feel_session.h"

#include "geometry/assertion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::haptic::test {

namespace {

constexpr double kTick = 0.001;

double percentile(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

}  // namespace

void SlowClient::step(double t, ForceRenderer& renderer) {
  if (t + 1e-9 >= next_look_) {
    next_look_ += 1.0 / rate_.rate_hz;
    if (t < stall_from_ || t >= stall_until_) {
      ConstraintSet set = scene_.setAt(renderer.proxy());
      set.sequence = ++sequence_;
      on_the_way_.push_back({t + rate_.latency, set});
    }
  }
  while (!on_the_way_.empty() && on_the_way_.front().arrival <= t + 1e-9) {
    renderer.adopt(on_the_way_.front().set);
    on_the_way_.pop_front();
  }
}

FeelSession::FeelSession(const FeelScene& scene, ClientRate rate, HandOptions hand, config::DeviceProfile profile,
                         RendererOptions options)
    : scene_(scene), client_(scene, rate), device_(profile), renderer_(options), exact_(options) {
  device_.hand().setOptions(hand);
  HAPTICELL_DEMAND(device_.open().has_value());
}

void FeelSession::begin(const dvec3& start) {
  device_.place(Pose::translation(start));
  renderer_.reset(Pose::translation(start));
  exact_.reset(Pose::translation(start));
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

void FeelSession::tick(bool measured) {
  const dvec3 before = device_.truePose().p;
  device_.advance(kTick);
  const dvec3 force_before = safety_result_.force_D;
  DeviceReading reading;
  device_.read(reading);
  client_.step(time_, renderer_);
  result_ = renderer_.tick(reading.X_DS, kTick);
  ConstraintSet exact = scene_.setAt(exact_.proxy());
  exact.sequence = ++ticks_;
  exact_.adopt(exact);
  exact_result_ = exact_.tick(reading.X_DS, kTick);
  SafetyInput input;
  input.force_D = result_.force_D;
  input.v_DS = result_.v_DS;
  input.enabled = true;
  safety_result_ = safety_.tick(input);
  renderer_.noteApplied(safety_result_.force_D);
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
  work_ -= glm::dot(device_.motorForce(), moved);
  const dvec3 f = safety_result_.force_D;
  balance_.push_back(work_ - glm::dot(f, f) / (2.0 * renderer_.options().stiffness));
}

void FeelSession::measure(const DeviceReading& reading, const dvec3& force_before) {
  const dvec3 force = safety_result_.force_D;
  const double size = glm::length(force);
  figures_.force_max = std::max(figures_.force_max, size);
  figures_.penetration = std::max(figures_.penetration, scene_.penetration(result_.X_DP));
  if (exact_result_.active_rows == 0 && glm::length(result_.offset_D) == 0.0 && result_.active_rows == 0) {
    ++figures_.free_ticks;
    figures_.free_force_max = std::max(figures_.free_force_max, glm::length(result_.force_D));
  }
  if (time_ - last_change_ > 0.05) figures_.step_n = std::max(figures_.step_n, glm::length(force - force_before));
  const dvec3 exact_depth = exact_result_.X_DP.p - reading.X_DS.p;
  const double depth = glm::length(exact_depth);
  if (exact_result_.active_rows == 0 || depth < 0.3e-3 || time_ - last_change_ <= 0.05) return;
  ++figures_.contact_ticks;
  const double rendered = glm::length(result_.spring_D) / renderer_.options().stiffness;
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
  for (std::size_t i = 0; i < balance_.size(); ++i) {
    for (std::size_t j = i + 1; j < std::min(i + 1000, balance_.size()); ++j) {
      result.energy_min = std::min(result.energy_min, balance_[j] - balance_[i]);
    }
  }
  return result;
}

}  // namespace hapticell::haptic::test
