// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/system/error.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {

/// Data that the readers of a document's parts share. All of it outlives the reading.
struct FormatContext {
  const std::filesystem::path& folder;  ///< Of the document.
  EntityLoader& loader;
  Diagnostics& diagnostics;
  const LoadOptions& options;
  std::optional<Error>& error;  ///< The first error found; later ones have no effect.

  /// Records a part's error as an error of the entity that needs the part.
  void failIn(const Text& place, const Error& cause) const {
    Error plain = cause;
    plain.fix = {};
    error = Error{.place = place, .found = plain.text(), .fix = cause.fix};
  }
};

}  // namespace hapticell::workcell
