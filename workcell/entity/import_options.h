// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::workcell {

/// The axis of a file that points up in the workcell (whose own up axis is z).
enum class UpAxis { kX, kY, kZ };

/// "x", "y" or "z".
const char* axisName(UpAxis axis);
Expected<UpAxis> parseAxis(std::string_view text);

/// How finely curved faces (STEP, IGES) are cut into triangles.
struct Tessellation {
  double chord =
      1e-4;            ///< Metres: farthest distance of a triangle from the true face. Raised to 1e-5 of a part's size.
  double angle = 0.3;  ///< Radians: largest turn of the normal along one edge.

  bool operator==(const Tessellation&) const = default;
};

/// What the importer's process may use. Beyond it, the import ends with a sentence.
struct ImportLimits {
  double seconds = 600.0;
  std::uint64_t bytes = std::uint64_t{6} << 30;  ///< Address space of the process.
};

/// What the user can choose before an import. The defaults take everything as the file says it.
struct ImportOptions {
  /// Metres per unit of the file. Empty: as the file says; metres where it names none (robots, meshes).
  std::optional<double> metres_per_unit = {};
  /// Empty: as the file says; z where it names none.
  std::optional<UpAxis> up_axis = {};
  Tessellation tessellation = {};
  /// Above 0: the chord is this share of the diagonal of the whole file, instead of `tessellation.chord`.
  double relative_chord = 0.0;
  bool merge = false;           ///< One solid instead of the file's tree.
  bool weld = true;             ///< Merge corners, drop degenerate and duplicate triangles (geometry::weld).
  bool warn_about_unit = true;  ///< Tell where the size of a file without unit makes another one likely.
  ImportLimits limits = {};
  std::map<std::string, std::string> arguments = {};  ///< Values of a xacro's arguments by name.
};

}  // namespace hapticell::workcell
