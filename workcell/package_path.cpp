// SPDX-License-Identifier: Apache-2.0
#include "workcell/package_path.h"

#include <tinyxml.h>

#include <cstdlib>
#include <vector>

#include "workcell/file_content.h"
#include "workcell/xml_text.h"

namespace hapticell::workcell {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNeighbours = 1000;  // folders looked into for a package.xml at one level
constexpr std::uintmax_t kLargestManifest = 1 << 20;

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// A file of the package, not another one of this machine under a borrowed name: a link stays below `folder` or leads
/// to a file of the same name, as the links do that build tools of ROS 2 make.
bool isFileOfPackage(const fs::path& folder, const fs::path& rest) {
  const fs::path path = folder / rest;
  if (!isFile(path)) return false;
  std::error_code problem;
  const fs::path real = fs::canonical(path, problem);
  if (problem) return false;
  if (real.filename() == path.filename()) return true;
  const fs::path inside = real.lexically_relative(fs::canonical(folder, problem));
  return !problem && !inside.empty() && *inside.begin() != "..";
}

/// True when the folder's package.xml has <name>NAME</name>.
bool isPackage(const fs::path& folder, const std::string& name) {
  const fs::path manifest = folder / "package.xml";
  std::error_code ignored;
  if (!isFile(manifest) || fs::file_size(manifest, ignored) > kLargestManifest) return false;
  const auto content = readFileContent(manifest);
  if (!content) return false;
  TiXmlDocument document;
  document.Parse(soundXmlText(*content).text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error()) return false;
  const TiXmlElement* root = document.RootElement();
  const TiXmlElement* element = root ? root->FirstChildElement("name") : nullptr;
  const char* text = element ? element->GetText() : nullptr;
  return text && name == text;
}

/// The file `rest` of the package `name` in `folder`, or in the folder itself where that is the package.
std::optional<fs::path> findIn(const fs::path& folder, const std::string& name, const fs::path& rest) {
  if (isFileOfPackage(folder / name, rest)) return folder / name / rest;
  if ((folder.filename() == name || isPackage(folder, name)) && isFileOfPackage(folder, rest)) return folder / rest;
  std::error_code problem;
  std::size_t seen = 0;
  for (fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, problem), end;
       !problem && entry != end && ++seen <= kMostNeighbours; entry.increment(problem)) {
    if (isFile(entry->path() / rest) && isPackage(entry->path(), name) && isFileOfPackage(entry->path(), rest))
      return entry->path() / rest;
  }
  return std::nullopt;
}

std::vector<fs::path> foldersOf(const char* variable, const fs::path& below) {
  std::vector<fs::path> folders;
  const char* value = std::getenv(variable);
  const std::string text = value ? value : "";
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    if (end > begin) folders.push_back(fs::path(text.substr(begin, end - begin)) / below);
    begin = end + 1;
  }
  return folders;
}

std::optional<fs::path> findInPackage(const std::string& name, const fs::path& rest, const fs::path& start) {
  std::vector<fs::path> folders;
  for (fs::path folder = start;; folder = folder.parent_path()) {
    folders.push_back(folder);
    if (folder == folder.parent_path()) break;
  }
  for (const fs::path& folder : foldersOf("ROS_PACKAGE_PATH", {})) folders.push_back(folder);
  for (const fs::path& folder : foldersOf("AMENT_PREFIX_PATH", "share")) folders.push_back(folder);
  for (const fs::path& folder : folders) {
    if (auto found = findIn(folder, name, rest)) return found->lexically_normal();
  }
  return std::nullopt;
}

}  // namespace

bool leavesPackage(const std::string& uri) {
  for (const std::string scheme : {"package://", "model://"}) {
    if (!uri.starts_with(scheme)) continue;
    const fs::path named = uri.substr(scheme.size());
    int depth = 0;  // Below the folder that holds the packages.
    for (const fs::path& step : named) {
      if (step == "..") {
        if (--depth < 1) return true;
      } else if (step != "." && !step.empty()) {
        ++depth;
      }
    }
    return named.begin() != named.end() && (*named.begin() == "." || *named.begin() == "..");
  }
  return false;
}

std::optional<fs::path> resolveMeshPath(const std::string& uri, const fs::path& description_folder) {
  std::error_code problem;
  const fs::path start = fs::absolute(description_folder, problem).lexically_normal();
  for (const std::string scheme : {"package://", "model://"}) {
    if (!uri.starts_with(scheme)) continue;
    const std::string tail = uri.substr(scheme.size());
    const std::size_t slash = tail.find('/');
    if (slash == std::string::npos || slash == 0 || leavesPackage(uri)) return std::nullopt;
    return findInPackage(tail.substr(0, slash), tail.substr(slash + 1), start);
  }
  const std::string plain = uri.starts_with("file://") ? uri.substr(7) : uri;
  const fs::path path = (start / plain).lexically_normal();  // an absolute right side stands alone
  return isFile(path) ? std::optional(path) : std::nullopt;
}

}  // namespace hapticell::workcell
