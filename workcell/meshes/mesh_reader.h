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
  /// Metres per unit of the file, positive. Empty: as stated by a comment of the file (statedUnit()), else 1: the
  /// formats have no field for it.
  std::optional<double> scale = {};
  bool weld = true;  ///< Merge corners and drop degenerate and duplicate triangles (geometry::weld).
  /// Warns if no unit is stated, the file is read in metres and the size makes millimetres likely (guessUnit) or leaves
  /// both open (unitIsOpen).
  bool warn_about_unit = true;
};

/// A mesh as read, with the messages about the file.
struct MeshFile {
  geometry::TriangleMesh mesh;  ///< Metres, in the file's own frame; indices valid, coordinates finite.
  MeshFormat format = MeshFormat::kUnknown;
  std::uint64_t triangles_in_file = 0;  ///< Before welding; polygons count as their triangles.
  geometry::WeldReport weld;
  double metres_per_unit = 1.0;  ///< As used for reading.
  bool unit_is_stated = false;   ///< The file states its unit, whatever unit was used for reading.
};

/// The same as solids with their names and colours, at least one; each is welded separately.
struct MeshFileParts {
  std::vector<MeshPart> parts;
  MeshFormat format = MeshFormat::kUnknown;
  std::uint64_t triangles_in_file = 0;
  geometry::WeldReport weld;  ///< Of all.
  double metres_per_unit = 1.0;
  bool unit_is_stated = false;
};

/// Detects the format from the file's content, not its name. A binary STL is recognised by its length (84 bytes plus 50
/// per triangle), so that a header that begins with "solid" does not mislead. `extension` (".obj", any case) only
/// matters if the content does not decide.
MeshFormat probeMeshFormat(std::string_view content, std::string_view extension);

/// Reads STL (ASCII, binary), OBJ, PLY (ASCII, binary in either byte order) or OFF. Splits polygons into triangles, and
/// makes one mesh of all objects in a file; ignores normals.
///
/// Errors (never a crash, a hang, or an allocation that the file's length does not justify): not a regular file, empty,
/// over 4 GB, unknown format, truncated, a count that does not match, an index out of range, a coordinate that is not
/// finite or beyond 1e12, UTF-16 text, no triangles. Each names line or triangle. Reports what was dropped or guessed
/// in `diagnostics`. Independent of the locale. Any thread.
Expected<MeshFile> readMeshFile(const std::filesystem::path& path, const MeshReadOptions& options,
                                Diagnostics& diagnostics);

/// The solids of the file with names and colours, including the colours of an OBJ file's material libraries next to it
/// (readObjMaterials()); without `split`, one solid. A missing library is a warning. Errors as for readMeshFile().
/// Leaves out parts that are empty after welding, and reports them.
Expected<MeshFileParts> readMeshParts(const std::filesystem::path& path, const MeshReadOptions& options, bool split,
                                      Diagnostics& diagnostics);

/// Only the mesh.
Expected<geometry::TriangleMesh> readMesh(const std::filesystem::path& path, const MeshReadOptions& options,
                                          Diagnostics& diagnostics);

/// The same from memory. Messages use `name`; its extension helps to detect the format.
Expected<MeshFile> parseMeshFile(std::string_view content, const std::filesystem::path& name,
                                 const MeshReadOptions& options, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
