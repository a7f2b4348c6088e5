// SPDX-License-Identifier: Apache-2.0
#include "kinematics/numeric_inverse.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/assertion.h"
#include "kinematics/true_arm.h"
#include "kinematics/turns.h"

namespace hapticell::kinematics {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr std::size_t kSeedCount = 1024;
constexpr std::size_t kSeedsForNearest = 64;  // enough to meet every configuration of a 6R arm
constexpr std::size_t kSeedsAboutStart = 16;
constexpr std::size_t kSeedsWithoutLimits = 96;
constexpr std::size_t kFurtherSeeds = 300;
/// Of startApart(): the nearest of the seeds is about so far; from further off a descent mostly ends elsewhere.
constexpr double kNearStart = 0.5;
constexpr int kHapticIterations = 24;
constexpr int kRestartIterations = 60;
constexpr double kNearEnough = 0.25;    // rad or m: an answer this near is not worth a search for a nearer one
constexpr double kKeptFirst = 0.004;    // times the lever, or its inverse: what is kept weighs 250 times as much
constexpr double kKept = 2e-4;          // m or rad
constexpr double kWorthTrying = 0.02;   // m: further off it is the hand that is fast, or the reach that ends
constexpr double kElbowMargin = 0.01;   // rad from straight or folded
constexpr double kSameSolution = 1e-4;  // rad or m
constexpr std::size_t kMaxAlternatives = 64;

double largestChange(const ChainPositions& a, const ChainPositions& b, std::size_t n) {
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// The radical inverse of `index` in a prime base: one coordinate of the Halton sequence (Halton 1960).
double radicalInverse(std::size_t index, std::size_t base) {
  double result = 0.0, fraction = 1.0 / static_cast<double>(base);
  for (; index > 0; index /= base, fraction /= static_cast<double>(base))
    result += fraction * static_cast<double>(index % base);
  return result;
}

double fitCost(const FitResult& fit, double lever) {
  return fit.position_error * fit.position_error + lever * lever * fit.orientation_error * fit.orientation_error;
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
  HAPTICELL_DEMAND(lever_m > 0.0 && X_LT.isValid());
  auto chain = Chain::create(model, tip_link, X_LT);
  if (!chain) return makeError(chain.error());
  return std::unique_ptr<NumericInverse>(new NumericInverse(std::move(*chain), model.dof(), lever_m));
}

NumericInverse::NumericInverse(Chain chain, std::size_t model_dof, double lever_m)
    : chain_(std::move(chain)), model_dof_(model_dof) {
  options_.lever = lever_m;
  options_.max_iterations = kRestartIterations;
  elbow_ = findElbow(chain_);
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
  solution.status =
      fit.converged ? InverseStatus::kSolved : (fit.held ? InverseStatus::kLimit : InverseStatus::kUnreachable);
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

std::vector<std::size_t> NumericInverse::seedsNear(const Pose& X_BT) const {
  const double scale = 3.0 / std::max(chain_.reach(), 1e-3);
  std::vector<double> cost(seeds_.size());
  for (std::size_t s = 0; s < seeds_.size(); ++s) {
    const dvec3 apart = scale * (seeds_[s].X_BT.p - X_BT.p);
    const double cosine = glm::dot(seeds_[s].X_BT.q, X_BT.q);
    cost[s] = glm::dot(apart, apart) + 4.0 * (1.0 - cosine * cosine);
  }
  std::vector<std::size_t> order(seeds_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return cost[a] < cost[b]; });
  return order;
}

// Points about the start, the first ones nearest: what one descent from the start itself passed by.
ChainPositions NumericInverse::aboutStart(const ChainPositions& x_start, std::size_t index) const {
  const double radius = kNearEnough * static_cast<double>(1 + index / 4);
  ChainPositions x = x_start;
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const double lower = seeds_.front().x[i];
    x[i] += radius *
            std::sin(kTurn * (static_cast<double>(index) * 0.618033988749895 * static_cast<double>(i + 1) + lower));
  }
  return x;
}

/// How far the start's pose is from the wanted one, in the measure by which seeds are sorted.
double NumericInverse::startApart(const Pose& X_BT, const ChainPositions& x_start) const {
  ChainState state;
  chain_.evaluate(x_start, state);
  const dvec3 apart = 3.0 / std::max(chain_.reach(), 1e-3) * (state.p_BT - X_BT.p);
  // The trace of R^T R' is 4 c^2 - 1, c the cosine of half the angle between them.
  const dmat3 R = X_BT.R();
  double trace = 0.0;
  for (int i = 0; i < 3; ++i) trace += glm::dot(R[i], state.R_BT[i]);
  return glm::dot(apart, apart) + 3.0 - trace;
}

FitResult NumericInverse::searchWithinLimits(const Pose& X_BT, const ChainPositions& x_start) const {
  FitOptions options = options_;
  options.max_iterations = 200;
  FitResult best = fitPose(chain_, X_BT, x_start, limits(), options, arm());
  if (best.converged) {
    takeNearestTurns(chain_, x_start, best.x);
    if (largestChange(best.x, x_start, chain_.size()) < kNearEnough) return best;
  }
  const double first_joint_distance = glm::length(X_BT.p - chain_.elements()[0].p_PJ);
  if (first_joint_distance > chain_.reach()) return best;
  options.max_iterations = kRestartIterations;
  options.give_up_when_slow = true;
  options.second_order = false;
  const std::vector<std::size_t> order = seedsNear(X_BT);
  double nearest = best.converged ? distanceSquared(chain_, best.x, x_start) : std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < kSeedsAboutStart + order.size(); ++s) {
    if (best.converged && s >= kSeedsAboutStart + kSeedsForNearest) break;
    const bool about_start = s < kSeedsAboutStart;
    const ChainPositions x_try = about_start ? aboutStart(x_start, s) : seeds_[order[s - kSeedsAboutStart]].x;
    FitResult fit = fitPose(chain_, X_BT, x_try, limits(), options, arm());
    if (!fit.converged) {
      if (!best.converged && fitCost(fit, options.lever) < fitCost(best, options.lever)) best = fit;
      continue;
    }
    takeNearestTurns(chain_, x_start, fit.x);
    const double distance = distanceSquared(chain_, fit.x, x_start);
    if (distance < nearest) {
      nearest = distance;
      best = fit;
    }
  }
  if (best.converged) return best;
  // The least misfit of all tries, taken to its minimum.
  return fitPose(chain_, X_BT, best.x, limits(), FitOptions{options_.lever, 200, true, false}, arm());
}

bool NumericInverse::reachableWithoutLimits(const Pose& X_BT, const ChainPositions& x_start) const {
  if (glm::length(X_BT.p - chain_.elements()[0].p_PJ) > chain_.reach()) return false;
  const FitBox box = withoutTurningLimits();
  if (fitPose(chain_, X_BT, x_start, box, options_, arm()).converged) return true;
  const std::vector<std::size_t> order = seedsNear(X_BT);
  for (std::size_t s = 0; s < kSeedsWithoutLimits; ++s) {
    if (fitPose(chain_, X_BT, seeds_[order[s]].x, box, options_, arm()).converged) return true;
  }
  return false;
}

// One descent from the start where that is near, from the seeds nearest to the pose, from the best of these with
// curvature, then from ever further points.
FitResult NumericInverse::searchAny(const Pose& X_BT, const ChainPositions& x_start) const {
  FitOptions options = options_;
  options.max_iterations = kRestartIterations;
  options.give_up_when_slow = true;
  options.second_order = false;
  const FitBox box = limits();
  const bool far = glm::length(X_BT.p - chain_.elements()[0].p_PJ) > chain_.reach();
  const bool near = startApart(X_BT, x_start) < kNearStart;
  FitResult best;
  best.position_error = std::numeric_limits<double>::max();
  if (near || far) best = fitPose(chain_, X_BT, x_start, box, options, arm());
  if (best.converged || far) return best;
  const auto tryFrom = [&](const ChainPositions& x) {
    const FitResult fit = fitPose(chain_, X_BT, x, box, options, arm());
    if (fit.converged || fitCost(fit, options.lever) < fitCost(best, options.lever)) best = fit;
    return best.converged;
  };
  kernels::SeedPoses seeds;
  seeds.count = static_cast<int>(kSeedCount);
  for (std::size_t i = 0; i < 7; ++i) seeds.values[i] = seed_columns_[i].data();
  const double wanted[7] = {X_BT.p.x, X_BT.p.y, X_BT.p.z, X_BT.q.w, X_BT.q.x, X_BT.q.y, X_BT.q.z};
  float numbers[7];
  std::transform(wanted, wanted + 7, numbers, [](double number) { return static_cast<float>(number); });
  int order[kernels::kSeedGroups] = {};
  kernels::table().nearestSeeds(seeds, numbers, static_cast<float>(3.0 / std::max(chain_.reach(), 1e-3)), order);
  for (const int seed : order) {
    if (tryFrom(seeds_[static_cast<std::size_t>(seed)].x)) return best;
  }
  if (!near && tryFrom(x_start)) return best;
  const FitResult patient = fitPose(chain_, X_BT, best.x, box, FitOptions{options_.lever, 200, true, false}, arm());
  if (patient.converged) return patient;
  for (std::size_t s = 0; s < kFurtherSeeds; ++s) {
    if (tryFrom(haltonPoint(kSeedCount + s))) return best;
  }
  return patient;
}

InverseSolution NumericInverse::solveAny(const Pose& X_BT, const std::vector<double>& q_start) const {
  const ChainPositions x_start = pick(q_start);
  FitResult fit = searchAny(X_BT, x_start);
  if (fit.converged) takeNearestTurns(chain_, x_start, fit.x);
  InverseSolution solution;
  fill(fit, q_start, solution);
  return solution;
}

InverseSolution NumericInverse::nearestMiss(const Pose& X_BT, const std::vector<double>& q_start) const {
  FitOptions options = options_;
  options.max_iterations = 200;
  InverseSolution solution;
  const FitResult fit = fitPose(chain_, X_BT, pick(q_start), limits(), options, arm());
  fill(fit, q_start, solution);
  solution.singular = chainIsSingular(chain_, fit.x);
  return solution;
}

InverseSolution NumericInverse::solve(const Pose& X_BT, const std::vector<double>& q_start) const {
  InverseSolution solution;
  const ChainPositions x_start = pick(q_start);
  const FitResult fit = searchWithinLimits(X_BT, x_start);
  fill(fit, q_start, solution);
  solution.singular = chainIsSingular(chain_, fit.x);
  if (!fit.converged) {
    solution.status = reachableWithoutLimits(X_BT, x_start) ? InverseStatus::kLimit : InverseStatus::kUnreachable;
  }
  return solution;
}

std::vector<AlternativeSolution> NumericInverse::solveAll(const Pose& X_BT, const std::vector<double>& q_start) const {
  const ChainPositions x_start = pick(q_start);
  const std::size_t n = chain_.size();
  std::vector<ChainPositions> found;
  std::vector<AlternativeSolution> solutions;
  if (glm::length(X_BT.p - chain_.elements()[0].p_PJ) > chain_.reach()) return solutions;
  FitOptions options = options_;
  options.give_up_when_slow = true;
  options.second_order = false;
  const FitBox box = withoutTurningLimits();
  std::vector<bool> within_limits;
  const auto take = [&](const ChainPositions& x_try) {
    FitResult fit = fitPose(chain_, X_BT, x_try, box, options, arm());
    if (!fit.converged || found.size() >= kMaxAlternatives) return;
    const bool within = takeNearestTurns(chain_, x_start, fit.x);
    const bool known = std::any_of(found.begin(), found.end(), [&](const ChainPositions& x) {
      return sameButForTurns(chain_, x, fit.x, kSameSolution);
    });
    if (known) return;
    found.push_back(fit.x);
    within_limits.push_back(within);
  };
  take(x_start);
  for (const Seed& seed : seeds_) take(seed.x);

  std::vector<std::size_t> order(found.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return distanceSquared(chain_, found[a], x_start) < distanceSquared(chain_, found[b], x_start);
  });
  for (const std::size_t index : order) {
    AlternativeSolution solution{q_start, within_limits[index], configurationName(chain_, found[index])};
    for (std::size_t i = 0; i < n; ++i) solution.q[static_cast<std::size_t>(chain_.variables()[i])] = found[index][i];
    solutions.push_back(std::move(solution));
  }
  return solutions;
}

}  // namespace hapticell::kinematics
