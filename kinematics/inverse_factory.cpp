// SPDX-License-Identifier: Apache-2.0
#include "kinematics/inverse_factory.h"

#include "kinematics/analytic_inverse.h"
#include "kinematics/numeric_inverse.h"

namespace hapticell::kinematics {

Expected<std::unique_ptr<InverseModel>> createInverse(const RobotModel& model, int tip_link, const Pose& X_LT,
                                                      const InverseOptions& options) {
  if (model.closure) return model.closure->inverse(model, tip_link, X_LT);
  auto numeric = NumericInverse::create(model, tip_link, X_LT, options.lever_m);
  if (!numeric) return makeError(numeric.error());
  using Keep = NumericInverse::Hurried::Keep;
  const bool orientation = options.at_singularity == SingularityChoice::kKeepOrientation;
  (*numeric)->setHurried({orientation ? Keep::kOrientation : Keep::kPosition, -1});
  const Classification classification = classify(*(*numeric)->chain(), options.tolerance);
  if (classification.robot_class == RobotClass::kNumeric) return std::unique_ptr<InverseModel>(std::move(*numeric));
  return std::unique_ptr<InverseModel>(
      std::make_unique<AnalyticInverse>(std::move(*numeric), classification, options, model.dof()));
}

}  // namespace hapticell::kinematics
