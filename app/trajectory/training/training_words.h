// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "trajectory/training/training.h"

namespace hapticell::app {

/// "Practice", "Retention", "Transfer".
QString runKindName(trajectory::RunKind kind);

/// Time since practice: "40 min", "26 h", "7 d". `seconds` >= 0.
QString restText(double seconds);

/// Smoothness of a run in percent: 100 if as smooth as the expert's, 0 if it gets no points for smoothness.
int smoothnessPercent(const trajectory::TrainingScore& score);

/// The scores of runs without guidance: "Retention after 26 h: 74 points. Transfer: 61 points." One entry for each
/// retention interval, with its newest run. Says so if there are no intervals.
QString unaidedText(const trajectory::TrainingSession& session);

}  // namespace hapticell::app
