// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workcell/text/field_reader.h"
#include "workcell/entity/guide.h"

namespace hapticell::workcell {

/// The words for the kinds in files, in the order of the kinds: "point", "line" ...
const std::vector<std::string>& guideWords();

Json jsonFromGuide(const Guide& guide);
/// Reads one guide; missing fields keep their defaults. `index` counts from 0, for messages.
Guide guideFromJson(const Json& json, std::size_t index, std::optional<Error>& error, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
