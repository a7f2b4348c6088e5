// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/document_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <utility>

#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/shapes.h"
#include "tests/support/test_data.h"
#include "tests/workcell/meshes/mesh_text.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const char* const kArm = R"(<robot name="arm"><link name="base"/><link name="upper"/><link name="tip"/>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
<joint name="end" type="fixed"><parent link="upper"/><child link="tip"/></joint></robot>)";

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string document(const std::string& entities, const std::string& more = "") {
  return R"({"format": "hapticell-workcell", "version": 1, "entities": [)" + entities + "]" + more + "}";
}

std::string refused(const std::string& text, const fs::path& folder = "/nowhere") {
  Diagnostics notes;
  const auto result = parseDocument(text, folder, "cell.hcell", notes);
  EXPECT_FALSE(result.has_value()) << text;
  return result ? "" : result.error().message();
}

/// A document in a fresh folder: a mesh beside it, one above it, a robot, a built-in box; pair sets, frames, a view.
class DocumentFile : public ::testing::Test {
 protected:
  DocumentFile() {
    folder.write("part.stl", test::stlBinary(geometry::makeTorus(400.0, 100.0)));
    folder.write("cells/meshes/table.obj", test::objText(geometry::makeBox(dvec3(1.0))));
    folder.write("robots/arm.urdf", kArm);
    path = folder.path() / "cells" / "cell.hcell";
  }

  Document made() {
    Document result;
    Diagnostics notes;
    EntityLoader loader(folder.path() / "cells");
    const std::pair<const char*, double> sources[] = {
        {"../part.stl", 0.001}, {"meshes/table.obj", 1.0}, {"box:0.1,0.2,0.3", 1.0}, {"../robots/arm.urdf", 1.0}};
    for (const auto& [what, scale] : sources) {
      auto entity = loader.load(what, scale, notes);
      EXPECT_TRUE(entity.has_value()) << (entity ? "" : entity.error().message());
      if (!entity) continue;
      entity->X_WE = {dvec3(0.1, 1.0 / 3.0, -2e-7), quaternionFromRotationVector({0.3, 0.2, -0.9})};
      entity->frames = {{"grip", Pose::translation({0.0, 0.0, 0.05})}};
      EXPECT_TRUE(result.execute(AddEntity{*entity}).has_value());
    }
    result.execute(
        SetProperties{.id = 1, .color = std::array<float, 3>{0.1f, 0.2f, 0.3f}, .locked = true, .mass = 2.5});
    result.execute(SetJoints{4, {0.123456789}});
    result.execute(SetTool{4, "upper", Pose::translation({0, 0, 0.1})});
    result.execute(
        AddPairSet{{.name = "set", .first = {"part"}, .second = {"table", "arm"}, .on_contact = OnContact::kStop}});
    result.execute(EditPairSet{"set",
                               {.name = "set",
                                .first = {"part"},
                                .second = {"table", "arm"},
                                .on_contact = OnContact::kStop,
                                .near_miss_color = std::array<float, 3>{0.25f, 0.5f, 0.75f}}});
    result.execute(SetPairRules{{{.first = "part", .second = "arm", .second_part = "upper", .checked = false},
                                 {.first = "part", .second = "table", .on_contact = OnContact::kPass}}});
    result.execute(SetView{SavedView{{1, 2, 3}, {0, 0, 0.5}}});
    return result;
  }

  test::TemporaryFolder folder;
  fs::path path;
};

TEST(KeptDocuments, OfVersion01OpenWithoutAWord) {
  const std::map<std::string, std::pair<std::size_t, std::string>> cells{
      {"extraction.hcell", {7, "filter unit"}}, {"robot.hcell", {1, "robot"}}, {"workbench.hcell", {19, "operator"}}};
  for (const auto& [name, facts] : cells) {
    Diagnostics diagnostics;
    const auto kept = loadDocument(hapticell::test::sourceFile("tests/samples/0.1/" + name), diagnostics);
    ASSERT_TRUE(kept) << kept.error().message();
    EXPECT_TRUE(diagnostics.warnings.empty()) << name << ": " << english(diagnostics.warnings);
    EXPECT_EQ(kept->state().entities.size(), facts.first) << name;
    EXPECT_NE(kept->findByName(facts.second), nullptr) << name;
  }
}

TEST_F(DocumentFile, AFreeHandIsSavedWithItsFingersAndIsOneAgain) {
  Document cell;
  Diagnostics notes;
  auto hand = EntityLoader(".").load("hand:left:female:5", 1.0, notes);
  ASSERT_TRUE(hand.has_value());
  hand->editJointed().joints[6] = 0.75;
  ASSERT_TRUE(cell.execute(AddEntity{*hand}).has_value());
  ASSERT_TRUE(saveDocument(cell, path).has_value());
  const auto again = loadDocument(path, notes);
  ASSERT_TRUE(again.has_value());
  const Entity& read = *again->state().entities.at(0);
  EXPECT_EQ(read.kind(), EntityKind::kRobot);
  EXPECT_EQ(read.joints(), hand->joints());
  EXPECT_EQ(read.robot()->findLink("l_index3"), hand->robot()->findLink("l_index3"));
}

TEST_F(DocumentFile, LoadThenSaveChangesNoByte) {
  Document first = made();
  ASSERT_TRUE(saveDocument(first, path).has_value());
  EXPECT_FALSE(first.isDirty());
  const std::string written = contentOf(path);
  Diagnostics notes;
  auto second = loadDocument(path, notes);
  ASSERT_TRUE(second.has_value()) << second.error().message();
  EXPECT_FALSE(second->isDirty());
  EXPECT_FALSE(second->canUndo());
  for (const Text& note : notes.warnings) ADD_FAILURE() << english(note);
  ASSERT_TRUE(saveDocument(*second, path).has_value());
  EXPECT_EQ(contentOf(path), written);
}

TEST_F(DocumentFile, KeepsWhatTheDocumentHeld) {
  Document first = made();
  ASSERT_TRUE(saveDocument(first, path).has_value());
  Diagnostics notes;
  const auto second = loadDocument(path, notes);
  ASSERT_TRUE(second.has_value()) << second.error().message();
  ASSERT_EQ(second->state().entities.size(), 4u);
  const Entity& part = *second->findByName("part");
  EXPECT_NEAR(part.mesh()->bounds().size().x, 1.0, 1e-6);  // 1000 mm
  EXPECT_EQ(part.source.scale, 0.001);
  EXPECT_EQ(part.source.path, (folder.path() / "part.stl").string());
  EXPECT_TRUE(part.locked);
  EXPECT_EQ(part.contact.mass, 2.5);
  EXPECT_EQ(part.X_WE.p, first.findByName("part")->X_WE.p);
  ASSERT_EQ(part.frames.size(), 1u);
  EXPECT_EQ(part.frames[0].name, "grip");
  const Entity& arm = *second->findByName("arm");
  EXPECT_THAT(arm.joints(), ElementsAre(0.123456789));
  EXPECT_EQ(arm.jointed().tip_link, "upper");
  EXPECT_EQ(second->state().pair_sets[0].on_contact, OnContact::kStop);
  EXPECT_THAT(second->state().pair_sets[0].second, ElementsAre("table", "arm"));
  EXPECT_EQ(second->state().view->p_WEye.z, 3.0);
  EXPECT_EQ(second->state().pair_rules, first.state().pair_rules);
  EXPECT_EQ(second->state().pair_rules.size(), 2u);
  EXPECT_EQ(second->state().pair_sets[0].near_miss_color->at(2), 0.75f);
  EXPECT_FALSE(second->state().pair_sets[0].contact_color.has_value());
}

TEST_F(DocumentFile, NamesAreRelativeSoThatFoldersCanMove) {
  Document first = made();
  ASSERT_TRUE(saveDocument(first, path).has_value());
  const std::string text = contentOf(path);
  EXPECT_THAT(text, HasSubstr("\"file\": \"../part.stl\""));
  EXPECT_THAT(text, HasSubstr("\"file\": \"meshes/table.obj\""));
  EXPECT_EQ(text.find(folder.path().string()), std::string::npos);
  const test::TemporaryFolder other;
  fs::copy(folder.path(), other.path() / "moved", fs::copy_options::recursive);
  Diagnostics notes;
  const auto moved = loadDocument(other.path() / "moved" / "cells" / "cell.hcell", notes);
  ASSERT_TRUE(moved.has_value()) << moved.error().message();
  EXPECT_THAT(moved->findByName("part")->source.path, HasSubstr("moved"));
}

TEST_F(DocumentFile, AMissingMeshNamesFileAndEntity) {
  Document first = made();
  ASSERT_TRUE(saveDocument(first, path).has_value());
  fs::remove(folder.path() / "part.stl");
  Diagnostics notes;
  const auto second = loadDocument(path, notes);
  ASSERT_FALSE(second.has_value());
  EXPECT_THAT(second.error().message(), HasSubstr("cell.hcell, entity 'part': "));
  EXPECT_THAT(second.error().message(), HasSubstr("part.stl: the file does not exist"));
}

TEST_F(DocumentFile, AFailedSaveLeavesTheOldFile) {
  Document first = made();
  ASSERT_TRUE(saveDocument(first, path).has_value());
  const std::string written = contentOf(path);
  first.execute(RemoveEntity{2});
  const auto failed = saveDocument(first, folder.path() / "no such folder" / "cell.hcell");
  ASSERT_FALSE(failed.has_value());
  EXPECT_THAT(failed.error().message(), HasSubstr("cell.hcell: "));
  EXPECT_TRUE(first.isDirty());
  EXPECT_EQ(contentOf(path), written);
  ASSERT_TRUE(saveDocument(first, path).has_value());
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(path.parent_path())) ++files;
  EXPECT_EQ(files, 2u);  // The document and meshes/: nothing left aside.
}

TEST(DocumentText, AHandWrittenMinimumIsEnough) {
  Diagnostics notes;
  const auto cell =
      parseDocument(document(R"({"name": "ball", "source": {"file": "sphere:0.1"}})"), "/nowhere", "c", notes);
  ASSERT_TRUE(cell.has_value()) << cell.error().message();
  EXPECT_EQ(cell->findByName("ball")->contact.on_contact, OnContact::kSlide);
  EXPECT_TRUE(notes.warnings.empty());
}

TEST(DocumentText, RefusesWhatItDoesNotUnderstand) {
  EXPECT_THAT(refused("{"), HasSubstr("cell.hcell, line 1"));
  EXPECT_THAT(refused("[1]"), HasSubstr("a JSON object in braces"));
  EXPECT_THAT(refused("{\"a\":\n1e999}"), HasSubstr("cell.hcell"));
  EXPECT_THAT(refused("{}"), HasSubstr("\"format\" is missing"));
  EXPECT_THAT(refused(R"({"format": "other", "version": 1})"), HasSubstr("the format \"other\""));
  EXPECT_THAT(refused(R"({"format": "hapticell-workcell", "version": 2})"), HasSubstr("newer HaptiCell"));
  EXPECT_THAT(refused(R"({"format": "hapticell-workcell"})"), HasSubstr("version"));
}

TEST(DocumentText, NamesEntityAndKeyOfABadValue) {
  const std::string ball = R"({"name": "ball", "source": {"file": "sphere:0.1"}, )";
  EXPECT_THAT(refused(document(ball + R"("visible": 3})")),
              HasSubstr("entity 'ball', \"visible\": 3; expected true or false"));
  EXPECT_THAT(refused(document(ball + R"("mass": "x"})")), HasSubstr("\"mass\""));
  EXPECT_THAT(refused(document(ball + R"("mass": -1})")), HasSubstr("an invalid mass"));
  EXPECT_THAT(refused(document(ball + R"("placement": {"quaternion": [2, 0, 0, 0]}})")), HasSubstr("of length 1"));
  EXPECT_THAT(refused(document(ball + R"("placement": {"position": [2, 0]}})")), HasSubstr("3 numbers"));
  EXPECT_THAT(refused(document(ball + R"("placement": {"position": [0, -1e200, 0]}})")), HasSubstr("at most 1e12"));
  EXPECT_THAT(refused(document(ball + R"("on_contact": "bounce"})")), HasSubstr("one of stop, slide, pass"));
  EXPECT_THAT(refused(document(ball + R"("kind": "robot"})")), HasSubstr("solid, like its file"));
  EXPECT_THAT(refused(document(R"({"source": {"file": "sphere:0.1"}})")), HasSubstr("entity 1: \"name\" is missing"));
  EXPECT_THAT(refused(document(R"({"name": "a", "source": {"file": "box:1,2"}})")),
              HasSubstr("invalid dimensions '1,2'"));
  EXPECT_THAT(refused(document(R"({"name": "a", "source": {"file": "library:../x"}})")), HasSubstr("library:../x"));
  EXPECT_THAT(refused(document(R"({"name": "a", "source": {"file": "mannequin:male:0"}})")), HasSubstr("0.1 to 99.9"));
  EXPECT_THAT(refused(document(R"({"name": "a", "source": {"file": "hand:middle"}})")), HasSubstr("hand:left"));
  EXPECT_THAT(refused(document(R"({"name": "a", "source": {"file": "hand:left:male:0"}})")), HasSubstr("0.1 to 99.9"));
  const std::string two =
      R"({"name": "a", "source": {"file": "sphere:1"}}, {"name": "a", "source": {"file": "sphere:1"}})";
  EXPECT_THAT(refused(document(two)), HasSubstr("already in use"));
}

TEST(DocumentText, WarnsOfUnknownKeysAndNames) {
  Diagnostics notes;
  const auto cell = parseDocument(document(R"({"name": "ball", "source": {"file": "sphere:0.1"}, "colour": 1})",
                                           R"(, "pair_sets": [{"name": "s", "first": ["bell"]}])"),
                                  "/nowhere", "c", notes);
  ASSERT_TRUE(cell.has_value());
  ASSERT_EQ(notes.warnings.size(), 2u);
  EXPECT_THAT(english(notes.warnings[0]), HasSubstr("\"colour\""));
  EXPECT_THAT(english(notes.warnings[1]), HasSubstr("'bell'"));
}

TEST(DocumentText, WhatHangsOnSomethingIsPlacedWhereItHangsAndThatIsSaid) {
  const auto chain = [](const std::string& placement_of_last) {
    return document(R"({"name": "last", "source": {"file": "sphere:0.1"}, )" + placement_of_last +
                    R"("attached": {"to": "middle", "placement": {"position": [0, 0, 3]}}},
    {"name": "middle", "source": {"file": "sphere:0.1"}, "placement": {"position": [1, 2, 0]},
     "attached": {"to": "first", "placement": {"position": [0, 2, 0]}}},
    {"name": "first", "source": {"file": "sphere:0.1"}, "placement": {"position": [1, 0, 0]}},
    {"name": "loose", "source": {"file": "sphere:0.1"}, "placement": {"position": [5, 0, 0]}, "attached": {"to": "first"}})");
  };
  Diagnostics told, silent;
  const auto moved = parseDocument(chain(""), "/nowhere", "c", told);
  ASSERT_TRUE(moved.has_value()) << moved.error().message();
  EXPECT_LT(glm::length(moved->findByName("last")->X_WE.p - dvec3(1, 2, 3)), 1e-12) << "by its carrier's carrier";
  ASSERT_EQ(told.warnings.size(), 1u);
  EXPECT_THAT(english(told.warnings[0]), HasSubstr("'last'"));
  EXPECT_LT(glm::length(moved->findByName("loose")->X_WE.p - dvec3(5, 0, 0)), 1e-12);
  EXPECT_LT(glm::length(moved->findByName("loose")->attachment.X_LE.p - dvec3(4, 0, 0)), 1e-12) << "where it stands";
  EXPECT_TRUE(parseDocument(chain(R"("placement": {"position": [1, 2, 3]}, )"), "/nowhere", "c", silent));
  EXPECT_TRUE(silent.warnings.empty());
}

TEST(DocumentText, RoundsHandWrittenQuaternionsToUnitOnes) {
  Diagnostics notes;
  const auto cell = parseDocument(
      document(R"({"name": "b", "source": {"file": "sphere:1"}, "placement": {"quaternion": [0.707, 0, 0, 0.707]}})"),
      "/nowhere", "c", notes);
  ASSERT_TRUE(cell.has_value()) << cell.error().message();
  EXPECT_TRUE(cell->findByName("b")->X_WE.isValid());
}

TEST(DocumentText, SurvivesDeepNesting) {
  EXPECT_FALSE(refused(std::string(200000, '[') + std::string(200000, ']')).empty());
  EXPECT_FALSE(refused(document(R"({"name": )" + std::string(100000, '[') + std::string(100000, ']') + "}")).empty());
}

RC_GTEST_PROP(DocumentText, SurvivesDamage, ()) {
  std::string text = document(
      R"({"name": "ball", "kind": "solid", "source": {"file": "sphere:0.1", "scale": 1}, "placement": {"position": [1, 2, 3],
      "quaternion": [1, 0, 0, 0]}, "color": [0.1, 0.2, 0.3], "frames": [{"name": "f"}]})",
      R"(, "pair_sets": [{"name": "s", "first": ["ball"], "near_miss": 0.1}], "view": {"eye": [1, 1, 1], "target": [0, 0, 0]})");
  const auto flips = *rc::gen::inRange(1, 4);
  for (int k = 0; k < flips; ++k) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    text[at] = *rc::gen::element('{', '}', '[', ']', '"', ',', ':', '0', '9', '-', 'e', ' ', 'x', '\xff');
  }
  if (*rc::gen::inRange(0, 4) == 0) text.resize(*rc::gen::inRange<std::size_t>(0, text.size()));
  Diagnostics notes;
  const auto cell = parseDocument(text, "/nowhere", "c", notes);
  if (cell) {
    // What was accepted can be written and read again.
    const std::string written = documentText(cell->state(), "/nowhere");
    const auto again = parseDocument(written, "/nowhere", "c", notes);
    RC_ASSERT(again.has_value());
    RC_ASSERT(documentText(again->state(), "/nowhere") == written);
  } else {
    RC_ASSERT(!cell.error().message().empty());
  }
}

}  // namespace
}  // namespace hapticell::workcell
