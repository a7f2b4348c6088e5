// SPDX-License-Identifier: Apache-2.0
#include "workcell/file_content.h"

#include <fstream>

#include "workcell/read_record.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

Expected<std::string> readFileContent(const fs::path& path) {
  constexpr std::uintmax_t kLargest = 4'000'000'000;
  std::error_code fault;
  const fs::file_status status = fs::status(path, fault);
  if (!fs::exists(status)) return makeError({path.string(), "", "there is no such file", "", ""});
  if (!fs::is_regular_file(status)) {
    return makeError({path.string(), "", fs::is_directory(status) ? "a folder" : "not a regular file", "a file", ""});
  }
  const std::uintmax_t size = fs::file_size(path, fault);
  if (fault || size > kLargest) {
    return makeError(
        {path.string(), "", fault ? fault.message() : std::to_string(size) + " bytes", "at most 4 GB", ""});
  }
  std::ifstream file(path, std::ios::binary);
  std::string content(size, '\0');
  file.read(content.data(), static_cast<std::streamsize>(size));
  if (!file || file.gcount() != static_cast<std::streamsize>(size)) {
    return makeError({path.string(), "", "the file could not be read", "", "Check that you may read it."});
  }
  ReadRecord::note(path);
  return content;
}

}  // namespace hapticell::workcell
