// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/bounded_step.h"

#include <algorithm>

#include "mannequin/posture/dual_system.h"

namespace hapticell::mannequin {

namespace {

// Newton steps, 1 to 5 are usual (bounded_step.h). Half: no effect but in rare cases; twice: the bounds hold after any
// number.
constexpr int kMostPasses = 32;
/// Share of a Newton step that counts as all of it: rounding. Half, twice of the rest: no effect.
constexpr double kWhole = 1.0 - 1e-6;

/// J^T y: the tasks' pull on each variable.
Variables pullOf(const StepProblem& problem, const Rows& y) {
  Variables pull;
  for (int v = 0; v < kVariables; ++v) {
    const double* column = problem.J[static_cast<std::size_t>(v)].data();
    const RowRanges rows = rowsOf(v, problem.arms_coupled);
    double sum = 0.0;
    for (int r = rows.begin_a; r < rows.end_a; ++r) sum += column[r] * y[static_cast<std::size_t>(r)];
    for (int r = rows.begin_b; r < rows.end_b; ++r) sum += column[r] * y[static_cast<std::size_t>(r)];
    pull[static_cast<std::size_t>(v)] = sum;
  }
  return pull;
}

/// A point of the dual problem with what follows from it.
struct DualPoint {
  Rows y{};
  Variables pull{};
};

/// Where along a step a variable comes off its bound or meets one, and by how much the dual function's bend changes.
struct Break {
  double t, change;
};

/// How far to go along a Newton step: to where the dual function, concave and made of parabolas, is highest, 1 at most.
double shareOf(const StepProblem& p, const DualPoint& at, const DualPoint& way) {
  double slope = 0.0, bend = 0.0;
  for (std::size_t r = 0; r < kTaskRows; ++r) {
    slope += way.y[r] * (p.e[r] - p.R[r] * at.y[r]);
    bend += p.R[r] * way.y[r] * way.y[r];
  }
  std::array<Break, 2 * kVariables> breaks;
  std::size_t count = 0;
  for (std::size_t i = 0; i < kVariables; ++i) {
    const double pull = way.pull[i], rate = pull / p.D[i];
    const double free = p.wish[i] + at.pull[i] / p.D[i];
    slope -= pull * std::clamp(free, p.lower[i], p.upper[i]);
    if (rate == 0.0 || p.lower[i] == p.upper[i]) continue;
    const double to_lower = (p.lower[i] - free) / rate, to_upper = (p.upper[i] - free) / rate;
    const double enters = std::min(to_lower, to_upper), leaves = std::max(to_lower, to_upper);
    if (enters <= 0.0 && leaves > 0.0) bend += pull * rate;
    if (enters > 0.0 && enters < 1.0) breaks[count++] = {enters, pull * rate};
    if (leaves > 0.0 && leaves < 1.0) breaks[count++] = {leaves, -pull * rate};
  }
  std::sort(breaks.data(), breaks.data() + count, [](const Break& a, const Break& b) { return a.t < b.t; });
  double t = 0.0;
  for (std::size_t k = 0; k < count && slope > bend * (breaks[k].t - t); ++k) {
    slope -= bend * (breaks[k].t - t);
    bend += breaks[k].change;
    t = breaks[k].t;
  }
  return bend > 0.0 ? std::min(1.0, t + slope / bend) : 1.0;
}

/// The sides that the variables stand on where the tasks pull so.
void takeSides(const StepProblem& p, const Variables& pull, ActiveSet& active) {
  for (std::size_t i = 0; i < kVariables; ++i) {
    const double free = p.wish[i] + pull[i] / p.D[i];
    active[i] = free <= p.lower[i] ? -1 : 0;
    if (free >= p.upper[i] || p.lower[i] == p.upper[i]) active[i] = 1;
  }
}

}  // namespace

void solveStep(const StepProblem& problem, ActiveSet& active, Variables& step) {
  for (std::size_t i = 0; i < kVariables; ++i) {
    if (problem.lower[i] == problem.upper[i]) active[i] = 1;
  }
  DualSystem system(problem, active);
  DualPoint at{system.solve(), {}};
  at.pull = pullOf(problem, at.y);
  takeSides(problem, at.pull, active);
  bool whole = true;
  for (int pass = 1; pass < kMostPasses; ++pass) {
    if (system.takeOver(active) && whole) break;
    DualPoint way{system.solve(), {}};
    for (std::size_t r = 0; r < kTaskRows; ++r) way.y[r] -= at.y[r];
    way.pull = pullOf(problem, way.y);
    const double share = shareOf(problem, at, way);
    whole = share > kWhole;
    for (std::size_t r = 0; r < kTaskRows; ++r) at.y[r] += share * way.y[r];
    for (std::size_t i = 0; i < kVariables; ++i) at.pull[i] += share * way.pull[i];
    takeSides(problem, at.pull, active);
  }
  for (std::size_t i = 0; i < kVariables; ++i) {
    step[i] = std::clamp(problem.wish[i] + at.pull[i] / problem.D[i], problem.lower[i], problem.upper[i]);
  }
}

}  // namespace hapticell::mannequin
