// SPDX-License-Identifier: Apache-2.0
#include "kinematics/numeric/numeric_inverse.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/system/assertion.h"
#include "kinematics/model/turns.h"
#include "kinematics/numeric/true_arm.h"

namespace hapticell::kinematics {

namespace {

// Start postures kept with their poses, of the Halton sequence; chosen by trial. Half: the nearest seeds are farther
// and more descents end elsewhere; twice: twice the time to make a model and to sort.
constexpr std::size_t kSeedCount = 1024;
// Steps of a descent while dragging, that bound the time of a step of the loop. Half: a singular pose is left behind
// for some steps of the loop; twice: its worst time doubles.
constexpr int kHapticIterations = 24;
// Steps of a descent from a seed; chosen by trial. Half: slow ones at singular poses fail and the next seed is tried;
// twice: seeds that fail cost twice the time.
constexpr int kRestartIterations = 60;
// Times the lever, or its inverse: what is kept weighs 250 times as much; chosen so that kKept is met. Half: a stiffer
// problem, more iterations; twice: kKept is missed more often and both yield.
constexpr double kKeptFirst = 0.004;
// m or rad: 0.2 mm, 0.2 mrad as inverse-kinematics.md says. Half: both yield more often; twice: a straight line near a
// singularity is 0.4 mm off.
constexpr double kKept = 2e-4;
// m: further off it is the hand that is fast, or the reach that ends. Chosen by trial. Half: a wrist singularity passed
// quickly loses the position; twice: a second descent for nothing for fast hands.
constexpr double kWorthTrying = 0.02;
// rad from straight or folded: there the elbow could change its side. 0.01 rad of a bend shortens an arm of 1 m by 13
// um. Half: the last iterations creep; twice: reach ends 50 um earlier.
constexpr double kElbowMargin = 0.01;

// The radical inverse of `index` in a prime base: one coordinate of the Halton sequence (Halton 1960).
double radicalInverse(std::size_t index, std::size_t base) {
  double result = 0.0, fraction = 1.0 / static_cast<double>(base);
  for (; index > 0; index /= base, fraction /= static_cast<double>(base))
    result += fraction * static_cast<double>(index % base);
  return result;
}

}  // namespace

const char* toString(InverseStatus status) {
  switch (status) {
    case InverseStatus::kSolved:
      return "solved";
    case InverseStatus::kLimit:
      return "limit";
    case InverseStatus::kUnreachable:
      break;
  }
  return "unreachable";
}

Expected<std::unique_ptr<NumericInverse>> NumericInverse::create(const RobotModel& model, int tip_link,
                                                                 const Pose& X_LT, double lever_m) {
  HAPTICELL_DEMAND(lever_m > 0.0);
  if (!X_LT.isValid())
    return makeError({.place = "tool", .found = "an invalid pose", .expected = "finite numbers, within 1e12 m"});
  auto chain = Chain::create(model, tip_link, X_LT);
  HAPTICELL_TRY(chain);
  return std::unique_ptr<NumericInverse>(new NumericInverse(std::move(*chain), model.dof(), lever_m));
}

NumericInverse::NumericInverse(Chain chain, std::size_t model_dof, double lever_m)
    : chain_(std::move(chain)), model_dof_(model_dof) {
  options_.lever = lever_m;
  options_.max_iterations = kRestartIterations;
  elbow_ = findElbow(chain_);
  // Eight columns of the kernels less one for the right-hand side, see fit_lanes.h.
  constexpr std::size_t kFastJoints = 7;
  if (chain_.size() <= kFastJoints && fitsTrueArm(chain_)) arm_ = trueArm(chain_);
  makeSeeds();
}

// The Halton sequence within the limits; a variable without limits goes half a turn (or metre) either way.
ChainPositions NumericInverse::haltonPoint(std::size_t index) const {
  constexpr std::size_t kPrimes[kMaxChainVariables] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};
  ChainPositions x{};
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const bool endless = !std::isfinite(chain_.lower()[i]) || !std::isfinite(chain_.upper()[i]);
    const double lower = endless ? -std::numbers::pi : chain_.lower()[i];
    const double upper = endless ? std::numbers::pi : chain_.upper()[i];
    x[i] = lower + (upper - lower) * radicalInverse(index + 20, kPrimes[i]);
  }
  return x;
}

void NumericInverse::makeSeeds() {
  seeds_.resize(kSeedCount);
  ChainState state;
  for (std::size_t s = 0; s < kSeedCount; ++s) {
    seeds_[s].x = haltonPoint(s);
    chain_.evaluate(seeds_[s].x, state);
    seeds_[s].X_BT = {state.p_BT, glm::normalize(glm::quat_cast(state.R_BT))};
    const Pose& X = seeds_[s].X_BT;
    const double numbers[7] = {X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z};
    for (std::size_t i = 0; i < 7; ++i) seed_columns_[i].push_back(static_cast<float>(numbers[i]));
  }
}

FitBox NumericInverse::limits() const {
  return {chain_.lower(), chain_.upper()};
}

FitBox NumericInverse::withoutTurningLimits() const {
  FitBox box = limits();
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    if (!chain_.turns(i)) continue;
    box.lower[i] = -std::numeric_limits<double>::infinity();
    box.upper[i] = std::numeric_limits<double>::infinity();
  }
  return box;
}

void NumericInverse::keepElbowSide(const ChainPositions& x, FitBox& box) const {
  if (!elbow_) return;
  const std::size_t i = elbow_->variable;
  const double side = std::floor((x[i] - elbow_->straight) / std::numbers::pi);
  const double lower = elbow_->straight + side * std::numbers::pi + kElbowMargin;
  const double upper = elbow_->straight + (side + 1.0) * std::numbers::pi - kElbowMargin;
  // An arm that a user put straight has no side yet.
  if (x[i] < lower - 0.5 * kElbowMargin || x[i] > upper + 0.5 * kElbowMargin) return;
  box.lower[i] = std::max(box.lower[i], std::min(lower, x[i]));
  box.upper[i] = std::min(box.upper[i], std::max(upper, x[i]));
}

ChainPositions NumericInverse::pick(const std::vector<double>& q) const {
  HAPTICELL_DEMAND(q.size() == model_dof_);
  ChainPositions x{};
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    x[i] = std::clamp(q[static_cast<std::size_t>(chain_.variables()[i])], chain_.lower()[i], chain_.upper()[i]);
  }
  return x;
}

void NumericInverse::fill(const FitResult& fit, const std::vector<double>& q_start, InverseSolution& solution) const {
  solution.q = q_start;
  for (std::size_t i = 0; i < chain_.size(); ++i)
    solution.q[static_cast<std::size_t>(chain_.variables()[i])] = fit.x[i];
  solution.position_error = fit.position_error;
  solution.orientation_error = fit.orientation_error;
  solution.singular = false;
  solution.status = statusOf(fit.converged, fit.held);
}

NumericInverse::Shot NumericInverse::shoot(const Pose& X_BT, const ChainPositions& x, double duration_s, double lever_m,
                                           int held) const {
  FitBox box = limits();
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const double reach = static_cast<int>(i) == held ? 0.0 : chain_.velocity()[i] * duration_s;
    box.lower[i] = std::max(box.lower[i], x[i] - reach);
    box.upper[i] = std::min(box.upper[i], x[i] + reach);
  }
  FitBox sided = box;
  keepElbowSide(x, sided);
  FitOptions options = options_;
  options.lever = lever_m;
  options.max_iterations = kHapticIterations;
  Shot shot{fitPose(chain_, X_BT, x, sided, options, arm())};
  for (std::size_t i = 0; i < chain_.size() && shot.fit.held; ++i) {
    const bool at_limit = shot.fit.x[i] <= chain_.lower()[i] || shot.fit.x[i] >= chain_.upper()[i];
    const bool at_bound = shot.fit.x[i] <= box.lower[i] || shot.fit.x[i] >= box.upper[i];
    shot.at_limit = shot.at_limit || at_limit;
    shot.at_speed = shot.at_speed || (at_bound && !at_limit && static_cast<int>(i) != held);
  }
  shot.fit.held = shot.at_limit;  // Held by its speed is not held by a limit: only the latter is told.
  return shot;
}

// True where what the user chose can be kept; `shot` is then that one.
bool NumericInverse::keepOne(const Pose& X_BT, const ChainPositions& x, double duration_s, Shot& shot) const {
  const bool position = hurried_.keep == Hurried::Keep::kPosition;
  const double lever = options_.lever * (position ? kKeptFirst : 1.0 / kKeptFirst);
  const Shot kept = shoot(X_BT, x, duration_s, lever, hurried_.held);
  if (!((position ? kept.fit.position_error : kept.fit.orientation_error) < kKept)) return false;
  shot = kept;
  return true;
}

void NumericInverse::solveNearest(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                                  InverseSolution& solution) const {
  HAPTICELL_DEMAND(duration_s > 0.0);
  const ChainPositions x = pick(q_start);
  Shot shot = shoot(X_BT, x, duration_s, options_.lever, -1);
  if (shot.at_speed && shot.fit.position_error < kWorthTrying) keepOne(X_BT, x, duration_s, shot);
  fill(shot.fit, q_start, solution);
}

void NumericInverse::solveHurried(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                                  InverseSolution& solution) const {
  HAPTICELL_DEMAND(duration_s > 0.0);
  const ChainPositions x = pick(q_start);
  Shot shot;
  if (!keepOne(X_BT, x, duration_s, shot)) shot = shoot(X_BT, x, duration_s, options_.lever, -1);
  fill(shot.fit, q_start, solution);
}

}  // namespace hapticell::kinematics
