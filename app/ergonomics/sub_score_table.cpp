// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/sub_score_table.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

#include "app/ergonomics/live_scores.h"
#include "app/ergonomics/score_painting.h"
#include "app/style/fonts.h"

namespace hapticell::app {
namespace {

constexpr int kScoreLine = 22, kLeastName = 106, kNumber = 22, kPatch = 22;
constexpr double kMostName = 0.6;  // Of a column.

using Row = SubScoreTable::Row;

QString capital(const std::string& text) {
  QString result = shown(text);
  if (!result.isEmpty()) result[0] = result[0].toUpper();
  return result;
}

template <class Values>
Row rowOf(const Values& values, std::size_t index, const ergonomics::ScoredMethod& method) {
  Row row;
  row.number = values[index] ? QString::number(*values[index]) : QStringLiteral("–");
  row.band = values[index] ? ergonomics::bandOfSubScore(method.subScores()[index], *values[index]) : -1;
  return row;
}

std::vector<Row> rulaRows(const ergonomics::PostureScores& scores) {
  using ergonomics::Rula;
  const auto& side = scores.worse();
  std::vector<Row> rows;
  for (const auto index : {Rula::kUpperArm, Rula::kNeck, Rula::kLowerArm, Rula::kTrunk, Rula::kWrist, Rula::kLegs,
                           Rula::kWristTwist, Rula::kMuscleUseArm, Rula::kForceArm, Rula::kForceBody}) {
    Row row = rowOf(side.rula, index, Rula());
    row.name = capital(ergonomics::rulaPart(index, scores.worseSide(), shownLanguage()));
    row.reason = shown(ergonomics::rulaReason(side, index, shownLanguage()));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Row> rebaRows(const ergonomics::PostureScores& scores) {
  using ergonomics::Reba;
  const auto& side = scores.worse();
  std::vector<Row> rows;
  for (const auto index : {Reba::kUpperArm, Reba::kNeck, Reba::kLowerArm, Reba::kTrunk, Reba::kWrist, Reba::kLegs,
                           Reba::kLoad, Reba::kCoupling, Reba::kActivity}) {
    Row row = rowOf(side.reba, index, Reba());
    row.name = capital(ergonomics::rebaPart(index, scores.worseSide(), shownLanguage()));
    row.reason = shown(ergonomics::rebaReason(side, index, shownLanguage()));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Row> owasRows(const ergonomics::PostureScores& scores) {
  using ergonomics::Owas;
  std::vector<Row> rows;
  for (std::size_t i = 0; i < scores.owas.size(); ++i) {
    Row row = rowOf(scores.owas, i, Owas());
    row.band = -1;
    row.name = capital(ergonomics::word(Owas().subScores()[i].name, shownLanguage()));
    const auto meaning = Owas::meaning(static_cast<Owas::Index>(i), scores.owas[i].value_or(1));
    row.reason = shown(ergonomics::word(meaning, shownLanguage()));
    rows.push_back(std::move(row));
  }
  return rows;
}

int bandOfZone(ergonomics::Zone zone) {
  if (zone == ergonomics::Zone::kAcceptable) return 0;
  return zone == ergonomics::Zone::kConditional ? 1 : 3;
}

void addZones(const ergonomics::PartVerdicts& verdicts, std::vector<Row>& rows) {
  for (const auto& part : verdicts.parts) {
    Row row;
    row.name = capital(ergonomics::word(part.part, shownLanguage()));
    row.band = bandOfZone(part.zone);
    row.reason = QStringLiteral("%1°").arg(part.angle, 0, 'f', 0);
    if (part.holding_time_min)
      row.reason += SubScoreTable::tr(", at most %1 min").arg(*part.holding_time_min, 0, 'f', 1);
    rows.push_back(std::move(row));
  }
}

void addOutline(const ergonomics::PostureScores& scores, std::vector<Row>& rows) {
  const int level = ergonomics::eawsLevel(scores.eaws_points);
  rows.push_back({SubScoreTable::tr("EAWS (outline)"), QString::number(scores.eaws_points, 'f', 0),
                  shown(ergonomics::word(ergonomics::nameOf(scores.eaws), shownLanguage())),
                  level == 3 ? 3 : level - 1});
  rows.push_back({SubScoreTable::tr("Joint comfort"),
                  {},
                  SubScoreTable::tr("%1 % of the joints").arg(100.0 * scores.comfort, 0, 'f', 0),
                  -1});
}

}  // namespace

SubScoreTable::SubScoreTable(QWidget* parent) : QWidget(parent) {
  setObjectName("subScores");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SubScoreTable::setRows(std::vector<Row> rows) {
  const bool other = rows.size() != rows_.size();
  rows_ = std::move(rows);
  if (other) updateGeometry();
  QStringList words;
  for (const Row& row : rows_) words << row.name + ' ' + row.number + ' ' + row.reason;
  setAccessibleDescription(words.join("; "));
  update();
}

QSize SubScoreTable::sizeHint() const {
  return {420, kScoreLine * static_cast<int>((rows_.size() + 1) / 2)};
}

double SubScoreTable::nameWidth() const {
  const QFontMetrics metrics(textFont(TextRole::kSecond));
  int widest = kLeastName;
  for (const Row& row : rows_) widest = std::max(widest, metrics.horizontalAdvance(row.name) + 8);
  return std::min(1.0 * widest, std::max(1.0 * kLeastName, kMostName * (0.5 * width() - 12.0)));
}

void SubScoreTable::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = themeOf(palette());
  const double half = 0.5 * width(), name = nameWidth();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const std::size_t line = i / 2;
    const double x = i % 2 == 0 ? 0.0 : half + 6.0, top = kScoreLine * static_cast<double>(line);
    const double wide = half - 12.0;
    painter.setPen(QPen(theme.line, 1));
    painter.drawLine(QPointF(x, top + kScoreLine - 0.5), QPointF(x + wide, top + kScoreLine - 0.5));
    painter.setFont(textFont(TextRole::kSecond));
    painter.setPen(theme.text2);
    const auto text = [&](double left, double span, const QString& words, int align) {
      painter.drawText(QRectF(left, top, span, kScoreLine), align | Qt::AlignVCenter,
                       painter.fontMetrics().elidedText(words, Qt::ElideRight, static_cast<int>(span)));
    };
    text(x, name - 4, row.name, Qt::AlignLeft);
    painter.setPen(theme.text1);
    painter.setFont(textFont(TextRole::kSection));
    text(x + name, kNumber - 6, row.number, Qt::AlignRight);
    if (row.band >= 0) paintBand(painter, QRectF(x + name + kNumber, top + 6, 15, 10), row.band, theme);
    painter.setFont(textFont(TextRole::kSecond));
    const double left = x + name + kNumber + kPatch;
    text(left, std::max(10.0, x + wide - left), row.reason, Qt::AlignLeft);
  }
}

std::vector<SubScoreTable::Row> subScoreRows(const ergonomics::PostureScores& scores, ergonomics::ColourMethod method) {
  if (method == ergonomics::ColourMethod::kReba) return rebaRows(scores);
  if (method == ergonomics::ColourMethod::kOwas) return owasRows(scores);
  if (method == ergonomics::ColourMethod::kEn1005) {
    std::vector<Row> rows;
    addZones(scores.worse().en1005, rows);
    addZones(scores.worse().iso11226, rows);
    addOutline(scores, rows);
    return rows;
  }
  return rulaRows(scores);
}

}  // namespace hapticell::app
