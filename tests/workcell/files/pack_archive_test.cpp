// SPDX-License-Identifier: Apache-2.0
#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/support/test_data.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/files/archive.h"
#include "workcell/files/pack.h"
#include "workcell/files/pack_check.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Content by name, as the library that other programs use reads it.
std::map<std::string, std::string> contentOf(const fs::path& file) {
  std::map<std::string, std::string> files;
  archive* in = archive_read_new();
  archive_read_support_format_all(in);
  archive_read_support_filter_all(in);
  EXPECT_EQ(archive_read_open_filename(in, file.c_str(), 1 << 16), ARCHIVE_OK);
  archive_entry* entry = nullptr;
  while (archive_read_next_header(in, &entry) == ARCHIVE_OK) {
    std::string content(static_cast<std::size_t>(archive_entry_size(entry)), '\0');
    EXPECT_EQ(archive_read_data(in, content.data(), content.size()), static_cast<la_ssize_t>(content.size()));
    files[archive_entry_pathname(entry)] = content;
  }
  archive_read_free(in);
  return files;
}

TEST(PackArchive, HoldsTheDocumentAndItsFiles) {
  test::TemporaryFolder folder;
  folder.write("part.obj", kTriangle);
  Diagnostics notes;
  Document document;
  auto part = EntityLoader(folder.path()).load("part.obj", 1.0, notes);
  ASSERT_TRUE(part);
  ASSERT_TRUE(document.execute(AddEntity{*part}));
  for (const char* name : {"cell.zip", "cell.tar.gz"}) {
    const fs::path file = folder.path() / name;
    const auto packed = pack(document.state(), file, "cell.hcell", {folder.path()}, notes);
    ASSERT_TRUE(packed) << packed.error().message();
    EXPECT_EQ(packed->document, "cell.hcell");
    const auto files = contentOf(file);
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files.at("files/part.obj"), kTriangle);
    EXPECT_THAT(files.at("cell.hcell"), HasSubstr("\"file\": \"files/part.obj\""));
    const std::string first = *readFileContent(file);
    if (file.extension() == ".gz") {
      EXPECT_EQ(first.substr(4, 4), std::string(4, '\0')) << "the time of packing";
    }
    ASSERT_TRUE(pack(document.state(), file, "cell.hcell", {folder.path()}, notes));
    EXPECT_EQ(*readFileContent(file), first) << "the same cell gives the same bytes";
  }
  const auto left = std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator());
  EXPECT_EQ(left, 3) << "the part and two archives, nothing beside them";
}

trajectory::Trajectory way() {
  trajectory::Trajectory way;
  way.name = "way";
  way.addFrame({.t = 0.0, .X_WT = Pose()});
  way.addFrame({.t = 1.0, .X_WT = Pose::translation({0.1, 0.0, 0.0})});
  return way;
}

/// A cell of one part, a robot and a recording, and its pack in a folder, which a test then damages.
class PackCheck : public ::testing::Test {
 protected:
  void SetUp() override {
    EntityLoader loader(folder_.path());
    folder_.write("part.obj", kTriangle);
    folder_.write("way.htraj", trajectory::toJsonText(way()));
    Document document;
    auto part = loader.load("part.obj", 1.0, notes_);
    auto robot = loader.load("library:ur5e", 1.0, notes_);
    ASSERT_TRUE(part && robot);
    robot->editJointed().joints.assign(robot->robot()->dof(), 0.0);
    robot->editJointed().joints[1] = -0.7;
    ASSERT_TRUE(document.execute(AddEntity{*part}));
    ASSERT_TRUE(document.execute(AddEntity{*robot}));
    state_ = document.state();
    state_.trajectories.push_back({"way", (folder_.path() / "way.htraj").string()});
    const auto packed = packDocument(state_, pack_, "cell.hcell", {folder_.path()}, notes_);
    ASSERT_TRUE(packed) << packed.error().message();
    ASSERT_TRUE(checkPack(state_, file_, nullptr));
  }
  void replace(const std::string& old, const std::string& by) const {
    std::string text = *readFileContent(file_);
    ASSERT_NE(text.find(old), std::string::npos) << text;
    ASSERT_TRUE(writeFileAtomically(file_, text.replace(text.find(old), old.size(), by)));
  }
  void expectMiss(const std::string& sentence) const {
    const auto kept = checkPack(state_, file_, nullptr);
    ASSERT_FALSE(kept);
    EXPECT_THAT(kept.error().message(), HasSubstr(sentence));
  }
  test::TemporaryFolder folder_;
  const fs::path pack_ = folder_.path() / "pack", file_ = pack_ / "cell.hcell";
  Diagnostics notes_;
  DocumentState state_;
};

TEST_F(PackCheck, FindsWhatStandsElsewhere) {
  replace("-0.7", "-0.70001");
  expectMiss("shoulder_lift_joint -0.7 -> -0.70001");
}

TEST_F(PackCheck, FindsWhatIsMissing) {
  replace("\"name\": \"way\"", "\"name\": \"walk\"");
  expectMiss("trajectories: 1 after packing, or different ones; expected the 1 that were packed");
}

TEST_F(PackCheck, FindsAFileOutsideOfThePack) {
  replace("files/part.obj", "../part.obj");
  expectMiss("the file is outside the pack");
}

TEST_F(PackCheck, FindsALinkThatLeadsOut) {
  fs::remove(pack_ / "files/way.htraj");
  fs::create_symlink(folder_.path() / "way.htraj", pack_ / "files/way.htraj");
  expectMiss("trajectory 'way': the file is outside the pack");
}

TEST(PackArchive, TakesThePackagesThatARobotNames) {
  const test::TemporaryFolder folder;
  folder.write("arm/package.xml", "<package><name>arm</name></package>");
  folder.write("shapes/package.xml", "<package><name>shapes</name></package>");
  folder.write("shapes/meshes/part.obj", kTriangle);
  const std::string urdf =
      "<robot name='arm'><link name='base'><visual><geometry><mesh "
      "filename='MESH'/></geometry></visual></link></robot>";
  const auto packed = [&](const std::string& mesh) -> Expected<PackReport> {
    std::string text = urdf;
    folder.write("arm/arm.urdf", text.replace(text.find("MESH"), 4, mesh));
    Diagnostics notes;
    Document document;
    auto robot = EntityLoader(folder.path()).load("arm/arm.urdf", 1.0, notes);
    EXPECT_TRUE(robot && document.execute(AddEntity{*robot}));
    return pack(document.state(), folder.path() / "packs/pack", "cell.hcell", {folder.path()}, notes);
  };
  fs::create_directories(folder.path() / "packs");
  const auto whole = packed("package://shapes/meshes/part.obj");
  ASSERT_TRUE(whole) << whole.error().message();
  EXPECT_THAT(whole->copied, ::testing::Contains("files/shapes/meshes/part.obj"));
  fs::remove_all(folder.path() / "packs/pack");
  const std::string elsewhere = folder.write("elsewhere/part.obj", kTriangle).string();
  const auto refused = packed(elsewhere);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), HasSubstr("link 'base': the file is outside the pack"));
  EXPECT_TRUE(fs::is_empty(folder.path() / "packs"));
}

TEST_F(PackCheck, FindsADamagedShape) {
  ASSERT_TRUE(writeFileAtomically(pack_ / "files/part.obj", "v 0 0 0\nv 1 0 0\nv 0 1.00001 0\nf 1 2 3\n"));
  expectMiss("entity 'part' in the pack: a shape with a bounding box that differs by 1e-05 m");
  ASSERT_TRUE(writeFileAtomically(pack_ / "files/part.obj", "v 0 0 0\n"));
  expectMiss("entity 'part' in the pack");
}

TEST_F(PackCheck, FindsACopyThatIsCutShort) {
  const fs::path original = folder_.path() / "part.obj", copy = pack_ / "files/part.obj";
  EXPECT_TRUE(checkCopy(copy, original));
  fs::resize_file(copy, fs::file_size(copy) - 1);
  EXPECT_FALSE(checkCopy(copy, original));
  EXPECT_FALSE(checkCopy(pack_ / "none", original));
}

TEST_F(PackCheck, FindsWhatAnArchiveLost) {
  for (const char* name : {"cell.zip", "cell.tar.gz"}) {
    const fs::path archive = folder_.path() / name;
    ASSERT_TRUE(writeArchive(pack_, archive));
    EXPECT_TRUE(checkArchive(archive, pack_));
    const fs::path other = folder_.write("other/part.txt", "x").parent_path();
    EXPECT_FALSE(checkArchive(archive, other)) << "files that were not packed";
    folder_.write("pack/more.txt", "x");
    EXPECT_FALSE(checkArchive(archive, pack_)) << "a file that it has not";
    fs::remove(pack_ / "more.txt");
    const std::string way = *readFileContent(pack_ / "files/way.htraj");
    for (const char* changed : {"[]", "{} ", "{"}) {
      folder_.write("pack/files/way.htraj", changed);
      const auto kept = checkArchive(archive, pack_);
      ASSERT_FALSE(kept) << changed;
      EXPECT_THAT(kept.error().message(), HasSubstr("'files/way.htraj' in the archive"));
    }
    folder_.write("pack/files/way.htraj", way);
    const std::string whole = *readFileContent(archive);
    for (std::size_t size = 0; size < whole.size(); size += 37) {
      ASSERT_TRUE(writeFileAtomically(archive, whole.substr(0, size)));
      // The list at a ZIP file's end says all twice: without it the files are read all the same.
      const bool has_files = checkArchive(archive, pack_).has_value();
      EXPECT_TRUE(!has_files || size > whole.size() / 2) << name << ' ' << size;
    }
  }
}

TEST(PackArchive, WhereItCannotBeWrittenNothingIsLeft) {
  test::TemporaryFolder folder;
  Diagnostics notes;
  EXPECT_FALSE(pack({}, folder.path() / "nowhere" / "cell.zip", "cell.hcell", {folder.path()}, notes));
  EXPECT_FALSE(writeArchive(folder.path() / "missing", folder.path() / "a.zip"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
  EXPECT_TRUE(isArchiveName("a.b.zip"));
  EXPECT_FALSE(isArchiveName("cell"));
}

}  // namespace
}  // namespace hapticell::workcell
