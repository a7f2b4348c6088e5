// SPDX-License-Identifier: Apache-2.0
#include "manipulation/scene/prepared_scene.h"

#include <gtest/gtest.h>

#include "collision/pieces/pieces_on_demand.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

TEST(PreparedScene, CountsWhatIsDoneAndTakesOverWhatIsKnown) {
  PreparationProgress progress;
  const auto entities = test::boxOverTable(0.02);
  const auto scene = PreparedScene::prepare(entities, {}, {}, nullptr, &progress);
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(progress.steps, 3u * 24u);
  EXPECT_EQ(progress.done, progress.steps);
  PreparationProgress again;
  const auto next = PreparedScene::prepare(entities, {}, {}, scene.get(), &again);
  ASSERT_NE(next, nullptr);
  EXPECT_EQ(again.steps, 0u);
  EXPECT_EQ(next->parts()[0].mesh.collider, scene->parts()[0].mesh.collider);
}

TEST(PreparedScene, IsGivenUpWhenCancelled) {
  PreparationProgress progress;
  progress.build.cancelled = true;
  const auto scene =
      PreparedScene::prepare({test::solid(1, "ball", geometry::makeSphere(0.1, 300))}, {}, {}, nullptr, &progress);
  EXPECT_EQ(scene, nullptr);
  EXPECT_LT(progress.done, progress.steps);
}

TEST(PreparedScene, WhatWasReadyWhenItWasCancelledIsNotMadeAgain) {
  const auto first = PreparedScene::prepare({test::solid(1, "ball", geometry::makeSphere(0.1, 24))}, {}, {});
  std::vector<workcell::Entity> entities = first->entities();
  entities.push_back(test::solid(2, "large", geometry::makeSphere(0.1, 64)));
  PreparationProgress progress;
  progress.build.cancelled = true;
  EXPECT_EQ(PreparedScene::prepare(entities, {}, {}, first.get(), &progress), nullptr);
  ASSERT_NE(progress.given_up, nullptr);
  PreparationProgress again;
  const auto scene = PreparedScene::prepare(first->entities(), {}, {}, progress.given_up.get(), &again);
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(again.steps, 0u) << "the ball was ready";
  EXPECT_EQ(scene->parts()[0].mesh.collider, first->parts()[0].mesh.collider);
  PreparationProgress whole;
  ASSERT_NE(PreparedScene::prepare(entities, {}, {}, progress.given_up.get(), &whole), nullptr);
  EXPECT_EQ(whole.steps, 3 * entities[1].mesh()->triangles.size()) << "the large one was not";
  EXPECT_EQ(whole.done, whole.steps);
}

TEST(PreparedScene, CutsLargeMeshesWhereTheyAreMetOnly) {
  auto large = geometry::makeSphere(0.2, 256);
  ASSERT_GT(large.triangles.size(), 60000u);
  const auto scene = PreparedScene::prepare(
      {test::solid(1, "large", std::move(large)), test::solid(2, "small", geometry::makeBox(dvec3(0.1)))}, {}, {});
  const PreparedMesh &first = scene->parts()[0].mesh, &second = scene->parts()[1].mesh;
  ASSERT_NE(first.pieces->blocks(), nullptr);
  EXPECT_EQ(&first.pieces->blocks()->surface(), first.collider.get());
  EXPECT_EQ(second.pieces->blocks(), nullptr);
  EXPECT_EQ(second.pieces->pieces().size(), 1u);
  EXPECT_EQ(second.collider, second.surfaces->sharedCollider()) << "one tree serves both";
}

TEST(PreparedScene, TheExactCheckKeepsWhatNoSurfaceIsMadeOf) {
  auto mesh = geometry::makeBox(dvec3(0.1));
  mesh.vertices.insert(mesh.vertices.end(), {dvec3(0.0, 0.0, 0.05), dvec3(0.0, 0.0, 0.08), dvec3(0.0, 0.0, 0.2)});
  mesh.triangles.push_back({8, 9, 10});  // A needle.
  const auto scene = PreparedScene::prepare({test::solid(1, "needle", mesh)}, {}, {});
  const auto& collider = scene->parts()[0].mesh.collider;
  EXPECT_EQ(collider->mesh().triangles.size(), mesh.triangles.size());
  EXPECT_NEAR(collider->bounds().max.z, 0.2, 1e-12);
}

TEST(PreparedScene, FindsEntitiesPartsAndRulesByTables) {
  std::vector<workcell::Entity> entities;
  for (int i = 1; i <= 20; ++i) {
    entities.push_back(test::solid(static_cast<workcell::EntityId>(100 + i), "part" + std::to_string(i),
                                   geometry::makeBox(dvec3(0.1))));
  }
  entities[4].body = workcell::Solid{};
  const std::vector<workcell::PairRule> rules{{.first = "part1", .second = "part2", .checked = false},
                                              {.first = "part3", .second = "part1", .checked = false},
                                              {.first = "part2", .second = "part1", .checked = true}};
  const auto scene = PreparedScene::prepare(entities, workcell::PairPolicy({}, rules), {});
  for (const workcell::Entity& entity : scene->entities()) {
    EXPECT_EQ(scene->find(entity.id), &entity);
    EXPECT_EQ(scene->find(entity.name), &entity);
    ASSERT_EQ(scene->partsOf(entity.id).size(), entity.mesh() ? 1u : 0u);
    if (entity.mesh()) {
      EXPECT_EQ(scene->partsOf(entity.id).front().entity, entity.id);
    }
  }
  EXPECT_EQ(scene->find(workcell::EntityId{7}), nullptr);
  EXPECT_TRUE(scene->partsOf(7).empty());
  const auto part = [&](workcell::EntityId id) -> const ScenePart& { return scene->partsOf(id).front(); };
  EXPECT_TRUE(scene->isChecked(part(101), part(102))) << "the later rule counts";
  EXPECT_FALSE(scene->isChecked(part(101), part(103)));
  EXPECT_TRUE(scene->isChecked(part(102), part(103)));
  EXPECT_EQ(scene->ruleFor(part(104), part(106)), nullptr);
}

}  // namespace
}  // namespace hapticell::manipulation
