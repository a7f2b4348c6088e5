// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <map>
#include <optional>
#include <string>

#include "workcell/entity/import_options.h"

namespace hapticell::app {

/// How finely curved faces are cut, relative to the size of what is imported.
enum class MeshQuality { kCoarse, kMedium, kFine };

/// What the import panel lets the user choose. The defaults take a file as it says.
struct ImportChoices {
  std::optional<double> metres_per_unit = {};
  std::optional<workcell::UpAxis> up_axis = {};
  MeshQuality quality = MeshQuality::kMedium;
  bool merge = false;                                 ///< One solid instead of the file's tree.
  std::map<std::string, std::string> arguments = {};  ///< Of a xacro, where not its defaults.

  bool operator==(const ImportChoices&) const = default;
};

/// The chord's share of the diagonal, and the largest turn along an edge (rad).
struct QualityMeasure {
  double relative_chord;
  double angle;
};
QualityMeasure measureOf(MeshQuality quality);

/// For the importer.
workcell::ImportOptions optionsOf(const ImportChoices& choices);

/// What an import with another quality will make, from one that was made. Growth is that of real machined parts: within
/// a factor of two.
struct ImportEstimate {
  double chord = 0.0;  ///< Metres.
  double triangles = 0.0;
  double seconds = 0.0;
};
ImportEstimate estimate(const ImportEstimate& known, MeshQuality known_quality, MeshQuality wanted);

/// "184 000" with thin spaces.
QString countText(double count);

/// "0.4 s", "6 s", "2 min".
QString durationText(double seconds);

/// "millimetre", "inch" ...; "0.32 m" for units without a name.
QString unitText(double metres_per_unit);

/// "14.2 MB".
QString sizeText(qint64 bytes);

}  // namespace hapticell::app
