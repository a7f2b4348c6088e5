// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/scripted_motion.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/test_data.h"
#include "workcell/document/document.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {
namespace {

ScriptedMotion shuttle(MotionRepeat repeat) {
  ScriptedMotion motion;
  motion.points = {{0.0, dvec3(0.0)}, {1.0, {0.2, 0, 0}}, {3.0, {0.2, 0.4, 0}}};
  motion.repeat = repeat;
  return motion;
}

TEST(ScriptedMotion, GoesFromPointToPointAndRepeatsAsAsked) {
  const ScriptedMotion once = shuttle(MotionRepeat::kOnce), loop = shuttle(MotionRepeat::kLoop),
                       back = shuttle(MotionRepeat::kBack);
  EXPECT_EQ(once.displacementAt(-1.0), dvec3(0.0));
  EXPECT_NEAR(once.displacementAt(0.5).x, 0.1, 1e-15);
  EXPECT_NEAR(once.displacementAt(2.0).y, 0.2, 1e-15);
  EXPECT_EQ(once.displacementAt(9.0), dvec3(0.2, 0.4, 0));
  EXPECT_EQ(once.velocityAt(9.0), dvec3(0.0));
  EXPECT_NEAR(loop.displacementAt(3.5).x, 0.1, 1e-12);
  EXPECT_NEAR(back.displacementAt(3.5).y, 0.3, 1e-12) << "on its way back";
  EXPECT_NEAR(back.displacementAt(6.5).x, 0.1, 1e-12) << "and there again";
}

TEST(ScriptedMotion, ItsVelocityIsTheSlopeOfItsWay) {
  for (const MotionRepeat repeat : {MotionRepeat::kOnce, MotionRepeat::kLoop, MotionRepeat::kBack}) {
    const ScriptedMotion motion = shuttle(repeat);
    for (double t = 0.05; t < 8.0; t += 0.1) {
      const dvec3 slope = (motion.displacementAt(t + 1e-4) - motion.displacementAt(t)) / 1e-4;
      EXPECT_NEAR(glm::distance(motion.velocityAt(t), slope), 0.0, 1e-9) << t;
    }
  }
}

TEST(ScriptedMotion, RefusesWhatIsNoPath) {
  ScriptedMotion motion = shuttle(MotionRepeat::kOnce);
  EXPECT_TRUE(checkMotion(motion).has_value());
  motion.points[2].t = 1.0;
  EXPECT_FALSE(checkMotion(motion).has_value());
  motion.points[2] = {1.1, {5.0, 0, 0}};
  EXPECT_NE(checkMotion(motion).error().message().find("at most 2 m/s"), std::string::npos);
  motion.points[2] = {3.0, {std::numeric_limits<double>::infinity(), 0, 0}};
  EXPECT_FALSE(checkMotion(motion).has_value());
  motion.points.resize(1);
  EXPECT_FALSE(checkMotion(motion).has_value());
}

TEST(ScriptedMotion, IsSavedAndReadAgainWithItsEntity) {
  const test::TemporaryFolder folder;
  Document document;
  Diagnostics diagnostics;
  auto entity = EntityLoader(".").load("box:0.1,0.1,0.1", 1.0, diagnostics);
  ASSERT_TRUE(entity.has_value());
  entity->name = "belt";
  entity->motion = shuttle(MotionRepeat::kBack);
  ASSERT_TRUE(document.execute(AddEntity{*entity}).has_value());
  const auto file = folder.path() / "belt.hcell";
  ASSERT_TRUE(saveDocument(document, file).has_value());
  const auto read = loadDocument(file, diagnostics);
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_TRUE(diagnostics.warnings.empty());
  const auto entities = read->snapshotEntities();
  ASSERT_EQ(entities.size(), 1U);
  ASSERT_TRUE(entities[0].motion.has_value());
  EXPECT_EQ(entities[0].motion->repeat, MotionRepeat::kBack);
  ASSERT_EQ(entities[0].motion->points.size(), 3U);
  EXPECT_EQ(entities[0].motion->points[2].p_W, dvec3(0.2, 0.4, 0));
}

}  // namespace
}  // namespace hapticell::workcell
