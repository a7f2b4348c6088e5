// SPDX-License-Identifier: Apache-2.0
// The parts of which variants are made: shared inputs, places, and the kinds of what varies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/shape/figure_model.h"
#include "studies/document/study_section.h"
#include "studies/variants/placed_entities.h"
#include "studies/variants/study_inputs.h"
#include "studies/variants/variation_kinds.h"
#include "tests/support/test_data.h"
#include "workcell/import/entity_source.h"

namespace hapticell::studies {
namespace {

workcell::Entity entityOf(const std::string& what, const std::string& name, const Pose& X_WE) {
  Diagnostics notes;
  auto entity = workcell::EntityLoader(".").load(what, 0.0, notes);
  EXPECT_TRUE(entity) << entity.error().message();
  entity->name = name;
  entity->X_WE = X_WE;
  return *entity;
}

/// A foot with a block on it, both locked, and the study of a text.
StudyInputs inputsOf(const std::string& text) {
  StudyInputs inputs;
  auto document = StudyDocument::parse("cell = \"a.hcell\"\n" + text, "/tmp/s.hstudy");
  EXPECT_TRUE(document) << document.error().message();
  inputs.document = *document;
  const auto add = [&](workcell::Entity entity) { return *inputs.cell.execute(workcell::AddEntity{std::move(entity)}); };
  const auto foot = add(entityOf("box:0.3,0.3,0.4", "foot", Pose::translation({0.0, 0.0, 0.2})));
  const auto block = add(entityOf("box:0.1,0.1,0.1", "block", Pose::translation({0.0, 0.0, 0.45})));
  EXPECT_TRUE(inputs.cell.execute(workcell::Attach{block, foot, ""}));
  workcell::SetProperties lock;
  lock.id = foot;
  lock.locked = true;
  EXPECT_TRUE(inputs.cell.execute(lock));
  return inputs;
}

const std::string kPosition =
    "[[vary]]\nwhat = \"position\"\nname = \"x\"\nentity = \"foot\"\naxis = \"x\"\nvalues = [0.0, 0.25]\n"
    "[[ask]]\nwhat = \"sight\"\n";

TEST(StudyInputs, ReadsEachShapeOnceAndNamesWhatTheCellHas) {
  StudyInputs inputs = inputsOf(kPosition);
  const auto first = inputs.shapeOf("library:ur5e"), second = inputs.shapeOf("library:ur5e");
  ASSERT_TRUE(first && second);
  EXPECT_EQ(*first, *second);
  EXPECT_TRUE((*first)->robot());
  EXPECT_EQ(inputs.shapes.size(), 1u);
  EXPECT_TRUE(inputs.files.empty()) << "what the program brings along is no file of the study";
  EXPECT_FALSE(inputs.shapeOf("library:none"));
  EXPECT_FALSE(inputs.motionOf("/none/m.htraj"));
  EXPECT_TRUE(inputs.motions.empty());
  const StudySection& section = inputs.document.variations[0];
  EXPECT_EQ((*inputs.entityNamed(section, "block"))->name, "block");
  const auto missing = inputs.entityNamed(section, "blok");
  ASSERT_FALSE(missing);
  for (const char* part : {"/tmp/s.hstudy", "blok", "foot", "block"})
    EXPECT_NE(missing.error().message().find(part), std::string::npos) << missing.error().message();
}

TEST(PlacedEntities, ALockedOneMovesWithWhatItCarriesAndStaysLocked) {
  StudyInputs inputs = inputsOf(kPosition);
  VariantCell cell(inputs);
  const workcell::EntityId foot = cell.document.findByName("foot")->id;
  ASSERT_TRUE(place(cell.document, foot, Pose::translation({0.5, 0.0, 0.2})));
  EXPECT_TRUE(cell.document.find(foot)->locked);
  EXPECT_LT(glm::distance(cell.document.findByName("block")->X_WE.p, dvec3(0.5, 0.0, 0.45)), 1e-12);
  EXPECT_EQ(inputs.cell.findByName("foot")->X_WE.p.x, 0.0) << "other variants do not see it";
}

TEST(PlacedEntities, AnotherBodyStandsWhereTheFirstOneStood) {
  workcell::Document document;
  const auto id = *document.execute(
      workcell::AddEntity{entityOf("mannequin:male:50", "worker", Pose::translation({1.0, 2.0, 0.0}))});
  const auto poseNow = [&] {
    const workcell::Entity& worker = *document.find(id);
    const auto posture = mannequin::toPosture(*worker.figure(), {worker.X_WE, worker.joints()});
    return mannequin::forwardKinematics(*worker.figure(), posture);
  };
  const mannequin::FigurePose before = poseNow();
  ASSERT_TRUE(replaceBody(document, id, entityOf("mannequin:female:5", "other", {})));
  const mannequin::FigurePose now = poseNow();
  using enum mannequin::Segment;
  EXPECT_LT(now[kHead].p_WS.z, before[kHead].p_WS.z - 0.1) << "a smaller one";
  const dvec3 moved = 0.5 * (now[kLeftFoot].p_WS + now[kRightFoot].p_WS - before[kLeftFoot].p_WS - before[kRightFoot].p_WS);
  EXPECT_LT(std::hypot(moved.x, moved.y), 0.03);
  EXPECT_LT(std::abs(moved.z), 0.03) << "on the same floor";
}

TEST(VariationKinds, EachNameHasItsOwnMaker) {
  const auto kinds = variationKinds();
  const auto makerOf = [&](const std::string& name) {
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.name == name; });
    return kind == kinds.end() ? nullptr : kind->make;
  };
  EXPECT_EQ(makerOf("position"), &makePosition);
  EXPECT_EQ(makerOf("rotation"), &makeRotation);
  EXPECT_EQ(makerOf("robot"), &makeRobotChoice);
  EXPECT_EQ(makerOf("body"), &makeBodyChoice);
  EXPECT_EQ(makerOf("size"), &makePartSize);
  EXPECT_EQ(makerOf("joint"), &makeJointPosition);
  EXPECT_EQ(makerOf("tool"), &makeToolChoice);
  EXPECT_EQ(makerOf("tool_offset"), &makeToolOffset);
  EXPECT_EQ(makerOf("motion"), &makeMotionChoice);
}

TEST(VariationKinds, APositionMovesWhatItNamesByItsValue) {
  StudyInputs inputs = inputsOf(kPosition);
  const auto variation = makePosition(inputs.document.variations[0], inputs);
  ASSERT_TRUE(variation) << variation.error().message();
  EXPECT_EQ((*variation)->name(), "x");
  EXPECT_EQ((*variation)->unit(), "m");
  EXPECT_FALSE((*variation)->changesShape());
  ASSERT_EQ((*variation)->range().count(), 2u);
  VariantCell cell(inputs);
  ASSERT_TRUE((*variation)->apply((*variation)->range().at(1), cell));
  EXPECT_NEAR(cell.document.findByName("foot")->X_WE.p.x, 0.25, 1e-12);
  EXPECT_NEAR(cell.document.findByName("block")->X_WE.p.x, 0.25, 1e-12);
}

TEST(VariationKinds, NoneVariesWhatIsNotInTheCell) {
  for (const VariationKind& kind : variationKinds()) {
    StudyInputs inputs = inputsOf("[[vary]]\nwhat = \"" + std::string(kind.name) +
                                  "\"\nname = \"v\"\nentity = \"nobody\"\naxis = \"x\"\nvalues = [0.0]\n[[ask]]\nwhat = \"sight\"\n");
    const auto refused = makeVariation(inputs.document.variations[0], inputs);
    ASSERT_FALSE(refused) << kind.name;
    EXPECT_NE(refused.error().message().find("s.hstudy"), std::string::npos) << refused.error().message();
  }
}

}  // namespace
}  // namespace hapticell::studies
