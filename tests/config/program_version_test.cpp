// SPDX-License-Identifier: Apache-2.0
#include "config/program_version.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace hapticell::config {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(ProgramVersion, SaysProgramCommitCompilerAndLibrariesALineEach) {
  const std::string text = versionText("a-program", {{"one", "1.2"}, {"two", "3"}});
  const std::vector<std::string> lines = linesOf(text);
  ASSERT_EQ(lines.size(), 4u) << text;
  EXPECT_NE(text.back(), '\n');
  EXPECT_TRUE(lines[0].starts_with("a-program ") && std::isdigit(static_cast<unsigned char>(lines[0].back()))) << lines[0];
  EXPECT_EQ(lines[1], "commit: " + std::string(builtCommit()));
  EXPECT_TRUE(lines[2].starts_with("compiler: ")) << lines[2];
#ifdef __clang__
  const std::string version = std::to_string(__clang_major__);
#else
  const std::string version = std::to_string(__GNUC__);
#endif
  EXPECT_NE(lines[2].find(version), std::string::npos) << lines[2];
  EXPECT_EQ(lines[3], "libraries: one 1.2, two 3");
  EXPECT_EQ(linesOf(versionText("a-program", {})).size(), 3u);
}

TEST(ProgramVersion, TheCommitHasTwelveDigitsOrIsUnknown) {
  const std::string_view commit = builtCommit();
  if (commit == "unknown") return;
  ASSERT_GE(commit.size(), 12u);
  EXPECT_TRUE(std::all_of(commit.begin(), commit.begin() + 12, [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0 || (c >= 'a' && c <= 'f');
  })) << commit;
}

}  // namespace
}  // namespace hapticell::config
