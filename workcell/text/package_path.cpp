// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/package_path.h"

#include <tinyxml.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>
#include <vector>

#include "geometry/system/nesting_limit.h"
#include "workcell/text/file_content.h"
#include "workcell/text/xml_text.h"

namespace hapticell::workcell {

namespace {

namespace fs = std::filesystem;

// Folders looked into for a package.xml at one level: guards time in a home folder. Half, twice: packages among more
// are not found, or time.
constexpr std::size_t kMostNeighbours = 1000;
// 1 MB: guards memory; a manifest is some kB. Half, twice: no effect.
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
  if (!geometry::checkNesting(*content, geometry::NestedText::kXml, manifest.string())) return false;
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

/// The folder of the description and those above it.
std::vector<fs::path> foldersAbove(const fs::path& start) {
  std::vector<fs::path> folders;
  for (fs::path folder = start;; folder = folder.parent_path()) {
    folders.push_back(folder);
    if (folder == folder.parent_path()) return folders;
  }
}

std::optional<fs::path> findInPackage(const std::string& name, const fs::path& rest, std::vector<fs::path> folders) {
  for (const fs::path& folder : foldersOf("ROS_PACKAGE_PATH", {})) folders.push_back(folder);
  for (const fs::path& folder : foldersOf("AMENT_PREFIX_PATH", "share")) folders.push_back(folder);
  for (const fs::path& folder : folders) {
    if (auto found = findIn(folder, name, rest)) return found->lexically_normal();
  }
  return std::nullopt;
}

/// "abb-irb2400_Main" begins with "abb_irb2400" but for case and dashes.
bool beginsWith(const std::string& folder, const std::string& name) {
  const auto plain = [](char c) {
    return c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  };
  return folder.size() >= name.size() &&
         std::equal(name.begin(), name.end(), folder.begin(), [&](char a, char b) { return plain(a) == plain(b); });
}

/// A folder beside `folder`'s children whose name begins with the package's.
std::optional<fs::path> folderLike(const std::string& name, const fs::path& rest, const fs::path& folder) {
  std::vector<fs::path> like;
  std::error_code problem;
  std::size_t seen = 0;
  for (fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, problem), end;
       !problem && entry != end && ++seen <= kMostNeighbours; entry.increment(problem)) {
    if (beginsWith(entry->path().filename().string(), name) && isFileOfPackage(entry->path(), rest))
      like.push_back(entry->path());
  }
  if (like.empty()) return std::nullopt;
  return *std::min_element(like.begin(), like.end());
}

/// A folder under any name that holds the rest of the path. Not looked for near the root of the file system, where any
/// path fits something.
std::optional<FoundFile> findUnderAnyName(const std::string& name, fs::path rest,
                                          const std::vector<fs::path>& folders) {
  // Levels of folders upwards in which a package is looked for; our choice. Half: meshes deep in a workspace are not
  // found; twice: folders of other things are looked into.
  constexpr std::size_t kLevels = 5;
  // Steps of a path: "/", "home", "user" are no packages. Not tuned.
  constexpr std::ptrdiff_t kNearRoot = 3;  // "/", "home", "user"
  for (bool whole = true; std::distance(rest.begin(), rest.end()) >= (whole ? 1 : 2); whole = false) {
    for (std::size_t i = 0; i < std::min(kLevels, folders.size()); ++i) {
      const bool near_root = std::distance(folders[i].begin(), folders[i].end()) <= kNearRoot;
      if (!near_root && std::distance(rest.begin(), rest.end()) >= 2 && isFileOfPackage(folders[i], rest))
        return FoundFile{(folders[i] / rest).lexically_normal(), folders[i]};
      if (const auto like = whole ? folderLike(name, rest, folders[i]) : std::nullopt)
        return FoundFile{(*like / rest).lexically_normal(), *like};
    }
    rest = rest.lexically_relative(*rest.begin());
  }
  return std::nullopt;
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const int letter = std::tolower(static_cast<unsigned char>(c));
  return letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
}

/// The reference as it is written, decoded, and with slashes for backslashes, each once.
std::vector<std::string> spellingsOf(const std::string& uri) {
  std::vector<std::string> spellings = {uri};
  const auto add = [&spellings](std::string text) {
    if (std::find(spellings.begin(), spellings.end(), text) == spellings.end()) spellings.push_back(std::move(text));
  };
  add(percentDecoded(uri));
  std::string slashes = percentDecoded(uri);
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  add(std::move(slashes));
  return spellings;
}

/// Without "file://" and, as some write it, a host.
std::string withoutFileScheme(const std::string& uri) {
  if (!uri.starts_with("file:")) return uri;
  std::string rest = uri.substr(uri.starts_with("file://") ? 7 : 5);
  if (rest.starts_with("localhost/")) rest.erase(0, 9);
  if (rest.starts_with("/package://") || rest.starts_with("/model://")) rest.erase(0, 1);  // file:///$(find NAME)
  return rest;
}

/// Of "package://NAME/rest" and "model://NAME/rest".
std::optional<std::pair<std::string, fs::path>> packageAndRest(const std::string& uri) {
  for (const std::string scheme : {"package://", "model://"}) {
    const std::string tail = uri.starts_with(scheme) ? uri.substr(scheme.size()) : "";
    const std::size_t slash = tail.find('/');
    if (slash != std::string::npos && slash > 0)
      return std::pair(tail.substr(0, slash), fs::path(tail.substr(slash + 1)).relative_path());
  }
  return std::nullopt;
}

}  // namespace

std::string percentDecoded(const std::string& text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? hexDigit(text[i + 1]) : -1;
    const int low = high >= 0 ? hexDigit(text[i + 2]) : -1;
    if (low < 0 || high * 16 + low == 0) {
      decoded += text[i];
      continue;
    }
    decoded += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return decoded;
}

bool leavesPackage(const std::string& written) {
  const std::string uri = percentDecoded(withoutFileScheme(written));
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

std::optional<FoundFile> findReference(const std::string& uri, const fs::path& description_folder) {
  std::error_code problem;
  const fs::path start = fs::absolute(description_folder, problem).lexically_normal();
  const std::vector<fs::path> folders = foldersAbove(start);
  const std::vector<std::string> spellings = spellingsOf(withoutFileScheme(uri));
  bool is_package = false;
  for (const std::string& spelling : spellings) {
    const auto name = packageAndRest(spelling);
    is_package = is_package || name || leavesPackage(spelling);
    if (name && !leavesPackage(spelling)) {
      if (auto found = findInPackage(name->first, name->second, folders)) return FoundFile{*found, {}};
    } else if (!is_package) {
      const fs::path path = (start / spelling).lexically_normal();  // An absolute right side stands alone.
      if (isFile(path)) return FoundFile{path, {}};
    }
  }
  for (const std::string& spelling : spellings) {
    const auto name = packageAndRest(spelling);
    if (!name || leavesPackage(spelling)) continue;
    if (auto found = findUnderAnyName(name->first, name->second.lexically_normal(), folders)) return found;
  }
  return std::nullopt;
}

bool isBelow(const fs::path& file, const fs::path& folder) {
  const fs::path relative = file.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

Text takenForPackage(const std::string& uri, const FoundFile& found) {
  return Text("the package of %1 is not found by name; the folder %2 is used, because it contains the rest of the path",
              uri, found.taken_for_package.string());
}

}  // namespace hapticell::workcell
