// SPDX-License-Identifier: Apache-2.0
// Files of every foreign format that are not what they claim: each is one sentence (or is read as far as it is sound),
// never a crash of ours, never a hang.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "geometry/shapes/shapes.h"
#include "geometry/system/sanitizers.h"
#include "tests/support/test_data.h"
#include "workcell/files/scene_export.h"
#include "workcell/scenes/gltf_writer.h"
#include "workcell/scenes/scene_batch.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStepHead =
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
    "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n";

constexpr const char* kCollada =
    "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
    "<asset><unit name=\"inch\" meter=\"0.0254\"/><up_axis>Z_UP</up_axis></asset>"
    "<library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"9\">"
    "0 0 0 10 0 0 0 10 0</float_array><technique_common><accessor source=\"#a\" count=\"3\" stride=\"3\">"
    "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/>"
    "</accessor></technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
    "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 INDEX</p></triangles>"
    "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\"><node id=\"n\" name=\"part\">"
    "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>"
    "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";

std::string colladaWithIndex(const std::string& index) {
  std::string text = kCollada;
  text.replace(text.find("INDEX"), 5, index);
  return text;
}

ImportedScene oneBox() {
  ImportedScene scene;
  scene.meshes.push_back(geometry::makeBox({0.1, 0.2, 0.3}));
  SceneNode node;
  node.name = "box";
  node.mesh = 0;
  scene.nodes = {node};
  return scene;
}

class Malformed : public ::testing::Test {
 protected:
  Expected<ImportedScene> read(const std::string& name, const std::string& content) {
    ImportOptions options;
    options.limits.seconds = 60.0;  // Only a hang takes that long, and it would be told.
    return readScene(folder_.write(name, content), options, nullptr);
  }
  void expectOneSentence(const std::string& name, const std::string& content) {
    expectOneSentenceEach({{name, content}});
  }
  /// One start of the importer for all of them; where it fails on one, each is read by itself.
  void expectOneSentenceEach(const std::vector<std::pair<std::string, std::string>>& contents) {
    ImportOptions options;
    options.limits.seconds = 60.0;  // As read().
    SceneBatch scenes(options);
    std::vector<fs::path> files;
    for (const auto& [name, content] : contents) files.push_back(folder_.write(name, content));
    if (files.size() > 1) scenes.readAhead(files);
    for (const fs::path& file : files) expectSentence(file.filename().string(), scenes.scene(file));
  }
  static void expectSentence(const std::string& name, const Expected<ImportedScene>& scene) {
    ASSERT_FALSE(scene) << name << " was read";
    const std::string message = scene.error().message();
    EXPECT_NE(message.find(name), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.find("reading took longer than"), std::string::npos) << message;
  }
  test::TemporaryFolder folder_;
};

TEST_F(Malformed, ABinaryGltfThatIsNotWholeSaysHowLongItShouldBe) {
  const std::string whole = gltfBytes(oneBox(), true);
  const auto cut = read("cut.glb", whole.substr(0, whole.size() / 2));
  ASSERT_FALSE(cut);
  EXPECT_THAT(cut.error().message(),
              ::testing::AllOf(::testing::HasSubstr("cut.glb, header: the file ends after " +
                                                    std::to_string(whole.size() / 2) + " bytes"),
                               ::testing::HasSubstr("expected " + std::to_string(whole.size()) + " bytes"),
                               ::testing::HasSubstr("incomplete")));
  const auto shorter = read("head.glb", whole.substr(0, 10));
  ASSERT_FALSE(shorter);
  EXPECT_THAT(shorter.error().message(), ::testing::HasSubstr("header: the file ends after 10 bytes"));
  const auto text = read("text.fbx", "hello");
  ASSERT_FALSE(text);
  EXPECT_THAT(text.error().message(), ::testing::HasSubstr("expected the content of an FBX file"));
}

TEST_F(Malformed, EmptyFilesAndRubbish) {
  std::mt19937 random(3);
  std::string rubbish;
  for (int k = 0; k < 5000; ++k) rubbish += static_cast<char>(random());
  std::vector<std::pair<std::string, std::string>> contents;
  for (const char* ending : {".step", ".igs", ".glb", ".gltf", ".dae", ".3mf", ".fbx", ".3ds"}) {
    contents.emplace_back(std::string("empty") + ending, "");
    contents.emplace_back(std::string("rubbish") + ending, rubbish);
  }
  expectOneSentenceEach(contents);
}

TEST_F(Malformed, StepThatIsNone) {
  const std::string head = kStepHead;
  expectOneSentenceEach({{"head.step", "ISO-10303-21;\n"},
                         {"nothing.step", head + "ENDSEC;\nEND-ISO-10303-21;\n"},
                         {"open.step", head + "#1=CARTESIAN_POINT('',(0.,"},
                         {"itself.step", head + "#1=SHAPE_REPRESENTATION('',(#1),#1);\nENDSEC;\nEND-ISO-10303-21;\n"}});
  expectOneSentence("nowhere.step",
                    head +
                        "#1=MANIFOLD_SOLID_BREP('',#99);\n#2=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#1,#98),#97);\n"
                        "ENDSEC;\nEND-ISO-10303-21;\n");
}

TEST_F(Malformed, GltfThatLies) {
  expectOneSentenceEach(
      {{"a.gltf", "{\"asset\":{\"version\":\"2.0\"}}"},
       {"b.gltf", "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":7}]}"},
       {"c.gltf",
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":4000000000000,\"uri\":"
        "\"data:application/octet-stream;base64,AAAA\"}],\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
        "\"nodes\":[{\"children\":[0]}]}"},
       {"d.gltf", std::string(100'000, '[')}});
}

TEST_F(Malformed, ColladaWithAnIndexThatIsNotThere) {
  const auto good = read("good.dae", colladaWithIndex("2"));
  ASSERT_TRUE(good) << good.error().message();
  EXPECT_DOUBLE_EQ(good->metres_per_unit, 0.0254);
  EXPECT_NEAR(good->meshes[0].bounds().max.x, 0.254, 1e-7);
  expectOneSentence("far.dae", colladaWithIndex("9999999"));
}

TEST_F(Malformed, AnySoundFileCutAnywhereEndsInASentenceOrAScene) {
  const ImportedScene scene = oneBox();
  Diagnostics notes;
  const fs::path step = folder_.path() / "box.step";
  ASSERT_TRUE(exportScene(scene, step, {}, notes));
  const std::string text = *readFileContent(step), binary = gltfBytes(scene, true);
  for (const double part : {0.3, 0.6, 0.95}) {
    for (const auto& [name, bytes] : {std::pair{"cut.step", text}, std::pair{"cut.glb", binary}}) {
      const auto read_back = read(name, bytes.substr(0, static_cast<std::size_t>(part * double(bytes.size()))));
      if (!read_back) {
        EXPECT_EQ(read_back.error().message().find('\n'), std::string::npos);
      }
    }
  }
}

TEST_F(Malformed, MemoryIsLimited) {
  ImportOptions options;
  options.limits.bytes = std::uint64_t{64} << 20;  // Less than the libraries themselves need.
  const auto scene = readScene(folder_.write("a.dae", colladaWithIndex("2")), options, nullptr);
#if !HAPTICELL_SANITIZED
  if (!scene) {
    EXPECT_EQ(scene.error().message().find('\n'), std::string::npos);
  }
#else
  static_cast<void>(scene);
#endif
}

}  // namespace
}  // namespace hapticell::workcell
