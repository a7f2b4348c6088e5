// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/ergonomics/sub_score_table.h"

namespace hapticell::app {

class LiveScores;

/// The lifting equation's multipliers with its limit and index (or why it cannot be applied), then the load on each
/// hand, how near that is to the methods' next class, and the moments at elbow, shoulder and low back.
std::vector<SubScoreTable::Row> loadRows(const LiveScores& scores);

}  // namespace hapticell::app
