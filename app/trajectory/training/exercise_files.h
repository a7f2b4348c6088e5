// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <filesystem>
#include <vector>

#include "manipulation/session/exercise.h"

namespace hapticell::app {

/// Where exercises that are made in the window are kept: among the user's data.
QString ownExercisesFolder();

/// Those of `folder`, behind the shipped ones; only files that can be read.
std::vector<std::filesystem::path> exercisesWith(const QString& folder);

/// Whether an exercise file lies in `folder`: only those are changed, of others a copy is made.
bool isOwnExercise(const QString& file, const QString& folder);

/// A file for a new exercise of this name; none that is there already.
QString newExerciseFile(const QString& name, const QString& folder);

/// Writes the expert's recording beside `file` and then the exercise, which names it. Both are read back: the recording
/// frame by frame, the exercise field by field. Errors: one of them cannot be written, or is not what was to be
/// written; then nothing is left of either, and an exercise that was there is as it was.
Expected<void> saveExercise(manipulation::Exercise exercise, const trajectory::Trajectory& expert, const QString& file);

}  // namespace hapticell::app
