// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/obj_materials.h"

#include <algorithm>
#include <optional>
#include <set>

#include "workcell/text/file_content.h"
#include "workcell/text/package_path.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

// Guards memory; a material is some lines. Half, twice: no effect.
constexpr std::uintmax_t kMostMaterialBytes = std::uintmax_t{16} << 20;

std::optional<Color> readColor(TextCursor& cursor) {
  Color color{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string_view word = cursor.nextWord();
    // One number stands for all three.
    const std::optional<double> value = parseNumber(word);
    if (k > 0 && word.empty()) {
      color[k] = color[0];
      continue;
    }
    if (!value || !(*value >= 0.0) || !isUsable(*value)) return std::nullopt;
    color[k] = static_cast<float>(std::min(*value, 1.0));
  }
  return color;
}

/// The file that a name means, if it stands in or below `folder` (which is canonical).
std::optional<fs::path> find(std::string name, const fs::path& folder) {
  std::replace(name.begin(), name.end(), '\\', '/');
  const fs::path named(name);
  for (const fs::path& place : {folder / named.relative_path(), folder / named.filename()}) {
    std::error_code fault;
    if (name.find('\0') != std::string::npos || name.size() > 1000) return std::nullopt;
    const fs::path there = fs::weakly_canonical(place, fault);
    if (fault || !isBelow(there, folder) || !fs::is_regular_file(there, fault) || fault) continue;
    return there;
  }
  return std::nullopt;
}

/// A line of mtllib: one name with blanks in it, or several names.
std::vector<fs::path> filesOf(const std::string& line, const fs::path& folder, Diagnostics& diagnostics) {
  if (const auto whole = find(line, folder)) return {*whole};
  // Guards time: names in one line. Half, twice: no effect on real files.
  constexpr std::size_t kMost = 64;
  std::vector<fs::path> files;
  TextCursor words(line);
  words.nextLine();
  for (std::string_view word = words.nextWord(); !word.empty() && files.size() < kMost; word = words.nextWord()) {
    const auto file = find(std::string(word), folder);
    if (file) files.push_back(*file);
    if (!file) {
      diagnostics.warn(Text("its colours are missing: the material file %1 is not in the same folder", inQuotes(line)));
      break;
    }
  }
  return files;
}

}  // namespace

std::map<std::string, Color> parseObjMaterials(std::string_view content, Diagnostics& diagnostics) {
  std::map<std::string, Color> colors;
  TextCursor cursor(content);
  std::string material;
  std::size_t pictures = 0, unreadable = 0;
  while (cursor.nextLine()) {
    const std::string_view keyword = cursor.nextWord();
    if (keyword == "newmtl") {
      material = cursor.restOfLine();
    } else if (keyword == "Kd") {
      const auto color = readColor(cursor);
      if (color) colors.emplace(material, *color);  // The first of a name counts.
      if (!color) ++unreadable;
    } else if (keyword == "map_Kd") {
      ++pictures;
    }
  }
  if (pictures > 0) diagnostics.warn(Text("%1 materials have a texture, which is not shown", pictures));
  if (unreadable > 0) {
    diagnostics.warn(Text("%1 materials have an invalid colour (expected three numbers, 0 or more)", unreadable));
  }
  return colors;
}

std::map<std::string, Color> readObjMaterials(const fs::path& obj_file, const std::vector<std::string>& libraries,
                                              Diagnostics& diagnostics) {
  std::map<std::string, Color> colors;
  std::error_code fault;
  const fs::path folder = fs::canonical(fs::absolute(obj_file).parent_path(), fault);
  if (fault) return colors;
  std::set<fs::path> done;
  for (const std::string& line : libraries) {
    for (const fs::path& file : filesOf(line, folder, diagnostics)) {
      if (!done.insert(file).second) continue;
      if (fs::file_size(file, fault) > kMostMaterialBytes || fault) {
        diagnostics.warn(
            Text("the material file %1 is larger than 16 MB; it was not read", inQuotes(file.filename().string())));
        continue;
      }
      const auto content = readFileContent(file);
      if (content) colors.merge(parseObjMaterials(*content, diagnostics));
      if (!content) diagnostics.warn(content.error().text());
    }
  }
  return colors;
}

}  // namespace hapticell::workcell
