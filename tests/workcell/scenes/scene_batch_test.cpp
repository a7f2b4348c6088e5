// SPDX-License-Identifier: Apache-2.0
// The scene files of a package are read by one run of the importer, as if each had been read by itself.
#include "workcell/scenes/scene_batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/test_data.h"
#include "workcell/robots/urdf_reader.h"
#include "workcell/scenes/sdf_cell_reader.h"

namespace hapticell::workcell {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

std::string colladaTriangle(double size) {
  const std::string s = std::to_string(size);
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0 0 0 )" +
         s + " 0 0 0 " + s + R"( 0</float_array><technique_common><accessor source="#a" count="3" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common>
</source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

class Batch : public ::testing::Test {
 protected:
  void TearDown() override { ::unsetenv("HAPTICELL_IMPORTER"); }

  fs::path mesh(const std::string& name, double size) { return folder_.write(name, colladaTriangle(size)); }
  /// Each start of the importer leaves a line; then the real one is started, or `instead` is done.
  void countStarts(const std::string& instead = "") {
    const fs::path self = fs::read_symlink("/proc/self/exe").parent_path() / "hapticell-importer";
    const fs::path program =
        folder_.write("importer.sh", "#!/bin/sh\necho $1 >> '" + (folder_.path() / "starts").string() + "'\n" +
                                         instead + "\nexec '" + self.string() + "' \"$@\"\n");
    fs::permissions(program, fs::perms::owner_all);
    ::setenv("HAPTICELL_IMPORTER", program.c_str(), 1);
  }
  std::string starts() {
    std::ostringstream text;
    text << std::ifstream(folder_.path() / "starts").rdbuf();
    return text.str();
  }
  std::string robotOf(const std::vector<fs::path>& meshes) {
    std::string text = "<robot name='r'><link name='base'/>";
    for (std::size_t k = 0; k < meshes.size(); ++k) {
      const std::string link = "l" + std::to_string(k);
      text += "<link name='" + link + "'><visual><geometry><mesh filename='";
      text += meshes[k].filename().string() + "'/></geometry></visual></link><joint name='j";
      text += link + "' type='fixed'><parent link='base'/><child link='";
      text += link + "'/></joint>";
    }
    return text + "</robot>";
  }

  test::TemporaryFolder folder_;
};

TEST_F(Batch, GivesWhatEachFileWouldGiveAlone) {
  const std::vector<fs::path> files = {mesh("a.dae", 1.0), folder_.write("broken.dae", "<COLLADA nonsense"),
                                       mesh("b.dae", 2.0)};
  ImportOptions options;
  SceneBatch batch(options);
  countStarts();
  batch.readAhead({files[0], files[1], files[2], files[0], folder_.path() / "none.dae"});
  EXPECT_EQ(starts(), "read-all\n");
  for (const fs::path& file : files) {
    const auto together = batch.scene(file);
    ::unsetenv("HAPTICELL_IMPORTER");
    const auto alone = readScene(file, options, nullptr);
    ASSERT_EQ(together.has_value(), alone.has_value()) << file;
    if (!alone) {
      EXPECT_EQ(together.error().message(), alone.error().message());
      continue;
    }
    ASSERT_EQ(together->meshes.size(), 1u);
    EXPECT_EQ(together->meshes[0].vertices, alone->meshes[0].vertices);
    EXPECT_EQ(together->nodes.size(), alone->nodes.size());
  }
}

TEST_F(Batch, ARobotIsOneStartOfTheImporter) {
  const fs::path robot =
      folder_.write("robot.urdf", robotOf({mesh("a.dae", 1.0), mesh("b.dae", 2.0), mesh("c.dae", 3.0)}));
  countStarts();
  Diagnostics notes;
  const auto model = readUrdf(robot, notes);
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(starts(), "read-all\n");
  for (int k = 0; k < 3; ++k) {
    const auto& link = model->links[static_cast<std::size_t>(k + 1)];
    ASSERT_EQ(link.visuals.size(), 1u);
    EXPECT_DOUBLE_EQ(link.visuals[0].mesh->bounds().size().x, k + 1.0);
  }
}

TEST_F(Batch, ACellIsOneStartOfTheImporterForItsTextAndOneForItsMeshes) {
  mesh("a.dae", 1.0);
  mesh("b.dae", 2.0);
  std::string models;
  for (const char* name : {"a", "b", "a"}) {
    models += "<model name='" + std::string(name) + std::to_string(models.size()) +
              "'><link name='l'><visual name='v'><geometry><mesh><uri>" + name +
              ".dae</uri></mesh></geometry></visual></link></model>";
  }
  const fs::path world = folder_.write("cell.world", "<sdf version='1.6'><world name='w'>" + models + "</world></sdf>");
  countStarts();
  const auto scene = readSdfCell(world, nullptr);
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(starts(), "resolve-sdf\nread-all\n");
  EXPECT_EQ(scene->meshes.size(), 2u);
}

TEST_F(Batch, WhereTheProcessFailsOnOneFileTheOthersAreStillThere) {
  const fs::path robot =
      folder_.write("robot.urdf", robotOf({mesh("good.dae", 1.0), mesh("crash.dae", 2.0), mesh("fine.dae", 3.0)}));
  countStarts("case \"$1 $2\" in read-all*|*crash*) kill -SEGV $$;; esac");
  Diagnostics notes;
  const auto model = readUrdf(robot, notes);
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(starts(), "read-all\nread\nread\nread\n");
  EXPECT_EQ(model->links[1].visuals.size(), 1u);
  EXPECT_TRUE(model->links[2].visuals.empty());
  EXPECT_EQ(model->links[3].visuals.size(), 1u);
  EXPECT_THAT(english(notes.warnings), HasSubstr("crash.dae"));
}

TEST_F(Batch, CancellingEndsTheWholeRobot) {
  const fs::path robot = folder_.write("robot.urdf", robotOf({mesh("a.dae", 1.0), mesh("b.dae", 2.0)}));
  countStarts("exec sleep 600");
  ImportMonitor monitor;
  monitor.cancel();
  Diagnostics notes;
  const auto model = readUrdf(robot, notes, &monitor);
  ASSERT_FALSE(model) << "half a robot would look like a whole one";
  EXPECT_THAT(model.error().message(), HasSubstr("cancelled"));
}

TEST(BatchBytes, ComeBackAsTheyWent) {
  const std::vector<BatchEntry> sent = {{true, "scene"}, {false, "line 3\tfound\texpected\tfix"}, {true, ""}};
  const auto back = batchFromBytes(batchBytes(sent), 3);
  ASSERT_TRUE(back);
  for (std::size_t k = 0; k < sent.size(); ++k) {
    EXPECT_EQ((*back)[k].is_scene, sent[k].is_scene);
    EXPECT_EQ((*back)[k].content, sent[k].content);
  }
  EXPECT_FALSE(batchFromBytes(batchBytes(sent), 2));
  EXPECT_FALSE(batchFromBytes(batchBytes(sent), 4));
}

RC_GTEST_PROP(BatchBytes, AreRefusedWhereverTheyAreCut, ()) {
  const std::string bytes = batchBytes({{true, "scene"}, {false, "an error"}});
  const auto cut = *rc::gen::inRange<std::size_t>(0, bytes.size());
  RC_ASSERT(!batchFromBytes(std::string_view(bytes).substr(0, cut), 2).has_value());
}

}  // namespace
}  // namespace hapticell::workcell
