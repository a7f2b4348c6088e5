// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/felt_load.h"

#include <algorithm>

namespace hapticell::manipulation {

namespace {

constexpr double kGravity = 9.80665;  // m/s^2.
// Of the continuous force, so that contacts have the other half and motors stay cool. Half: heavy parts feel alike
// sooner; twice: contacts under a weight are derated.
constexpr double kWeightShare = 0.5;

}  // namespace

haptic::LoadOptions feltLoad(const workcell::Entity& entity, workcell::ForceClass force_class,
                             const config::Configuration::Manipulation& settings, const MotionMapping& mapping,
                             double continuous_force) {
  haptic::LoadOptions load;
  if (force_class == workcell::ForceClass::kConstant) return load;
  const double weight = std::min((1.0 - settings.gravity_compensation) * entity.contact.mass * kGravity,
                                 kWeightShare * std::max(0.0, continuous_force));
  if (weight > 0.0) load.weight_D = weight * (glm::conjugate(mapping.axes()) * dvec3(0.0, 0.0, -1.0));
  if (force_class != workcell::ForceClass::kDynamics) return load;
  load.mass = std::min(entity.contact.mass, settings.felt_mass);
  load.damping = settings.load_damping;
  return load;
}

}  // namespace hapticell::manipulation
