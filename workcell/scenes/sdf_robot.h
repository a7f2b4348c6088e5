// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <sdf/Model.hh>

#include "workcell/scenes/sdf_reader.h"
#include "workcell/scenes/sdf_source.h"

namespace hapticell::workcell {

/// True if the model has a joint that moves, not counting those of models inside it.
bool hasMovingJoints(const sdf::Model& model);

/// One model of `source` as a robot, as in readSdf(); X_FB is its root in the model's frame.
Expected<SdfRobot> readSdfRobot(const SdfSource& source, const sdf::Model& model, const std::filesystem::path& file,
                                Diagnostics& diagnostics, ImportMonitor* monitor = nullptr);

}  // namespace hapticell::workcell
