// SPDX-License-Identifier: Apache-2.0
// What a mannequin is as it is taken: on its feet or in the air, what it carries, what its body is in.
#include "manipulation/manipulators/mannequin_taking.h"

#include <gtest/gtest.h>

#include "tests/manipulation/manipulators/worker.h"

namespace hapticell::manipulation {
namespace {

using test::box;
using test::worker;

struct Taken {
  explicit Taken(std::vector<workcell::Entity> entities, double lifted = 0.0)
      : scene(test::workerScene(std::move(entities))), entity(*scene->find("worker")) {
    stands = {entity.X_WE, entity.joints()};
    stands.X_WE.p.z += lifted;
  }
  Taking taking() const { return {entity, stands, by::Whole{}, *scene, configuration, {}}; }
  std::shared_ptr<const PreparedScene> scene;
  const workcell::Entity& entity;
  EntityConfiguration stands;
  config::Configuration configuration;
};

TEST(MannequinTaking, HangsOnlyWithNothingUnderItsFeet) {
  EXPECT_FALSE(hangsInTheAir(Taken({worker("standing")}).taking()));
  EXPECT_FALSE(hangsInTheAir(Taken({worker("standing")}, 0.01).taking())) << "a little high";
  EXPECT_TRUE(hangsInTheAir(Taken({worker("standing")}, 0.1).taking()));
  const workcell::Entity step = box(8, "step", {1.0, 1.0, 0.09}, {0.0, 0.0, 0.045});
  EXPECT_FALSE(hangsInTheAir(Taken({worker("standing"), step}, 0.1).taking())) << "on a step, 10 mm high";
  workcell::Entity carried = step;
  carried.attachment.to = "worker";
  EXPECT_TRUE(hangsInTheAir(Taken({worker("standing"), carried}, 0.1).taking())) << "what it carries bears nothing";
}

TEST(MannequinTaking, WhatAHandHoldsIsOneLoad) {
  const auto part = [](workcell::EntityId id, const char* name, double mass, const dvec3& p_LE) {
    workcell::Entity held = box(id, name, dvec3(0.04), {});
    held.attachment = {"worker", mannequin::segmentInfo(mannequin::Segment::kLeftHand).name, Pose::translation(p_LE)};
    held.contact.mass = mass;
    return held;
  };
  const auto none = loadsInHands(Taken({worker("standing")}).taking());
  EXPECT_EQ(none[0].mass, 0.0);
  const auto one = loadsInHands(Taken({worker("standing"), part(8, "a", 3.0, {0.1, 0.0, 0.0})}).taking());
  const auto other = loadsInHands(Taken({worker("standing"), part(8, "a", 1.0, {-0.1, 0.0, 0.0})}).taking());
  EXPECT_EQ(one[0].mass, 3.0);
  EXPECT_EQ(one[1].mass, 0.0) << "the right hand is empty";
  EXPECT_NEAR(glm::distance(one[0].p_HC, other[0].p_HC), 0.2, 1e-9);
  const auto both = loadsInHands(
      Taken({worker("standing"), part(8, "a", 3.0, {0.1, 0.0, 0.0}), part(9, "b", 1.0, {-0.1, 0.0, 0.0})}).taking());
  EXPECT_EQ(both[0].mass, 4.0);
  EXPECT_NEAR(glm::length(both[0].p_HC - (0.75 * one[0].p_HC + 0.25 * other[0].p_HC)), 0.0, 1e-9);
}

}  // namespace
}  // namespace hapticell::manipulation
