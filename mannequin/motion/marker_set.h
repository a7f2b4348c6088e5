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

/// Maps markers of a recording to landmarks of a body: landmark ("left_knee") to the indices of the markers whose mean
/// it is.
struct MarkerSet {
  std::string name;  ///< "Plug-in Gait", "Helen Hayes", or that of the user's table.
  std::map<std::string, std::vector<std::size_t>> markers;

  bool has(const std::string& landmark) const { return markers.contains(landmark); }
};

/// The landmarks that a figure requires: both asis, psis or the sacrum, knees, ankles, shoulders, elbows, wrists.
std::vector<std::string> missingLandmarks(const MarkerSet& set);
/// All words of a table, in the order of the documentation.
const std::vector<std::string>& landmarkNames();

/// Plug-in Gait (full body, with CMU's names for the waist too) or Helen Hayes, by the names of the markers: the set
/// that is complete, else the one with more markers. A namespace, case, blanks and points do not matter. Error:
/// required markers are missing, by their names.
Expected<MarkerSet> recogniseMarkers(const MarkerClip& clip);

/// A table of the user's own (TOML): `name`, and under `[markers]` for each landmark the name of a marker, or a list
/// whose mean is used; landmarks that are not named come from the known sets, except with `base = "none"`. Errors name
/// the line: an unknown landmark, a marker that is not in the recording, missing landmarks.
Expected<MarkerSet> readMarkerTable(const std::filesystem::path& file, const MarkerClip& clip);
Expected<MarkerSet> parseMarkerTable(std::string_view text, const std::string& name, const MarkerClip& clip);

}  // namespace hapticell::mannequin
