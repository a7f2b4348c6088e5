// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/source_format.h"

#include <cmath>

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kAxisWords = {"x", "y", "z"};  // As UpAxis.

/// Colours are kept to four decimals: 0.72, not 0.7200000286102295.
double rounded(float part) {
  return std::round(static_cast<double>(part) * 1e4) / 1e4;
}

}  // namespace

std::string relativeName(const std::string& path, const fs::path& folder) {
  const fs::path relative = fs::path(path).lexically_relative(folder);
  const std::string name = relative.empty() ? path : relative.generic_string();
  return isBuiltIn(name) ? "./" + name : name;
}

Json jsonFromColor(const std::array<float, 3>& color) {
  return {rounded(color[0]), rounded(color[1]), rounded(color[2])};
}

Json jsonFromSource(const SourceFile& source, const fs::path& folder) {
  Json json;
  json["file"] = isBuiltIn(source.path) ? source.path : relativeName(source.path, folder);
  json["scale"] = source.scale;
  if (!source.part.empty()) json["part"] = source.part;
  if (source.up_axis) json["up_axis"] = axisName(*source.up_axis);
  if (source.tessellation != Tessellation{}) {
    json["chord"] = source.tessellation.chord;
    json["angle"] = source.tessellation.angle;
  }
  if (!source.arguments.empty()) json["arguments"] = source.arguments;
  if (source.oriented) json["oriented"] = true;
  if (source.simplified > 0.0) json["simplified"] = source.simplified;
  return json;
}

/// Where a file is that may have been moved since the document was saved.
void SourceReader::locate(std::string& path) {
  if (!context_.options.locate || isBuiltIn(path)) return;
  const fs::path file = (context_.folder / path).lexically_normal();
  std::error_code ignored;
  if (fs::exists(file, ignored)) return;
  if (const auto moved = moved_folders_.find(file.parent_path()); moved != moved_folders_.end()) {
    const fs::path there = moved->second / file.filename();
    if (fs::exists(there, ignored)) {
      path = there.string();
      return;
    }
  }
  const auto [asked, is_new] = located_.try_emplace(file);
  if (is_new) asked->second = context_.options.locate(file);
  if (!asked->second) return;
  path = fs::absolute(*asked->second).string();
  moved_folders_.try_emplace(file.parent_path(), fs::path(path).parent_path());
}

void SourceReader::read(const Json& json, const Text& place, SourceFile& source) {
  FieldReader fields(json, Text("%1, \"%2\"", place, "source"), context_.error);
  int axis = -1;
  source.scale = 0.0;
  fields.require("file");
  fields.read("file", source.path);
  fields.read("scale", source.scale);
  fields.read("part", source.part);
  fields.readWord("up_axis", kAxisWords, axis);
  fields.read("chord", source.tessellation.chord);
  fields.read("angle", source.tessellation.angle);
  fields.read("arguments", source.arguments);
  fields.read("oriented", source.oriented);
  fields.read("simplified", source.simplified);
  if (context_.error) return;
  locate(source.path);
  if (axis >= 0) source.up_axis = static_cast<UpAxis>(axis);
  if (json.contains("scale") && !(source.scale >= 1e-9 && source.scale <= 1e9)) {
    fields.fail("scale", Text("out of range"), Text("metres per unit, 1e-9 to 1e9"));
  } else if (!(source.tessellation.chord >= 1e-9 && source.tessellation.chord <= 1e3)) {
    fields.fail("chord", Text("out of range"), Text("metres, 1e-9 to 1000"));
  } else if (!(source.tessellation.angle >= 1e-3 && source.tessellation.angle <= 3.0)) {
    fields.fail("angle", Text("out of range"), Text("radians, 0.001 to 3"));
  } else if (!(source.simplified >= 0.0 && source.simplified <= 1e3)) {
    fields.fail("simplified", Text("out of range"), Text("metres, 0 to 1000"));
  } else {
    fields.warnAboutOthers(context_.diagnostics);
  }
}

}  // namespace hapticell::workcell
