// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "workcell/entity/pair_policy.h"
#include "workcell/text/field_reader.h"

namespace hapticell::workcell {

Json jsonFromPairSet(const PairSet& set);
Json jsonFromPairRule(const PairRule& rule);

/// One pair set; missing fields but the name keep their defaults. Whether its entities exist is not looked at. `index`
/// counts from 0, for messages.
PairSet pairSetFromJson(const Json& json, std::size_t index, std::optional<Error>& error, Diagnostics& diagnostics);
/// One rule for a pair, in the same way.
PairRule pairRuleFromJson(const Json& json, std::size_t index, std::optional<Error>& error, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
