// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "mannequin/ergonomics/scores/work_task.h"
#include "workcell/text/field_reader.h"

namespace hapticell::workcell {

/// Leaves out unknown values.
Json jsonFromWorkTask(const ergonomics::WorkTask& task);
/// Reads a task; missing values stay unknown. `index` counts from 0, for messages.
ergonomics::WorkTask workTaskFromJson(const Json& json, std::size_t index, std::optional<Error>& error,
                                      Diagnostics& diagnostics);

}  // namespace hapticell::workcell
