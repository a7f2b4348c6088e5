// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/load_rows.h"

#include <array>
#include <utility>

#include "app/ergonomics/live_scores.h"
#include "app/style/library_text.h"
#include "mannequin/ergonomics/scores/hand_force.h"

namespace hapticell::app {
namespace {

using Row = SubScoreTable::Row;

QString newtons(double force) {
  return SubScoreTable::tr("%1 N").arg(force, 0, 'f', 0);
}

/// Bands of the lifting index as the manual's own bounds 1 and 3 have them.
int bandOfIndex(double index) {
  if (index <= 1.0) return 0;
  if (index <= 2.0) return 1;
  return index <= 3.0 ? 2 : 3;
}

int bandOfMultiplier(double multiplier) {
  if (multiplier >= 0.9) return 0;
  return multiplier >= 0.7 ? 1 : 2;
}

/// What is said of one hand, or of both together.
QString namedByHand(const QString& method, int hand) {
  if (hand == 0) return SubScoreTable::tr("%1, left").arg(method);
  return hand == 1 ? SubScoreTable::tr("%1, right").arg(method) : method;
}

void addLift(const ergonomics::LiftingResult& lift, std::vector<Row>& rows) {
  const std::array<std::pair<QString, double>, 6> multipliers{{{SubScoreTable::tr("Horizontal distance"), lift.hm},
                                                               {SubScoreTable::tr("Height"), lift.vm},
                                                               {SubScoreTable::tr("Travel distance"), lift.dm},
                                                               {SubScoreTable::tr("Asymmetry"), lift.am},
                                                               {SubScoreTable::tr("Frequency"), lift.fm},
                                                               {SubScoreTable::tr("Coupling"), lift.cm}}};
  for (const auto& [name, value] : multipliers)
    rows.push_back({name, {}, SubScoreTable::tr("× %1").arg(value, 0, 'f', 2), bandOfMultiplier(value)});
  rows.push_back({SubScoreTable::tr("Weight limit"),
                  {},
                  SubScoreTable::tr("%1 kg").arg(lift.recommended_weight_limit_kg, 0, 'f', 1),
                  -1});
  if (lift.lifting_index)
    rows.push_back({SubScoreTable::tr("Lifting index"),
                    {},
                    QString::number(*lift.lifting_index, 'f', 2),
                    bandOfIndex(*lift.lifting_index)});
  else
    rows.push_back({SubScoreTable::tr("Lifting index"), {}, SubScoreTable::tr("no load is acceptable"), 3});
}

void addForces(const ergonomics::HandForces& forces, std::vector<Row>& rows) {
  for (const ergonomics::ForceLimit& limit : forces.limits) {
    const QString method = QString::fromLatin1(limit.method.data(), static_cast<qsizetype>(limit.method.size()));
    if (limit.method == "own") {
      const QString hand =
          limit.hand == 0 ? SubScoreTable::tr("Custom limit, left") : SubScoreTable::tr("Custom limit, right");
      rows.push_back(
          {hand, {}, SubScoreTable::tr("%1 of %2").arg(newtons(limit.force_n), newtons(*limit.limit_n)), limit.band});
      continue;
    }
    const QString reason = limit.limit_n
                               ? SubScoreTable::tr("%1 of %2").arg(newtons(limit.force_n), newtons(*limit.limit_n))
                               : SubScoreTable::tr("%1, heaviest class").arg(newtons(limit.force_n));
    rows.push_back({namedByHand(method, limit.hand), {}, reason, limit.band});
  }
  for (const std::string_view name : forces.missing) {
    if (name == "force_limits")
      rows.push_back(
          {SubScoreTable::tr("Custom limits"), {}, SubScoreTable::tr("partial: none entered for this place"), -1});
  }
  const std::array<std::pair<QString, double>, 5> moments{{{SubScoreTable::tr("Left elbow"), forces.elbow_nm[0]},
                                                           {SubScoreTable::tr("Right elbow"), forces.elbow_nm[1]},
                                                           {SubScoreTable::tr("Left shoulder"), forces.shoulder_nm[0]},
                                                           {SubScoreTable::tr("Right shoulder"), forces.shoulder_nm[1]},
                                                           {SubScoreTable::tr("Low back"), forces.lumbar_nm}}};
  for (const auto& [name, moment] : moments)
    rows.push_back({name, {}, SubScoreTable::tr("%1 N m").arg(moment, 0, 'f', 1), -1});
}

}  // namespace

std::vector<Row> loadRows(const LiveScores& scores) {
  std::vector<Row> rows;
  const auto pose = mannequin::forwardKinematics(*scores.figure(), scores.posture());
  const auto lift = ergonomics::scoreLift(*scores.figure(), pose, scores.scores(), scores.task());
  if (!scores.task().is_lift) {
    rows.push_back({SubScoreTable::tr("Lift"), {}, SubScoreTable::tr("none in the task"), -1});
  } else if (lift) {
    addLift(*lift, rows);
  } else {
    rows.push_back({SubScoreTable::tr("Lift"), {}, shownText(lift.error()), 3});
  }
  if (rows.size() % 2 == 1) rows.push_back({});
  addForces(ergonomics::handForces(*scores.figure(), pose, scores.task(), scores.ownLimits()), rows);
  return rows;
}

}  // namespace hapticell::app
