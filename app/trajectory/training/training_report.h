// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "geometry/system/error.h"
#include "trajectory/training/training.h"

namespace hapticell::app {

/// A trainee's results as one page or more: a table of all runs and the plot of points and help. A name that ends in
/// .csv gets the table as text. Errors: the file cannot be written.
Expected<void> writeTrainingReport(const QString& path, const trajectory::TrainingSession& session, double pass);

}  // namespace hapticell::app
