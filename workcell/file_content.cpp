// SPDX-License-Identifier: Apache-2.0
#include "workcell/file_content.h"

#include "geometry/regular_file.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

Expected<std::string> readFileContent(const fs::path& path) {
  return geometry::readRegularFile(path);
}

}  // namespace hapticell::workcell
