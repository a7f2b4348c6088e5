// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "xacro/expand.h"

namespace hapticell::workcell {

/// Origin of the lines of a URDF text: in the file, or in the files that a xacro was made of.
class UrdfLines {
 public:
  /// `places` (may be null) must outlive it: one for each line of the text.
  explicit UrdfLines(std::string file, const std::vector<xacro::Expanded::Place>* places = nullptr)
      : file_(std::move(file)), places_(places) {}

  const std::string& file() const { return file_; }
  /// "line 12", or "arm_macro.xacro, line 12" where it is another file's; line 0: empty.
  std::string words(int line) const {
    const xacro::Expanded::Place* place = placeOf(line);
    if (!place) return line > 0 ? "line " + std::to_string(line) : "";
    const std::string own = "line " + std::to_string(place->line);
    return place->file == file_ ? own : std::filesystem::path(place->file).filename().string() + ", " + own;
  }
  tl::unexpected<Error> refuse(int line, std::string found, std::string expected, std::string fix = {}) const {
    const xacro::Expanded::Place* place = placeOf(line);
    const int shown = place ? place->line : line;
    return makeError({.file = place ? place->file : file_,
                      .place = shown > 0 ? "line " + std::to_string(shown) : "",
                      .found = std::move(found),
                      .expected = std::move(expected),
                      .fix = std::move(fix)});
  }

 private:
  std::string file_;
  const std::vector<xacro::Expanded::Place>* places_;

  const xacro::Expanded::Place* placeOf(int line) const {
    const bool known = places_ && line > 0 && static_cast<std::size_t>(line) <= places_->size();
    return known ? &(*places_)[static_cast<std::size_t>(line) - 1] : nullptr;
  }
};

}  // namespace hapticell::workcell
