// SPDX-License-Identifier: Apache-2.0
#include "importer/model_package.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"
#include "importer/archive_closer.h"

namespace hapticell::importer {

namespace {

namespace fs = std::filesystem;

// 1 GB unpacked: guards memory. Half, twice: other files are refused with a message.
constexpr std::int64_t kMostBytes = std::int64_t{1} << 30;
constexpr std::int64_t kMostFold =
    200;  // Text of coordinates packs to a fifth, of a lattice to a fiftieth, blanks to a thousandth.
// 64 MB may unpack at any fold: blanks pack to a thousandth. Half, twice: small files of blanks are refused, or take
// memory.
constexpr std::int64_t kHarmless = std::int64_t{64} << 20;

/// Only what is read is kept.
bool isRead(const std::string& name) {
  const std::string lower = lowerCase(name);
  return lower.ends_with(".model") || lower == "_rels/.rels" || lower.ends_with("model_settings.config") ||
         lower.ends_with("_model.config");
}

std::string contentOf(archive* in, std::int64_t most) {
  std::string content;
  std::vector<char> block(std::size_t{1} << 20);
  for (;;) {
    const la_ssize_t count = archive_read_data(in, block.data(), block.size());
    if (count <= 0 || static_cast<std::int64_t>(content.size()) > most) return content;
    content.append(block.data(), static_cast<std::size_t>(count));
  }
}

bool leadsOut(const std::string& name) {
  if (name.starts_with('/')) return true;
  const fs::path path(name);
  return std::find(path.begin(), path.end(), "..") != path.end();
}

}  // namespace

Expected<ModelPackage> unpackModel(const fs::path& file) {
  HAPTICELL_TRY(geometry::checkRegularFile(file));
  const std::unique_ptr<archive, ArchiveCloser> in(archive_read_new());
  archive_read_support_format_zip(in.get());
  if (archive_read_open_filename(in.get(), file.c_str(), 65536) != ARCHIVE_OK) {
    return makeError({.found = "not a ZIP archive", .expected = "a 3MF file", .fix = "Export it again."});
  }
  std::error_code ignored;
  const auto packed = static_cast<std::int64_t>(fs::file_size(file, ignored));
  ModelPackage package;
  std::int64_t bytes = 0, unpacked = 0;
  archive_entry* entry = nullptr;
  int status = ARCHIVE_OK;
  while ((status = archive_read_next_header(in.get(), &entry)) == ARCHIVE_OK || status == ARCHIVE_WARN) {
    const char* const told = archive_entry_pathname(entry);
    const std::string name = told ? told : "";
    if (leadsOut(name) || archive_entry_filetype(entry) == AE_IFLNK) {
      return makeError({.place = Text("entry '%1'", name),
                        .found = "a name or link that leads out of the archive",
                        .expected = "names and links inside the archive"});
    }
    bytes += std::max<std::int64_t>(archive_entry_size(entry), 0);
    if (bytes > kMostBytes || (bytes > kHarmless && bytes > kMostFold * packed)) {
      return makeError({.place = Text("entry '%1'", name),
                        .found = "the unpacked size exceeds the limit",
                        .expected = "at most 1 GB and 200 times the packed size",
                        .fix = "Split the model, or export it again."});
    }
    if (!isRead(name)) continue;
    std::string part = contentOf(in.get(), kMostBytes);  // Whatever size it states.
    unpacked += static_cast<std::int64_t>(part.size());
    if (unpacked > kMostBytes || (unpacked > kHarmless && unpacked > kMostFold * packed)) {
      return makeError({.place = Text("entry '%1'", name),
                        .found = "the unpacked size exceeds the limit",
                        .expected = "at most 1 GB and 200 times the packed size",
                        .fix = "Split the model, or export it again."});
    }
    package.parts["/" + name] = std::move(part);
  }
  if (status != ARCHIVE_EOF) {
    const char* const why = archive_error_string(in.get());
    return makeError({.found = why ? Text(std::string(why)) : Text("a damaged archive"),
                      .expected = "a 3MF file",
                      .fix = "Export it again."});
  }
  return package;
}

}  // namespace hapticell::importer
