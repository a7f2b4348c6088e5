// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mannequin/body/figure.h"
#include "workcell/document/document.h"
#include "workcell/format/document_format.h"
#include "workcell/import/entity_source.h"
#include "workcell/format/work_task_format.h"

namespace hapticell::workcell {
namespace {

Entity mannequinEntity(const std::string& source) {
  Diagnostics diagnostics;
  auto entity = EntityLoader({}).load(source, 0.0, diagnostics);
  EXPECT_TRUE(entity.has_value()) << (entity ? "" : entity.error().message());
  return entity ? std::move(*entity) : Entity{};
}

ergonomics::WorkTask screwing() {
  ergonomics::WorkTask task = ergonomics::workTaskPresets()[2];
  task.name = "Screw the cover";
  task.mannequin = "mannequin";
  return task;
}

TEST(WorkTask, IsKeptUndoneAndRenamedWithItsMannequin) {
  Document document;
  ASSERT_TRUE(document.execute(AddEntity{mannequinEntity("mannequin:female:5")}));
  ASSERT_TRUE(document.execute(SetWorkTask{screwing()}));
  EXPECT_EQ(document.state().workTaskOf("mannequin")->name, "Screw the cover");
  EXPECT_EQ(document.undoTexts().back(), "Change task Screw the cover");
  const EntityId id = document.findByName("mannequin")->id;
  ASSERT_TRUE(document.execute(RenameEntity{id, "Operator"}));
  EXPECT_EQ(document.state().work_tasks[0].mannequin, "Operator");
  ASSERT_TRUE(document.execute(RemoveEntity{id}));
  EXPECT_TRUE(document.state().work_tasks.empty());
  document.undo();
  ASSERT_EQ(document.state().work_tasks.size(), 1u);
  document.undo();
  document.undo();
  EXPECT_TRUE(document.state().work_tasks.empty());
}

TEST(WorkTask, RefusesWhatMakesNoSenseByName) {
  Document document;
  ergonomics::WorkTask task;
  task.load_kg[1] = 500.0;
  auto refused = document.execute(SetWorkTask{task});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("load_kg 500"), std::string::npos) << refused.error().message();
  task = {};
  task.mannequin = "nobody";
  EXPECT_FALSE(document.execute(SetWorkTask{task}));
  EXPECT_FALSE(document.execute(RemoveWorkTask{"none"}));
  EXPECT_TRUE(document.undoTexts().empty());
}

TEST(WorkTask, ComesBackFromItsTextWithWhatIsUnknownStillUnknown) {
  ergonomics::WorkTask task = screwing();
  task.grip.reset();
  task.has_shock.reset();
  task.arm_supported[1] = true;
  task.is_lift = true;
  task.lift_distance_m = 0.45;
  std::optional<Error> error;
  Diagnostics diagnostics;
  EXPECT_EQ(workTaskFromJson(jsonFromWorkTask(task), 0, error, diagnostics), task);
  EXPECT_FALSE(error);
  const Json bad{{"name", "x"}, {"load_left_kg", "heavy"}};
  workTaskFromJson(bad, 0, error, diagnostics);
  ASSERT_TRUE(error);
  EXPECT_NE(english(error->place).find("load_left_kg"), std::string::npos);
}

TEST(MannequinSource, TakesStatureMassAndOwnMeasures) {
  const Entity entity = mannequinEntity("mannequin:female:1620mm:70kg:handlength=0.19");
  EXPECT_NEAR(entity.figure()->body[mannequin::Dimension::kStature], 1.62, 1e-9);
  EXPECT_NEAR(entity.contact.mass, 70.0, 1e-9);
  EXPECT_NEAR(entity.figure()->body[mannequin::Dimension::kHandLength], 0.19, 1e-9);
  for (const char* bad : {"mannequin:female:1620cm", "mannequin:male:50:heavy", "mannequin:male:50:nose=0.1"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(EntityLoader({}).load(bad, 0.0, diagnostics)) << bad;
  }
}

TEST(MannequinSource, AnotherSizeIsOneStepThatKeepsTheJoints) {
  Document document;
  ASSERT_TRUE(document.execute(AddEntity{mannequinEntity("mannequin:male:50")}));
  const Entity before = *document.findByName("mannequin");
  ASSERT_TRUE(document.execute(ReplaceShape{before.id, mannequinEntity("mannequin:female:5")}));
  const Entity& after = *document.findByName("mannequin");
  EXPECT_NEAR(after.figure()->body[mannequin::Dimension::kStature], 1.525, 0.001);
  EXPECT_EQ(after.joints(), before.joints());
  EXPECT_EQ(after.source.path, "mannequin:female:5");
  document.undo();
  EXPECT_EQ(document.findByName("mannequin")->figure(), before.figure());
}

}  // namespace
}  // namespace hapticell::workcell
