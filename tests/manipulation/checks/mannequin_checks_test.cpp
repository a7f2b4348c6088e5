// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "manipulation/checks/mannequin_sight.h"
#include "manipulation/checks/mannequin_workplace.h"
#include "manipulation/checks/workplace_check.h"
#include "tests/manipulation/manipulators/worker.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

using test::box;
using test::worker;

TEST(TargetSight, AWallHidesWhatIsBehindIt) {
  const workcell::Entity entity = worker("standing");
  const workcell::Entity target = box(8, "target", dvec3(0.2), {2.0, 0.0, 1.6});
  const auto posture = mannequin::toPosture(*entity.figure(), {entity.X_WE, entity.joints()});
  const auto free = PreparedScene::prepare({entity, target}, {}, {});
  const TargetSight seen = sightOfTarget(*free, entity, posture, 8);
  EXPECT_NEAR(seen.seen, 1.0, 1e-12);
  EXPECT_NEAR(seen.distance, 1.9, 0.15);
  EXPECT_NE(seen.zone, mannequin::VisionZone::kOutside);
  const auto walled =
      PreparedScene::prepare({entity, target, box(9, "wall", {0.02, 2.0, 2.0}, {1.0, 0.0, 1.5})}, {}, {});
  const TargetSight hidden = sightOfTarget(*walled, entity, posture, 8);
  EXPECT_NEAR(hidden.seen, 0.0, 1e-12);
  EXPECT_EQ(hidden.hidden_by, "wall");
  EXPECT_EQ(hidden.clearance, 0.0);
}

TEST(WorkplaceSearch, MovesTheChosenPartsWithWhatIsAttachedAndNothingElse) {
  WorkplaceQuestion question;
  workcell::Entity vise = box(9, "vise", {0.1, 0.1, 0.1}, {0.8, 0.0, 0.66}),
                   jaw = box(10, "jaw", {0.02, 0.1, 0.02}, {});
  vise.attachment.to = "table";
  jaw.attachment.to = "vise";
  question.entities = {jaw, worker("both_hands_forward"), vise, box(8, "table", {0.5, 0.8, 0.04}, {0.80, 0.0, 0.60}),
                       box(11, "shelf", {0.5, 0.1, 0.04}, {1.20, 0.0, 0.60})};
  question.mannequin = 7;
  question.station = {8};
  EXPECT_EQ(movedWith(question), (std::vector<workcell::EntityId>{10, 9, 8}));
  question.station = {9};
  EXPECT_EQ(movedWith(question), (std::vector<workcell::EntityId>{10, 9}));
  question.station = {7};
  const std::atomic<bool> cancel{false};
  EXPECT_FALSE(searchWorkplace(question, {}, cancel)) << "the mannequin does not move itself";
}

TEST(WorkplaceSearch, FindsAPlaceRefusesNonsenseAndCanBeCancelled) {
  WorkplaceQuestion question;
  question.entities = {worker("both_hands_forward"), box(8, "table", {0.5, 0.8, 0.04}, {0.80, 0.0, 0.60})};
  question.mannequin = 7;
  question.station = {8};
  question.rise_from = question.away_from = -0.1;
  question.rise_to = question.away_to = 0.1;
  question.rise_step = question.away_step = 0.1;
  std::atomic<bool> cancel{false};
  std::atomic<int> told{0};
  const auto map = searchWorkplace(
      question, [&](double) { ++told; }, cancel);
  ASSERT_TRUE(map) << map.error().message();
  EXPECT_EQ(map->cells.size(), 9u);
  EXPECT_EQ(told, 9);
  EXPECT_TRUE(map->is_complete);
  ASSERT_GE(map->best, 0);
  const WorkplaceCell& best = map->cells[static_cast<std::size_t>(map->best)];
  for (const WorkplaceCell& cell : map->cells) {
    if (cell.worst > 0) {
      EXPECT_LE(best.worst, cell.worst);
    } else {
      EXPECT_FALSE(cell.why.empty());
    }
  }
  const auto again = searchWorkplace(question, {}, cancel);
  EXPECT_EQ(again->best, map->best) << "whatever thread took which cell";
  cancel = true;
  EXPECT_FALSE(searchWorkplace(question, {}, cancel)->is_complete);
  cancel = false;
  question.station = {99};
  EXPECT_FALSE(searchWorkplace(question, {}, cancel));
  question.station = {8};
  question.rise_step = 0.0;
  EXPECT_FALSE(searchWorkplace(question, {}, cancel));
}

TEST(WorkplaceSearch, WhatItPromisesIsMeasuredOnThePostures) {
  WorkplaceQuestion question;
  question.entities = {worker("both_hands_forward"), box(8, "table", {0.5, 0.8, 0.04}, {0.80, 0.0, 0.60})};
  question.mannequin = 7;
  question.station = {8};
  question.rise_from = question.away_from = -0.1;
  question.rise_to = question.away_to = 0.1;
  question.rise_step = question.away_step = 0.2;
  const std::atomic<bool> cancel{false};
  const auto map = searchWorkplace(question, {}, cancel);
  ASSERT_TRUE(map && map->best >= 0);
  for (const WorkplaceCell& cell : map->cells) {
    EXPECT_EQ(cell.postures.size(), cell.worst > 0 ? 4u : 0u);
    if (cell.worst == 0) continue;
    const Promises kept = workplacePromises(question, cell, movedCell(question, cell));
    EXPECT_TRUE(kept.areKept()) << kept.missed("").message();
    EXPECT_EQ(kept.list.size(), 16u);
  }
  const WorkplaceCell& best = map->cells[static_cast<std::size_t>(map->best)];
  const auto worstOf = [&](const WorkplaceCell& place, const std::vector<workcell::Entity>& after) {
    const Promises promises = workplacePromises(question, place, after);
    return promises.areKept() ? std::string() : promises.worst()->name + ' ' + english(promises.worst()->place);
  };
  const auto after = movedCell(question, best);
  WorkplaceCell place = best;
  place.rula[2] -= 1;
  EXPECT_EQ(worstOf(place, after), "rula_P50M P50M");
  place = best, place.rise += 0.01;
  EXPECT_NE(worstOf(place, after).find("hands_"), std::string::npos);
  place = best, place.postures[3].X_WR.p.x -= 0.01;
  EXPECT_EQ(worstOf(place, after), "hands_P95M P95M");
  place = best, place.postures.pop_back();
  EXPECT_EQ(worstOf(place, after), "bodies ");
  auto blocked = after;  // A post where the trunk is.
  blocked.push_back(box(12, "post", {0.1, 0.1, 2.0}, {best.postures[0].X_WR.p.x, best.postures[0].X_WR.p.y, 1.0}));
  EXPECT_NE(worstOf(best, blocked).find(" in post"), std::string::npos);
}

}  // namespace
}  // namespace hapticell::manipulation
