// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closed_form/inverse_factory.h"

#include <algorithm>

#include "kinematics/closed_form/analytic_inverse.h"
#include "kinematics/numeric/numeric_inverse.h"

namespace hapticell::kinematics {

int wristJoint(const Chain& chain) {
  const std::vector<Chain::Element>& elements = chain.elements();
  const auto turning =
      std::count_if(elements.begin(), elements.end(), [](const Chain::Element& element) { return !element.prismatic; });
  if (turning < 6) return -1;
  const bool own = std::all_of(elements.end() - 3, elements.end(), [&](const Chain::Element& element) {
    const auto uses = std::count_if(elements.begin(), elements.end(),
                                    [&](const Chain::Element& other) { return other.variable == element.variable; });
    return !element.prismatic && uses == 1;
  });
  return own ? elements[elements.size() - 3].variable : -1;
}

Expected<std::unique_ptr<InverseModel>> createInverse(const RobotModel& model, int tip_link, const Pose& X_LT,
                                                      const InverseOptions& options) {
  if (model.closure) return model.closure->inverse(model, tip_link, X_LT);
  auto numeric = NumericInverse::create(model, tip_link, X_LT, options.lever_m);
  HAPTICELL_TRY(numeric);
  using Keep = NumericInverse::Hurried::Keep;
  const bool orientation = options.at_singularity == SingularityChoice::kKeepOrientation;
  const bool joint = options.at_singularity == SingularityChoice::kKeepJoint4;
  (*numeric)->setHurried(
      {orientation ? Keep::kOrientation : Keep::kPosition, joint ? wristJoint(*(*numeric)->chain()) : -1});
  const Classification classification = classify(*(*numeric)->chain(), options.tolerance);
  if (classification.robot_class == RobotClass::kNumeric) return std::unique_ptr<InverseModel>(std::move(*numeric));
  return std::unique_ptr<InverseModel>(
      std::make_unique<AnalyticInverse>(std::move(*numeric), classification, options, model.dof()));
}

}  // namespace hapticell::kinematics
