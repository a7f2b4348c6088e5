// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/named_files.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "geometry/system/text_case.h"
#include "workcell/text/file_content.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {

namespace {

namespace fs = std::filesystem;

// Guards time and memory of a pack. Half, twice: larger packs lack files, or take longer.
constexpr std::size_t kMostFiles = 10'000;

bool isStep(const fs::path& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".step" || extension == ".stp" || extension == ".p21";
}

bool isText(const fs::path& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".obj" || extension == ".gltf" || isStep(file);
}

std::vector<std::string> materialLibraries(std::string_view content) {
  std::vector<std::string> names;
  TextCursor cursor(content);
  while (cursor.nextLine()) {
    if (cursor.nextWord() != "mtllib") continue;
    const std::string_view line = cursor.restOfLine();
    names.emplace_back(line);  // One name with blanks in it, or several.
    TextCursor words(line);
    words.nextLine();
    for (auto word = words.nextWord(); !word.empty(); word = words.nextWord()) names.emplace_back(word);
  }
  return names;
}

/// Texts between `quote`s that look like names of files.
std::vector<std::string> quotedNames(std::string_view content, char quote) {
  // Bytes: longer texts are no names of files; a step of a path has 255 at most. Half, twice: no effect on real files.
  constexpr std::size_t kLongest = 1000;
  std::vector<std::string> names;
  for (std::size_t begin = content.find(quote); begin != std::string_view::npos;) {
    const std::size_t end = content.find(quote, begin + 1);
    if (end == std::string_view::npos) break;
    const std::string_view text = content.substr(begin + 1, end - begin - 1);
    if (text.size() < kLongest && text.find('.') != std::string_view::npos) names.emplace_back(text);
    begin = content.find(quote, end + 1);
  }
  return names;
}

std::vector<std::string> namesIn(const fs::path& file) {
  const auto content = readFileContent(file);
  if (!content) return {};
  if (lowerExtension(file) == ".obj") return materialLibraries(*content);
  if (lowerExtension(file) == ".gltf") return quotedNames(*content, '"');
  std::vector<std::string> names = quotedNames(*content, '\'');
  std::erase_if(names, [](const std::string& name) { return !isStep(name); });
  return names;
}

void collect(const fs::path& file, const fs::path& folder, std::set<fs::path>& found) {
  for (std::string name : namesIn(file)) {
    if (found.size() >= kMostFiles || name.find('\0') != std::string::npos) return;
    std::replace(name.begin(), name.end(), '\\', '/');
    const fs::path relative = fs::path(name).lexically_normal();
    if (relative.empty() || relative.is_absolute() || *relative.begin() == "..") continue;
    const fs::path there = (file.parent_path() / relative).lexically_normal();
    std::error_code fault;
    const fs::path below = there.lexically_relative(folder);
    if (below.empty() || *below.begin() == ".." || !fs::is_regular_file(there, fault)) continue;
    if (found.insert(there).second && isText(there)) collect(there, folder, found);
  }
}

}  // namespace

std::vector<fs::path> filesNamedIn(const fs::path& file) {
  if (!isText(file)) return {};
  const fs::path whole = fs::absolute(file).lexically_normal();
  std::set<fs::path> found{whole};
  collect(whole, whole.parent_path(), found);
  found.erase(whole);
  return {found.begin(), found.end()};
}

}  // namespace hapticell::workcell
