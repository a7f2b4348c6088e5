// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/shapes/vector.h"
#include "geometry/system/error.h"
#include "mannequin/motion/up_axis.h"

namespace hapticell::mannequin {

/// Recorded positions of markers on a body or a part: metres, z up.
struct MarkerClip {
  std::vector<std::string> names;            ///< One a marker, as the file has them; "marker 7" where it has none.
  std::vector<std::optional<dvec3>> places;  ///< Frame by frame; empty if the cameras did not see a marker.
  double frame_time = 1.0 / 120.0;           ///< s
  double metres_per_unit = 1e-3;             ///< Of the file.
  UpAxis up = UpAxis::kZ;                    ///< Which of the file's axes became z.
  std::vector<Text> warnings;                ///< Assumptions and contradictions in the file, one sentence each.

  std::size_t frames() const { return names.empty() ? 0 : places.size() / names.size(); }
  double seconds() const { return static_cast<double>(frames()) * frame_time; }
  const std::optional<dvec3>& at(std::size_t frame, std::size_t marker) const {
    return places[frame * names.size() + marker];
  }
  /// Share of the frames in which the marker was visible, 0 to 1.
  double seenShare(std::size_t marker) const;
};

/// Reads C3D (the C3D File Format user guide, c3d.org): numbers of Intel, DEC and MIPS processors, integer or real
/// points; analog channels are skipped. If header and parameters disagree on counts, places or scale, the size of the
/// file decides (c3d_layout.h); a truncated unit ("mete") is completed. Up is `up` if it is given; else the axis along
/// which head and shoulders are above pelvis and feet, by the usual names of the markers; else POINT:Y_SCREEN; else the
/// longest side of all markers; else z. Every choice gives a warning. Errors name the byte: truncated files and files
/// without points.
Expected<MarkerClip> parseC3d(std::string_view bytes, const std::string& name, std::optional<UpAxis> up = {});
/// The same for a file of at most 1 GB.
Expected<MarkerClip> readC3d(const std::filesystem::path& file, std::optional<UpAxis> up = {});

}  // namespace hapticell::mannequin
