// SPDX-License-Identifier: Apache-2.0
// A hand that is suddenly far away: the body comes after it in steps, each of which may only take so long.
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/shapes/shapes.h"
#include "manipulation/holding/held_entity.h"
#include "mannequin/shape/figure_model.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

workcell::Entity worker() {
  Diagnostics diagnostics;
  workcell::Entity entity = *workcell::EntityLoader(".").load("mannequin:male:50", 1.0, diagnostics);
  entity.id = 7;
  entity.name = "worker";
  const auto model = mannequin::toModel(*entity.figure(), *mannequin::libraryPosture(*entity.figure(), "standing"));
  entity.X_WE = model.X_WE;
  entity.setJoints(model.joints);
  return entity;
}

double turned(const EntityConfiguration& from, const EntityConfiguration& to) {
  double sum = glm::length(difference(to.X_WE, from.X_WE).angular);
  for (std::size_t i = 0; i < from.joints.size(); ++i) sum += std::abs(to.joints[i] - from.joints[i]);
  return sum;
}

TEST(LongWay, IsGoneInStepsUntilTheHandIsReached) {
  const auto scene = PreparedScene::prepare({worker()}, {}, {});
  HoldOptions options;
  options.moved_by = by::Hand{mannequin::Side::kLeft};
  auto held = HeldEntity::take(scene, 7, {}, options, config::Configuration{});
  ASSERT_TRUE(held) << held.error().message();
  MotionMapping mapping;
  const Pose start = (*held)->movedFrame();
  mapping.anchor(start, start);
  const EntityConfiguration first = (*held)->accepted();
  // Down to the floor in front: legs, trunk and arm all have far to go.
  Pose wanted = start;
  wanted.p += dvec3(0.45, -0.1, -0.55);
  double longest = 0.0;
  EntityConfiguration before = first;
  int steps = 0;
  for (; steps < 60; ++steps) {
    (*held)->follow(wanted, mapping, nullptr);
    const double way = turned(before, (*held)->accepted());
    longest = std::max(longest, way);
    before = (*held)->accepted();
    if (way < 1e-9) break;
  }
  const double whole = turned(first, before);
  EXPECT_GT(whole, 4.0) << "the test asks for too little";
  EXPECT_LT(longest, 0.8 * whole) << "all at once";
  EXPECT_GE(steps, 2);
  EXPECT_LT(steps, 60) << "it never comes to rest";
}

}  // namespace
}  // namespace hapticell::manipulation
