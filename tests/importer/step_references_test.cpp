// SPDX-License-Identifier: Apache-2.0
// A STEP assembly whose parts stand in files of their own (written by Open CASCADE 7.6: a plate and two uses of a pin).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_data.h"
#include "workcell/files/named_files.h"
#include "workcell/files/pack.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/import/imported_entities.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

fs::path references() {
  return test::sourceFile("tests/importer/references");
}

/// Runs the rest of the scope from another working directory.
class WorkingDirectory {
 public:
  explicit WorkingDirectory(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
  ~WorkingDirectory() { fs::current_path(before_); }

 private:
  fs::path before_;
};

TEST(StepReferences, AreReadFromAnyWorkingDirectory) {
  const test::TemporaryFolder elsewhere;
  for (const fs::path& from : {elsewhere.path(), references(), fs::path("/")}) {
    const WorkingDirectory there(from);
    const auto scene = readScene(references() / "fixture.step", {}, nullptr);
    ASSERT_TRUE(scene) << scene.error().message();
    ASSERT_EQ(scene->nodes.size(), 4u) << from;
    EXPECT_EQ(scene->nodes[0].name, "fixture");
    EXPECT_EQ(scene->nodes[1].name, "plate");
    EXPECT_EQ(scene->nodes[2].name, "pin");
    EXPECT_EQ(scene->nodes[2].mesh, scene->nodes[3].mesh) << "two uses share one mesh";
    EXPECT_EQ(scene->nodes[1].color, (std::array<float, 3>{1, 0, 0}));
    EXPECT_EQ(scene->nodes[3].color, (std::array<float, 3>{0, 0, 1}));
    EXPECT_NEAR(nodePoses(*scene)[3].p.x, 0.03, 1e-9);
    EXPECT_EQ(scene->meshes[static_cast<std::size_t>(scene->nodes[1].mesh)].triangles.size(), 12u);
    EXPECT_TRUE(scene->warnings.empty());
  }
}

TEST(StepReferences, APartThatIsNotThereIsToldAndTheRestComes) {
  const test::TemporaryFolder folder;
  for (const char* name : {"fixture.step", "part_plate.stp"}) fs::copy_file(references() / name, folder.path() / name);
  const auto scene = readScene(folder.path() / "fixture.step", {}, nullptr);
  ASSERT_TRUE(scene) << scene.error().message();
  std::string told;
  for (const Text& warning : scene->warnings) told += english(warning) + "\n";
  EXPECT_THAT(told, HasSubstr("pin"));
  fs::remove(folder.path() / "part_plate.stp");
  const auto none = readScene(folder.path() / "fixture.step", {}, nullptr);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message(), HasSubstr("fixture.step"));
}

TEST(StepReferences, GoIntoThePack) {
  const test::TemporaryFolder folder;
  Diagnostics notes;
  auto tree = EntityLoader(folder.path()).loadTree((references() / "fixture.step").string(), {}, notes);
  ASSERT_TRUE(tree) << tree.error().message();
  Document document;
  ASSERT_TRUE(addImported(document, std::move(tree->entities), {}));
  const auto report =
      packDocument(document.state(), folder.path() / "pack", "cell.hcell", {folder.path(), true}, notes);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_EQ(report->copied.size(), 3u);
  const auto again = loadDocument(folder.path() / "pack/cell.hcell", notes);
  ASSERT_TRUE(again) << again.error().message();
  ASSERT_NE(again->findByName("pin 2"), nullptr);
  EXPECT_FALSE(again->findByName("pin 2")->unloaded);
  EXPECT_EQ(again->findByName("pin")->mesh(), again->findByName("pin 2")->mesh());
}

}  // namespace
}  // namespace hapticell::workcell
