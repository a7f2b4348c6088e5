// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <thread>

#include "tests/support/test_data.h"
#include "workcell/import_process.h"
#include "workcell/import_scene.h"

namespace hapticell::workcell {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// Puts a script in the importer's place: what a library that went mad would do.
class FakeImporter : public ::testing::Test {
 protected:
  void TearDown() override { ::unsetenv("HAPTICELL_IMPORTER"); }

  Expected<ImportedScene> read(const std::string& script, ImportLimits limits = {}, ImportMonitor* monitor = nullptr) {
    const fs::path program = folder_.write("importer.sh", "#!/bin/sh\n" + script + "\n");
    fs::permissions(program, fs::perms::owner_all);
    ::setenv("HAPTICELL_IMPORTER", program.c_str(), 1);
    const fs::path file = folder_.write("part.step", "ISO-10303-21;");
    ImportOptions options;
    options.limits = limits;
    return readScene(file, options, monitor);
  }

  test::TemporaryFolder folder_;
};

TEST_F(FakeImporter, aCrashIsOneSentence) {
  const auto scene = read("kill -SEGV $$");
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("part.step"));
  EXPECT_THAT(scene.error().message(), HasSubstr("Segmentation fault"));
  EXPECT_THAT(read("kill -ABRT $$").error().message(), HasSubstr("failed on it"));
  EXPECT_THAT(read("exit 3").error().message(), HasSubstr("failed on it"));
}

TEST_F(FakeImporter, aHangEndsWithTheTimeAllowed) {
  ImportLimits limits;
  limits.seconds = 0.2;
  const auto scene = read("exec sleep 100", limits);
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("not done after"));
}

TEST_F(FakeImporter, oneThatSpeaksAndThenHangsEndsToo) {
  ImportLimits limits;
  limits.seconds = 0.3;
  EXPECT_FALSE(read("echo progress 0.5 reading >&4; exec sleep 100", limits));
}

TEST_F(FakeImporter, cancellingKillsIt) {
  ImportMonitor monitor;
  std::thread user([&] {
    while (monitor.progress().stage != "meshing") std::this_thread::yield();
    monitor.cancel();
  });
  const auto scene = read("echo progress 0.7 meshing >&4; exec sleep 100", {}, &monitor);
  user.join();
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("cancelled"));
  EXPECT_DOUBLE_EQ(monitor.progress().share, 0.7);
}

TEST_F(FakeImporter, itsOwnErrorIsPassedOn) {
  const auto scene = read("printf 'error line 3\\ta thing\\tanother\\tMend it.\\n' >&4; exit 1");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().place, "line 3");
  EXPECT_EQ(scene.error().found, "a thing");
  EXPECT_EQ(scene.error().expected, "another");
  EXPECT_EQ(scene.error().fix, "Mend it.");
}

TEST_F(FakeImporter, rubbishInPlaceOfASceneIsRefused) {
  const auto scene = read("head -c 100000 /dev/urandom >&3; echo done >&4");
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("not a scene"));
  EXPECT_FALSE(read("echo done >&4"));
  EXPECT_FALSE(read("head -c 300000 /dev/zero | tr '\\0' x >&4"));
}

TEST_F(FakeImporter, choicesThatAreNoNumbersAreRefusedBeforeItIsStarted) {
  const fs::path file = folder_.write("part.step", "ISO-10303-21;");
  const double bad = std::numeric_limits<double>::quiet_NaN();
  ImportOptions chord, angle, relative, unit;
  chord.tessellation.chord = bad;
  angle.tessellation.angle = 0.0;
  relative.relative_chord = bad;
  unit.metres_per_unit = -1.0;
  for (const ImportOptions& options : {chord, angle, relative, unit}) {
    const auto scene = readScene(file, options, nullptr);
    ASSERT_FALSE(scene);
    EXPECT_THAT(scene.error().message(), HasSubstr("part.step"));
    EXPECT_FALSE(scene.error().place.empty());
  }
}

TEST_F(FakeImporter, aMissingProgramIsTold) {
  ::setenv("HAPTICELL_IMPORTER", "/nowhere/hapticell-importer", 1);
  const auto scene = readScene(folder_.write("part.step", "ISO-10303-21;"), {}, nullptr);
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("hapticell-importer"));
}

}  // namespace
}  // namespace hapticell::workcell
