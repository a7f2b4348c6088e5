// SPDX-License-Identifier: Apache-2.0
// The small parts that scene files are read and written with.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "geometry/shapes/shapes.h"
#include "tests/support/test_data.h"
#include "workcell/scenes/gltf_writer.h"
#include "workcell/scenes/import_monitor.h"
#include "workcell/scenes/import_scene.h"
#include "workcell/scenes/packed_bytes.h"
#include "workcell/scenes/placeholder_name.h"
#include "workcell/scenes/scene_call.h"
#include "workcell/scenes/scene_exchange.h"
#include "workcell/scenes/sdf_content.h"
#include "workcell/scenes/sdf_exchange.h"
#include "workcell/scenes/sdf_files.h"
#include "workcell/scenes/sdf_joints.h"
#include "workcell/scenes/sdf_population.h"
#include "workcell/scenes/sdf_robot.h"
#include "workcell/scenes/sdf_source.h"
#include "workcell/scenes/sdf_tidier.h"
#include "workcell/scenes/sdf_values.h"
#include "workcell/scenes/sdf_xml.h"
#include "workcell/scenes/whole_mesh.h"

namespace hapticell::workcell {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
namespace fs = std::filesystem;

TEST(ImportMonitor, TheShareNeverFallsAndStaysWithinItsRange) {
  ImportMonitor monitor;
  monitor.report("reading", 0.5);
  monitor.report("meshing", 0.2);
  EXPECT_EQ(monitor.progress().share, 0.5);
  EXPECT_EQ(english(monitor.progress().stage), "meshing");
  monitor.setRange(0.6, 0.8);  // The second of several files.
  monitor.report("reading", 0.5);
  EXPECT_NEAR(monitor.progress().share, 0.7, 1e-12);
  monitor.setRange(0.0, 1.0);
  monitor.report("checking", 7.0);
  EXPECT_EQ(monitor.progress().share, 1.0);
  monitor.report("checking", std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(monitor.progress().share, 1.0);
  EXPECT_FALSE(monitor.isCancelled());
  monitor.cancel();
  EXPECT_TRUE(monitor.isCancelled());
}

TEST(PackedBytes, GiveBackWhatWasPutInAndRefuseAnyShorterText) {
  PackedWriter writer;
  writer.number(std::uint8_t{7});
  writer.number(-0.25);
  writer.text("Gehäuse");
  writer.pose(Pose{{1, 2, 3}, glm::normalize(dquat(0.5, 0.1, -0.7, 0.2))});
  for (std::size_t size = 0; size <= writer.bytes.size(); ++size) {
    PackedReader reader(std::string_view(writer.bytes).substr(0, size));
    const auto seven = reader.number<std::uint8_t>();
    const double quarter = reader.number<double>();
    const std::string text = reader.text();
    const Pose pose = reader.pose();
    EXPECT_EQ(reader.failed, size < writer.bytes.size()) << size;
    EXPECT_EQ(reader.left(), 0u);
    if (reader.failed) continue;
    EXPECT_EQ(seven, 7);
    EXPECT_EQ(quarter, -0.25);
    EXPECT_EQ(text, "Gehäuse");
    EXPECT_EQ(pose.p, dvec3(1, 2, 3));
  }
}

TEST(PackedBytes, RefuseNumbersThatAreNotFiniteAndCountsThatCannotBe) {
  PackedWriter writer;
  writer.number(std::numeric_limits<double>::infinity());
  PackedReader strict(writer.bytes), lenient(writer.bytes);
  strict.number<double>();
  EXPECT_TRUE(strict.failed);
  EXPECT_TRUE(std::isinf(lenient.anyNumber<double>()));
  EXPECT_FALSE(lenient.failed);
  PackedWriter many;
  many.number(std::numeric_limits<std::uint64_t>::max());
  many.number(1.0);
  PackedReader reader(many.bytes);
  EXPECT_EQ(reader.count(8), 0u);
  EXPECT_TRUE(reader.failed);
  EXPECT_EQ(reader.anyNumber<double>(), 0.0) << "nothing is read after a failure";
}

/// The number after a word; -1 where the word is missing.
double wordAfter(const std::vector<std::string>& words, const std::string& name) {
  const auto at = std::find(words.begin(), words.end(), name);
  return at == words.end() || at + 1 == words.end() ? -1.0 : std::stod(*(at + 1));
}

TEST(SceneCall, PassesOnTheOptionsThatWereChosenToTheBit) {
  ImportOptions options;
  options.tessellation = {1e-4 / 3.0, 0.3};
  EXPECT_THAT(importerWords(options), SizeIs(4));
  EXPECT_EQ(wordAfter(importerWords(options), "--chord"), 1e-4 / 3.0);
  EXPECT_EQ(wordAfter(importerWords(options), "--angle"), 0.3);
  options.relative_chord = 0.25;
  options.metres_per_unit = 0.0254;
  EXPECT_THAT(importerWords(options), SizeIs(8));
  EXPECT_EQ(wordAfter(importerWords(options), "--relative-chord"), 0.25);
  EXPECT_EQ(wordAfter(importerWords(options), "--unit"), 0.0254);
}

TEST(SceneCall, FinerThanUsualIsToldFromCoarser) {
  ImportOptions options;
  EXPECT_FALSE(isFiner(options));
  options.tessellation.chord = 5e-5;
  EXPECT_TRUE(isFiner(options));
  options.tessellation = {1e-3, 0.1};
  EXPECT_TRUE(isFiner(options)) << "by the angle";
  options.relative_chord = 1e-3;
  EXPECT_FALSE(isFiner(options)) << "the share goes over the chord";
}

TEST(SceneCall, PackedFilesCountTenfold) {
  const hapticell::test::TemporaryFolder folder;
  EXPECT_EQ(bytesToRead(folder.write("a.step", "12345")), 5u);
  EXPECT_EQ(bytesToRead(folder.write("a.stpz", "12345")), 50u);
  EXPECT_EQ(bytesToRead(folder.write("b.step", "PK345")), 50u) << "by its content";
  EXPECT_EQ(bytesToRead(folder.path() / "none.step"), 0u);
}

TEST(SceneCall, TurnsASceneUprightByTheChosenAxis) {
  ImportedScene scene;
  scene.format = "dae";
  scene.up_axis = UpAxis::kY;
  scene.meshes = {geometry::makeBox({1, 1, 1})};
  SceneNode root;
  root.mesh = 0;
  root.X_PN = Pose::translation({0, 3, 0});
  scene.nodes = {root};
  const auto upright = uprightScene(sceneBytes(scene), "a.dae", {});
  ASSERT_TRUE(upright.has_value()) << upright.error().message();
  EXPECT_NEAR(glm::distance(upright->nodes[0].X_PN.p, dvec3(0, 0, 3)), 0.0, 1e-12);
  const auto as_it_is = uprightScene(sceneBytes(scene), "a.dae", {.up_axis = UpAxis::kZ});
  EXPECT_NEAR(glm::distance(as_it_is->nodes[0].X_PN.p, dvec3(0, 3, 0)), 0.0, 1e-12);
  const auto refused = uprightScene("nonsense", "a.dae", {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().message(), HasSubstr("a.dae"));
}

SdfModel arm(const std::string& name) {
  SdfModel model;
  model.name = name;
  model.X_M.fault = "no such frame";
  SdfLink link;
  link.name = "base";
  SdfShape box;
  box.kind = SdfShape::Kind::kBox;
  box.size = {1, 2, 3};
  box.diffuse = std::array<float, 3>{0.5f, 0.25f, 1.0f};
  link.visuals = {box};
  model.links = {link};
  SdfJoint joint;
  joint.name = "turn";
  joint.type = SdfJoint::Type::kRevolute;
  joint.parent = "world";
  joint.child = "base";
  SdfJointAxis axis;
  axis.xyz_M = {0, 0, 1};
  axis.upper = std::numeric_limits<double>::infinity();
  axis.mimic = SdfMimic{"other", true, 2.0, 0.5, 0.25};
  joint.axes = {axis, std::nullopt};
  model.joints = {joint};
  return model;
}

TEST(SdfExchange, BringsBackWhatWasSentAndRefusesAnyShorterText) {
  SdfContent sent;
  sent.has_world = true;
  sent.complaints = {"one", "two"};
  sent.first_complaint = "one";
  sent.models = {arm("outer")};
  sent.models[0].models = {arm("inner")};
  const std::string bytes = sdfBytes(sent);
  const auto got = sdfFromBytes(bytes);
  ASSERT_TRUE(got.has_value()) << got.error().message();
  EXPECT_EQ(sdfBytes(*got), bytes);
  const SdfModel& inner = got->models.at(0).models.at(0);
  EXPECT_EQ(inner.name, "inner");
  EXPECT_EQ(inner.X_M.fault, "no such frame");
  EXPECT_TRUE(std::isinf(inner.joints.at(0).axes.at(0)->upper)) << "numbers may be infinite";
  EXPECT_EQ(inner.joints[0].axes[0]->mimic->multiplier, 2.0);
  EXPECT_FALSE(inner.joints[0].axes.at(1).has_value());
  EXPECT_EQ(inner.links.at(0).visuals.at(0).size, dvec3(1, 2, 3));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_FALSE(sdfFromBytes(std::string_view(bytes).substr(0, size)).has_value()) << size;
}

TEST(SdfExchange, RefusesModelsNestedTooDeep) {
  SdfContent deep;
  deep.models = {arm("m")};
  for (int k = 0; k < 300; ++k) {
    SdfModel outer;
    outer.name = "m";
    outer.models = {std::move(deep.models[0])};
    deep.models[0] = std::move(outer);
  }
  EXPECT_FALSE(sdfFromBytes(sdfBytes(deep)).has_value());
}

TEST(SdfRobot, JointsOfModelsInsideDoNotCount) {
  SdfModel outer;
  outer.models = {arm("inner")};
  EXPECT_FALSE(hasMovingJoints(outer));
  EXPECT_TRUE(hasMovingJoints(outer.models[0]));
  SdfModel rigid = arm("rigid");
  rigid.joints[0].type = SdfJoint::Type::kFixed;
  EXPECT_FALSE(hasMovingJoints(rigid));
}

TEST(SdfXml, ReadsTextsAndNumbers) {
  TiXmlDocument document;
  document.Parse("<model name='m'><a>  two words </a><joint name='j' type='fixed'/></model>");
  TiXmlElement& model = *document.RootElement();
  EXPECT_EQ(textOf(&model, "a"), "two words");
  EXPECT_EQ(textOf(&model, "b"), "");
  EXPECT_EQ(textOf(nullptr, "a"), "");
  EXPECT_EQ(attributeOf(model, "name"), "m");
  EXPECT_EQ(attributeOf(model, "none"), "");
  EXPECT_FALSE(hasMovingJoint(model));
  model.FirstChildElement("joint")->SetAttribute("type", "revolute");
  EXPECT_TRUE(hasMovingJoint(model));
  setText(*model.FirstChildElement("a"), "1 -2.5e1");
  EXPECT_EQ(textOf(*model.FirstChildElement("a")), "1 -2.5e1");
  EXPECT_THAT(numbersIn(" 1 -2.5e1\n3 four 5"), ElementsAre(1.0, -25.0, 3.0));
  EXPECT_THAT(numbersIn(""), IsEmpty());
  EXPECT_TRUE(std::isinf(numbersIn("inf").at(0)));
}

TEST(SdfXml, RefusesOtherFiles) {
  const hapticell::test::TemporaryFolder folder;
  const auto isRead = [](const fs::path& file) {
    TiXmlDocument document;
    return parseSdf(file, document).has_value();
  };
  EXPECT_TRUE(isRead(folder.write("a.sdf", "<sdf version='1.6'><model name='m'/></sdf>")));
  EXPECT_FALSE(isRead(folder.write("b.sdf", "<robot name='r'/>")));
  EXPECT_FALSE(isRead(folder.write("c.sdf", "<sdf version='1.6'><model")));
  EXPECT_FALSE(isRead(folder.path() / "none.sdf"));
  std::string deep = "<sdf>";
  for (int k = 0; k < 300; ++k) deep += "<a>";
  EXPECT_FALSE(isRead(folder.write("d.sdf", deep)));
}

TEST(SdfXml, ASecondFileTakesThePlaceOfTheFirst) {
  const hapticell::test::TemporaryFolder folder;
  TiXmlDocument document;
  ASSERT_TRUE(parseSdf(folder.write("a.sdf", "<sdf version='1.6'><model name='first'/></sdf>"), document));
  const auto root = parseSdf(folder.write("b.sdf", "<sdf version='1.6'><model name='second'/></sdf>"), document);
  ASSERT_TRUE(root);
  EXPECT_EQ(attributeOf(*(*root)->FirstChildElement("model"), "name"), "second");
  EXPECT_FALSE(parseSdf(folder.write("c.sdf", "<sdf version='1.6'><model"), document));
  EXPECT_TRUE(parseSdf(folder.write("d.sdf", "<sdf version='1.6'/>"), document)) << "an error is not kept";
}

TEST(PlaceholderName, IsWhatProgramsWriteInPlaceOfAName) {
  for (const char* name : {"", "  ", "-", "Document", "UNNAMED", "Unnamed1", "untitled 2", "the product name", "None."})
    EXPECT_TRUE(saysNothing(name)) << name;
  for (const char* name : {"bracket", "4711", "Default bracket", "Documents", "\xC3\x84", "unknown part"})
    EXPECT_FALSE(saysNothing(name)) << name;
}

TEST(SdfValues, AreMadeAsTheLibraryAcceptsThem) {
  std::vector<std::string> told;
  const TellSdf tell = [&](const Text& what) { told.push_back(english(what)); };
  const auto element = [](const std::string& text) {
    TiXmlDocument document;
    document.Parse(text.c_str());
    return TiXmlElement(*document.RootElement());
  };
  TiXmlElement pose = element("<pose>1 2 3</pose>");
  EXPECT_TRUE(keepSdfPose(pose, tell));
  EXPECT_EQ(textOf(pose), "1 2 3 0 0 0");
  TiXmlElement turned = element("<pose rotation_format='quat_xyzw'>0 0 0 0 0 0 0</pose>");
  EXPECT_TRUE(keepSdfPose(turned, tell));
  EXPECT_EQ(textOf(turned), "0 0 0 0 0 0 1");
  ASSERT_THAT(told, SizeIs(2));
  EXPECT_THAT(told[0], HasSubstr("3 numbers instead of 6"));
  EXPECT_THAT(told[1], HasSubstr("length 0"));

  TiXmlElement size = element("<size>1 2 3 4</size>"), lower = element("<lower>-inf</lower>");
  EXPECT_FALSE(keepSdfNumbers(size, tell));
  EXPECT_THAT(told.back(), HasSubstr("instead of 3 numbers"));
  EXPECT_TRUE(keepSdfNumbers(lower, tell));
  EXPECT_EQ(numbersIn(textOf(lower)).at(0), -1e16);
  EXPECT_EQ(sdfNumbersOf("size"), 3u);
  EXPECT_EQ(sdfNumbersOf("link"), 0u);
  EXPECT_EQ(sdfTextOf({0.1, 2.0}), "0.10000000000000001 2");

  TiXmlElement word = element("<center>TRUE</center>"), other = element("<center>perhaps</center>");
  EXPECT_TRUE(keepSdfWord(word));
  EXPECT_EQ(textOf(word), "true");
  EXPECT_FALSE(keepSdfWord(other));
  EXPECT_TRUE(keepSdfShape(element("<geometry><sphere><radius>1</radius></sphere></geometry>"), tell));
  EXPECT_FALSE(keepSdfShape(element("<geometry><cylinder><radius>1</radius></cylinder></geometry>"), tell));
  EXPECT_THAT(told.back(), HasSubstr("<cylinder> without size"));
}

TEST(SdfJoints, ABallIsThreeJointsAndAMimicFollowsWhatIsThere) {
  kinematics::JointGraph graph;
  graph.links.resize(3);
  for (int k = 0; k < 3; ++k) graph.links[static_cast<std::size_t>(k)].link.name = "l" + std::to_string(k);
  const fs::path file("robot.sdf");
  Diagnostics notes;
  SdfJointReader joints(graph, file, notes);
  const auto add = [&](const SdfJoint& source, int parent) {
    kinematics::GraphJoint joint;
    joint.joint.name = source.name;
    joint.joint.parent_link = parent;
    joint.joint.child_link = parent + 1;
    return joints.add(source, joint, "", Pose(), Text("joint '%1'", source.name));
  };
  SdfJointAxis axis;
  axis.xyz_M = {0, 0, 2};
  axis.lower = -1.0;
  axis.upper = 1e16;
  SdfJoint turning, ball, odd;
  turning.name = "turning";
  turning.type = SdfJoint::Type::kRevolute;
  turning.axes = {axis, std::nullopt};
  ball.name = "ball";
  ball.type = SdfJoint::Type::kBall;
  odd.name = "odd";
  ASSERT_TRUE(add(turning, 0));
  ASSERT_THAT(graph.joints, SizeIs(1));
  EXPECT_EQ(graph.joints[0].joint.lower, -1.0);
  EXPECT_TRUE(std::isinf(graph.joints[0].joint.upper)) << "SDF's word for no limit";
  ASSERT_TRUE(add(ball, 1));
  EXPECT_THAT(graph.joints, SizeIs(4));

  SdfJoint follower = turning;
  follower.name = "follower";
  SdfMimic mimic;
  mimic.joint = "turning";
  mimic.multiplier = 2.0;
  mimic.offset = 0.5;
  mimic.reference = 0.25;
  follower.axes[0]->mimic = mimic;
  ASSERT_TRUE(add(follower, 1));
  SdfJoint astray = turning;
  astray.name = "astray";
  mimic.joint = "nowhere";
  astray.axes[0]->mimic = mimic;
  ASSERT_TRUE(add(astray, 1));
  joints.setMimics();
  ASSERT_TRUE(graph.joints[4].joint.mimic.has_value());
  EXPECT_EQ(graph.joints[4].joint.mimic->joint, 0);
  EXPECT_EQ(graph.joints[4].joint.mimic->offset, 0.5 - 2.0 * 0.25);
  ASSERT_THAT(notes.warnings, SizeIs(1));
  EXPECT_THAT(english(notes.warnings[0]), HasSubstr("'nowhere', which does not exist"));

  const auto refused = add(odd, 0);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), HasSubstr("unknown joint type"));
  EXPECT_EQ(sdfRefusal(file, "here", "this", "that").file, "robot.sdf");
}

Population settled(const std::string& text) {
  TiXmlDocument document;
  document.Parse(text.c_str());
  return populationOf(*document.RootElement());
}

TEST(SdfPopulation, OfAGridStandsAroundThePoseAndTurnsWithIt) {
  const Population grid = settled(
      "<population><pose>10 0 1 0 0 0</pose><distribution><type>grid</type><rows>2</rows><cols>3</cols>"
      "<step>1 2 0</step></distribution></population>");
  ASSERT_THAT(grid.positions, SizeIs(6));
  EXPECT_EQ(grid.positions[0], dvec3(9, -1, 1));
  EXPECT_EQ(grid.positions[5], dvec3(11, 1, 1));
  EXPECT_TRUE(grid.remark.empty());
  EXPECT_THAT(settled("<population><distribution><type>grid</type><rows>9999</rows><cols>9999</cols></distribution>"
                      "</population>")
                  .positions,
              IsEmpty());
}

TEST(SdfPopulation, IsSpreadEvenlyOverItsBoxOrCylinder) {
  const Population in_box = settled(
      "<population><model_count>1000</model_count><box><size>2 4 6</size></box><distribution><type>random</type>"
      "</distribution></population>");
  ASSERT_THAT(in_box.positions, SizeIs(1000));
  dvec3 sum(0.0);
  for (const dvec3& p : in_box.positions) {
    EXPECT_LE(std::abs(p.x), 1.0);
    EXPECT_LE(std::abs(p.y), 2.0);
    EXPECT_LE(std::abs(p.z), 3.0);
    sum += p;
  }
  EXPECT_LT(glm::length(sum / 1000.0), 0.05) << "around its middle";
  EXPECT_FALSE(in_box.remark.empty());
  const Population round = settled(
      "<population><model_count>1000</model_count><cylinder><radius>2</radius><length>1</length></cylinder>"
      "</population>");
  ASSERT_THAT(round.positions, SizeIs(1000));
  int inner = 0;
  for (const dvec3& p : round.positions) {
    EXPECT_LE(std::hypot(p.x, p.y), 2.0 + 1e-12);
    EXPECT_LE(std::abs(p.z), 0.5);
    inner += std::hypot(p.x, p.y) < 1.0 ? 1 : 0;
  }
  EXPECT_NEAR(inner, 250, 10) << "a quarter of the area";
  const Population line = settled(
      "<population><model_count>4</model_count><box><size>8 1 1</size></box><distribution><type>linear-x</type>"
      "</distribution></population>");
  ASSERT_THAT(line.positions, SizeIs(4));
  EXPECT_EQ(line.positions[0].x, -4.0);
  EXPECT_EQ(line.positions[3].x, 2.0);
  for (const char* none : {"<population><model_count>3</model_count></population>",
                           "<population><model_count>0</model_count><box><size>1 1 1</size></box></population>"}) {
    EXPECT_THAT(settled(none).positions, IsEmpty()) << none;
    EXPECT_FALSE(settled(none).remark.empty()) << none;
  }
}

TEST(SdfFiles, FindModelsBesideAndAboveTheFile) {
  const hapticell::test::TemporaryFolder folder;
  fs::create_directories(folder.path() / "worlds");
  fs::create_directories(folder.path() / "models" / "my table");
  const fs::path world = folder.write("worlds/a.world", "");
  const fs::path oldest = folder.write("models/my table/old.sdf", "<sdf/>");
  const fs::path newest = folder.write("models/my table/new.sdf", "");
  const fs::path plain = folder.write("models/my table/model.sdf", "<sdf/>");
  EXPECT_EQ(findSdfModel("model://my%20table", world), plain) << "percent-encoded, no manifest";
  folder.write("models/my table/model.config",
               "<model><sdf version='1.4'>old.sdf</sdf><sdf version='1.7'> new.sdf </sdf>"
               "<sdf version='1.12'>model.sdf</sdf></model>");
  EXPECT_EQ(findSdfModel("model://my table", world), newest);
  folder.write("models/my table/model.config", "<model><sdf version='1.4'>../../worlds/a.world</sdf></model>");
  EXPECT_EQ(findSdfModel("model://my table", world), plain) << "not out of its folder";
  ASSERT_TRUE(findSdfFile("model://my table/old.sdf", world).has_value());
  EXPECT_EQ(findSdfFile("model://my table/old.sdf", world)->path, oldest);
  EXPECT_FALSE(findSdfFile("model://none/a.stl", world).has_value());
  EXPECT_FALSE(findSdfFile("", world).has_value());
  EXPECT_TRUE(findSdfModel("model://none", world).empty());
}

TEST(SdfTidier, NumbersDuplicatesAndLeavesOutWhatIsMissing) {
  const hapticell::test::TemporaryFolder folder, work;
  const fs::path file = folder.write(
      "a.sdf",
      "<sdf version='1.6'><model name='m'><link name='l'/><link name='l'/><link name='n'>"
      "<visual name='v'><geometry><mesh><uri>none.stl</uri></mesh></geometry></visual></link></model></sdf>");
  SdfTidier tidier(work.path());
  const auto text = tidier.tidy(file);
  ASSERT_TRUE(text.has_value()) << text.error().message();
  TiXmlDocument tidy;
  tidy.Parse(text->c_str());
  ASSERT_FALSE(tidy.Error()) << *text;
  std::vector<std::string> names;
  const TiXmlElement* model = tidy.RootElement()->FirstChildElement("model");
  ASSERT_NE(model, nullptr) << *text;
  for (auto* link = model->FirstChildElement("link"); link; link = link->NextSiblingElement("link"))
    names.push_back(attributeOf(*link, "name"));
  ASSERT_THAT(names, SizeIs(3));
  EXPECT_NE(names[0], names[1]);
  EXPECT_THAT(*text, Not(HasSubstr("none.stl")));
  EXPECT_THAT(tidier.meshes(), IsEmpty());
  EXPECT_THAT(english(tidier.warnings()), HasSubstr("none.stl"));
  EXPECT_FALSE(SdfTidier(work.path()).tidy(folder.path() / "none.sdf").has_value());
}

TEST(GltfWriter, WritesTheTreeSharedMeshesAndLinearColors) {
  ImportedScene scene;
  scene.meshes = {geometry::makeBox({1, 2, 3})};
  SceneNode root, first, second;
  root.name = "root";
  first.name = "first";
  first.parent = 0;
  first.mesh = 0;
  first.color = {0.5f, 0.0f, 1.0f};
  second = first;
  second.name = "second";
  second.X_PN = Pose::translation({1, 2, 3});
  scene.nodes = {root, first, second};
  const auto json = nlohmann::json::parse(gltfBytes(scene, false));
  EXPECT_EQ(json["asset"]["version"], "2.0");
  std::vector<int> meshes;
  for (const auto& node : json["nodes"])
    if (node.contains("mesh")) meshes.push_back(node["mesh"]);
  ASSERT_THAT(meshes, SizeIs(2));
  EXPECT_EQ(meshes[0], meshes[1]) << "shared";
  const auto color = json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_NEAR(color[0].get<double>(), std::pow((0.5 + 0.055) / 1.055, 2.4), 1e-4) << "IEC 61966-2-1";
  EXPECT_NEAR(color[2].get<double>(), 1.0, 1e-6);

  const std::string binary = gltfBytes(scene, true);
  ASSERT_GT(binary.size(), 20u);
  EXPECT_EQ(binary.substr(0, 4), "glTF");
  std::uint32_t head[4];
  std::memcpy(head, binary.data() + 4, sizeof head);
  EXPECT_EQ(head[0], 2u);
  EXPECT_EQ(head[1], binary.size()) << "its header states its length";
  EXPECT_EQ(head[2] % 4, 0u);
}

TEST(WholeMesh, IsTheFileInMetres) {
  const hapticell::test::TemporaryFolder folder;
  const fs::path file =
      folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  Diagnostics notes;
  const auto metres = readWholeMesh(file, {}, notes),
             millimetres = readWholeMesh(file, {.metres_per_unit = 0.001}, notes);
  ASSERT_TRUE(metres.has_value() && millimetres.has_value());
  EXPECT_EQ(metres->triangles.size(), 4u);
  EXPECT_NEAR(metres->bounds().max.x, 1.0, 1e-12);
  EXPECT_NEAR(millimetres->bounds().max.x, 0.001, 1e-12);
  EXPECT_FALSE(readWholeMesh(folder.path() / "none.obj", {}, notes).has_value());
}

TEST(SdfOutline, CountsModelsAndThoseThatMove) {
  const hapticell::test::TemporaryFolder folder;
  const std::string
      box = "<link name='l'><visual name='v'><geometry><box><size>1 1 1</size></box></geometry></visual></link>",
      plane = "<link name='l'><visual name='v'><geometry><plane/></geometry></visual></link>",
      joint = "<joint name='j' type='revolute'><parent>l</parent><child>l</child></joint>";
  const auto outline = outlineOf(folder.write(
      "w.sdf", "<sdf version='1.6'><world name='w'><model name='a'>" + box + "</model><model name='ground'>" + plane +
                   "</model><model name='r'>" + box + joint + "</model></world></sdf>"));
  ASSERT_TRUE(outline);
  EXPECT_TRUE(outline->world);
  EXPECT_EQ(outline->models, 2) << "the ground is no model to count";
  EXPECT_EQ(outline->jointed, 1);
  EXPECT_FALSE(outline->grouped);
  EXPECT_FALSE(outlineOf(folder.write("no.sdf", "rubbish")));
  EXPECT_FALSE(outlineOf(folder.path() / "none.sdf"));
}

}  // namespace
}  // namespace hapticell::workcell
