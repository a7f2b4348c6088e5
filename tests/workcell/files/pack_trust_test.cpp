// SPDX-License-Identifier: Apache-2.0
// A workcell of others may name any file of this machine. What goes into a pack of it?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/support/test_data.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/files/claimed_content.h"
#include "workcell/files/pack.h"
#include "workcell/format/document_io.h"
#include "workcell/format/recordings.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

constexpr const char* kOneTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr const char* kSecret = "root:$6$secret:19000:0:99999:7:::\n";

/// cell/ with a stranger's document, and beside it what is nobody's business.
class PackTrust : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("private/shadow", kSecret);
    folder_.write("private/id_rsa.obj", kSecret);
    folder_.write("cell/part.obj", kOneTriangle);
  }
  /// The document with these entities and trajectories, as JSON lists without their brackets.
  fs::path cell(const std::string& entities, const std::string& trajectories = {}) const {
    return folder_.write("cell/cell.hcell", R"({"format":"hapticell-workcell","version":1,"entities":[)" + entities +
                                                R"(],"trajectories":[)" + trajectories + "]}");
  }
  Expected<PackReport> packed(bool allow_outside = false) {
    const auto document = loadDocument(folder_.path() / "cell/cell.hcell", notes_, {.keep_unloaded = true});
    HAPTICELL_TRY(document);
    std::error_code ignored;
    fs::remove_all(pack_, ignored);
    return packDocument(document->state(), pack_, "cell.hcell", {folder_.path() / "cell", allow_outside}, notes_);
  }
  /// Nothing of what is secret is in the pack, under any name.
  void expectNoSecret() const {
    std::error_code none;
    for (fs::recursive_directory_iterator at(pack_, none), end; !none && at != end; at.increment(none)) {
      if (!at->is_regular_file()) continue;
      EXPECT_EQ(readFileContent(at->path())->find("secret"), std::string::npos) << at->path();
    }
  }
  void expectRefused(const std::string& sentence) {
    for (const bool allowed : {false, true}) {
      const auto report = packed(allowed);
      ASSERT_FALSE(report) << "allowed " << allowed;
      EXPECT_THAT(report.error().message(), HasSubstr(sentence));
      EXPECT_FALSE(fs::exists(pack_));
    }
  }

  test::TemporaryFolder folder_;
  const fs::path pack_ = folder_.path() / "pack";
  Diagnostics notes_;
};

std::string part(const std::string& file, const std::string& kind = "solid", const std::string& name = "a") {
  return R"({"name":")" + name + R"(","kind":")" + kind + R"(","source":{"file":")" + file + R"("}})";
}

TEST_F(PackTrust, AnAssemblyTakesNoFileThatIsNoShape) {
  cell(part("part.obj", "solid", "b") + "," + part("../private/shadow", "assembly"));
  expectRefused("assembly 'a'");
  cell(part("part.obj", "solid", "b") + "," + part("../private/id_rsa.obj", "assembly"));
  expectRefused("assembly 'a'");
}

TEST_F(PackTrust, ATrajectoryTakesNoFileThatIsNone) {
  for (const char* file : {"../private/shadow", "../private/id_rsa.obj", "part.obj"}) {
    cell(part("part.obj"), R"({"name":"way","file":")" + std::string(file) + "\"}");
    expectRefused("trajectory 'way'");
  }
}

TEST_F(PackTrust, ASolidThatCouldNotBeReadTakesNothing) {
  cell(part("part.obj") + "," + part("../private/id_rsa.obj", "solid", "key"));
  const auto report = packed(true);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_THAT(report->copied, UnorderedElementsAre("files/part.obj"));
  expectNoSecret();
}

TEST_F(PackTrust, WhatAMeshNamesBesideItMustBeWhatItClaims) {
  folder_.write("cell/part.obj", std::string("mtllib paint.mtl\nmtllib keys.mtl\nmtllib link.mtl\n") + kOneTriangle);
  folder_.write("cell/paint.mtl", "# colours\nnewmtl red\nKd 1 0 0\n");
  folder_.write("cell/keys.mtl", kSecret);
  fs::create_symlink(folder_.path() / "private/shadow", folder_.path() / "cell/link.mtl");
  cell(part("part.obj"));
  const auto report = packed();
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_THAT(report->copied, UnorderedElementsAre("files/part/part.obj", "files/part/paint.mtl"));
  expectNoSecret();
}

TEST_F(PackTrust, WhatLiesOutsideIsListedAndNothingWritten) {
  folder_.write("private/house.obj", kOneTriangle);
  fs::create_symlink(folder_.path() / "private/house.obj", folder_.path() / "cell/link.obj");
  for (const char* file : {"../private/house.obj", "link.obj"}) {
    cell(part(file) + "," + part("part.obj", "solid", "b"));
    const auto asked = packed();
    ASSERT_TRUE(asked) << asked.error().message();
    EXPECT_FALSE(asked->isWritten());
    EXPECT_EQ(asked->outside.size(), 1u);
    EXPECT_FALSE(fs::exists(pack_));
    const auto allowed = packed(true);
    ASSERT_TRUE(allowed) << allowed.error().message();
    EXPECT_TRUE(allowed->isWritten());
    EXPECT_EQ(allowed->copied.size(), 2u);
    EXPECT_EQ(allowed->outside.size(), 1u) << "it is told all the same";
  }
}

TEST_F(PackTrust, ARobotTakesWhatWasReadForItAndNothingBesideIt) {
  folder_.write("cell/arm.urdf",
                "<robot name='arm'><link name='base'><visual><geometry><mesh filename='part.obj'/></geometry></visual>"
                "</link></robot>");
  folder_.write("cell/passwords.txt", kSecret);
  folder_.write("cell/.netrc", kSecret);
  folder_.write("cell/sub/.ssh/id_rsa", kSecret);
  cell(part("arm.urdf", "robot"));
  const auto report = packed();
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_THAT(report->copied, UnorderedElementsAre("files/cell/arm.urdf", "files/cell/part.obj"));
  expectNoSecret();
}

TEST_F(PackTrust, ARobotWithIncludesMeshesAboveItAndPackagesStillPacksWithLeave) {
  folder_.write("robots/arm/package.xml", "<package><name>arm</name></package>");
  folder_.write("robots/arm/notes.txt", kSecret);
  folder_.write("robots/arm/urdf/arm.urdf.xacro",
                "<robot name='arm' xmlns:xacro='http://ros.org/wiki/xacro'><xacro:include filename='part.xacro'/>"
                "<xacro:base/></robot>");
  folder_.write("robots/arm/urdf/part.xacro",
                "<robot xmlns:xacro='http://ros.org/wiki/xacro'><xacro:macro name='base'><link name='base'><visual>"
                "<geometry><mesh filename='package://shapes/meshes/part.obj'/></geometry></visual></link></xacro:macro>"
                "</robot>");
  folder_.write("robots/shapes/package.xml", "<package><name>shapes</name></package>");
  folder_.write("robots/shapes/meshes/part.obj", kOneTriangle);
  folder_.write("robots/plain/urdf/plain.urdf",
                "<robot name='plain'><link name='l'><visual><geometry><mesh filename='../meshes/part.obj'/></geometry>"
                "</visual></link></robot>");
  folder_.write("robots/plain/meshes/part.obj", kOneTriangle);
  cell(part("../robots/arm/urdf/arm.urdf.xacro", "robot") + "," +
       part("../robots/plain/urdf/plain.urdf", "robot", "plain"));
  EXPECT_FALSE(packed()->isWritten());
  const auto report = packed(true);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_THAT(report->copied, UnorderedElementsAre("files/arm/package.xml", "files/arm/urdf/arm.urdf.xacro",
                                                   "files/arm/urdf/part.xacro", "files/shapes/package.xml",
                                                   "files/shapes/meshes/part.obj", "files/plain/urdf/plain.urdf",
                                                   "files/plain/meshes/part.obj"));
  expectNoSecret();
  fs::remove_all(folder_.path() / "robots");
  const auto again = loadDocument(pack_ / "cell.hcell", notes_);
  EXPECT_TRUE(again) << again.error().message();
}

TEST_F(PackTrust, SavingBringsNoFileHereThatIsNoRecording) {
  cell(part("part.obj"), R"({"name":"way","file":"../private/shadow"})");
  const auto document = loadDocument(folder_.path() / "cell/cell.hcell", notes_);
  ASSERT_TRUE(document);
  EXPECT_TRUE(gatherRecordings(document->state(), folder_.path() / "elsewhere/cell.hcell").moved.empty());
}

TEST(ClaimedContent, IsToldByTheFirstBytes) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(isWhatItClaims(folder.write("a.png", std::string("\x89PNG\r\n\x1A\n", 8) + "x")));
  EXPECT_FALSE(isWhatItClaims(folder.write("b.png", kSecret)));
  EXPECT_TRUE(isWhatItClaims(folder.write("c.JPG", "\xFF\xD8\xFF\xE0")));
  EXPECT_TRUE(isWhatItClaims(folder.write("d.mtl", "  # x\n\nnewmtl a\n")));
  EXPECT_FALSE(isWhatItClaims(folder.write("e.mtl", "PRIVATE KEY\nnewmtl a\n")));
  EXPECT_TRUE(isWhatItClaims(folder.write("f.stp", "ISO-10303-21;\n")));
  EXPECT_FALSE(isWhatItClaims(folder.write("g.stp", kSecret)));
  EXPECT_TRUE(isWhatItClaims(folder.write("h.bin", "anything")));
  for (const char* name : {"id_rsa", "keys.txt", "x.pem", "y.yaml"})
    EXPECT_FALSE(isWhatItClaims(folder.write(name, kSecret))) << name;
  EXPECT_FALSE(isWhatItClaims(folder.path()));
  EXPECT_FALSE(isWhatItClaims(folder.path() / "none.png"));
}

}  // namespace
}  // namespace hapticell::workcell
