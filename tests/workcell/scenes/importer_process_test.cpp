// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "geometry/system/packed_text.h"
#include "geometry/system/sanitizers.h"
#include "tests/support/test_data.h"
#include "workcell/scenes/import_process.h"
#include "workcell/scenes/import_scene.h"

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

  /// The shell command by which the importer says that error.
  static std::string sayingError(const Error& error) { return "echo 'error " + packed(error) + "' >&4"; }

  /// The shell command by which the importer says how far it is.
  static std::string sayingProgress(double share, const Text& stage) {
    return "echo 'progress " + std::to_string(share) + " " + packed(stage) + "' >&4; ";
  }

  test::TemporaryFolder folder_;
};

TEST_F(FakeImporter, ACrashIsOneSentenceOfWhatWasFoundAndWhatHelps) {
  for (const char* const end : {"kill -SEGV $$", "kill -ABRT $$", "exit 3"}) {
    const auto scene = read(sayingProgress(0.7, Text("meshing part %1 of %2, %3", 2, 3, "Flange")) + end);
    ASSERT_FALSE(scene);
    EXPECT_THAT(scene.error().message(),
                HasSubstr("part.step, meshing part 2 of 3, Flange: content that makes the reader crash; expected an "
                          "undamaged file. Export it again or in another format"));
  }
  EXPECT_THAT(read("exit 3").error().message(), HasSubstr("part.step, at its start: "));
}

TEST_F(FakeImporter, APartThatBreaksItDownIsLeftOut) {
  const std::string counted = "echo \"$@\" >> " + (folder_.path() / "calls").string() + "\n";
  const auto calls = [this] {
    std::ifstream stream(folder_.path() / "calls");
    std::vector<std::string> all;
    for (std::string line; std::getline(stream, line);) all.push_back(line);
    return all;
  };
  const auto scene = read(counted + R"(case "$*" in
  *"--skip 2 --skip 5"*) )" +
                          sayingError({.found = "the rest was read"}) +
                          R"(;;
  *"--skip 2"*) echo part 5 >&4; kill -SEGV $$;;
  *) echo part 1 >&4; echo part 2 >&4; kill -SEGV $$;;
esac)");
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("the rest was read"));
  EXPECT_EQ(calls().size(), 3u);
  ASSERT_FALSE(read(counted + "echo part 1 >&4; kill -SEGV $$")) << "the same part again is not tried for ever";
  EXPECT_EQ(calls().size(), 5u);
  fs::remove(folder_.path() / "calls");
  ASSERT_FALSE(read(counted + "echo part $# >&4; kill -SEGV $$")) << "nor is always another one";
  EXPECT_EQ(calls().size(), 8u);
}

TEST_F(FakeImporter, WhatKeepsTheProcessorBusyEndsByTheSizeOfTheFile) {
  const auto scene = read("while :; do :; done");
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("reading took longer than"));
  EXPECT_THAT(scene.error().message(), HasSubstr("the time for its size"));
}

TEST(ImportLimits, FollowTheSizeOfTheFile) {
  const auto limited = [](std::uintmax_t bytes, bool finer = false) {
    ImporterCall call;
    limitBySize(call, bytes, finer);
    return call;
  };
  if (HAPTICELL_SANITIZED) GTEST_SKIP() << "sanitizers have more";
  EXPECT_LT(limited(10'000).processor_seconds, 2.0);
  EXPECT_NEAR(limited(1'000'000).processor_seconds, 21.5, 0.1);
  EXPECT_EQ(limited(1'000'000'000).processor_seconds, 600.0);
  EXPECT_LT(limited(10'000).limits.bytes, std::uint64_t{2} << 30);
  EXPECT_EQ(limited(1'000'000'000).limits.bytes, std::uint64_t{6} << 30);
  EXPECT_EQ(limited(~std::uintmax_t{0}).limits.bytes, std::uint64_t{6} << 30);
  EXPECT_GT(limited(10'000, true).processor_seconds, 600.0) << "finer triangles than usual were asked for";
}

TEST_F(FakeImporter, AHangEndsWithTheTimeAllowed) {
  ImportLimits limits;
  limits.seconds = 0.2;
  const auto scene = read("exec sleep 100", limits);
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("reading took longer than"));
}

TEST_F(FakeImporter, OneThatSpeaksAndThenHangsEndsToo) {
  ImportLimits limits;
  limits.seconds = 0.3;
  EXPECT_FALSE(read(sayingProgress(0.5, "reading") + "exec sleep 100", limits));
}

TEST_F(FakeImporter, CancellingKillsIt) {
  ImportMonitor monitor;
  std::thread user([&] {
    while (monitor.progress().stage != Text("meshing")) std::this_thread::yield();
    monitor.cancel();
  });
  const auto scene = read(sayingProgress(0.7, "meshing") + "exec sleep 100", {}, &monitor);
  user.join();
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("cancelled"));
  EXPECT_DOUBLE_EQ(monitor.progress().share, 0.7);
}

TEST_F(FakeImporter, ItsOwnErrorIsPassedOn) {
  const auto scene =
      read(sayingError({.place = Text("line %1", 3), .found = "a thing", .expected = "another", .fix = "Repair it."}) +
           "; exit 1");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().place, Text("line %1", 3));
  EXPECT_EQ(english(scene.error().found), "a thing");
  EXPECT_EQ(english(scene.error().expected), "another");
  EXPECT_EQ(english(scene.error().fix), "Repair it.");
}

TEST_F(FakeImporter, RubbishInPlaceOfASceneIsRefused) {
  const auto scene = read("head -c 100000 /dev/urandom >&3; echo done >&4");
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("sent invalid data"));
  EXPECT_FALSE(read("echo done >&4"));
  EXPECT_FALSE(read("head -c 300000 /dev/zero | tr '\\0' x >&4"));
}

TEST_F(FakeImporter, ChoicesThatAreNoNumbersAreRefusedBeforeItIsStarted) {
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

TEST_F(FakeImporter, AMissingProgramIsTold) {
  ::setenv("HAPTICELL_IMPORTER", "/nowhere/hapticell-importer", 1);
  const auto scene = readScene(folder_.write("part.step", "ISO-10303-21;"), {}, nullptr);
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("hapticell-importer"));
}

}  // namespace
}  // namespace hapticell::workcell
