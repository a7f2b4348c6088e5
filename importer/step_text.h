// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// True where the text begins as a STEP file does (ISO 10303-21), behind a byte order mark, blanks and comments.
bool beginsAsStep(std::string_view head);

/// The content of a STEP file's text, read without building shapes.
struct StepOutline {
  std::size_t exact_faces = 0;  ///< Faces of exact shapes.
  std::size_t tessellated = 0;  ///< Tessellated solids, shells and surfaces (AP242) without an exact shape behind
                                ///< them.
  std::size_t joints = 0;       ///< Of a mechanism.
  /// Texts with bytes of 0x80 and above that are no UTF-8: where they begin and how long they are.
  std::vector<std::pair<std::size_t, std::size_t>> raw;
};
StepOutline outlineOfStep(std::string_view content);

/// The encoding that raw bytes in names most likely have, among those that CAD programs write: "UTF-8", "SHIFT_JIS",
/// "GB18030" or "ISO-8859-1". All of them are looked at together.
std::string guessEncoding(const std::vector<std::string>& raw);

/// A STEP file as OpenCASCADE takes it: unpacked (.stpz), without byte order mark, names in UTF-8.
class StepText {
 public:
  /// Errors: not readable, packed in an unknown way or to more than 4 GB, tessellated shapes only.
  static Expected<StepText> open(const std::filesystem::path& file);
  StepText(StepText&& other) noexcept;
  StepText(const StepText&) = delete;
  StepText& operator=(const StepText&) = delete;
  ~StepText();

  /// A name under which the library can read it, while this lives.
  const std::string& name() const { return name_; }
  const std::vector<Text>& warnings() const { return warnings_; }

 private:
  StepText() = default;
  std::string name_;
  int descriptor_ = -1;
  std::vector<Text> warnings_;
};

}  // namespace hapticell::importer
