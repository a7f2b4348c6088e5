// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"
#include "geometry/shapes/triangle_mesh.h"
#include "workcell/meshes/mesh_parts.h"

namespace hapticell::workcell {

enum class MeshFormat { kUnknown, kStlAscii, kStlBinary, kObj, kPly, kOff };

/// "stl", "obj", "ply", "off" or "unknown".
const char* formatName(MeshFormat format);

struct MeshReadOptions {
  /// Metres per unit of the file, positive. Empty: as a comment of the file states it (statedUnit()), else 1: the
  /// formats have no field for it.
  std::optional<double> scale = {};
  bool weld = true;  ///< Merge corners and drop degenerate and duplicate triangles (geometry::weld).
  /// Warn where no unit is stated, it is read in metres and the size makes millimetres likely (guessUnit) or leaves
  /// both open (unitIsOpen).
  bool warn_about_unit = true;
};

/// A mesh as read, with the messages about the file.
struct MeshFile {
  geometry::TriangleMesh mesh;  ///< Metres, in the file's own frame; indices valid, coordinates finite.
  MeshFormat format = MeshFormat::kUnknown;
  std::uint64_t triangles_in_file = 0;  ///< Before welding; polygons count as their triangles.
  geometry::WeldReport weld;
  double metres_per_unit = 1.0;  ///< As it was read.
  bool unit_is_stated = false;   ///< The file says it, whatever it was read in.
};

/// The same as solids with their names and colours, at least one; each is welded by itself.
struct MeshFileParts {
  std::vector<MeshPart> parts;
  MeshFormat format = MeshFormat::kUnknown;
  std::uint64_t triangles_in_file = 0;
  geometry::WeldReport weld;  ///< Of all.
  double metres_per_unit = 1.0;
  bool unit_is_stated = false;
};

/// Detects the format from the file's content, not its name. A binary STL is known by its length (84 + 50 bytes a
/// triangle), so a header that begins with "solid" does not mislead. `extension` (".obj", any case) only decides where
/// the content leaves it open.
MeshFormat probeMeshFormat(std::string_view content, std::string_view extension);

/// Reads STL (ASCII, binary), OBJ, PLY (ASCII, binary of either byte order) or OFF. Polygons are cut into triangles,
/// several objects of a file become one mesh, normals are not read.
///
/// Errors (never a crash, a hang, or an allocation that the file's length does not justify): not a regular file, empty,
/// over 4 GB, unknown format, truncated, a count that does not match, an index out of range, a coordinate that is not
/// finite or beyond 1e12, UTF-16 text, no triangles. Each names line or triangle. What was dropped or guessed goes to
/// `diagnostics`. Independent of the locale. Any thread.
Expected<MeshFile> readMeshFile(const std::filesystem::path& path, const MeshReadOptions& options,
                                Diagnostics& diagnostics);

/// The solids of the file with names and colours, those of an OBJ file's material libraries beside it too
/// (readObjMaterials()); `split` false: one solid. A library that is missing is a warning. Errors as readMeshFile(). A
/// part that is empty after welding is left out and reported.
Expected<MeshFileParts> readMeshParts(const std::filesystem::path& path, const MeshReadOptions& options, bool split,
                                      Diagnostics& diagnostics);

/// The mesh alone.
Expected<geometry::TriangleMesh> readMesh(const std::filesystem::path& path, const MeshReadOptions& options,
                                          Diagnostics& diagnostics);

/// The same from memory; Messages use `name`; its extension helps to detect the format.
Expected<MeshFile> parseMeshFile(std::string_view content, const std::filesystem::path& name,
                                 const MeshReadOptions& options, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
