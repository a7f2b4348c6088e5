// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <filesystem>
#include <vector>

#include "manipulation/session/exercise.h"

namespace hapticell::app {

/// The folder for exercises made in the window, in the user's data.
QString ownExercisesFolder();

/// The shipped exercises, then those of `folder`; only files that can be read.
std::vector<std::filesystem::path> exercisesWith(const QString& folder);

/// Whether an exercise file is in `folder`: only those are changed; others are copied.
bool isOwnExercise(const QString& file, const QString& folder);

/// A new file for an exercise of this name.
QString newExerciseFile(const QString& name, const QString& folder);

/// Writes the expert's recording next to `file`, and then the exercise, which refers to it. Reads both back and
/// compares: the recording by frame, the exercise by field. Errors: one of them cannot be written, or differs when read
/// back; then neither remains, and an existing exercise is unchanged.
Expected<void> saveExercise(manipulation::Exercise exercise, const trajectory::Trajectory& expert, const QString& file);

}  // namespace hapticell::app
