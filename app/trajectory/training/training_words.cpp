// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/training_words.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <map>

namespace hapticell::app {

using trajectory::RunKind;

QString runKindName(RunKind kind) {
  switch (kind) {
    case RunKind::kPractice:
      return QObject::tr("Practice");
    case RunKind::kRetention:
      return QObject::tr("Retention");
    case RunKind::kTransfer:
      return QObject::tr("Transfer");
  }
  return {};
}

QString restText(double seconds) {
  constexpr double kMinute = 60.0, kHour = 3600.0, kDay = 86400.0;
  if (seconds < 1.5 * kHour) return QObject::tr("%1 min").arg(std::round(seconds / kMinute));
  if (seconds < 2.0 * kDay) return QObject::tr("%1 h").arg(std::round(seconds / kHour));
  return QObject::tr("%1 d").arg(std::round(seconds / kDay));
}

int smoothnessPercent(const trajectory::TrainingScore& score) {
  const double lost = (score.expert_smoothness - score.smoothness) / trajectory::ScoringRule{}.smoothness;
  return static_cast<int>(std::lround(100.0 * std::clamp(1.0 - lost, 0.0, 1.0)));
}

QString unaidedText(const trajectory::TrainingSession& session) {
  // By whole hours of rest, the newest run of each.
  std::map<long, QString> retention;
  QString transfer;
  for (const auto& attempt : session.attempts) {
    const QString points = QString::number(attempt.score.points, 'f', 0);
    if (attempt.kind == RunKind::kTransfer) transfer = QObject::tr("Transfer: %1 points.").arg(points);
    if (attempt.kind != RunKind::kRetention) continue;
    const auto rest = session.restBefore(attempt.date);
    retention[rest ? std::lround(*rest / 3600.0) : -1] =
        rest ? QObject::tr("Retention after %1: %2 points.").arg(restText(*rest), points)
             : QObject::tr("Retention: %1 points.").arg(points);
  }
  QStringList words;
  for (const auto& [hours, text] : retention) words << text;
  if (!transfer.isEmpty()) words << transfer;
  return words.isEmpty() ? QObject::tr("No run without guidance yet.") : words.join(' ');
}

}  // namespace hapticell::app
