// SPDX-License-Identifier: Apache-2.0
// The searches from many starts: NumericInverse's answers that are not for the haptic path.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "kinematics/model/turns.h"
#include "kinematics/numeric/numeric_inverse.h"

namespace hapticell::kinematics {

namespace {

// Seeds tried after a first solution, for one nearer to the start: enough to meet every configuration of a 6R arm.
// Half: another configuration may be returned; twice: twice the time of solve().
constexpr std::size_t kSeedsForNearest = 64;
// Starts about the present posture, four rings of four, kNearEnough apart: up to 1 rad. Half: fewer near solutions are
// found; twice: more time for each pose that has none.
constexpr std::size_t kSeedsAboutStart = 16;
// Seeds that tell "out of limits" from "out of reach". Chosen by trial. Half: a reachable pose is more often taken for
// out of reach; twice: twice the time for a refusal.
constexpr std::size_t kSeedsWithoutLimits = 96;
// New starts when 1024 known ones were not enough; chosen by trial. Half: hard poses of odd arms are lost; twice: twice
// the time until a pose out of reach is reported.
constexpr std::size_t kFurtherSeeds = 300;
/// Of startApart(): the nearest of the seeds is about so far; from further off a descent mostly ends elsewhere. Half:
/// the present posture is tried less often first; twice: more descents for nothing.
constexpr double kNearStart = 0.5;
// rad or m: an answer this near is not worth a search for a nearer one; two configurations differ by more. Half: more
// searches; twice: the elbow of a nearly straight arm may turn over.
constexpr double kNearEnough = 0.25;
// rad or m: two results of a descent are one; a descent's 2e-10 is 1e-5 rad beside a double solution. Half: such may be
// listed twice; twice: no effect.
constexpr double kSameSearched = 1e-4;
// Listed solutions: four times the 16 of a 6R arm, for arms with a free parameter, whose list is a sample. Half: a
// coarser sample; twice: a longer list.
constexpr std::size_t kMaxAlternatives = 64;

double largestChange(const ChainPositions& a, const ChainPositions& b, std::size_t n) {
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

double fitCost(const FitResult& fit, double lever) {
  return fit.position_error * fit.position_error + lever * lever * fit.orientation_error * fit.orientation_error;
}

}  // namespace

/// Beyond the reach, and by more than rounding: a tip that no joint takes away from the first one is at its very end.
bool NumericInverse::isTooFar(const Pose& X_BT) const {
  // m, and in parts of the reach; what is accepted as met (1e-9). Half: a stretched arm may be refused; twice: a search
  // for nothing for poses 2e-9 m too far.
  constexpr double kRounding = 1e-9;
  const double distance = glm::length(X_BT.p - chain_.elements()[0].p_PJ);
  return distance > chain_.reach() * (1.0 + kRounding) + kRounding;
}

std::vector<std::size_t> NumericInverse::seedsNear(const Pose& X_BT) const {
  const double scale = 3.0 / std::max(chain_.scale(), 1e-3);
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
  const std::size_t ring = 1 + index / 4;
  const double radius = kNearEnough * static_cast<double>(ring);
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
  const dvec3 apart = 3.0 / std::max(chain_.scale(), 1e-3) * (state.p_BT - X_BT.p);
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
  if (isTooFar(X_BT)) return best;
  options.max_iterations = options_.max_iterations;
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
  best = fitPose(chain_, X_BT, best.x, limits(), FitOptions{options_.lever, 200, true, false}, arm());
  // m and rad: the best descent is so near that 2000 patient iterations are worth it; chosen by trial. Half: some poses
  // where two solutions meet are refused; twice: more time for refusals at the edge of reach.
  constexpr double kNearlyMet = 1e-4;
  if (best.converged || best.position_error > kNearlyMet || best.orientation_error > kNearlyMet) return best;
  for (const bool curved : {false, true}) {
    const FitResult patient = fitPose(chain_, X_BT, best.x, limits(), FitOptions{options_.lever, 2000, curved, false});
    if (fitCost(patient, options_.lever) < fitCost(best, options_.lever)) best = patient;
    if (best.converged) break;
  }
  // There the last digits of the joints are lost: what is met to this is met (arm 356 of RandomArms with 2000 arms).
  // m and rad. Half: that arm's pose is refused; twice: 2e-8 off passes, of such poses only.
  constexpr double kMet = 1e-8;
  best.converged = best.converged || (best.position_error < kMet && best.orientation_error < kMet);
  return best;
}

bool NumericInverse::reachableWithoutLimits(const Pose& X_BT, const ChainPositions& x_start) const {
  if (isTooFar(X_BT)) return false;
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
  options.max_iterations = options_.max_iterations;
  options.give_up_when_slow = true;
  options.second_order = false;
  const FitBox box = limits();
  const bool far = isTooFar(X_BT);
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
  seeds.count = static_cast<int>(seeds_.size());
  for (std::size_t i = 0; i < 7; ++i) seeds.values[i] = seed_columns_[i].data();
  const double wanted[7] = {X_BT.p.x, X_BT.p.y, X_BT.p.z, X_BT.q.w, X_BT.q.x, X_BT.q.y, X_BT.q.z};
  float numbers[7];
  std::transform(wanted, wanted + 7, numbers, [](double number) { return static_cast<float>(number); });
  int order[kernels::kSeedGroups] = {};
  kernels::table().nearestSeeds(seeds, numbers, static_cast<float>(3.0 / std::max(chain_.scale(), 1e-3)), order);
  for (const int seed : order) {
    if (tryFrom(seeds_[static_cast<std::size_t>(seed)].x)) return best;
  }
  if (!near && tryFrom(x_start)) return best;
  const FitResult patient = fitPose(chain_, X_BT, best.x, box, FitOptions{options_.lever, 200, true, false}, arm());
  if (patient.converged) return patient;
  for (std::size_t s = 0; s < kFurtherSeeds; ++s) {
    if (tryFrom(haltonPoint(seeds_.size() + s))) return best;
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
      return sameButForTurns(chain_, x, fit.x, kSameSearched);
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
