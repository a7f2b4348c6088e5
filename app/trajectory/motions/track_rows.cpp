// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/motions/track_rows.h"

#include "app/style/units.h"

#include <QObject>
#include <algorithm>
#include <cmath>

namespace hapticell::app {
namespace {

using Kind = manipulation::PathFinding::Kind;

int strength(CheckMark mark) {
  switch (mark) {
    case CheckMark::kCollision:
      return 4;
    case CheckMark::kLimit:
      return 3;
    case CheckMark::kCareful:
      return 2;
    case CheckMark::kFree:
      return 1;
    case CheckMark::kNone:
      break;
  }
  return 0;
}

QString degrees(double radians) {
  return QObject::tr("%1°").arg(radians * 57.29577951308232, 0, 'f', 1);
}

void addDots(const Motion& motion, std::size_t most, TrackRow& row) {
  const auto& trajectory = *motion.trajectory;
  const std::size_t stride = std::max<std::size_t>(1, (trajectory.size() + most - 1) / std::max<std::size_t>(1, most));
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const auto& frame = trajectory[i];
    const bool is_end = i + 1 == trajectory.size();
    if (i % stride != 0 && !frame.isSet() && !is_end) continue;
    row.dots.push_back({frame.t, i, frame.by_hand, markAt(motion, frame.t)});
  }
}

/// Which frames get a row, in order.
std::vector<std::size_t> rowFrames(const Motion& motion, std::size_t most) {
  const auto frames = motion.trajectory->frames();
  const std::size_t stride = std::max<std::size_t>(1, (frames.size() + most - 1) / most);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < frames.size(); i += stride) rows.push_back(i);
  rows.push_back(frames.size() - 1);
  if (motion.check)
    for (const auto& finding : motion.check->findings) {
      const auto after = std::upper_bound(frames.begin(), frames.end(), finding.t_in,
                                          [](double t, const auto& frame) { return t < frame.t; });
      rows.push_back(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - frames.begin() - 1)));
    }
  for (std::size_t i = 0; stride > 1 && i < frames.size(); ++i)
    if (frames[i].isSet()) rows.push_back(i);
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

Mark treeMark(CheckMark mark) {
  switch (mark) {
    case CheckMark::kCollision:
      return Mark::kContact;
    case CheckMark::kLimit:
      return Mark::kLimit;
    case CheckMark::kCareful:
      return Mark::kNearMiss;
    case CheckMark::kFree:
    case CheckMark::kNone:
      break;
  }
  return Mark::kNone;
}

/// The strongest of what was found on the way from t to t_next.
void addFinding(const manipulation::PathCheckResult& check, double t, double t_next,
                WorkcellTreeModel::MotionFrame& row) {
  CheckMark strongest = CheckMark::kNone;
  for (const auto& finding : check.findings) {
    if (finding.t_out < t || (finding.t_in >= t_next && finding.t_in > t)) continue;
    if (strength(markOf(finding)) <= strength(strongest)) continue;
    strongest = markOf(finding);
    row.finding = findingText(finding);
  }
  row.mark = treeMark(strongest);
}

}  // namespace

QString findingText(const manipulation::PathFinding& finding) {
  const QString first = QString::fromStdString(finding.first), second = QString::fromStdString(finding.second);
  switch (finding.kind) {
    case Kind::kCollision:
      return QObject::tr("%1 touches %2").arg(first, second);
    case Kind::kJointLimit:
      return QObject::tr("%1 is %2 beyond its limit").arg(first, degrees(finding.worst));
    case Kind::kJointSpeed:
      return QObject::tr("%1 would exceed its speed limit by %2/s").arg(first, degrees(finding.worst));
    case Kind::kSingularity:
      return QObject::tr("Near a singularity: one direction is nearly lost");
    case Kind::kOffPose:
      return QObject::tr("The robot cannot reach the frame: it stays up to %1 or %2 away")
          .arg(lengthText(finding.worst), angleText(finding.worst));
    case Kind::kConfiguration:
      return QObject::tr("The arm changes its configuration: %1").arg(first);
  }
  return {};
}

CheckMark markOf(const manipulation::PathFinding& finding) {
  switch (finding.kind) {
    case Kind::kCollision:
      return CheckMark::kCollision;
    case Kind::kSingularity:
    case Kind::kConfiguration:
      return CheckMark::kCareful;
    default:
      return CheckMark::kLimit;
  }
}

CheckMark markAt(const Motion& motion, double t) {
  if (!motion.check) return CheckMark::kNone;
  CheckMark mark = motion.check->cancelled ? CheckMark::kNone : CheckMark::kFree;
  for (const auto& finding : motion.check->findings) {
    if (t < finding.t_in - 1e-9 || t > finding.t_out + 1e-9) continue;
    if (strength(markOf(finding)) > strength(mark)) mark = markOf(finding);
  }
  return mark;
}

QString checkLine(const manipulation::PathCheckResult& check) {
  if (check.cancelled) return QObject::tr("check cancelled");
  int collisions = 0, limits = 0, careful = 0;
  for (const auto& finding : check.findings) {
    const CheckMark mark = markOf(finding);
    collisions += mark == CheckMark::kCollision;
    limits += mark == CheckMark::kLimit;
    careful += mark == CheckMark::kCareful;
  }
  QStringList words;
  if (collisions > 0) words << QObject::tr("contacts: %1").arg(collisions);
  if (limits > 0) words << QObject::tr("limits exceeded: %1").arg(limits);
  if (careful > 0) words << QObject::tr("singularities, configuration changes: %1").arg(careful);
  if (words.isEmpty()) words << QObject::tr("no contact");
  if (std::isfinite(check.least_clearance) && collisions == 0)
    words << QObject::tr("minimum clearance %1 at %2 s")
                 .arg(lengthText(check.least_clearance))
                 .arg(check.t_nearest, 0, 'f', 1);
  return words.join(QStringLiteral(", "));
}

std::vector<TrackRow> trackRows(const MotionList& list, std::size_t most) {
  std::vector<TrackRow> rows;
  for (const Motion& motion : list.motions()) {
    TrackRow row;
    row.name = motion.name;
    row.played = motion.played;
    row.current = list.current() && list.current()->name == motion.name;
    row.playable = motion.replay != nullptr;
    if (!motion.problem.isEmpty()) row.note = motion.problem;
    if (motion.trajectory && !motion.trajectory->empty()) {
      row.begin = (*motion.trajectory)[0].t;
      row.end = motion.trajectory->frames().back().t;
      if (motion.check) row.note = checkLine(*motion.check);
      addDots(motion, most, row);
      if (motion.check)
        for (const auto& finding : motion.check->findings)
          row.spans.push_back({finding.t_in, finding.t_out, markOf(finding), findingText(finding)});
    } else if (!motion.trajectory && motion.problem.isEmpty()) {
      row.note = QObject::tr("loading…");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<WorkcellTreeModel::MotionFrame> motionFrames(const Motion& motion, std::size_t most) {
  std::vector<WorkcellTreeModel::MotionFrame> rows;
  if (!motion.trajectory || motion.trajectory->empty() || most == 0) return rows;
  const auto& trajectory = *motion.trajectory;
  const bool taught = trajectory.isTaught();  // All of it is by hand: no word needed.
  const std::vector<std::size_t> frames = rowFrames(motion, most);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto& frame = trajectory[frames[i]];
    WorkcellTreeModel::MotionFrame row;
    row.frame = frames[i];
    row.own_name = QString::fromStdString(frame.nameText());
    row.name = row.own_name.isEmpty() ? QObject::tr("Frame %1 · %2 s").arg(frames[i] + 1).arg(frame.t, 0, 'f', 2)
                                      : QObject::tr("%1 · %2 s").arg(row.own_name).arg(frame.t, 0, 'f', 2);
    if (frame.by_hand && !taught) row.name += QObject::tr(", by hand");
    row.checked = motion.check && !motion.check->cancelled;
    if (motion.check) addFinding(*motion.check, frame.t, trajectory[frames[std::min(i + 1, frames.size() - 1)]].t, row);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace hapticell::app
