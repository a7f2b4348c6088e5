// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <map>
#include <optional>
#include <string>

#include "workcell/entity/import_options.h"

namespace hapticell::app {

/// How finely curved faces are meshed, relative to the size of the import.
enum class MeshQuality { kCoarse, kMedium, kFine };

/// The options of the import panel. The defaults follow the file.
struct ImportChoices {
  std::optional<double> metres_per_unit = {};
  std::optional<workcell::UpAxis> up_axis = {};
  MeshQuality quality = MeshQuality::kMedium;
  bool merge = false;                                 ///< One solid instead of the file's tree.
  std::map<std::string, std::string> arguments = {};  ///< Of a xacro, where they differ from its defaults.

  bool operator==(const ImportChoices&) const = default;
};

/// Chord error as a fraction of the diagonal, and the largest turn along an edge (rad).
struct QualityMeasure {
  double relative_chord;
  double angle;
};
QualityMeasure measureOf(MeshQuality quality);

/// The choices as options for the importer.
workcell::ImportOptions optionsOf(const ImportChoices& choices);

/// Estimate of an import with another quality, from one that was made. Growth is that of real machined parts: accurate
/// within a factor of two.
struct ImportEstimate {
  double chord = 0.0;  ///< Chord error, metres.
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
