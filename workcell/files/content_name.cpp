// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/content_name.h"

#include <span>

#include "collision/trees/cache_file.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {

std::string contentName(std::string_view bytes) {
  collision::ContentHash hash{};
  collision::addToHash(hash, std::as_bytes(std::span(bytes)));
  return collision::nameOf(hash);
}

std::string contentNameOf(const std::filesystem::path& file) {
  const auto bytes = readFileContent(file);
  return bytes ? contentName(*bytes) : std::string();
}

bool changedOnDisk(const std::filesystem::path& file, const std::string& known) {
  if (known.empty()) return false;
  const std::string now = contentNameOf(file);
  return !now.empty() && now != known;
}

}  // namespace hapticell::workcell
