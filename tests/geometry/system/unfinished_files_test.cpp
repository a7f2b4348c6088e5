// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/unfinished_files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "tests/support/test_data.h"

namespace hapticell {
namespace {

namespace fs = std::filesystem;

class UnfinishedFiles : public ::testing::Test {
 protected:
  /// A file as a program leaves it that was killed while it wrote.
  fs::path left(const std::string& name) const { return folder_.write(name, "half"); }
  test::TemporaryFolder folder_;
};

TEST_F(UnfinishedFiles, WhatADeadProgramLeftIsTidiedButNothingElse) {
  const fs::path dead = left(".hapticell-aB3dE9"), dead_with_ending = left(".hapticell-aB3dE9.stl");
  const fs::path short_name = left(".hapticell-aB3"), long_name = left(".hapticell-aB3dE9x"), user = left("weld.csv");
  const fs::path visible = left("hapticell-aB3dE9"), strange = left(".hapticell-aB-dE9");
  unfinished::tidyOnce(folder_.path());
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_FALSE(fs::exists(dead_with_ending));
  for (const fs::path& kept : {short_name, long_name, user, visible, strange}) EXPECT_TRUE(fs::exists(kept)) << kept;
}

TEST_F(UnfinishedFiles, AFolderIsNotTidiedAgainAtOnce) {
  unfinished::tidyOnce(folder_.path());
  const fs::path dead = left(".hapticell-aB3dE9");
  unfinished::tidyOnce(folder_.path());
  EXPECT_TRUE(fs::exists(dead)) << "looking through a folder for each file of a thousand would take minutes";
}

TEST_F(UnfinishedFiles, WhatIsTakenStaysUntilItIsClosed) {
  const fs::path name = left(".hapticell-aB3dE9");
  const int file = ::open(name.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(file, 0);
  EXPECT_TRUE(unfinished::take(file, name));
  unfinished::tidyOnce(folder_.path());
  EXPECT_TRUE(fs::exists(name));
  const int other = ::open(name.c_str(), O_RDWR | O_CLOEXEC);
  EXPECT_FALSE(unfinished::take(other, name)) << "somebody holds it";
  ::close(file);
  EXPECT_TRUE(unfinished::take(other, name));
  ::close(other);
}

TEST_F(UnfinishedFiles, WhatHasLostItsNameCannotBeTaken) {
  const fs::path name = left(".hapticell-aB3dE9");
  const int file = ::open(name.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(file, 0);
  fs::remove(name);
  EXPECT_FALSE(unfinished::take(file, name)) << "a tidying program was quicker";
  left(".hapticell-aB3dE9");
  EXPECT_FALSE(unfinished::take(file, name)) << "another file has the name now";
  ::close(file);
}

TEST_F(UnfinishedFiles, FlushingAFolderSaysWhatTheSystemSaid) {
  EXPECT_EQ(unfinished::flushFolder(folder_.path()), 0);
  EXPECT_EQ(unfinished::flushFolder({}), 0) << "the current folder";
  EXPECT_EQ(unfinished::flushFolder(folder_.path() / "none"), ENOENT);
  EXPECT_EQ(unfinished::flushFolder(left("file")), ENOTDIR);
}

TEST_F(UnfinishedFiles, TheUsersMaskIsThatOfTheProcessAndStays) {
  const pid_t child = ::fork();  // umask() is of the whole process
  ASSERT_GE(child, 0);
  if (child == 0) {
    bool is_right = true;
    for (const mode_t mask : {mode_t{0}, mode_t{022}, mode_t{027}, mode_t{077}}) {
      ::umask(mask);
      is_right = is_right && unfinished::userMask() == mask && ::umask(mask) == mask;
    }
    ::_exit(is_right ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace hapticell
