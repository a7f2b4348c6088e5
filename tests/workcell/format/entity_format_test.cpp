// SPDX-License-Identifier: Apache-2.0
// The parts of a workcell document's text: what is written is read again, and what cannot be is refused with its place.
#include "workcell/format/entity_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/test_data.h"
#include "tests/workcell/document/every_command.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/entity/mechanism.h"
#include "workcell/format/document_io.h"
#include "workcell/format/format_context.h"
#include "workcell/format/guide_format.h"
#include "workcell/format/mechanism_format.h"
#include "workcell/format/motion_format.h"
#include "workcell/format/recordings.h"
#include "workcell/format/robot_format.h"
#include "workcell/format/source_format.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
namespace fs = std::filesystem;

class Format : public ::testing::Test {
 protected:
  const fs::path folder{"/cell"};
  EntityLoader loader{"/cell"};
  Diagnostics notes;
  LoadOptions options;
  std::optional<Error> error;
  FormatContext context{folder, loader, notes, options, error};
  const Text place{"entity 'it'"};
};

TEST_F(Format, TheFirstErrorOfAPartBecomesOneOfItsEntity) {
  context.failIn(place, Error{.place = "face 3", .found = "no corner", .fix = "Export it again."});
  ASSERT_TRUE(error.has_value());
  EXPECT_THAT(error->message(), HasSubstr("entity 'it'"));
  EXPECT_THAT(error->message(), HasSubstr("face 3"));
  EXPECT_THAT(error->message(), HasSubstr("Export it again."));
}

TEST_F(Format, ThereIsAWordForEachKindOfEntity) {
  EXPECT_THAT(entityKindWords(), ElementsAre("solid", "robot", "mechanism", "assembly", "mannequin", "frame"));
  EXPECT_THAT(kOnContactWords, SizeIs(3));
}

TEST_F(Format, AnEntityIsReadAsItWasWritten) {
  Entity entity = test::makeSolid("it", 0.5);
  entity.X_WE.q = quaternionFromRotationVector({0.1, 0.2, 0.3});
  entity.parent = "group";
  entity.color = {0.25f, 0.5f, 1.0f};
  entity.visible = false;
  entity.locked = true;
  entity.checked = false;
  entity.contact = {OnContact::kPass, ForceClass::kDynamics, "rubber", 2.5};
  entity.frames = {{"top", Pose::translation({0, 0, 0.05})}};
  entity.attachment = {"table", "", Pose::translation({1, 2, 3})};
  entity.motion = ScriptedMotion{{{0.0, {}}, {2.0, {0.5, 0.0, 0.0}}}, MotionRepeat::kBack};
  const Json json = jsonFromEntity(entity, folder);
  EXPECT_EQ(json["kind"], "solid");

  Entity read = test::makeSolid("it");
  FieldReader fields(json, place, error);
  readEntityFields(fields, place, context, read);
  ASSERT_FALSE(error.has_value()) << error->message();
  read.source = entity.source;  // Read with the shape, by its own reader.
  EXPECT_EQ(jsonFromEntity(read, folder), json);
  EXPECT_EQ(read.contact.on_contact, OnContact::kPass);
  EXPECT_NEAR(glm::distance(read.X_WE.p, entity.X_WE.p), 0.0, 1e-12);
  EXPECT_EQ(read.motion->points.size(), 2u);
}

TEST_F(Format, AnEntityWithAWrongFieldIsRefusedWithItsPlace) {
  for (const char* text : {R"({"on_contact": "bounce"})", R"({"mass": "heavy"})", R"({"color": [1, 2]})",
                           R"({"frames": [{"placement": {}}]})", R"({"attached": {"link": "x"}})"}) {
    const Json json = Json::parse(text);
    error.reset();
    Entity read = test::makeSolid("it");
    FieldReader fields(json, place, error);
    readEntityFields(fields, place, context, read);
    ASSERT_TRUE(error.has_value()) << text;
    EXPECT_THAT(error->message(), HasSubstr("entity 'it'")) << text;
  }
}

TEST_F(Format, ARobotsFieldsAreReadAsTheyWereWritten) {
  Entity arm = test::makeArm("arm");
  arm.setJoints({0.25});
  arm.editJointed().tip_link = "upper";
  arm.editJointed().X_LT = Pose::translation({0.0, 0.0, 0.1});
  arm.editJointed().tools = {{"gun", "upper", Pose::translation({0.0, 0.0, 0.2})}};
  arm.editJointed().named_poses = {{"park", {0.5}}};
  Json json;
  addRobotFields(arm, json);
  Entity read = test::makeArm("arm");
  FieldReader fields(json, place, error);
  readRobotFields(fields, place, context, read);
  ASSERT_FALSE(error.has_value()) << error->message();
  EXPECT_THAT(read.joints(), ElementsAre(0.25));
  ASSERT_THAT(read.jointed().tools, SizeIs(1));
  EXPECT_EQ(read.jointed().tools[0].X_LT.p, dvec3(0.0, 0.0, 0.2));
  Json again;
  addRobotFields(read, again);
  EXPECT_EQ(again, json);
  Json none;
  addRobotFields(test::makeSolid("box"), none);
  EXPECT_TRUE(none.empty()) << "a solid has none of them";
}

Guide everyField() {
  Guide guide;
  guide.name = "guide";
  guide.kind = GuideKind::kTube;
  guide.entity = "part";
  guide.enabled = false;
  guide.X_WG = Pose::translation({1, 2, 3});
  guide.radius = 0.02;
  guide.pitch = 0.003;
  guide.offset = 0.004;
  guide.surface = "table";
  guide.lower = -0.5;
  guide.upper = 0.75;
  guide.friction = 1.5;
  guide.detents = {0.0, 0.1};
  guide.detent_width = 0.02;
  guide.detent_stiffness = 300.0;
  guide.path = {{0, 0, 0}, {0, 0, 1}};
  guide.help = 50.0;
  guide.lead = 0.1;
  guide.locked = {true, false, true, false, false, true};
  return guide;
}

TEST_F(Format, AGuideIsReadAsItWasWritten) {
  for (std::size_t kind = 0; kind < guideWords().size(); ++kind) {
    Guide guide = everyField();
    guide.kind = static_cast<GuideKind>(kind);
    const Json json = jsonFromGuide(guide);
    EXPECT_EQ(json["kind"], guideWords()[kind]);
    const Guide read = guideFromJson(json, 0, error, notes);
    ASSERT_FALSE(error.has_value()) << error->message();
    EXPECT_EQ(jsonFromGuide(read), json);
    EXPECT_EQ(read.kind, guide.kind);
    EXPECT_EQ(read.locked, guide.locked);
    EXPECT_EQ(read.path, guide.path);
    EXPECT_EQ(*read.upper, 0.75);
  }
  EXPECT_THAT(notes.warnings, IsEmpty());
  EXPECT_FALSE(guideFromJson(Json::parse(R"({"name": "g", "kind": "line", "entity": "e"})"), 0, error, notes).lower)
      << "no stop unless the file has one";
}

TEST_F(Format, AGuideThatCannotBeReadIsCountedFromOne) {
  for (const char* change : {R"({"kind": "rope"})", R"({"kind": null})", R"({"path": [[1, 2]]})",
                             R"({"locked": [1, 0]})", R"({"radius": "wide"})", R"({"detents": ["a"]})"}) {
    Json json = jsonFromGuide(everyField());
    json.merge_patch(Json::parse(change));
    error.reset();
    guideFromJson(json, 2, error, notes);
    ASSERT_TRUE(error.has_value()) << change;
    EXPECT_THAT(error->message(), HasSubstr("guide 3")) << change;
  }
  Json odd = jsonFromGuide(everyField());
  odd["raduis"] = 1.0;
  error.reset();
  guideFromJson(odd, 0, error, notes);
  EXPECT_FALSE(error.has_value());
  ASSERT_THAT(notes.warnings, SizeIs(1));
  EXPECT_THAT(english(notes.warnings[0]), HasSubstr("raduis"));
}

TEST_F(Format, AMotionIsReadAsItWasWrittenAndChecked) {
  for (const MotionRepeat repeat : {MotionRepeat::kOnce, MotionRepeat::kLoop, MotionRepeat::kBack}) {
    const ScriptedMotion motion{{{0.0, {}}, {1.5, {0.1, 0.2, 0.3}}}, repeat};
    const ScriptedMotion read = motionFromJson(jsonFromMotion(motion), place, error, notes);
    ASSERT_FALSE(error.has_value()) << error->message();
    EXPECT_EQ(read.repeat, repeat);
    ASSERT_THAT(read.points, SizeIs(2));
    EXPECT_EQ(read.points[1].t, 1.5);
    EXPECT_EQ(read.points[1].p_W, dvec3(0.1, 0.2, 0.3));
  }
  for (const char* bad :
       {R"({})", R"({"path": [[0, 0, 0]]})", R"({"path": [[0, 0, 0, 0]]})", R"({"path": [[0, 0, 0, 0], [1, 9, 0, 0]]})",
        R"({"path": [[0, 0, 0, 0], [0, 1, 0, 0]]})", R"({"path": [[0, 0, 0, 0], [1, 1, 0, 0]], "repeat": "often"})"}) {
    error.reset();
    motionFromJson(Json::parse(bad), place, error, notes);
    ASSERT_TRUE(error.has_value()) << bad;
    EXPECT_THAT(error->message(), HasSubstr("entity 'it'")) << bad;
  }
}

TEST_F(Format, FilesAreNamedFromTheDocumentsFolder) {
  EXPECT_EQ(relativeName("/cell/parts/a.stl", "/cell"), "parts/a.stl");
  EXPECT_EQ(relativeName("/parts/a.stl", "/cell"), "../parts/a.stl");
  EXPECT_EQ(relativeName("/cell/box:1,1,1", "/cell"), "./box:1,1,1") << "a file, not the built-in part";
  EXPECT_EQ(jsonFromSource({"box:1,1,1", 1.0}, "/cell")["file"], "box:1,1,1");
  EXPECT_EQ(jsonFromColor({0.72f, 0.0f, 1.0f}).dump(), "[0.72,0.0,1.0]");
}

TEST_F(Format, ASourceIsReadAsItWasWritten) {
  SourceFile source{"/cell/a.stp", 0.001};
  source.part = "top/bolt#2";
  source.up_axis = UpAxis::kY;
  source.tessellation = {2e-4, 0.1};
  source.oriented = true;
  source.simplified = 1e-3;
  source.arguments = {{"prefix", "left_"}};
  SourceFile read;
  SourceReader(context).read(jsonFromSource(source, folder), place, read);
  ASSERT_FALSE(error.has_value()) << error->message();
  EXPECT_EQ(read.path, "a.stp");
  read.path = source.path;
  EXPECT_EQ(jsonFromSource(read, folder), jsonFromSource(source, folder));
  for (const char* change : {R"({"file": null})", R"({"scale": 0})", R"({"chord": 0})", R"({"angle": 4})",
                             R"({"simplified": -1})", R"({"up_axis": "w"})"}) {
    Json json = jsonFromSource(source, folder);
    json.merge_patch(Json::parse(change));
    error.reset();
    SourceReader(context).read(json, place, read);
    ASSERT_TRUE(error.has_value()) << change;
    EXPECT_THAT(error->message(), HasSubstr("source")) << change;
  }
}

TEST_F(Format, AMovedFolderIsAskedForOnce) {
  const test::TemporaryFolder there;
  const fs::path first = there.write("a.stl", ""), second = there.write("b.stl", "");
  int asked = 0;
  options.locate = [&](const fs::path& missing) -> std::optional<fs::path> {
    ++asked;
    return there.path() / missing.filename();
  };
  SourceReader reader(context);
  SourceFile a, b, box;
  reader.read(Json{{"file", "gone/a.stl"}}, place, a);
  reader.read(Json{{"file", "gone/b.stl"}}, place, b);
  reader.read(Json{{"file", "box:1,1,1"}}, place, box);
  ASSERT_FALSE(error.has_value()) << error->message();
  EXPECT_EQ(a.path, first.string());
  EXPECT_EQ(b.path, second.string());
  EXPECT_EQ(box.path, "box:1,1,1");
  EXPECT_EQ(asked, 1);
}

TEST_F(Format, AMechanismIsMadeAgainFromItsText) {
  Document document = test::cellOfEverything();
  MechanismJoint hinge;
  hinge.name = "hinge";
  hinge.parent = "frame";
  hinge.child = "leaf";
  hinge.upper = 1.0;
  const auto made = document.execute(
      MakeMechanism{"door", {document.findByName("frame")->id, document.findByName("leaf")->id}, {hinge}});
  ASSERT_TRUE(made.has_value()) << made.error().message();
  const Entity& door = *document.find(*made);
  const Json json = jsonFromMechanism(*door.mechanism(), folder);
  SourceReader sources(context);
  const auto read = mechanismFromJson(json, "door", place, context, sources);
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(read->kind(), EntityKind::kMechanism);
  EXPECT_EQ(jsonFromMechanism(*read->mechanism(), folder), json);
  EXPECT_EQ(read->robot()->dof(), door.robot()->dof());
  Json broken = json;
  broken["joints"][0]["child"] = "nobody";
  const auto refused = mechanismFromJson(broken, "door", place, context, sources);
  EXPECT_TRUE(!refused.has_value() || error.has_value());
}

TEST(Recordings, AreGatheredBesideTheDocumentUnlessTheyAreThere) {
  const test::TemporaryFolder elsewhere, here;
  const fs::path document = here.path() / "cell.hcell";
  EXPECT_EQ(recordingsFolder(document), here.path() / "cell-trajectories");
  const fs::path letter = elsewhere.write("letter.htraj", "Dear Anna, ...");
  DocumentState state;
  state.trajectories = {{"letter", letter.string(), {}},
                        {"missing", (elsewhere.path() / "none.htraj").string(), {}},
                        {"here", (here.path() / "cell-trajectories" / "a.htraj").string(), {}}};
  const GatheredRecordings gathered = gatherRecordings(state, document);
  EXPECT_THAT(gathered.files, IsEmpty()) << "a stranger's document may name any file";
  EXPECT_THAT(gathered.moved, IsEmpty());
}

TEST(Recordings, OfACellInTheHomeFolderDoNotStayInTheUsersData) {
  const test::TemporaryFolder home;
  const fs::path data = home.path() / ".local/share/hapticell/trajectories";
  fs::create_directories(data);
  trajectory::Trajectory motion;
  motion.entity = "box";
  ASSERT_TRUE(motion.addFrame({.t = 0.0, .X_WT = {}}) && motion.addFrame({.t = 1.0, .X_WT = {}}));
  const fs::path kept = data / "box-Take-1.htraj", beside = home.path() / "box.htraj";
  for (const fs::path& file : {kept, beside}) std::ofstream(file) << trajectory::toJsonText(motion);
  DocumentState state;
  state.trajectories = {{"take", kept.string(), {}}, {"beside", beside.string(), {}}};
  const GatheredRecordings gathered = gatherRecordings(state, home.path() / "cell.hcell");
  ASSERT_THAT(gathered.files, SizeIs(1));
  EXPECT_EQ(gathered.files[0].path, home.path() / "cell-trajectories" / "box-Take-1.htraj");
  EXPECT_EQ(gathered.moved.at(kept.string()), gathered.files[0].path.string());
}

}  // namespace
}  // namespace hapticell::workcell
