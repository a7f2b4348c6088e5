// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/body_contacts.h"

#include <gtest/gtest.h>

#include "collision/queries/proximity_query.h"
#include "tests/manipulation/manipulators/worker.h"

namespace hapticell::manipulation {
namespace {

using test::box;
using test::worker;

std::string entered(const workcell::Entity& other, workcell::PairPolicy pairs = {}) {
  const auto scene = test::workerScene({worker("standing"), other}, std::move(pairs));
  const workcell::Entity& body = *scene->find("worker");
  return enteredByBody(*scene, body, mannequin::toPosture(*body.figure(), {body.X_WE, body.joints()}));
}

TEST(BodyContacts, NameWhatTheBodyIsIn) {
  const dvec3 chest(0.0, 0.0, 1.3);
  EXPECT_EQ(entered(box(8, "post", dvec3(0.1), chest)), "post");
  EXPECT_EQ(entered(box(8, "post", dvec3(0.1), chest + dvec3(2.0, 0.0, 0.0))), "");
  workcell::Entity carried = box(8, "pack", dvec3(0.1), chest);
  carried.attachment.to = "worker";
  EXPECT_EQ(entered(carried), "") << "what it carries";
  workcell::Entity unchecked = box(8, "ghost", dvec3(0.1), chest);
  unchecked.checked = false;
  EXPECT_EQ(entered(unchecked), "");
  workcell::PairRule rule;
  rule.first = "worker";
  rule.second = "post";
  rule.checked = false;
  EXPECT_EQ(entered(box(8, "post", dvec3(0.1), chest), workcell::PairPolicy({}, {rule})), "") << "left out by the user";
}

TEST(BodyContacts, HandsTouchTheWork) {
  const workcell::Entity body = worker("standing");
  const int hand = body.robot()->findLink(mannequin::segmentInfo(mannequin::Segment::kLeftHand).name);
  ASSERT_GE(hand, 0);
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*body.robot(), body.joints(), X_BL);
  const dvec3 p_WHand = body.X_WE * X_BL[static_cast<std::size_t>(hand)] * dvec3(0.0);
  // 90 mm beyond the wrist, in the palm, where the hand hangs.
  const workcell::Entity work = box(8, "work", dvec3(0.02), p_WHand + dvec3(0.0, 0.0, -0.09));
  const auto scene = test::workerScene({body, work});
  const ScenePart& solid = scene->partsOf(8).front();
  bool is_in_hand = false;
  for (const ScenePart& part : scene->partsOf(body.id))
    is_in_hand =
        is_in_hand ||
        (part.link == hand && collision::distance(part.mesh.collider, body.X_WE * X_BL[static_cast<std::size_t>(hand)],
                                                  solid.mesh.collider, work.X_WE, 1e-3)
                                  .colliding);
  EXPECT_TRUE(is_in_hand);
  EXPECT_EQ(entered(work), "") << "though the hand is in it";
}

}  // namespace
}  // namespace hapticell::manipulation
