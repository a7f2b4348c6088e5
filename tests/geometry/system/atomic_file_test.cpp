// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/atomic_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <thread>

#include "geometry/system/scratch_folder.h"
#include "tests/support/test_data.h"

namespace hapticell {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

struct stat factsOf(const fs::path& path) {
  struct stat facts {};
  EXPECT_EQ(::stat(path.c_str(), &facts), 0) << path;
  return facts;
}

/// Runs `work` in a process of its own, which then kills itself without a word.
void runAndKill(const std::function<void()>& work) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    work();
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

class AtomicFileTest : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
  const fs::path& at() const { return folder_.path(); }
};

TEST_F(AtomicFileTest, HasItsNameOnlyWhenItIsWhole) {
  const fs::path path = folder_.write("a.txt", "old");
  {
    auto file = AtomicFile::begin(path);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->aside().extension(), ".txt") << "readers know a file by its extension";
    ASSERT_TRUE(file->write("ne"));
    EXPECT_EQ(contentOf(path), "old");
    ASSERT_TRUE(file->write("w"));
    ASSERT_TRUE(file->commit());
  }
  EXPECT_EQ(contentOf(path), "new");
  {
    auto given_up = AtomicFile::begin(path);
    ASSERT_TRUE(given_up);
    ASSERT_TRUE(given_up->write("part"));
  }
  EXPECT_EQ(contentOf(path), "new");
  EXPECT_THAT(namesIn(at()), ::testing::ElementsAre("a.txt"));
}

TEST_F(AtomicFileTest, KeepsRightsAndAttributesOfWhatItReplaces) {
  const fs::path path = folder_.write("a.txt", "old");
  for (const mode_t rights : {0600, 0640, 0664, 0755}) {
    ASSERT_EQ(::chmod(path.c_str(), rights), 0);
    ASSERT_TRUE(writeFileAtomically(path, "new"));
    EXPECT_EQ(factsOf(path).st_mode & 07777, rights);
  }
  if (::setxattr(path.c_str(), "user.origin", "cell", 4, 0) != 0) GTEST_SKIP() << "no attributes on this disk";
  ASSERT_TRUE(writeFileAtomically(path, "newer"));
  char value[8] = {};
  EXPECT_EQ(::getxattr(path.c_str(), "user.origin", value, sizeof value), 4);
  EXPECT_STREQ(value, "cell");
}

TEST_F(AtomicFileTest, KeepsOwnerAndGroup) {
  if (::geteuid() != 0) GTEST_SKIP() << "only the administrator may give files away";
  const fs::path path = folder_.write("a.txt", "old");
  ASSERT_EQ(::chown(path.c_str(), 12345, 23456), 0);
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  ASSERT_TRUE(writeFileAtomically(path, "new"));
  EXPECT_EQ(factsOf(path).st_uid, 12345u);
  EXPECT_EQ(factsOf(path).st_gid, 23456u);
  EXPECT_EQ(factsOf(path).st_mode & 07777, 0640u);
}

TEST_F(AtomicFileTest, AGroupThatCannotBeKeptGetsNoMoreThanAllOthers) {
  if (::geteuid() != 0) GTEST_SKIP() << "only the administrator may give files away";
  const fs::path path = folder_.write("a.txt", "old");
  ASSERT_EQ(::chown(path.c_str(), 12345, 23456), 0);
  ASSERT_EQ(::chmod(path.c_str(), 0666), 0);
  const fs::path secret = folder_.write("b.txt", "old");
  ASSERT_EQ(::chown(secret.c_str(), 12345, 23456), 0);
  ASSERT_EQ(::chmod(secret.c_str(), 0662), 0);
  ASSERT_EQ(::chmod(at().c_str(), 0777), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    if (::setgid(34567) != 0 || ::setuid(34567) != 0) ::_exit(1);
    ::_exit(writeFileAtomically(path, "new") && writeFileAtomically(secret, "new") ? 0 : 2);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(contentOf(path), "new");
  EXPECT_EQ(factsOf(path).st_uid, 34567u) << "who may not give it away owns it";
  EXPECT_EQ(factsOf(path).st_mode & 07777, 0666u);
  EXPECT_EQ(factsOf(secret).st_mode & 07777, 0622u) << "another group must not read what only the old one could";
}

TEST_F(AtomicFileTest, NewFilesHaveTheUsualRights) {
  const mode_t before = ::umask(027);
  ASSERT_TRUE(writeFileAtomically(at() / "a.txt", "new"));
  ASSERT_TRUE(writeFileAtomically(at() / "b.txt", "new", {.mode = 0600}));
  ::umask(before);
  EXPECT_EQ(factsOf(at() / "a.txt").st_mode & 07777, 0640u);
  EXPECT_EQ(factsOf(at() / "b.txt").st_mode & 07777, 0600u);
}

TEST_F(AtomicFileTest, FollowsLinksAlsoToWhatIsNotThereYet) {
  fs::create_directory(at() / "far");
  fs::create_symlink("far/a.txt", at() / "near.txt");
  fs::create_symlink("near.txt", at() / "nearer.txt");
  for (const char* content : {"first", "second"}) {
    ASSERT_TRUE(writeFileAtomically(at() / "nearer.txt", content));
    EXPECT_TRUE(fs::is_symlink(at() / "near.txt") && fs::is_symlink(at() / "nearer.txt"));
    EXPECT_EQ(contentOf(at() / "far/a.txt"), content);
  }
  fs::create_symlink("round", at() / "round");
  const auto round = writeFileAtomically(at() / "round", "x");
  ASSERT_FALSE(round);
  EXPECT_THAT(round.error().message(), ::testing::HasSubstr("refer to each other"));
}

TEST_F(AtomicFileTest, RefusesFoldersAndWriteProtectedFiles) {
  EXPECT_FALSE(writeFileAtomically(at(), "x"));
  EXPECT_FALSE(writeFileAtomically(at() / "missing/a.txt", "x"));
  if (::geteuid() == 0) GTEST_SKIP() << "the administrator may write everything";
  const fs::path path = folder_.write("a.txt", "old");
  ::chmod(path.c_str(), 0444);
  const auto written = writeFileAtomically(path, "new");
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message(), ::testing::HasSubstr("write-protected"));
  EXPECT_EQ(contentOf(path), "old");
}

TEST_F(AtomicFileTest, SeveralTakeTheirPlacesTogetherOrNot) {
  folder_.write("a.txt", "old a");
  folder_.write("b.txt", "old b");
  ASSERT_FALSE(
      writeFilesAtomically({{at() / "a.txt", "new a"}, {at() / "missing/c.txt", "c"}, {at() / "b.txt", "new b"}}));
  EXPECT_EQ(contentOf(at() / "a.txt"), "old a");
  ASSERT_TRUE(writeFilesAtomically({{at() / "a.txt", "new a"}, {at() / "b.txt", "new b"}}));
  EXPECT_EQ(contentOf(at() / "a.txt"), "new a");
  EXPECT_EQ(contentOf(at() / "b.txt"), "new b");
  EXPECT_THAT(namesIn(at()), ::testing::ElementsAre("a.txt", "b.txt"));
  std::vector<FileToWrite> many;
  for (int i = 0; i < 210; ++i) many.push_back({at() / ("many" + std::to_string(i)), std::to_string(i)});
  ASSERT_TRUE(writeFilesAtomically(many));
  EXPECT_EQ(namesIn(at()).size(), 212u);
  EXPECT_EQ(contentOf(at() / "many209"), "209");
}

TEST_F(AtomicFileTest, AFullDiskLeavesTheOldFile) {
  const fs::path path = folder_.write("a.txt", "old");
  const auto before = ::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small{100, limit.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  const auto written = writeFileAtomically(path, std::string(1000, 'x'));
  const auto several = writeFilesAtomically({{at() / "b.txt", "short"}, {path, std::string(1000, 'x')}});
  ::setrlimit(RLIMIT_FSIZE, &limit);
  ::signal(SIGXFSZ, before);
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message(), ::testing::HasSubstr("Free disk space"));
  EXPECT_FALSE(several);
  EXPECT_EQ(contentOf(path), "old");
  EXPECT_THAT(namesIn(at()), ::testing::ElementsAre("a.txt"));
  EXPECT_FALSE(writeFileAtomically("/dev/full", "x")) << "a device is written into as it is";
}

TEST_F(AtomicFileTest, TwoWritersGiveTwoWholeFilesInTurn) {
  const fs::path path = at() / "a.txt";
  const std::string first(200'000, 'a'), second(300'000, 'b');
  const auto write = [&](const std::string& content) {
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(writeFileAtomically(path, content, {.durable = false}));
  };
  std::thread other(write, std::cref(second));
  write(first);
  other.join();
  const std::string content = contentOf(path);
  EXPECT_TRUE(content == first || content == second);
  EXPECT_THAT(namesIn(at()), ::testing::ElementsAre("a.txt"));
}

TEST_F(AtomicFileTest, WhatADeadWriterLeftIsRemovedAndWhatALivingOneWritesIsNot) {
  runAndKill([&] {
    auto file = AtomicFile::begin(at() / "a.txt");
    auto folder = ScratchFolder::make(at());
    (void)file->write("part");
    std::ofstream(folder->path() / "inside") << "part";
    ::chmod(file->aside().c_str(), 0400);
    ::kill(::getpid(), SIGKILL);
  });
  folder_.write(".hapticell-notes.txt", "not ours: another name");
  folder_.write("a.hapticell-abcdef", "not ours either");
  ASSERT_EQ(namesIn(at()).size(), 4u);
  auto living = AtomicFile::begin(at() / "b.txt");
  ASSERT_TRUE(living);
  auto folder = ScratchFolder::make(at());
  ASSERT_TRUE(folder);
  removeUnfinished(at());
  EXPECT_THAT(namesIn(at()),
              ::testing::UnorderedElementsAre(".hapticell-notes.txt", "a.hapticell-abcdef",
                                              living->aside().filename().string(), folder->path().filename().string()));
  ASSERT_TRUE(living->write("whole"));
  ASSERT_TRUE(living->commit());
  EXPECT_EQ(contentOf(at() / "b.txt"), "whole");
}

TEST_F(AtomicFileTest, TheNextWriterTidies) {
  runAndKill([&] {
    auto file = AtomicFile::begin(at() / "a.txt");
    ::kill(::getpid(), SIGKILL);
  });
  ASSERT_EQ(namesIn(at()).size(), 1u);
  ASSERT_TRUE(writeFileAtomically(at() / "b.txt", "new"));
  EXPECT_THAT(namesIn(at()), ::testing::ElementsAre("b.txt"));
}

TEST_F(AtomicFileTest, AScratchFolderGoesOrGetsItsPlace) {
  {
    auto folder = ScratchFolder::make(at());
    ASSERT_TRUE(folder);
    std::ofstream(folder->path() / "inside") << "x";
  }
  EXPECT_TRUE(namesIn(at()).empty());
  fs::create_directory(at() / "empty");
  folder_.write("kept", "x");
  for (const char* place : {"new", "empty"}) {
    auto folder = ScratchFolder::make(at());
    ASSERT_TRUE(folder);
    fs::create_directory(folder->path() / "below");
    std::ofstream(folder->path() / "below/inside") << place;
    ASSERT_TRUE(folder->moveTo(at() / place));
    EXPECT_EQ(contentOf(at() / place / "below/inside"), place);
  }
  auto folder = ScratchFolder::make(at());
  ASSERT_TRUE(folder);
  EXPECT_FALSE(folder->moveTo(at() / "new")) << "it is not empty";
  EXPECT_FALSE(folder->moveTo(at() / "kept"));
  fs::create_directory(at() / "a disk's own");
  auto inside = ScratchFolder::make(at() / "a disk's own");
  ASSERT_TRUE(inside);
  fs::create_directory(inside->path() / "files");
  std::ofstream(inside->path() / "files/a") << "a";
  std::ofstream(inside->path() / "cell.hcell") << "names a";
  ASSERT_TRUE(inside->moveContentTo(at() / "a disk's own", "cell.hcell"));
  EXPECT_EQ(contentOf(at() / "a disk's own/files/a"), "a");
  EXPECT_EQ(contentOf(at() / "a disk's own/cell.hcell"), "names a");
}

}  // namespace
}  // namespace hapticell
