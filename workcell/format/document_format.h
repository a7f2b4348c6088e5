// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"
#include "workcell/format/document_io.h"
#include "workcell/document/document_state.h"
#include "workcell/text/field_reader.h"

namespace hapticell::workcell {

/// "format" and the newest "version" in documents.
inline constexpr const char* kDocumentFormat = "hapticell-workcell";
inline constexpr int kDocumentVersion = 1;

/// The JSON of a state, with file names relative to `folder` (absolute).
Json jsonFromState(const DocumentState& state, const std::filesystem::path& folder);

/// The state described by the JSON, with its meshes and robots read; an error names the entity but not the document's
/// file.
Expected<DocumentState> stateFromJson(const Json& json, const std::filesystem::path& folder, Diagnostics& diagnostics,
                                      const LoadOptions& options);

}  // namespace hapticell::workcell
