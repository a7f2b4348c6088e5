// SPDX-License-Identifier: Apache-2.0
#include "config/program_folders.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hapticell::config {
namespace {

namespace fs = std::filesystem;

TEST(ProgramFolders, BeginWithThatOfTheRunningProgramAndNameEachOnce) {
  const std::vector<fs::path> folders = programFolders();
  ASSERT_FALSE(folders.empty());
  EXPECT_EQ(folders.front(), fs::read_symlink("/proc/self/exe").parent_path());
  for (const fs::path& folder : folders) {
    EXPECT_TRUE(folder.is_absolute() && fs::is_directory(folder)) << folder;
    EXPECT_EQ(std::count(folders.begin(), folders.end(), folder), 1) << folder;
  }
}

}  // namespace
}  // namespace hapticell::config
