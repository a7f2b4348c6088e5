// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "kinematics/model/jacobian.h"
#include "studies/document/study_section.h"
#include "studies/questions/question_kinds.h"
#include "studies/questions/robot_targets.h"

namespace hapticell::studies {

namespace {

using workcell::Entity;

/// m: larger clearances count as this one, as they need no better place. Half: good variants look alike; twice: longer
/// queries.
constexpr double kLook = 0.2;
constexpr double kMostLook = 2.0;  ///< m; half and twice: only what is refused as a slip.
/// m: 1 rad counts like this, InverseOptions::lever_m. Half: turning counts less; twice: more.
constexpr double kLever = 0.25;

/// A measure of how good a solution is, larger is better: of each target the best of its free solutions, and of all
/// targets the least.
class Quality : public Question {
 public:
  using Measure = std::function<double(const Entity& robot, RobotTargets& solved, const std::vector<double>& joints)>;

  Quality(std::string name, TargetList list, std::string unit, Measure measure)
      : Question(std::move(name)), list_(std::move(list)), unit_(std::move(unit)), measure_(std::move(measure)) {}

  std::vector<Column> columns() const override {
    return {{"least", Column::Kind::kNumber, unit_}, {"mean", Column::Kind::kNumber, unit_}};
  }

  Expected<std::vector<Answer>> answer(VariantCell& cell) const override {
    const auto solved = solvedTargets(cell, list_);
    HAPTICELL_TRY(solved);
    const Entity& robot = *cell.document.find((*solved)->robot);
    double least = std::numeric_limits<double>::infinity(), sum = 0.0;
    for (const manipulation::FreeAnswer& target : (*solved)->targets) {
      if (!target.isFree()) continue;
      double best = -std::numeric_limits<double>::infinity();
      for (const auto& solution : target.free) best = std::max(best, measure_(robot, **solved, solution.joints));
      least = std::min(least, best);
      sum += best;
    }
    const std::size_t reached = (*solved)->reached();
    if (reached == 0) return std::vector<Answer>{std::monostate(), std::monostate()};
    return std::vector<Answer>{least, sum / static_cast<double>(reached)};
  }

 private:
  TargetList list_;
  std::string unit_;
  Measure measure_;
};

/// Share of the half range that the joint nearest to a limit has left: 0 at a limit, 1 with all joints in the middle.
double jointMargin(const Entity& robot, RobotTargets&, const std::vector<double>& joints) {
  double least = 1.0;
  const auto distances = kinematics::limitDistances(*robot.robot(), joints);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const double range = distances[i].to_lower + distances[i].to_upper;
    if (!std::isfinite(range) || range <= 0.0) continue;
    least = std::min(least, 2.0 * std::min(distances[i].to_lower, distances[i].to_upper) / range);
  }
  return least;
}

double leastSingularValue(const Entity& robot, RobotTargets& solved, const std::vector<double>& joints) {
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*robot.robot(), joints, X_BL);
  kinematics::Jacobian jacobian;
  const dvec3 p_BT = X_BL[static_cast<std::size_t>(solved.tip)] * robot.jointed().X_LT.p;
  kinematics::geometricJacobian(*robot.robot(), X_BL, solved.tip, p_BT, jacobian);
  return kinematics::manipulability(jacobian, kLever).smallest;
}

MadeQuestion madeQuality(const StudySection& section, StudyInputs& inputs, std::string unit, Quality::Measure measure) {
  SectionReader reader(section);
  auto list = readTargetList(reader, section, inputs);
  HAPTICELL_TRY(list);
  HAPTICELL_TRY(reader.end());
  return std::make_unique<Quality>(section.name, std::move(*list), std::move(unit), std::move(measure));
}

}  // namespace

MadeQuestion makeClearance(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  auto list = readTargetList(reader, section, inputs);
  HAPTICELL_TRY(list);
  double look = kLook;
  reader.fields().read("look", look, 1.0, 1e-4, kMostLook);
  HAPTICELL_TRY(reader.end());
  return std::make_unique<Quality>(section.name, std::move(*list), "m",
                                   [look](const Entity&, RobotTargets& solved, const std::vector<double>& joints) {
                                     return solved.check.clearance(joints, look);
                                   });
}

MadeQuestion makeJointMargin(const StudySection& section, StudyInputs& inputs) {
  return madeQuality(section, inputs, "", jointMargin);
}

MadeQuestion makeManipulability(const StudySection& section, StudyInputs& inputs) {
  return madeQuality(section, inputs, "", leastSingularValue);
}

}  // namespace hapticell::studies
