// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/kept_result.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/support/test_data.h"
#include "workcell/text/file_content.h"

namespace hapticell::cli {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t filesIn(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// Measures the length of the file's text, which may be at most five.
Expected<Promises> lengthOf(const fs::path& written) {
  EXPECT_EQ(written.extension(), ".txt") << "readers know a file by its extension";
  Promises promises;
  promises.help = "Say less.";
  promises.list.push_back({"length", 5.0, static_cast<double>(contentOf(written).size()), "letters", "at the end"});
  return promises;
}

TEST(KeptResult, WhatKeepsItsPromiseTakesItsPlace) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "a.txt";
  nlohmann::ordered_json result;
  ASSERT_TRUE(writeKept(path.string(), "short", ".txt", false, lengthOf, result).has_value());
  EXPECT_EQ(contentOf(path), "short");
  EXPECT_EQ(result["promised"]["length"], 5.0);
  EXPECT_EQ(result["measured"]["length"], 5.0);
  EXPECT_FALSE(result.contains("missed"));
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(KeptResult, WhatMissesItLeavesNothing) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "a.txt";
  for (const bool stood : {false, true}) {
    if (stood) std::ofstream(path) << "old";
    nlohmann::ordered_json result;
    const auto written = writeKept(path.string(), "far too long", ".txt", false, lengthOf, result);
    ASSERT_FALSE(written.has_value());
    EXPECT_NE(written.error().message().find("at the end: length 12 letters; expected at most 5 letters. Say less. "
                                             "Nothing was written. To write the file anyway, use --allow-miss."),
              std::string::npos)
        << written.error().message();
    EXPECT_EQ(filesIn(folder.path()), stood ? 1u : 0u);
    EXPECT_EQ(contentOf(path), stood ? "old" : "");
  }
}

TEST(KeptResult, AllowedItIsWrittenAndSaid) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "a.txt";
  nlohmann::ordered_json result;
  ASSERT_TRUE(writeKept(path.string(), "far too long", ".txt", true, lengthOf, result).has_value());
  EXPECT_EQ(contentOf(path), "far too long");
  EXPECT_NE(result["missed"].get<std::string>().find("length 12 letters"), std::string::npos);
}

TEST(KeptResult, WithoutAPlaceItIsMeasuredAllTheSame) {
  nlohmann::ordered_json result;
  ASSERT_TRUE(writeKept("", "short", ".txt", false, lengthOf, result).has_value());
  EXPECT_EQ(result["measured"]["length"], 5.0);
  EXPECT_FALSE(writeKept("", "far too long", ".txt", false, lengthOf, result).has_value());
}

}  // namespace
}  // namespace hapticell::cli
