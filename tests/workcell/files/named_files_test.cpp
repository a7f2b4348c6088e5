// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/named_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_data.h"
#include "tests/workcell/document/every_command.h"
#include "workcell/files/pack_plan.h"

namespace hapticell::workcell {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;
namespace fs = std::filesystem;

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

class NamedFiles : public ::testing::Test {
 protected:
  test::TemporaryFolder folder;
};

TEST_F(NamedFiles, AreMaterialLibrariesAlsoWithBlanksAndInFolders) {
  fs::create_directory(folder.path() / "mats");
  const fs::path one = folder.write("one.mtl", ""), blank = folder.write("two words.mtl", ""),
                 below = folder.write("mats/three.mtl", "");
  const fs::path obj =
      folder.write("a.obj", "mtllib one.mtl missing.mtl\nmtllib two words.mtl\nmtllib mats\\three.mtl\n" +
                                std::string(kTriangle) + "mtllib one.mtl\n");
  EXPECT_THAT(filesNamedIn(obj), UnorderedElementsAre(one, blank, below));
}

TEST_F(NamedFiles, NeverLeadAboveTheFolder) {
  fs::create_directory(folder.path() / "inner");
  const fs::path secret = folder.write("secret.mtl", "");
  const fs::path obj = folder.write(
      "inner/a.obj", "mtllib ../secret.mtl\nmtllib x/../../secret.mtl\nmtllib " + secret.string() + "\n" + kTriangle);
  EXPECT_THAT(filesNamedIn(obj), IsEmpty());
}

TEST_F(NamedFiles, OfGltfAndOfStepAssembliesWithTheirOwnFiles) {
  const fs::path buffer = folder.write("a.bin", "1234");
  const fs::path gltf = folder.write("a.gltf", R"({"buffers": [{"uri": "a.bin"}, {"uri": "data:abc.bin"}]})");
  EXPECT_THAT(filesNamedIn(gltf), ElementsAre(buffer));

  const fs::path top = folder.write("top.stp", "ISO-10303-21; FILE('middle.stp'); FILE('a.bin'); FILE('top.stp')");
  const fs::path middle = folder.write("middle.stp", "ISO-10303-21; FILE('leaf.step'); FILE('top.stp')");
  const fs::path leaf = folder.write("leaf.step", "ISO-10303-21;");
  EXPECT_THAT(filesNamedIn(top), UnorderedElementsAre(middle, leaf)) << "itself left out, circles ended, STEP only";
  EXPECT_THAT(filesNamedIn(folder.write("a.stl", "solid mtllib a.bin")), IsEmpty());
  EXPECT_THAT(filesNamedIn(folder.path() / "missing.obj"), IsEmpty());
}

class PlannedPack : public NamedFiles {
 protected:
  /// A state with one solid whose shape was read from `file`.
  static DocumentState stateOf(const fs::path& file) {
    Entity part = test::makeSolid("part");
    part.id = 1;
    part.source = {file.string(), 1.0};
    DocumentState state;
    state.entities = {std::make_shared<const Entity>(part)};
    return state;
  }
  Diagnostics notes;
};

TEST_F(PlannedPack, NamesFilesByTheirPlacesAndTakesWhatTheyName) {
  folder.write("a.mtl", "newmtl red\n");
  const fs::path obj = folder.write("a.obj", "mtllib a.mtl\n" + std::string(kTriangle));
  const auto plan = planPack(stateOf(obj), {.folder = folder.path()}, notes);
  ASSERT_TRUE(plan.has_value()) << plan.error().message();
  ASSERT_EQ(plan->copies.size(), 2u);
  const std::string place = plan->state.entities.at(0)->source.path;
  EXPECT_TRUE(fs::path(place).is_relative()) << place;
  EXPECT_TRUE(plan->copies[0].place == place || plan->copies[1].place == place);
  for (const PlannedCopy& copy : plan->copies) {
    EXPECT_TRUE(fs::is_regular_file(copy.from)) << copy.from;
    EXPECT_THAT(copy.place, HasSubstr(copy.from.filename().string()));
  }
  EXPECT_THAT(plan->outside, IsEmpty());
}

TEST_F(PlannedPack, TellsWhatLiesOutsideOnce) {
  fs::create_directory(folder.path() / "cell");
  const fs::path outside = folder.write("a.obj", kTriangle), inside = folder.write("cell/b.obj", kTriangle);
  fs::create_symlink(outside, folder.path() / "cell/link.obj");
  const PackScope scope{.folder = folder.path() / "cell"};
  const auto planned = planPack(stateOf(outside), scope, notes), within = planPack(stateOf(inside), scope, notes),
             linked = planPack(stateOf(folder.path() / "cell/link.obj"), scope, notes);
  ASSERT_TRUE(planned && within && linked);
  EXPECT_THAT(planned->outside, ElementsAre(outside));
  EXPECT_THAT(within->outside, IsEmpty());
  EXPECT_THAT(linked->outside, ElementsAre(folder.path() / "cell/link.obj")) << "a link counts as its target";
  EXPECT_EQ(linked->copies.at(0).from, fs::canonical(outside));
  const auto unsaved = planPack(stateOf(inside), {}, notes);
  ASSERT_TRUE(unsaved);
  EXPECT_THAT(unsaved->outside, ElementsAre(inside)) << "a document without a folder";
}

TEST_F(PlannedPack, RefusesAFileThatIsNotWhatItClaimsToBe) {
  const fs::path letter = folder.write("private.obj", "Dear Anna, ...\n");
  Entity named;  // The state has no shape of that file: it is only named.
  named.id = 1;
  named.name = "group";
  named.body = Assembly{};
  named.source.path = letter.string();
  DocumentState state;
  state.entities = {std::make_shared<const Entity>(named)};
  const auto plan = planPack(state, {.folder = folder.path()}, notes);
  ASSERT_FALSE(plan.has_value());
  EXPECT_THAT(plan.error().message(), HasSubstr("group"));
  DocumentState recorded;
  recorded.trajectories = {{"run", letter.string(), {}}};
  const auto no_recording = planPack(recorded, {.folder = folder.path()}, notes);
  ASSERT_FALSE(no_recording.has_value());
  EXPECT_THAT(no_recording.error().message(), HasSubstr("run"));
}

}  // namespace
}  // namespace hapticell::workcell
