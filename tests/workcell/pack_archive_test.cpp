// SPDX-License-Identifier: Apache-2.0
#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/support/test_data.h"
#include "workcell/archive.h"
#include "workcell/document_io.h"
#include "workcell/entity_source.h"
#include "workcell/file_content.h"
#include "workcell/pack.h"

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

TEST(PackArchive, holdsTheDocumentAndItsFiles) {
  test::TemporaryFolder folder;
  folder.write("part.obj", kTriangle);
  Diagnostics notes;
  Document document;
  auto part = EntityLoader(folder.path()).load("part.obj", 1.0, notes);
  ASSERT_TRUE(part);
  ASSERT_TRUE(document.execute(AddEntity{*part}));
  for (const char* name : {"cell.zip", "cell.tar.gz"}) {
    const fs::path file = folder.path() / name;
    const auto packed = pack(document.state(), file, "cell.hcell", notes);
    ASSERT_TRUE(packed) << packed.error().message();
    EXPECT_EQ(packed->document, "cell.hcell");
    const auto files = contentOf(file);
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files.at("files/part.obj"), kTriangle);
    EXPECT_THAT(files.at("cell.hcell"), HasSubstr("\"file\": \"files/part.obj\""));
    const std::string first = *readFileContent(file);
    ASSERT_TRUE(pack(document.state(), file, "cell.hcell", notes));
    EXPECT_EQ(*readFileContent(file), first) << "the same cell gives the same bytes";
  }
  const auto left = std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator());
  EXPECT_EQ(left, 3) << "the part and two archives, nothing beside them";
}

TEST(PackArchive, whereItCannotBeWrittenNothingIsLeft) {
  test::TemporaryFolder folder;
  Diagnostics notes;
  EXPECT_FALSE(pack({}, folder.path() / "nowhere" / "cell.zip", "cell.hcell", notes));
  EXPECT_FALSE(writeArchive(folder.path() / "missing", folder.path() / "a.zip"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
  EXPECT_TRUE(isArchiveName("a.b.zip"));
  EXPECT_FALSE(isArchiveName("cell"));
}

}  // namespace
}  // namespace hapticell::workcell
