// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/system/error.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {

/// What the readers of a document's parts share. Everything outlives the reading.
struct FormatContext {
  const std::filesystem::path& folder;  ///< Of the document.
  EntityLoader& loader;
  Diagnostics& diagnostics;
  const LoadOptions& options;
  std::optional<Error>& error;  ///< The first that was found; the rest then has no effect.

  /// What went wrong with a part, as said of the entity that needs it.
  void failIn(const Text& place, const Error& cause) const {
    Error plain = cause;
    plain.fix = {};
    error = Error{.place = place, .found = plain.text(), .fix = cause.fix};
  }
};

}  // namespace hapticell::workcell
