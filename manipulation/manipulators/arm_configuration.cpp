// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/arm_configuration.h"

#include <utility>

#include "kinematics/model/configuration_flags.h"

namespace hapticell::manipulation {

std::optional<kinematics::Chain> sixAxisChain(const workcell::Entity& entity) {
  if (entity.kind() != workcell::EntityKind::kRobot || !entity.robot() || entity.robot()->dof() != 6)
    return std::nullopt;
  int tip = entity.robot()->findLink(entity.jointed().tip_link);
  if (tip < 0) tip = entity.robot()->defaultTip();
  if (tip < 0) return std::nullopt;
  auto chain = kinematics::Chain::create(*entity.robot(), tip, entity.jointed().X_LT);
  if (!chain || chain->size() != 6) return std::nullopt;
  return std::move(*chain);
}

std::optional<int> configurationNumber(const kinematics::Chain& chain, std::span<const double> joints) {
  kinematics::ChainPositions x{};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto variable = static_cast<std::size_t>(chain.variables()[i]);
    if (variable >= joints.size()) return std::nullopt;
    x[i] = joints[variable];
  }
  const auto shape = kinematics::armShape(chain, x);
  if (!shape) return std::nullopt;
  return (shape->front ? 0 : 1) + (shape->elbow_up ? 0 : 2) + (shape->flipped ? 4 : 0);
}

}  // namespace hapticell::manipulation
