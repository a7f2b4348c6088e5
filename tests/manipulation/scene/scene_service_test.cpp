// SPDX-License-Identifier: Apache-2.0
#include "manipulation/scene/scene_service.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

SceneSource sourceAt(std::uint64_t revision) {
  SceneSource source;
  source.entities = {test::solid(1, "ball", geometry::makeSphere(0.1, 24))};
  source.revision = revision;
  return source;
}

TEST(SceneService, GivesTheSameSceneForTheSameRevisionAndPairs) {
  SceneService scenes;
  const SceneSource source = sourceAt(7);
  const auto first = scenes.prepare(source);
  EXPECT_EQ(scenes.prepare(source), first);
  SceneSource other = source;
  other.pairs.rules = {{.first = "ball", .second = "table", .checked = false}};
  EXPECT_NE(scenes.prepare(other), first) << "other rules are another scene";
  SceneSource unknown = source;
  unknown.revision = 0;
  EXPECT_NE(scenes.prepare(unknown), first);
}

TEST(SceneService, MakesAMeshReadyOnceForWhoeverAsks) {
  SceneService scenes;
  const SceneSource source = sourceAt(1);
  const auto first = scenes.prepare(source);
  SceneSource next = source;
  next.revision = 2;
  PreparationProgress progress;
  const auto second = scenes.prepare(next, &progress);
  EXPECT_EQ(progress.steps, 0U);
  EXPECT_EQ(second->parts()[0].mesh.collider, first->parts()[0].mesh.collider);
  // Two at once, too.
  SceneService fresh;
  std::shared_ptr<const PreparedScene> a, b;
  std::thread other([&] { a = fresh.prepare(source); });
  b = fresh.prepare(source);
  other.join();
  EXPECT_EQ(a, b);
}

TEST(SceneService, AnswersNobodyWhoCancelledAndForgetsAClosedDocument) {
  SceneService scenes;
  PreparationProgress cancelled;
  cancelled.build.cancelled = true;
  EXPECT_EQ(scenes.prepare(sourceAt(1), &cancelled), nullptr);
  std::weak_ptr<const PreparedScene> watched;
  {
    const auto scene = scenes.prepare(sourceAt(1));
    scenes.setShown(scene);
    EXPECT_EQ(scenes.shown(), scene);
    watched = scene;
  }
  EXPECT_FALSE(watched.expired()) << "kept for the next question";
  scenes.forget();
  EXPECT_TRUE(watched.expired());
  EXPECT_EQ(scenes.shown(), nullptr);
}

}  // namespace
}  // namespace hapticell::manipulation
