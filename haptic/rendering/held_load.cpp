// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/held_load.h"

#include <algorithm>
#include <cmath>

namespace hapticell::haptic {

namespace {

// Where nothing is said, half and twice pass the tests of this folder. docs/dev/feel.md, "Force classes".
constexpr double kLeastMass = 0.01, kMostMass = 2.0;  // kg.
constexpr double kMostDamping = 20.0, kMostWeight = 5.0, kMostFriction = 3.0;
/// N/m of friction that sticks. Half and twice fail HeldLoad.DryFrictionSticksThenSlips.
constexpr double kBristle = 800.0;
constexpr double kCoupling = 300.0;  // N/m between stylus and mass.
/// N s/m. Half fails HeldLoad.ASteadyAccelerationIsAnsweredByMassTimesIt, twice passes.
constexpr double kCouplingDamping = 3.0;
constexpr double kWeightRate = 5.0;       // N/s. Half passes, twice fails HeldLoad.AWeightComesWithoutAStep.
constexpr double kLongestStretch = 0.02;  // m: 6 N; beyond it the mass is dragged along.
constexpr int kSteps = 4;                 // Of the mass in a tick.

double within(double value, double most) {
  return std::isfinite(value) ? std::clamp(value, 0.0, most) : 0.0;
}

}  // namespace

LoadOptions sane(LoadOptions options) {
  options.mass = within(options.mass, kMostMass);
  options.damping = within(options.damping, kMostDamping);
  options.friction = within(options.friction, kMostFriction);
  const double weight = glm::length(options.weight_D);
  options.weight_D = std::isfinite(weight) ? shortenedTo(options.weight_D, kMostWeight) : dvec3(0.0);
  return options;
}

void HeldLoad::setOptions(const LoadOptions& options) {
  options_ = sane(options);
  if (options_.mass < kLeastMass) has_mass_ = false;
}

void HeldLoad::reset() {
  has_mass_ = rubs_ = false;
  weight_D_ = dvec3(0.0);
}

dvec3 HeldLoad::tick(const dvec3& p_DS, const dvec3& v_DS, double dt) {
  weight_D_ += shortenedTo(options_.weight_D - weight_D_, kWeightRate * dt);
  const dvec3 steady = weight_D_ + drag(p_DS);
  if (options_.mass < kLeastMass) return steady - options_.damping * v_DS;
  if (!has_mass_) {
    p_DM_ = p_DS;
    v_DM_ = v_DS;
    has_mass_ = true;
  }
  moveMass(p_DS, v_DS, dt);
  return steady + kCoupling * (p_DM_ - p_DS) + kCouplingDamping * (v_DM_ - v_DS);
}

/// Dry friction as a bristle (P. Dahl, 1968): a spring to where the stylus stuck, which slips at the friction force.
dvec3 HeldLoad::drag(const dvec3& p_DS) {
  if (options_.friction <= 0.0) {
    rubs_ = false;
    return dvec3(0.0);
  }
  if (!rubs_) p_DA_ = p_DS;
  rubs_ = true;
  p_DA_ = p_DS + shortenedTo(p_DA_ - p_DS, options_.friction / kBristle);
  return kBristle * (p_DA_ - p_DS);
}

void HeldLoad::moveMass(const dvec3& p_DS, const dvec3& v_DS, double dt) {
  const double h = dt / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const dvec3 p = p_DS - (dt - h * i) * v_DS;  // Both as they were when the step began.
    const dvec3 pull = kCoupling * (p - p_DM_) + kCouplingDamping * v_DS;
    // Both dampers implicitly: a light mass must not ring.
    const double drag = h * (kCouplingDamping + options_.damping) / options_.mass;
    v_DM_ = (v_DM_ + h * pull / options_.mass) / (1.0 + drag);
    p_DM_ += h * v_DM_;
  }
  const dvec3 stretch = p_DM_ - p_DS;
  if (glm::length(stretch) <= kLongestStretch) return;
  p_DM_ = p_DS + shortenedTo(stretch, kLongestStretch);
  v_DM_ = v_DS;
}

}  // namespace hapticell::haptic
