// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/file_content.h"

#include "geometry/system/regular_file.h"

#include "workcell/text/read_record.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

Expected<std::string> readFileContent(const fs::path& path) {
  auto content = geometry::readRegularFile(path);
  if (content) ReadRecord::note(path);
  return content;
}

}  // namespace hapticell::workcell
