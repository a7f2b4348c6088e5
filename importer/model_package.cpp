// SPDX-License-Identifier: Apache-2.0
#include "importer/model_package.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>

namespace hapticell::importer {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kMostBytes = std::int64_t{1} << 30;
constexpr std::int64_t kMostFold =
    200;  // Text of coordinates packs to a fifth, of a lattice to a fiftieth, blanks to a thousandth.
constexpr std::int64_t kHarmless = std::int64_t{64} << 20;

struct Closer {
  void operator()(archive* a) const { archive_read_free(a); }
};

double metresOf(const std::string& unit) {
  static const std::map<std::string, double> kUnits = {{"micron", 1e-6}, {"millimeter", 1e-3}, {"centimeter", 1e-2},
                                                       {"inch", 0.0254}, {"foot", 0.3048},     {"meter", 1.0}};
  const auto found = kUnits.find(unit);
  return found == kUnits.end() ? 1e-3 : found->second;
}

/// The unit in the beginning of the model's text.
double unitIn(archive* in) {
  std::array<char, 4096> head{};
  const la_ssize_t count = archive_read_data(in, head.data(), head.size());
  const std::string text(head.data(), static_cast<std::size_t>(std::max<la_ssize_t>(count, 0)));
  const std::size_t model = text.find("<model"), end = text.find('>', model);
  const std::size_t unit = text.find("unit=\"", model);
  if (model == std::string::npos || unit == std::string::npos || unit > end) return 1e-3;
  const std::size_t begin = unit + 6;
  return metresOf(text.substr(begin, text.find('"', begin) - begin));
}

bool leadsOut(const std::string& name) {
  if (name.starts_with('/')) return true;
  const fs::path path(name);
  return std::find(path.begin(), path.end(), "..") != path.end();
}

}  // namespace

Expected<ModelPackage> lookIntoPackage(const fs::path& file) {
  const std::unique_ptr<archive, Closer> in(archive_read_new());
  archive_read_support_format_zip(in.get());
  if (archive_read_open_filename(in.get(), file.c_str(), 65536) != ARCHIVE_OK) {
    return makeError({"", "", "no ZIP archive", "a 3MF file", "Export it again."});
  }
  std::error_code ignored;
  const auto packed = static_cast<std::int64_t>(fs::file_size(file, ignored));
  ModelPackage package;
  std::int64_t bytes = 0;
  archive_entry* entry = nullptr;
  int status = ARCHIVE_OK;
  while ((status = archive_read_next_header(in.get(), &entry)) == ARCHIVE_OK || status == ARCHIVE_WARN) {
    const char* const told = archive_entry_pathname(entry);
    const std::string name = told ? told : "";
    if (leadsOut(name) || archive_entry_filetype(entry) == AE_IFLNK) {
      return makeError(
          {"", "entry '" + name + "'", "a name or link that leads out of the archive", "files inside it", ""});
    }
    bytes += std::max<std::int64_t>(archive_entry_size(entry), 0);
    if (bytes > kMostBytes || (bytes > kHarmless && bytes > kMostFold * packed)) {
      return makeError({"", "entry '" + name + "'", "more than it may unpack to",
                        "at most 1 GB, and 200 times its own size", "Split the model, or export it again."});
    }
    if (name.ends_with(".model")) package.metres_per_unit = unitIn(in.get());
  }
  if (status != ARCHIVE_EOF) {
    const char* const why = archive_error_string(in.get());
    return makeError({"", "", why ? why : "a damaged archive", "a 3MF file", "Export it again."});
  }
  return package;
}

}  // namespace hapticell::importer
