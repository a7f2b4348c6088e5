// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"
#include "mannequin/motion/marker_clip.h"

namespace hapticell::mannequin {

/// Which markers of a recording sit on which landmarks of a body: landmark ("left_knee") to indices of markers, whose
/// middle it is.
struct MarkerSet {
  std::string name;  ///< "Plug-in Gait", "Helen Hayes", or that of the user's table.
  std::map<std::string, std::vector<std::size_t>> markers;

  bool has(const std::string& landmark) const { return markers.contains(landmark); }
};

/// The landmarks that a figure cannot do without: both asis, psis or the sacrum, knees, ankles, shoulders, elbows,
/// wrists.
std::vector<std::string> missingLandmarks(const MarkerSet& set);
/// All words of a table, in the order of the documentation.
const std::vector<std::string>& landmarkNames();

/// Plug-in Gait (full body, CMU's names for the waist too) or Helen Hayes, by the markers' names: whichever is there
/// wholly, else whichever is there more. A namespace, small letters, blanks and points do not matter. Error: markers
/// that a figure needs are missing, by their names.
Expected<MarkerSet> recogniseMarkers(const MarkerClip& clip);

/// A table of the user's own (TOML): `name`, and under `[markers]` a marker's name, or a list whose middle counts, for
/// each landmark; what it does not name comes from the sets that are known, with `base = "none"` nothing does. Errors
/// name the line: a landmark that there is not, a marker that is not in the recording, landmarks that are missing.
Expected<MarkerSet> readMarkerTable(const std::filesystem::path& file, const MarkerClip& clip);
Expected<MarkerSet> parseMarkerTable(std::string_view text, const std::string& name, const MarkerClip& clip);

}  // namespace hapticell::mannequin
