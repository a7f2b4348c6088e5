// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/training_report.h"

#include <QPainter>
#include <QPdfWriter>

#include "app/kit/written_file.h"
#include "app/style/fonts.h"
#include "app/style/theme.h"
#include "app/trajectory/training/progress_plot.h"
#include "app/trajectory/training/training_words.h"

namespace hapticell::app {
namespace {

constexpr int kDpi = 96;
constexpr int kRow = 20;

struct Column {
  QString head;
  int width;
};

std::vector<Column> columns() {
  const auto tr = [](const char* text) { return QObject::tr(text); };
  return {{tr("Run"), 28},     {tr("When"), 100},  {tr("Type"), 62},     {tr("Rest"), 40},    {tr("Guidance"), 40},
          {tr("Points"), 44},  {tr("Path"), 42},   {tr("Time s"), 44},   {tr("Dev. mm"), 48}, {tr("Max mm"), 48},
          {tr("Force N"), 52}, {tr("Smooth"), 48}, {tr("Contacts"), 50}, {tr("Passed"), 42}};
}

QStringList cells(const trajectory::TrainingSession& session, std::size_t number) {
  const trajectory::TrainingAttempt& attempt = session.attempts[number - 1];
  const auto& s = attempt.score;
  const auto rest = attempt.kind == trajectory::RunKind::kPractice ? std::nullopt : session.restBefore(attempt.date);
  return {QString::number(number),
          QString::fromStdString(attempt.date).left(16).replace('T', ' '),
          runKindName(attempt.kind),
          rest ? restText(*rest) : QString(),
          QObject::tr("%1 %").arg(100.0 * attempt.help, 0, 'f', 0),
          QString::number(s.points, 'f', 0),
          QObject::tr("%1 %").arg(100.0 * s.completed, 0, 'f', 0),
          QString::number(s.time, 'f', 1),
          QString::number(1e3 * s.mean_deviation, 'f', 1),
          QString::number(1e3 * s.max_deviation, 'f', 1),
          QString::number(s.max_force, 'f', 1),
          QObject::tr("%1 %").arg(smoothnessPercent(s)),
          QString::number(s.contacts),
          attempt.success ? QObject::tr("yes") : QObject::tr("no")};
}

void drawRow(QPainter& painter, int y, const QStringList& words, bool head) {
  int x = 0, i = 0;
  for (const Column& column : columns()) {
    const auto side = i < 3 ? Qt::AlignLeft : Qt::AlignRight;
    painter.setFont(textFont(head ? TextRole::kSection : TextRole::kSecond));
    painter.drawText(QRect(x, y, column.width - 4, kRow), side | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(words[i], Qt::ElideRight, column.width - 4));
    x += column.width;
    ++i;
  }
}

void drawReport(QPdfWriter& writer, const trajectory::TrainingSession& session, double pass) {
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(15, 15, 15, 15));
  writer.setResolution(kDpi);
  writer.setTitle(QObject::tr("Training of %1").arg(QString::fromStdString(session.trainee)));
  QPainter painter(&writer);
  const QPalette palette = paletteOf(lightTheme());
  painter.setPen(palette.color(QPalette::WindowText));
  painter.setFont(textFont(TextRole::kPanelNumber));
  painter.drawText(QRect(0, 0, 680, 30), Qt::AlignVCenter, QString::fromStdString(session.exercise));
  painter.setFont(textFont(TextRole::kText));
  painter.drawText(QRect(0, 30, 680, 22), Qt::AlignVCenter,
                   QObject::tr("%1 · runs: %3 · next guidance %2 %")
                       .arg(QString::fromStdString(session.trainee))
                       .arg(100.0 * session.nextHelp(), 0, 'f', 0)
                       .arg(session.attempts.size()));
  painter.drawText(QRect(0, 52, 676, 36), Qt::AlignVCenter | Qt::TextWordWrap, unaidedText(session));
  ProgressPlot::paint(painter, QRect(0, 94, 676, 190), session.attempts, pass, palette);
  painter.setPen(palette.color(QPalette::WindowText));
  int y = 300;
  QStringList heads;
  for (const Column& column : columns()) heads << column.head;
  drawRow(painter, y, heads, true);
  for (const std::size_t i : shownOrder(session.attempts)) {
    y += kRow;
    if (y > writer.height() - kRow) {
      writer.newPage();
      y = 0;
      drawRow(painter, y, heads, true);
      y += kRow;
    }
    drawRow(painter, y, cells(session, i + 1), false);
  }
}

}  // namespace

Expected<void> writeTrainingReport(const QString& path, const trajectory::TrainingSession& session, double pass) {
  if (path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive))
    return writeFileAtomically(path.toStdString(), trajectory::toCsvText(session));
  return writePdf(path, [&](QPdfWriter& writer) { drawReport(writer, session, pass); });
}

}  // namespace hapticell::app
