// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "workcell/entity/mechanism.h"
#include "workcell/format/source_format.h"

namespace hapticell::workcell {

Json jsonFromMechanism(const MechanismDefinition& definition, const std::filesystem::path& folder);

/// Reads the mechanism `name` with its parts. Messages use `place`.
Expected<Entity> mechanismFromJson(const Json& json, const std::string& name, const Text& place,
                                   const FormatContext& context, SourceReader& sources);

}  // namespace hapticell::workcell
