// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/archive.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "workcell/files/pack_check.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

struct Closer {
  void operator()(archive* a) const { archive_write_free(a); }
  void operator()(archive_entry* e) const { archive_entry_free(e); }
};

Expected<std::vector<fs::path>> filesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code fault;
  for (fs::recursive_directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
    if (at->is_regular_file(fault)) files.push_back(at->path());
  }
  if (fault)
    return makeError({.file = folder.string(), .found = fault.message(), .expected = "a folder that can be read"});
  std::sort(files.begin(), files.end());
  return files;
}

Error failed(const fs::path& file, archive* out) {
  const char* why = archive_error_string(out);
  return {.file = file.string(),
          .found = why ? Text(std::string(why)) : Text("it cannot be written"),
          .expected = "free space and permission to write"};
}

Expected<void> addFile(archive* out, const fs::path& file, const std::string& name) {
  std::ifstream stream(file, std::ios::binary);
  std::error_code fault;
  const std::uintmax_t size = fs::file_size(file, fault);
  if (!stream || fault) return makeError({.file = file.string(), .found = "it cannot be read", .expected = "a file"});
  const std::unique_ptr<archive_entry, Closer> entry(archive_entry_new());
  constexpr int kReadable = 0644;
  archive_entry_set_pathname(entry.get(), name.c_str());
  archive_entry_set_size(entry.get(), static_cast<la_int64_t>(size));
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), kReadable);
  if (archive_write_header(out, entry.get()) != ARCHIVE_OK) return makeError(failed(file, out));
  std::vector<char> buffer(1 << 16);
  while (stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const auto got = static_cast<std::size_t>(stream.gcount());
    if (got > 0 && archive_write_data(out, buffer.data(), got) < 0) return makeError(failed(file, out));
  }
  return {};
}

}  // namespace

bool isArchiveName(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.ends_with(".zip") || name.ends_with(".tar.gz") || name.ends_with(".tgz");
}

Expected<void> writeArchive(const fs::path& folder, const fs::path& file) {
  const auto files = filesBelow(folder);
  HAPTICELL_TRY(files);
  auto aside = AtomicFile::begin(file);
  HAPTICELL_TRY(aside);
  Expected<void> written;
  {
    const std::unique_ptr<archive, Closer> out(archive_write_new());
    if (file.extension() == ".zip") {
      archive_write_set_format_zip(out.get());
    } else {
      archive_write_add_filter_gzip(out.get());
      archive_write_set_filter_option(out.get(), "gzip", "timestamp", nullptr);  // Equal folders make equal archives.
      archive_write_set_format_pax_restricted(out.get());
    }
    if (archive_write_open_fd(out.get(), aside->descriptor()) != ARCHIVE_OK) return makeError(failed(file, out.get()));
    for (const fs::path& each : *files) {
      written = addFile(out.get(), each, each.lexically_relative(folder).generic_string());
      if (!written) break;
    }
    if (written && archive_write_close(out.get()) != ARCHIVE_OK) written = makeError(failed(file, out.get()));
  }
  if (written) {
    written = checkArchive(aside->aside(), folder);
    if (!written) written.error().file = file.string();  // The name that the user knows.
  }
  return written ? aside->commit() : written;
}

}  // namespace hapticell::workcell
