// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// True if the text begins like a STEP file (ISO 10303-21), after a byte order mark, blanks and comments.
bool beginsAsStep(std::string_view head);

/// The content of a STEP file's text, read without building shapes.
struct StepOutline {
  std::size_t exact_faces = 0;  ///< Faces of exact shapes.
  std::size_t tessellated = 0;  ///< Tessellated solids, shells and surfaces (AP242) without an exact shape behind
                                ///< them.
  std::size_t joints = 0;       ///< Of a mechanism.
  /// Texts with bytes of 0x80 and above that are not UTF-8: start and length.
  std::vector<std::pair<std::size_t, std::size_t>> raw;
};
StepOutline outlineOfStep(std::string_view content);

/// The most likely encoding of raw bytes in names, among those that CAD programs write: "UTF-8", "SHIFT_JIS", "GB18030"
/// or "ISO-8859-1". Judges all of them together.
std::string guessEncoding(const std::vector<std::string>& raw);

/// A STEP file in the form that OpenCASCADE accepts: unpacked (.stpz), without byte order mark, names in UTF-8.
class StepText {
 public:
  /// Errors: not readable, packed in an unknown way or to more than 4 GB, only tessellated shapes.
  static Expected<StepText> open(const std::filesystem::path& file);
  StepText(StepText&& other) noexcept;
  StepText(const StepText&) = delete;
  StepText& operator=(const StepText&) = delete;
  ~StepText();

  /// A file name from which the library can read it while this object exists.
  const std::string& name() const { return name_; }
  const std::vector<Text>& warnings() const { return warnings_; }

 private:
  StepText() = default;
  std::string name_;
  int descriptor_ = -1;
  std::vector<Text> warnings_;
};

}  // namespace hapticell::importer
