// SPDX-License-Identifier: Apache-2.0
// A scene under the pull of a planner that changes its mind ten times a second.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include "feel/scene.h"
#include "manipulation/engine/felt_plan.h"

namespace hapticell::feel {

namespace {

/// s that a plan lasts: ten a second, the figure of the aim. Half and twice: twice and half the changes.
constexpr double kPlanPeriod = 0.1;
/// s in which the pull comes in at first, as the share of FeltPlan does. At once: it presses a hinge while the force
/// itself is still coming in, and the coupling yields; twice: the same figures.
constexpr double kComesIn = 1.0;

/// What `of` is, and at full authority the pull of a way that begins at the proxy; every tenth of a second another one,
/// in any direction. The target jumps: nothing but the renderer takes the jump out (in a session the target runs).
class PlannedScene final : public FeelScene {
 public:
  explicit PlannedScene(std::unique_ptr<FeelScene> of) : of_(std::move(of)) {}
  std::string name() const override { return of_->name() + ", changing plan"; }
  ConstraintSet setAt(const Pose& X_DP, double t) const override {
    ConstraintSet set = of_->setAt(X_DP, t);
    std::uint32_t group = set.count == 0 ? 0 : set.constraints[set.count - 1].group + 1;
    const dvec3 target = X_DP.p + manipulation::kPlanLead * directionAt(t);
    for (Constraint& row : manipulation::planPull(X_DP, target, std::min(1.0, t / kComesIn), {})) {
      row.group = group++;
      add(set, row);
    }
    return set;
  }
  double penetration(const Pose& X_DP, double t) const override { return of_->penetration(X_DP, t); }
  dvec3 handAt(double t, double press) const override { return of_->handAt(t, press); }
  haptic::HandOptions hand() const override { return of_->hand(); }
  dvec3 start() const override { return of_->start(); }
  dvec3 rest() const override { return of_->rest(); }
  dvec3 pressDirection() const override { return of_->pressDirection(); }

 private:
  static dvec3 directionAt(double t) {
    std::mt19937_64 random(static_cast<std::uint64_t>(std::max(0.0, t) / kPlanPeriod) + 1);
    random.discard(8);
    const auto unit = [&] { return static_cast<double>(random() >> 11U) * 0x1.0p-52 - 1.0; };
    const double x = unit(), y = unit(), z = unit();
    return glm::normalize(dvec3(x, y, z) + dvec3(1e-6));
  }

  std::unique_ptr<FeelScene> of_;
};

}  // namespace

std::unique_ptr<FeelScene> plannedScene(std::unique_ptr<FeelScene> scene) {
  return std::make_unique<PlannedScene>(std::move(scene));
}

}  // namespace hapticell::feel
