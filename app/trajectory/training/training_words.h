// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "trajectory/training/training.h"

namespace hapticell::app {

/// "Practice", "Retention", "Transfer".
QString runKindName(trajectory::RunKind kind);

/// How long ago the practice was: "40 min", "26 h", "7 d". `seconds` >= 0.
QString restText(double seconds);

/// Smoothness of a run in percent: 100 where it is as smooth as the expert's, 0 where it gets no points for smoothness.
int smoothnessPercent(const trajectory::TrainingScore& score);

/// The points of runs without guidance, apart from those of practice: "Retention after 26 h: 74 points. Transfer: 61
/// points." Each rest once, with its newest run. Says so if there are no rests.
QString unaidedText(const trajectory::TrainingSession& session);

}  // namespace hapticell::app
