// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/felt_load.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hapticell::manipulation {
namespace {

using workcell::ForceClass;

constexpr double kStandardGravity = 9.80665;  // m/s^2, by definition (CGPM, 1901).

struct Held {
  Held() {
    entity.contact.mass = 0.8;
    settings.gravity_compensation = 0.75;
  }
  haptic::LoadOptions load(ForceClass force_class, double continuous_force = 20.0) const {
    return feltLoad(entity, force_class, settings, mapping, continuous_force);
  }
  workcell::Entity entity;
  config::Configuration::Manipulation settings;
  MotionMapping mapping;
};

TEST(FeltLoad, GrowsWithTheForceClass) {
  const Held held;
  const haptic::LoadOptions constant = held.load(ForceClass::kConstant), contact = held.load(ForceClass::kContact),
                            dynamics = held.load(ForceClass::kDynamics);
  EXPECT_EQ(constant.weight_D, dvec3(0.0));
  EXPECT_EQ(constant.mass, 0.0);
  EXPECT_EQ(constant.damping, 0.0);
  EXPECT_NEAR(contact.weight_D.z, -0.25 * 0.8 * kStandardGravity, 1e-12);
  EXPECT_EQ(contact.mass, 0.0);
  EXPECT_EQ(contact.damping, 0.0);
  EXPECT_EQ(dynamics.weight_D, contact.weight_D);
  EXPECT_EQ(dynamics.mass, held.settings.felt_mass) << "0.8 kg are more than is felt";
  EXPECT_EQ(dynamics.damping, held.settings.load_damping);
}

TEST(FeltLoad, OfALightPartIsItsOwnMassAndOfABalancedOneNoWeight) {
  Held held;
  held.entity.contact.mass = 0.1;
  held.settings.gravity_compensation = 1.0;
  const haptic::LoadOptions load = held.load(ForceClass::kDynamics);
  EXPECT_EQ(load.mass, 0.1);
  EXPECT_EQ(load.weight_D, dvec3(0.0));
}

TEST(FeltLoad, LeavesHalfOfTheMotorsForContacts) {
  Held held;
  held.entity.contact.mass = 100.0;
  held.settings.gravity_compensation = 0.0;
  EXPECT_NEAR(glm::length(held.load(ForceClass::kContact, 1.4).weight_D), 0.7, 1e-12);
  for (const double none : {0.0, -1.0})
    EXPECT_EQ(held.load(ForceClass::kContact, none).weight_D, dvec3(0.0)) << "no motors, no weight";
}

TEST(FeltLoad, PointsDownInTheCellWhateverTheAxes) {
  Held held;
  held.mapping.setAxes(quaternionFromRotationVector({0.4, -1.1, 0.7}));
  const dvec3 weight_W = held.mapping.axes() * held.load(ForceClass::kContact).weight_D;
  EXPECT_NEAR(glm::length(weight_W - dvec3(0.0, 0.0, -0.25 * 0.8 * kStandardGravity)), 0.0, 1e-12);
}

}  // namespace
}  // namespace hapticell::manipulation
