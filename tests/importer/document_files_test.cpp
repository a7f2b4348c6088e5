// SPDX-License-Identifier: Apache-2.0
// A document and its files: missing ones, the copy against a crash, the pack, what changed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/shapes/shapes.h"
#include "tests/support/test_data.h"
#include "workcell/document/assembly_solid.h"
#include "workcell/files/autosave.h"
#include "workcell/files/named_files.h"
#include "workcell/files/pack.h"
#include "workcell/format/document_io.h"
#include "workcell/import/change_report.h"
#include "workcell/import/entity_source.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

Entity solid(const std::string& name, const fs::path& file) {
  Entity entity;
  entity.name = name;
  entity.source.path = file.string();
  entity.body = Solid{std::make_shared<const geometry::TriangleMesh>(geometry::TriangleMesh{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}})};  // As in kObj.
  return entity;
}

/// Two solids of two files, one below an assembly, saved as cell.hcell.
class DocumentFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    Document document;
    Entity group;
    group.body = Assembly{};
    group.name = "group";
    Entity b = solid("b", folder_.write("parts/b.obj", kObj));
    b.parent = "group";
    ASSERT_TRUE(document.execute(AddEntity{solid("a", folder_.write("parts/a.obj", kObj))}));
    ASSERT_TRUE(document.execute(AddEntity{group}));
    ASSERT_TRUE(document.execute(AddEntity{b}));
    ASSERT_TRUE(saveDocument(document, file()));
  }
  fs::path file() const { return folder_.path() / "cell.hcell"; }
  test::TemporaryFolder folder_;
  Diagnostics notes_;
};

TEST_F(DocumentFiles, WhatCannotBeReadIsKeptAndSavedAsItWas) {
  const std::string text = *readFileContent(file());
  fs::remove(folder_.path() / "parts/a.obj");
  EXPECT_FALSE(loadDocument(file(), notes_));
  auto document = loadDocument(file(), notes_, {.keep_unloaded = true});
  ASSERT_TRUE(document) << document.error().message();
  EXPECT_THAT(english(notes_.warnings.at(0)), HasSubstr("a.obj"));
  EXPECT_TRUE(document->findByName("a")->unloaded);
  EXPECT_TRUE(document->findByName("b")->mesh());
  EXPECT_EQ(documentText(document->state(), folder_.path()), text);
}

TEST_F(DocumentFiles, AMovedFolderIsAskedForOnce) {
  fs::rename(folder_.path() / "parts", folder_.path() / "elsewhere");
  int asked = 0;
  LoadOptions options;
  options.locate = [&](const fs::path& missing) -> std::optional<fs::path> {
    ++asked;
    return folder_.path() / "elsewhere" / missing.filename();
  };
  const auto document = loadDocument(file(), notes_, options);
  ASSERT_TRUE(document) << document.error().message();
  EXPECT_EQ(asked, 1);
  EXPECT_THAT(documentText(document->state(), folder_.path()), HasSubstr("elsewhere/b.obj"));
}

/// The user's state folder, for as long as this lives.
class StateFolder {
 public:
  explicit StateFolder(const fs::path& folder) { ::setenv("XDG_STATE_HOME", folder.c_str(), 1); }
  ~StateFolder() { ::unsetenv("XDG_STATE_HOME"); }
};

TEST_F(DocumentFiles, WhatADeadRunLeftIsFoundUntilItIsDiscarded) {
  const StateFolder state(folder_.path() / "state");
  auto document = loadDocument(file(), notes_);
  ASSERT_TRUE(document);
  ASSERT_TRUE(document->execute(SetPlacement{document->findByName("a")->id, Pose::translation({1, 2, 3})}));
  {
    RunFolder run;
    ASSERT_TRUE(run.path());
    ASSERT_TRUE(autosave(document->state(), file(), *run.path()));
    EXPECT_TRUE(findLeftWork().empty()) << "the run lives";
  }
  const auto left = findLeftWork();
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].document, file());
  EXPECT_TRUE(left[0].crash.empty());
  auto restored = loadDocument(left[0].copy, notes_);
  ASSERT_TRUE(restored) << restored.error().message();
  EXPECT_EQ(restored->findByName("a")->X_WE.p, dvec3(1, 2, 3));
  EXPECT_NE(restored->findByName("b")->mesh(), nullptr) << "its file is found from there";
  EXPECT_EQ(findLeftWork().size(), 1u) << "looking changes nothing";
  discardLeftWork(left[0].run);
  EXPECT_TRUE(findLeftWork().empty());
}

TEST_F(DocumentFiles, RunsDoNotTouchEachOthersCopies) {
  const StateFolder state(folder_.path() / "state");
  auto document = loadDocument(file(), notes_);
  ASSERT_TRUE(document);
  const EntityId a = document->findByName("a")->id;
  {
    RunFolder first, second;
    ASSERT_TRUE(document->execute(SetPlacement{a, Pose::translation({1, 0, 0})}));
    ASSERT_TRUE(autosave(document->state(), file(), *first.path()));
    ASSERT_TRUE(document->execute(SetPlacement{a, Pose::translation({2, 0, 0})}));
    ASSERT_TRUE(autosave(document->state(), file(), *second.path()));
  }
  ASSERT_EQ(findLeftWork().size(), 2u);
  {
    RunFolder third;
    const auto left = findLeftWork();
    ASSERT_TRUE(third.adopt(left[0].run));
    EXPECT_EQ(findLeftWork().size(), 1u) << "the other one is still on offer";
    const auto restored = loadDocument(copyIn(*third.path()), notes_);
    ASSERT_TRUE(restored);
    EXPECT_NE(restored->findByName("a")->mesh(), nullptr);
    third.discardCopy();
  }
  EXPECT_EQ(findLeftWork().size(), 1u) << "a run that ends in order leaves nothing";
  EXPECT_EQ(std::distance(fs::directory_iterator(runsFolder()), fs::directory_iterator()), 1);
}

TEST_F(DocumentFiles, WhatBrokeIsFoundToo) {
  const StateFolder state(folder_.path() / "state");
  {
    RunFolder run;
    ASSERT_TRUE(run.path());
    ASSERT_TRUE(writeFileAtomically(crashNoteIn(*run.path()), "part.cpp:12: a == b [worker]\nmore\n"));
    ASSERT_TRUE(autosave(DocumentState(), {}, *run.path()));
  }
  const auto left = findLeftWork();
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].crash, "part.cpp:12: a == b [worker]");
  EXPECT_TRUE(left[0].document.empty());
}

TEST_F(DocumentFiles, ThePackStandsOnItsOwn) {
  folder_.write("other/a.obj", kObj);
  auto document = loadDocument(file(), notes_);
  ASSERT_TRUE(document);
  ASSERT_TRUE(document->execute(AddEntity{solid("a again", folder_.path() / "other/a.obj")}));
  const fs::path pack = folder_.path() / "pack";
  const auto report = packDocument(document->state(), pack, "cell.hcell", {folder_.path()}, notes_);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_EQ(report->copied.size(), 3u);
  EXPECT_FALSE(packDocument(document->state(), pack, "cell.hcell", {folder_.path()}, notes_))
      << "the folder is not empty";
  const fs::path moved = folder_.path() / "handed on";
  fs::rename(pack, moved);
  fs::remove_all(folder_.path() / "parts");
  fs::remove_all(folder_.path() / "other");
  const auto again = loadDocument(moved / "cell.hcell", notes_);
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->state().entities.size(), 4u);
}

TEST_F(DocumentFiles, APackHasWhatItsFilesName) {
  // Two files of one name, each with a library of one name and another content.
  for (const char* color : {"1 0 0", "0 1 0"}) {
    const std::string sub = *color == '1' ? "red" : "green";
    fs::create_directories(folder_.path() / sub / "colours");
    folder_.write(sub + "/part.obj", "mtllib colours/all.mtl\nusemtl paint\n" + std::string(kObj));
    folder_.write(sub + "/colours/all.mtl", std::string("newmtl paint\nKd ") + color + "\n");
  }
  Document document;
  for (const char* sub : {"red", "green"}) {
    ASSERT_TRUE(document.execute(AddEntity{solid(sub, folder_.path() / sub / "part.obj")}));
  }
  const fs::path pack = folder_.path() / "with colours";
  const auto report = packDocument(document.state(), pack, "cell.hcell", {folder_.path()}, notes_);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_EQ(report->copied.size(), 4u);
  for (const char* sub : {"red", "green"}) fs::remove_all(folder_.path() / sub);
  notes_.warnings.clear();
  const auto again = loadDocument(pack / "cell.hcell", notes_);
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_TRUE(notes_.warnings.empty()) << english(notes_.warnings.front());
  EntityLoader loader(pack);
  const auto tree = loader.loadTree(again->findByName("green")->source.path, {}, notes_);
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->entities.at(0).color, (std::array<float, 3>{0, 1, 0}));
}

TEST_F(DocumentFiles, FilesThatAreNamedAreFoundAndNoOthers) {
  const auto named = [&](const char* name, const std::string& text) {
    std::vector<std::string> found;
    for (const fs::path& file : filesNamedIn(folder_.write(name, text)))
      found.push_back(file.lexically_relative(folder_.path()).generic_string());
    return found;
  };
  fs::create_directories(folder_.path() / "sub");
  folder_.write("sub/bolt.stp", "ISO-10303-21; 'nut.stp' '../root.step' '../../away.stp'");
  folder_.write("sub/nut.stp", "ISO-10303-21;");
  folder_.write("data.bin", "x");
  folder_.write("a b.mtl", "");
  EXPECT_EQ(named("root.step",
                  "ISO-10303-21; #1=DOCUMENT_FILE('sub/bolt.stp','','',#2,'',$); 'none.stp' 'data.bin' '/etc/x.stp'"),
            (std::vector<std::string>{"sub/bolt.stp", "sub/nut.stp"}));
  EXPECT_EQ(named("m.gltf", R"({"buffers":[{"uri":"data.bin"},{"uri":"../secret.bin"},{"uri":"data:x;base64,AA=="}]})"),
            std::vector<std::string>{"data.bin"});
  EXPECT_EQ(named("m.obj", "mtllib a b.mtl\nmtllib ../x.mtl\n"), std::vector<std::string>{"a b.mtl"});
  EXPECT_TRUE(named("m.stl", "solid data.bin").empty());
}

TEST_F(DocumentFiles, APackThatFailsLeavesNothing) {
  auto document = loadDocument(file(), notes_);
  fs::remove(folder_.path() / "parts/b.obj");
  EXPECT_FALSE(packDocument(document->state(), folder_.path() / "pack", "cell.hcell", {folder_.path()}, notes_));
  EXPECT_FALSE(fs::exists(folder_.path() / "pack"));
}

TEST_F(DocumentFiles, APackThatIsNotWhatWasPackedIsNotKept) {
  const auto document = loadDocument(file(), notes_);
  ASSERT_TRUE(document);
  folder_.write("parts/b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");  // Since it was opened.
  const auto report = packDocument(document->state(), folder_.path() / "pack", "cell.hcell", {folder_.path()}, notes_);
  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message(), HasSubstr("entity 'b' in the pack: 1 triangles; expected 4"));
  EXPECT_FALSE(fs::exists(folder_.path() / "pack"));
  EXPECT_FALSE(pack(document->state(), folder_.path() / "pack.zip", "cell.hcell", {folder_.path()}, notes_));
  EXPECT_FALSE(fs::exists(folder_.path() / "pack.zip"));
}

TEST_F(DocumentFiles, WhatWasOpenedWithoutItsFileIsPackedWithout) {
  fs::remove(folder_.path() / "parts/a.obj");
  const auto document = loadDocument(file(), notes_, {.keep_unloaded = true});
  ASSERT_TRUE(document);
  notes_.warnings.clear();
  const auto report = packDocument(document->state(), folder_.path() / "pack", "cell.hcell", {folder_.path()}, notes_);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_EQ(report->copied, std::vector<std::string>{"files/b.obj"});
  EXPECT_THAT(english(notes_.warnings.at(0)), HasSubstr("entity 'a' is packed without its file"));
}

TEST_F(DocumentFiles, ChangesTellWhatMovedAndHowFar) {
  const auto before = loadDocument(file(), notes_);
  auto after = loadDocument(file(), notes_);
  ASSERT_TRUE(before && after);
  const Pose X{{3, 4, 0}, glm::angleAxis(0.5, dvec3(0, 0, 1))};
  ASSERT_TRUE(after->execute(SetPlacement{after->findByName("group")->id, X}));
  ASSERT_TRUE(after->execute(RemoveEntity{after->findByName("a")->id}));
  ASSERT_TRUE(after->execute(AddEntity{solid("new, \"quoted\"", folder_.path() / "x")}));
  const auto changes = compareStates(before->state(), after->state());
  ASSERT_EQ(changes.size(), 4u);
  EXPECT_EQ(changes[1].name, "b");  // It went with its assembly.
  EXPECT_EQ(changes[1].kind, EntityChange::Kind::kMoved);
  EXPECT_NEAR(changes[1].distance, 5.0, 1e-12);
  EXPECT_NEAR(changes[1].angle, 0.5, 1e-12);
  EXPECT_EQ(changes[2].kind, EntityChange::Kind::kAdded);
  EXPECT_EQ(changes[3].kind, EntityChange::Kind::kRemoved);
  const std::string csv = changesAsCsv(changes, false);
  EXPECT_THAT(csv, HasSubstr("\n\"new, \"\"quoted\"\"\",solid,added,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
}

TEST_F(DocumentFiles, AnAssemblyCanBeHeldAsOneSolid) {
  const auto document = loadDocument(file(), notes_);
  ASSERT_TRUE(document);
  const DocumentState folded = withAssemblyAsSolid(document->state(), "group");
  ASSERT_EQ(folded.entities.size(), 2u);
  EXPECT_EQ(folded.findByName("group")->kind(), EntityKind::kSolid);
  EXPECT_EQ(folded.findByName("group")->mesh()->triangles.size(), 4u);
  EXPECT_EQ(withAssemblyAsSolid(document->state(), "a").entities.size(), 3u);
}

TEST_F(DocumentFiles, AssembliesCannotStandBelowThemselves) {
  auto document = loadDocument(file(), notes_);
  ASSERT_TRUE(document);
  SetProperties change;
  change.id = document->findByName("group")->id;
  change.parent = "b";
  EXPECT_FALSE(document->execute(change));
  ASSERT_TRUE(document->execute(RenameEntity{change.id, "renamed"}));
  EXPECT_EQ(document->findByName("b")->parent, "renamed");
  change.parent.reset();
  change.visible = false;
  ASSERT_TRUE(document->execute(change));
  EXPECT_FALSE(document->findByName("b")->visible);
}

}  // namespace
}  // namespace hapticell::workcell
