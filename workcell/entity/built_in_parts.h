// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/entity/entity.h"

namespace hapticell::workcell {

/// One size of a built-in part, metres.
struct PartSize {
  const char* name;  ///< "width"
  double standard;   ///< Taken where no sizes are given.
  double least;      ///< Smaller ones are refused: its legs or bars would not fit.
};

/// A solid that is made from its sizes: a plain shape (box, cylinder, ...), or common equipment (table, fence, pallet,
/// ...). A source names it as "SCHEME:SIZE,SIZE,...", e.g. "table:1.2,0.8,0.75"; "table:" has the standard sizes.
/// Meshes are watertight, body by body.
struct BuiltInPart {
  /// Where its origin is.
  enum class Origin {
    kMiddle,  ///< Plain shapes.
    kFloor,   ///< In the middle of its footprint, z up: at z = 0 it is on the floor.
    kFlange,  ///< Parts mounted on a robot: the middle of its mounting face, z out of the flange.
  };
  const char* scheme;
  std::span<const PartSize> sizes;
  Origin origin;
  std::array<float, 3> color;
  geometry::TriangleMesh (*make)(std::span<const double> sizes);
};

/// All of them, plain shapes first.
std::span<const BuiltInPart> builtInParts();

/// The one of that scheme, or null.
const BuiltInPart* findBuiltInPart(std::string_view scheme);

/// "bench:1.2,0.8,0.95"; sizes in metres.
std::string partSource(const BuiltInPart& part, const std::vector<double>& sizes);

/// The sizes of the part that a source names, metres; empty where it names none.
std::vector<double> partSizes(const SourceFile& source);

/// The solid of a source such as "fence:2,1.8": named by its scheme, with shape, colour and source. `scale`: metres per
/// unit of the sizes. An error where the sizes cannot be used; it says which are expected.
Expected<Entity> makeBuiltInPart(const std::string& what, double scale);

}  // namespace hapticell::workcell
