// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "app/panels/tree/workcell_tree_model.h"
#include "app/trajectory/motions/motion_list.h"

namespace hapticell::app {

/// What a mark of a check on the time bar says.
enum class CheckMark { kNone, kFree, kCollision, kLimit, kCareful };

/// A dot of a motion on the time bar.
struct TrackDot {
  double t = 0.0;
  std::size_t frame = 0;
  bool by_hand = false;
  CheckMark mark = CheckMark::kNone;
};

/// A time span with a finding.
struct TrackSpan {
  double t_in = 0.0, t_out = 0.0;
  CheckMark mark = CheckMark::kNone;
  QString text;  ///< "Gripper touches Clamp tower B"
};

/// A motion as one row of the time bar.
struct TrackRow {
  std::string name;
  double begin = 0.0, end = 0.0;
  bool played = false, current = false, playable = false;
  QString note;  ///< Text in the bar: findings of its check, or why it cannot be played.
  std::vector<TrackDot> dots;
  std::vector<TrackSpan> spans;
};

/// "Gripper touches Clamp tower B", "A5 is 3.2 deg beyond its end", ...
QString findingText(const manipulation::PathFinding& finding);
CheckMark markOf(const manipulation::PathFinding& finding);
/// The strongest mark at a time: collision before limit before careful; kFree if checked without a finding.
CheckMark markAt(const Motion& motion, double t);
/// One line about a check: "free of contact, least gap 3.8 mm at 11.2 s".
QString checkLine(const manipulation::PathCheckResult& check);

/// Rows of all motions, with at most `most` dots a row: all frames if there are no more, else those set by hand and a
/// regular selection of the others.
std::vector<TrackRow> trackRows(const MotionList& list, std::size_t most);

/// The frames of a motion as rows of the tree: all if there are at most `most`; else those set by hand, with a dwell or
/// with a name, and of the sampled ones those where a finding begins and a regular selection. Findings between a row's
/// frame and the next row's are shown at the row, so that none is left out.
std::vector<WorkcellTreeModel::MotionFrame> motionFrames(const Motion& motion, std::size_t most);

}  // namespace hapticell::app
