// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "xacro/expand.h"

namespace hapticell::workcell {

/// Origin of the lines of a URDF text: in the file, or in the files from which a xacro was expanded.
class UrdfLines {
 public:
  /// `places` (may be null) must outlive it and has one entry per line of the text.
  explicit UrdfLines(std::string file, const std::vector<xacro::Expanded::Place>* places = nullptr)
      : file_(std::move(file)), places_(places) {}

  const std::string& file() const { return file_; }
  /// "line 12", or "arm_macro.xacro, line 12" for another file; line 0: empty.
  Text words(int line) const {
    const xacro::Expanded::Place* place = placeOf(line);
    if (!place) return line > 0 ? Text("line %1", line) : Text();
    if (place->file == file_) return Text("line %1", place->line);
    return Text("%1, line %2", std::filesystem::path(place->file).filename().string(), place->line);
  }
  tl::unexpected<Error> refuse(int line, Text found, Text expected, Text fix = {}) const {
    const xacro::Expanded::Place* place = placeOf(line);
    const int shown = place ? place->line : line;
    return makeError({.file = place ? place->file : file_,
                      .place = shown > 0 ? Text("line %1", shown) : Text(),
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
