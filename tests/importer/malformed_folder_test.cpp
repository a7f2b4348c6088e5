// SPDX-License-Identifier: Apache-2.0
// Every file of tests/importer/malformed ends in one sentence that names it: no crash, no hang, no line ends, and
// nothing in the document. A new fault that somebody met becomes a file there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "tests/support/test_data.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> malformedFiles() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(test::sourceFile("tests/importer/malformed"))) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class MalformedFile : public ::testing::TestWithParam<fs::path> {};

TEST_P(MalformedFile, IsOneSentence) {
  const fs::path& file = GetParam();
  Diagnostics notes;
  std::string message;
  if (file.extension() == ".hcell") {
    const auto document = loadDocument(file, notes);
    ASSERT_FALSE(document) << "it was read";
    message = document.error().message();
  } else {
    ImportOptions options;
    options.limits.seconds = 60.0;  // Only a hang takes that long, and it would be told.
    const auto tree = EntityLoader(fs::current_path()).loadTree(file.string(), options, notes);
    ASSERT_FALSE(tree) << "it was read";
    message = tree.error().message();
  }
  EXPECT_NE(message.find(file.filename().string()), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_EQ(message.find("reading took longer than"), std::string::npos) << message;
  EXPECT_LT(message.size(), 600u) << message;
}

std::string testName(const ::testing::TestParamInfo<fs::path>& tested) {
  std::string name = tested.param.filename().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, MalformedFile, ::testing::ValuesIn(malformedFiles()), testName);

}  // namespace
}  // namespace hapticell::workcell
