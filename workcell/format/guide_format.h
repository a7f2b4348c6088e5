// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workcell/text/field_reader.h"
#include "workcell/entity/guide.h"

namespace hapticell::workcell {

/// The words of the kinds in files, in their order: "point", "line" ...
const std::vector<std::string>& guideWords();

Json jsonFromGuide(const Guide& guide);
/// Reads one; what is missing keeps its default. `index` counts from 0, for messages.
Guide guideFromJson(const Json& json, std::size_t index, std::optional<Error>& error, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
