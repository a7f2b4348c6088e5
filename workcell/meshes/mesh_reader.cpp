// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/mesh_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "geometry/system/assertion.h"
#include "geometry/system/file_bytes.h"
#include "geometry/system/text_case.h"
#include "workcell/meshes/length_unit.h"
#include "workcell/meshes/mesh_care.h"
#include "workcell/meshes/mesh_formats.h"
#include "workcell/meshes/obj_materials.h"
#include "workcell/text/read_record.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {

namespace {

constexpr char kReadable[] = HAPTICELL_TRANSLATED("a mesh as STL, OBJ, PLY or OFF");

bool beginsWithUtf16(std::string_view content) {
  return content.starts_with("\xFF\xFE") || content.starts_with("\xFE\xFF");
}

/// The first word of the first line that is neither empty nor a comment, within the file's beginning.
std::string_view firstWord(std::string_view content) {
  TextCursor cursor(content.substr(0, 65536));
  while (cursor.nextLine()) {
    const std::string_view word = cursor.nextWord();
    if (!word.empty() && !word.starts_with('#')) return word;
  }
  return {};
}

bool isObjKeyword(std::string_view word) {
  constexpr std::array<std::string_view, 11> kKeywords = {"v", "vn", "vt", "vp", "f",     "o",
                                                          "g", "s",  "l",  "p",  "mtllib"};
  return word == "usemtl" || std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
}

/// What an unreadable file seems to be, for the message; empty: unknown.
Text seemsToBe(std::string_view content) {
  if (content.starts_with("ISO-10303-21")) return Text("a STEP file");
  if (content.starts_with("glTF")) return Text("a glTF file");
  if (content.starts_with("PK\x03\x04")) return Text("a zip archive");
  if (content.substr(0, 4096).find("<COLLADA") != std::string_view::npos) return Text("a Collada file");
  if (content.substr(0, 4096).find("<robot") != std::string_view::npos) return Text("a URDF robot");
  if (beginsWithUtf16(content)) return Text("UTF-16 text");
  return {};
}

using Reader = Expected<RawMesh> (*)(std::string_view, Diagnostics&);

Reader readerOf(MeshFormat format) {
  switch (format) {
    case MeshFormat::kStlAscii:
      return readStlAscii;
    case MeshFormat::kStlBinary:
      return readStlBinary;
    case MeshFormat::kObj:
      return readObj;
    case MeshFormat::kPly:
      return readPly;
    case MeshFormat::kOff:
      return readOff;
    case MeshFormat::kUnknown:
      break;
  }
  return nullptr;
}

/// `assumed`: nobody said metres either.
void warnAboutUnit(const geometry::Bounds& bounds, bool assumed, Diagnostics& diagnostics) {
  const bool open = assumed && unitIsOpen(bounds);
  if (guessUnit(bounds) == LengthUnit::kMetre && !open) return;
  const dvec3 size = bounds.size();
  const double largest = std::max({size.x, size.y, size.z});
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.4g", largest);
  diagnostics.warn(
      open
          ? Text("the file has no unit; it was read in metres and measures %1 m; if it measures %1 mm, set the unit mm",
                 std::string(digits))
          : Text("the file has no unit; in metres it measures %1 m, so the unit is probably mm", std::string(digits)));
}

void warnAboutWelding(const geometry::WeldReport& weld, Diagnostics& diagnostics) {
  if (weld.degenerate_triangles > 0) {
    diagnostics.warn(Text("%1 zero-area triangles were removed", weld.degenerate_triangles));
  }
  if (weld.duplicate_triangles > 0) {
    diagnostics.warn(Text("%1 duplicate triangles were removed", weld.duplicate_triangles));
  }
}

Error named(Error error, const std::filesystem::path& name) {
  if (error.file.empty()) error.file = name.string();
  return error;
}

Error unreadable(std::string_view content) {
  if (beginsWithUtf16(content)) {
    return {.found = "the file is UTF-16 text",
            .expected = "plain text (UTF-8)",
            .fix = "Save it again as UTF-8 or ASCII."};
  }
  const Text kind = seemsToBe(content);
  return {.found = kind.empty() ? Text("content of an unknown type") : kind,
          .expected = kReadable,
          .fix = "Export it in one of these formats."};
}

Expected<geometry::FileBytes> readBytes(const std::filesystem::path& path) {
  auto content = geometry::FileBytes::read(path);
  if (content) ReadRecord::note(path);
  return content;
}

Expected<RawMesh> parseRaw(std::string_view content, const std::filesystem::path& name, MeshFormat& format,
                           Diagnostics& diagnostics) {
  if (content.empty()) return makeError({.file = name.string(), .found = "the file is empty", .expected = kReadable});
  format = probeMeshFormat(content, name.extension().string());
  const Reader reader = readerOf(format);
  if (!reader) return makeError(named(unreadable(content), name));
  Expected<RawMesh> raw = reader(content, diagnostics);
  if (!raw) return makeError(named(raw.error(), name));
  return raw;
}

double unitOf(const RawMesh& raw, const MeshReadOptions& options) {
  const double unit = options.scale.value_or(raw.metres_per_unit.value_or(1.0));
  HAPTICELL_DEMAND(unit > 0.0 && std::isfinite(unit));
  return unit;
}

/// To metres and, where asked for, welded; what welding did is added up. Corners that were shared when the file was read
/// count as merged.
void finish(geometry::TriangleMesh& mesh, double metres_per_unit, bool shared_corners, const MeshReadOptions& options,
            geometry::WeldReport& sum) {
  if (metres_per_unit != 1.0) {
    for (dvec3& vertex : mesh.vertices) vertex *= metres_per_unit;
  }
  if (!options.weld) return;
  if (shared_corners) sum.merged_vertices += static_cast<std::uint32_t>(3 * mesh.triangles.size() - mesh.vertices.size());
  const geometry::WeldReport weld = geometry::weld(mesh, geometry::weldTolerance(mesh));
  sum.merged_vertices += weld.merged_vertices;
  sum.degenerate_triangles += weld.degenerate_triangles;
  sum.duplicate_triangles += weld.duplicate_triangles;
}

/// What is read to be counted only (unwelded) is judged by who counts.
void warnAboutFacing(std::span<const geometry::TriangleMesh* const> meshes, const MeshReadOptions& options,
                     Diagnostics& diagnostics) {
  if (!options.weld) return;
  FacingNote note;
  for (const geometry::TriangleMesh* mesh : meshes) note.look(*mesh);
  note.tell(diagnostics);
}

Error nothingLeft(const std::filesystem::path& name, std::uint64_t triangles_in_file) {
  return {.file = name.string(),
          .found = triangles_in_file == 0 ? Text("the file has no triangles") : Text("only zero-area triangles"),
          .expected = "a mesh with at least one triangle"};
}

template <typename File>
bool guessIsDue(const File& file, const MeshReadOptions& options) {
  return options.warn_about_unit && file.metres_per_unit == 1.0 && !file.unit_is_stated;
}

}  // namespace

const char* formatName(MeshFormat format) {
  switch (format) {
    case MeshFormat::kStlAscii:
    case MeshFormat::kStlBinary:
      return "stl";
    case MeshFormat::kObj:
      return "obj";
    case MeshFormat::kPly:
      return "ply";
    case MeshFormat::kOff:
      return "off";
    case MeshFormat::kUnknown:
      break;
  }
  return "unknown";
}

MeshFormat probeMeshFormat(std::string_view content, std::string_view extension) {
  if (hasLengthOfBinaryStl(content)) return MeshFormat::kStlBinary;
  if (content.starts_with("ply\n") || content.starts_with("ply\r")) return MeshFormat::kPly;
  const std::string named = lowerCase(extension);
  const std::string_view word = firstWord(content);
  const bool text = !beginsWithUtf16(content) && content.substr(0, 4096).find('\0') == std::string_view::npos;
  if (!text) return named == ".stl" && !beginsWithUtf16(content) ? MeshFormat::kStlBinary : MeshFormat::kUnknown;
  if (word.ends_with("OFF") && word.size() <= 7) return MeshFormat::kOff;
  if (lowerCase(word.substr(0, 6)) == "solid") return MeshFormat::kStlAscii;
  if (isObjKeyword(word)) return MeshFormat::kObj;
  if (named == ".stl") return content.size() < 84 ? MeshFormat::kStlAscii : MeshFormat::kStlBinary;
  if (named == ".obj" && seemsToBe(content).empty()) return MeshFormat::kObj;
  return MeshFormat::kUnknown;
}

Expected<MeshFile> parseMeshFile(std::string_view content, const std::filesystem::path& name,
                                 const MeshReadOptions& options, Diagnostics& diagnostics) {
  MeshFile file;
  Expected<RawMesh> raw = parseRaw(content, name, file.format, diagnostics);
  HAPTICELL_TRY(raw);
  file.metres_per_unit = unitOf(*raw, options);
  file.unit_is_stated = raw->metres_per_unit.has_value();
  file.triangles_in_file = raw->mesh.triangles.size();
  file.mesh = std::move(raw->mesh);
  finish(file.mesh, file.metres_per_unit, raw->shared_corners, options, file.weld);
  if (file.mesh.triangles.empty()) return makeError(nothingLeft(name, file.triangles_in_file));
  warnAboutWelding(file.weld, diagnostics);
  warnAboutFacing(std::array<const geometry::TriangleMesh*, 1>{&file.mesh}, options, diagnostics);
  if (guessIsDue(file, options)) warnAboutUnit(file.mesh.bounds(), !options.scale, diagnostics);
  return file;
}

Expected<MeshFileParts> readMeshParts(const std::filesystem::path& path, const MeshReadOptions& options, bool split,
                                      Diagnostics& diagnostics) {
  Expected<geometry::FileBytes> content = readBytes(path);
  HAPTICELL_TRY(content);
  MeshFileParts file;
  Expected<RawMesh> raw = parseRaw(content->view(), path, file.format, diagnostics);
  HAPTICELL_TRY(raw);
  *content = {};
  file.metres_per_unit = unitOf(*raw, options);
  file.unit_is_stated = raw->metres_per_unit.has_value();
  file.triangles_in_file = raw->mesh.triangles.size();
  const auto materials = readObjMaterials(path, raw->material_files, diagnostics);
  const bool shared_corners = raw->shared_corners;
  file.parts = partsOf(std::move(*raw), materials, split, diagnostics);
  geometry::Bounds bounds;
  for (MeshPart& part : file.parts) {
    finish(part.mesh, file.metres_per_unit, shared_corners, options, file.weld);
    bounds.add(part.mesh.bounds());
  }
  const std::size_t gone = std::erase_if(file.parts, [](const MeshPart& part) { return part.mesh.triangles.empty(); });
  if (file.parts.empty()) return makeError(nothingLeft(path, file.triangles_in_file));
  if (gone > 0) diagnostics.warn(Text("%1 solids with only zero-area triangles were left out", gone));
  warnAboutWelding(file.weld, diagnostics);
  std::vector<const geometry::TriangleMesh*> meshes;
  for (const MeshPart& part : file.parts) meshes.push_back(&part.mesh);
  warnAboutFacing(meshes, options, diagnostics);
  if (guessIsDue(file, options)) warnAboutUnit(bounds, !options.scale, diagnostics);
  return file;
}

Expected<MeshFile> readMeshFile(const std::filesystem::path& path, const MeshReadOptions& options,
                                Diagnostics& diagnostics) {
  const Expected<geometry::FileBytes> content = readBytes(path);
  HAPTICELL_TRY(content);
  return parseMeshFile(content->view(), path, options, diagnostics);
}

Expected<geometry::TriangleMesh> readMesh(const std::filesystem::path& path, const MeshReadOptions& options,
                                          Diagnostics& diagnostics) {
  Expected<MeshFile> file = readMeshFile(path, options, diagnostics);
  HAPTICELL_TRY(file);
  return std::move(file->mesh);
}

}  // namespace hapticell::workcell
