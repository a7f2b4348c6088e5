// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closed_form/analytic_inverse.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/system/assertion.h"
#include "kinematics/model/turns.h"
#include "kinematics/numeric/true_arm.h"

namespace hapticell::kinematics {

namespace {

// m and rad: the pose is met; what numeric_search.cpp accepts too, and five times the descent's tolerance. Half, twice:
// no effect where the polish converges; near singular poses fewer or more are accepted.
constexpr double kAccepted = 1e-9;
// m and rad: exact as far as doubles go, a hundredth of kAccepted. Half, twice: an arm whose file is rounded to about
// 1e-11 is polished at each step or not; met within kAccepted either way.
constexpr double kProven = 1e-11;
// Poses tried when a model is made; its worst error decides on polishing. Chosen by trial. Half: the worst may be
// missed; twice: a model takes longer to make.
constexpr int kProofSamples = 48;
// Newton steps; real files are off by 1e-10, so one step converges and two are spare. Half: a pose near a singularity
// may miss kAccepted; twice: no effect, the loop ends when it is met.
constexpr int kExactSteps = 3;
// Newton steps from a nominal arm up to 0.02 rad off; chosen by trial. Half: damped steps near branches do not converge
// and branches that the nominal arm just misses are lost; twice: slower where none exists.
constexpr int kCalibratedSteps = 10;
// rad or m: far above kAccepted times the worst lever, far below two real solutions. Half: a solution may be listed
// twice near a singularity; twice: two that nearly meet are listed as one.
constexpr double kSameSolution = 1e-7;
// rad or m in one call that has no bound from speeds; as the longest step of the polish. Half: a fast hand falls to the
// slower descent; twice: the arm may change its configuration while dragged.
constexpr double kNoJump = 0.3;

struct PoseError {
  double position = 0.0;
  double orientation = 0.0;
  bool within(double bound) const { return position < bound && orientation < bound; }
};

PoseError errorAt(const Chain& chain, const ChainPositions& x, const Pose& X_BT) {
  ChainState state;
  chain.evaluate(x, state);
  const dmat3 R = X_BT.R();
  // Half the sum of the columns' cross products is the axis times the sine of the angle between the two.
  dvec3 sine(0.0);
  double cosine = -1.0;
  for (int i = 0; i < 3; ++i) {
    sine += 0.5 * glm::cross(R[i], state.R_BT[i]);
    cosine += glm::dot(R[i], state.R_BT[i]);
  }
  return {glm::length(state.p_BT - X_BT.p), std::atan2(glm::length(sine), 0.5 * cosine)};
}

struct PoseRows {
  double R[9], p[3];
  PoseRows(const Pose& X_BT, const dvec3& p_BT) {
    const dmat3 rotation = X_BT.R();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) R[3 * row + column] = rotation[column][row];
      p[row] = p_BT[row];
    }
  }
};

std::string nameOf(const ArmShapes& shapes, const kernels::FourAxes& axes, std::size_t lane) {
  dvec3 axis_B[6], origin_B[6];
  for (std::size_t i = 0; i < 6; ++i) {
    const auto at = [&](const double(&vector)[3][4]) {
      return dvec3(vector[0][lane], vector[1][lane], vector[2][lane]);
    };
    axis_B[i] = at(axes.axis[i]);
    origin_B[i] = at(axes.origin[i]);
  }
  const auto shape = shapes.of(axis_B, origin_B);
  return shape ? toString(*shape) : std::string();
}

}  // namespace

AnalyticInverse::AnalyticInverse(std::unique_ptr<NumericInverse> numeric, const Classification& classification,
                                 const InverseOptions& options, std::size_t model_dof)
    : numeric_(std::move(numeric)), classification_(classification), options_(options), model_dof_(model_dof) {
  const Chain& chain = *numeric_->chain();
  const ArmAxes axes = armAxes(chain);
  rails_ = classification.rails;
  rail_B_ = axes.rail_B;
  closed_ = makeClosedForm(classification.robot_class, axes);
  HAPTICELL_DEMAND(closed_ != nullptr);
  bounds_.joints = static_cast<int>(chain.size() - rails_);
  arm_ = trueArm(chain, rails_);
  shapes_ = ArmShapes(chain);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (i < rails_) continue;
    bounds_.lower[i - rails_] = chain.lower()[i];
    bounds_.upper[i - rails_] = chain.upper()[i];
    bounds_.turn[i - rails_] = chain.turns(i) ? kTurn : 0.0;
  }
  proven_error_ = sampleError();
}

// The worst error of any solution over some poses within the limits: where the axes are exactly those of the class, the
// haptic path need not check each answer again.
double AnalyticInverse::sampleError() const {
  if (freeCount() > 0 || classification_.calibrated) return 1.0;
  const Chain& chain = *numeric_->chain();
  double worst = 0.0;
  for (int sample = 0; sample < kProofSamples; ++sample) {
    ChainPositions x{};
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const double lower = std::max(chain.lower()[i], -std::numbers::pi),
                   upper = std::min(chain.upper()[i], std::numbers::pi);
      const double place = 0.5 + sample * (std::numbers::phi - 1.0) * static_cast<double>(i + 1);
      x[i] = lower + (upper - lower) * (place - std::floor(place));
    }
    ChainState state;
    chain.evaluate(x, state);
    const Pose X_BT{state.p_BT, glm::normalize(glm::quat_cast(state.R_BT))};
    kernels::Solutions solutions;
    evaluate(X_BT, {}, x, false, solutions);
    for (int slot = 0; slot < 4 * closed_->groups(); ++slot) {
      if ((solutions.valid >> slot & 1u) == 0) continue;
      const PoseError error = errorAt(chain, assemble({}, solutions, slot), X_BT);
      worst = std::max({worst, error.position, error.orientation});
    }
  }
  return worst;
}

ChainPositions AnalyticInverse::pick(const std::vector<double>& q) const {
  HAPTICELL_DEMAND(q.size() == model_dof_);
  const Chain& chain = *numeric_->chain();
  ChainPositions x{};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    x[i] = std::clamp(q[static_cast<std::size_t>(chain.variables()[i])], chain.lower()[i], chain.upper()[i]);
  }
  return x;
}

kernels::Choice AnalyticInverse::evaluate(const Pose& X_BT, const Free& free, const ChainPositions& x_start,
                                          bool checked, kernels::Solutions& solutions) const {
  dvec3 p = X_BT.p;
  for (std::size_t i = 0; i < rails_; ++i) p -= free[i] * rail_B_[i];
  const double* previous = x_start.data() + rails_;
  closed_->solve(X_BT.R(), p, free[rails_], previous, solutions);
  if (checked || classification_.calibrated) check(X_BT, p, solutions);
  return kernels::table().choose(bounds_, previous, closed_->groups(), solutions);
}

// Checks all solutions on the true arm and polishes those that are off. An arm that is only near its class may reach
// where the nominal one just does not: then the branches' stretched poses are polished too.
void AnalyticInverse::check(const Pose& X_BT, const dvec3& p_BT, kernels::Solutions& solutions) const {
  const PoseRows pose(X_BT, p_BT);
  const bool planar = classification_.robot_class == RobotClass::kOpw || classification_.robot_class == RobotClass::kUr;
  if (classification_.calibrated && planar) solutions.valid = 0xffu;
  for (int group = 0; group < closed_->groups(); ++group) {
    if ((solutions.valid >> (4 * group) & 0xfu) == 0) continue;
    double errors[4];
    kernels::table().polish(arm_, pose.R, pose.p, group, classification_.calibrated ? kCalibratedSteps : kExactSteps,
                            solutions, errors);
    for (int lane = 0; lane < 4; ++lane) {
      if (!(errors[lane] < kAccepted)) solutions.valid &= ~(1u << (4 * group + lane));
    }
  }
}

ChainPositions AnalyticInverse::assemble(const Free& free, const kernels::Solutions& solutions, int slot) const {
  ChainPositions x{};
  for (std::size_t i = 0; i < rails_; ++i) x[i] = free[i];
  for (int joint = 0; joint < bounds_.joints; ++joint) {
    x[rails_ + static_cast<std::size_t>(joint)] = solutions.q[joint][slot];
  }
  return x;
}

// All solutions at one place of the free parameters; polishing may have brought two branches together.
void AnalyticInverse::collect(const Pose& X_BT, const Free& free, const ChainPositions& x_start,
                              std::vector<Found>& all) const {
  kernels::Solutions solutions;
  const kernels::Choice choice = evaluate(X_BT, free, x_start, true, solutions);
  const std::size_t first = all.size();
  for (int slot = 0; slot < 4 * closed_->groups(); ++slot) {
    if ((solutions.valid >> slot & 1u) == 0) continue;
    Found found{assemble(free, solutions, slot), (choice.within >> slot & 1u) != 0, 0.0};
    const bool known = std::any_of(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(), [&](const Found& one) {
      return sameButForTurns(*numeric_->chain(), one.x, found.x, kSameSolution);
    });
    if (known) continue;
    found.distance_squared = distanceSquared(*numeric_->chain(), found.x, x_start);
    all.push_back(found);
  }
}

AnalyticInverse::Best AnalyticInverse::searchPlain(const Pose& X_BT, const ChainPositions& x_start) const {
  std::vector<Found> all;
  collect(X_BT, freeAt(X_BT, x_start), x_start, all);
  Best best;
  best.outside = !all.empty();
  for (const Found& found : all) {
    best.free = best.free || (!found.within && chainIsSingular(*numeric_->chain(), found.x));
    if (!found.within) continue;
    if (best.any && found.distance_squared >= best.distance_squared) continue;
    best.x = found.x;
    best.distance_squared = found.distance_squared;
    best.any = true;
  }
  return best;
}

void AnalyticInverse::fill(const Pose& X_BT, const ChainPositions& x, const std::vector<double>& q_start,
                           InverseSolution& solution) const {
  const Chain& chain = *numeric_->chain();
  const PoseError error = errorAt(chain, x, X_BT);
  solution.q = q_start;
  for (std::size_t i = 0; i < chain.size(); ++i) solution.q[static_cast<std::size_t>(chain.variables()[i])] = x[i];
  solution.position_error = error.position;
  solution.orientation_error = error.orientation;
  solution.singular = chainIsSingular(chain, x);
  solution.status = InverseStatus::kSolved;
}

InverseSolution AnalyticInverse::solve(const Pose& X_BT, const std::vector<double>& q_start) const {
  const ChainPositions x_start = pick(q_start);
  Best best;
  if (freeCount() == 0) {
    best = searchPlain(X_BT, x_start);
  } else {
    searchFree(X_BT, x_start, best);
  }
  InverseSolution solution;
  if (best.any) {
    fill(X_BT, best.x, q_start, solution);
    return solution;
  }
  // A narrow way between the samples, off the nominal arm, or a joint that the pose leaves free and whose present place
  // drives another one out of its limits.
  if (freeCount() > 0 || classification_.calibrated || best.free) {
    solution = numeric_->solve(X_BT, q_start);
    if (solution.status == InverseStatus::kUnreachable && best.outside) solution.status = InverseStatus::kLimit;
    return solution;
  }
  // The least misfit; which of the two reasons it has is known for sure.
  solution = numeric_->nearestMiss(X_BT, q_start);
  // A stretched arm is on the edge of what the closed form takes: the descent may still meet the pose.
  if (solution.status == InverseStatus::kSolved) return solution;
  solution.status = best.outside ? InverseStatus::kLimit : InverseStatus::kUnreachable;
  return solution;
}

std::vector<AlternativeSolution> AnalyticInverse::solveAll(const Pose& X_BT, const std::vector<double>& q_start) const {
  constexpr int kPlaces[] = {1, 16, 5, 3};
  const ChainPositions x_start = pick(q_start);
  const std::size_t count = freeCount();
  std::vector<Found> all;
  all.reserve(kernels::kMaxSolutions);
  Free place = freeAt(X_BT, x_start);
  collect(X_BT, place, x_start, all);
  const int samples = count < 4 ? kPlaces[count] : 2;
  int total = 1;
  for (std::size_t i = 0; i < count; ++i) total *= samples;
  for (int index = 0; count > 0 && index < total; ++index) {
    int rest = index;
    for (std::size_t i = 0; i < count; ++i, rest /= samples) {
      double lower, upper;
      freeRange(i, lower, upper);
      place[i] = lower + (upper - lower) * (rest % samples + 0.5) / samples;
    }
    collect(X_BT, place, x_start, all);
  }
  if (count > 0 && std::none_of(all.begin(), all.end(), [](const Found& one) { return one.within; }))
    addBetweenSamples(X_BT, x_start, q_start, all);
  return listed(all, q_start);
}

// Nearest first, with the names of their shapes, which are told from the axes of four at a time.
std::vector<AlternativeSolution> AnalyticInverse::listed(const std::vector<Found>& all,
                                                         const std::vector<double>& q_start) const {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double near = all[a].distance_squared, far = all[b].distance_squared;
    return near != far ? near < far : a < b;
  });
  const std::vector<int>& variables = numeric_->chain()->variables();
  std::vector<AlternativeSolution> solutions;
  solutions.reserve(all.size());
  kernels::Solutions four;
  kernels::FourAxes axes;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Found& found = all[order[k]];
    std::string name;
    if (shapes_.any()) {
      if (k % 4 == 0) {
        for (std::size_t lane = 0; lane < 4; ++lane) {
          const Found& one = all[order[std::min(k + lane, order.size() - 1)]];
          for (int joint = 0; joint < bounds_.joints; ++joint) {
            four.q[joint][lane] = one.x[rails_ + static_cast<std::size_t>(joint)];
          }
        }
        kernels::table().axes(arm_, four, 0, axes);
      }
      name = nameOf(shapes_, axes, k % 4);
    }
    solutions.push_back({q_start, found.within, std::move(name)});
    for (std::size_t i = 0; i < variables.size(); ++i) {
      solutions.back().q[static_cast<std::size_t>(variables[i])] = found.x[i];
    }
  }
  return solutions;
}

// The closed form's nearest solution where every joint gets there in time; `too_fast` where only speeds are in the way.
bool AnalyticInverse::quickAnswer(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                                  InverseSolution& solution, bool& too_fast) const {
  if (freeCount() > 0 || classification_.calibrated || classification_.robot_class == RobotClass::kOffsetWrist) {
    return false;
  }
  const Chain& chain = *numeric_->chain();
  const ChainPositions x_start = pick(q_start);
  kernels::Solutions solutions;
  const kernels::Choice choice = evaluate(X_BT, {}, x_start, false, solutions);
  if (choice.nearest < 0) return false;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const double allowed = std::isfinite(duration_s) ? chain.velocity()[i] * duration_s : kNoJump;
    too_fast = too_fast || std::abs(solutions.q[i][choice.nearest] - x_start[i]) > allowed;
  }
  if (too_fast) return false;
  double error = proven_error_;
  if (!(proven_error_ < kProven)) {
    double errors[4];
    const PoseRows pose(X_BT, X_BT.p);
    kernels::table().polish(arm_, pose.R, pose.p, choice.nearest / 4, kExactSteps, solutions, errors);
    error = errors[choice.nearest % 4];
    if (!(error < kAccepted)) return false;
  }
  solution.q = q_start;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    solution.q[static_cast<std::size_t>(chain.variables()[i])] =
        std::clamp(solutions.q[i][choice.nearest], chain.lower()[i], chain.upper()[i]);
  }
  solution.position_error = solution.orientation_error = error;
  solution.singular = false;
  solution.status = InverseStatus::kSolved;
  return true;
}

void AnalyticInverse::solveNearest(const Pose& X_BT, const std::vector<double>& q_start, double duration_s,
                                   InverseSolution& solution) const {
  HAPTICELL_DEMAND(duration_s > 0.0);
  bool too_fast = false;
  if (quickAnswer(X_BT, q_start, duration_s, solution, too_fast)) return;
  if (too_fast && std::isfinite(duration_s)) return numeric_->solveHurried(X_BT, q_start, duration_s, solution);
  numeric_->solveNearest(X_BT, q_start, duration_s, solution);
}

}  // namespace hapticell::kinematics
