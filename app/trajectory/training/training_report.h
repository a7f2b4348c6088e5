// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "geometry/system/error.h"
#include "trajectory/training/training.h"

namespace hapticell::app {

/// Writes a trainee's results as one page or more: a table of all runs and the plot of score and guidance. If the name
/// ends in .csv, writes the table as text. Error: the file cannot be written.
Expected<void> writeTrainingReport(const QString& path, const trajectory::TrainingSession& session, double pass);

}  // namespace hapticell::app
