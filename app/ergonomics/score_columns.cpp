// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/score_columns.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <array>

#include "app/ergonomics/live_scores.h"
#include "app/ergonomics/score_painting.h"
#include "app/mannequin/figure_sketch.h"
#include "app/style/fonts.h"
#include "app/style/key_step.h"
#include "app/style/units.h"

namespace hapticell::app {
namespace {

constexpr int kColumnLabels = 72, kPicture = 126, kLine = 18, kBodies = 4;
constexpr int kScoreTop = kPicture + 40, kDriverTop = kScoreTop + 62, kRebaTop = kDriverTop + 40;

const std::array<const char*, 4> kBodyRows{
    QT_TRANSLATE_NOOP("ScoreColumns", "P5 woman"), QT_TRANSLATE_NOOP("ScoreColumns", "P50 woman"),
    QT_TRANSLATE_NOOP("ScoreColumns", "P50 man"), QT_TRANSLATE_NOOP("ScoreColumns", "P95 man")};

}  // namespace

ScoreColumns::ScoreColumns(const LiveScores& scores, QWidget* parent) : QWidget(parent), scores_(scores) {
  setObjectName("scoreColumns");
  setFocusPolicy(Qt::TabFocus);
  setAccessibleName(tr("Four mannequins at the same task"));
}

void ScoreColumns::setMethod(ergonomics::ColourMethod method) {
  method_ = method;
  update();
}

const std::vector<mannequin::Flesh>& ScoreColumns::fleshOf(std::size_t body) {
  auto& flesh = flesh_[body];
  if (flesh.empty()) flesh = mannequin::fleshOf(scores_.bodies()[body].figure);
  return flesh;
}

QRectF ScoreColumns::columnRect(int body) const {
  const double width = (this->width() - kColumnLabels) / static_cast<double>(kBodies);
  return {kColumnLabels + width * body, 0.0, width, static_cast<double>(height())};
}

void ScoreColumns::choose(int body) {
  chosen_ = body == chosen_ ? -1 : body;
  update();
  emit chose(chosen_);
}

void ScoreColumns::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  for (int i = 0; i < kBodies; ++i)
    if (columnRect(i).contains(event->position())) choose(i);
}

void ScoreColumns::keyPressEvent(QKeyEvent* event) {
  const int step = keyStep(event->key(), Qt::Key_Left, Qt::Key_Right);
  if (step == 0) return QWidget::keyPressEvent(event);
  choose(std::clamp(chosen_ + step, 0, kBodies - 1));
}

void ScoreColumns::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = themeOf(palette());
  painter.setFont(textFont(TextRole::kSecond));
  painter.setPen(theme.text2);
  const auto label = [&](int top, const QString& text, int lines = 3) {
    painter.drawText(QRectF(0, top, kColumnLabels - 6, lines * kLine), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                     text);
  };
  label(kPicture + 4, tr("Same task, four mannequins"), 5);
  label(kDriverTop, tr("Driver"));
  label(kRebaTop, tr("REBA"));
  label(kRebaTop + kLine + 2, tr("OWAS"));
  label(kRebaTop + 2 * kLine + 4, tr("Reach"));
  if (scores_.bodies().size() < kBodies) return;
  for (int i = 0; i < kBodies; ++i) paintColumn(painter, i);
}

void ScoreColumns::paintColumn(QPainter& painter, int body) {
  const Theme& theme = themeOf(palette());
  const auto& at = scores_.bodies()[static_cast<std::size_t>(body)];
  const QRectF column = columnRect(body).adjusted(2, 0, -2, 0);
  const bool own = scores_.ownBody() == body;
  const QRectF picture(column.left(), 0, column.width(), kPicture);
  QLinearGradient back(picture.topLeft(), picture.bottomLeft());
  back.setColorAt(0, theme.scene.background_top);
  back.setColorAt(1, theme.scene.background_bottom);
  painter.fillRect(picture, back);
  if (own)
    painter.fillRect(QRectF(column.left(), kPicture, column.width(), kDriverTop - kPicture - 4), theme.selected_row);
  if (own || body == chosen_)
    painter.fillRect(QRectF(column.left(), 0, column.width(), 2),
                     body == chosen_ ? theme.scene.guide : theme.selection);
  const auto bands = ergonomics::segmentBands(at.scores, method_);
  const auto parts = mannequin::outlineOf(at.figure, at.posture, fleshOf(static_cast<std::size_t>(body)),
                                          mannequin::OutlineView::besides(at.posture));
  drawFigure(
      painter, picture, parts, [&](std::size_t part) { return lookOf(bands[part], theme); },
      theme.scene.background_bottom.darker(160));
  const double x = column.left() + 6, width = column.width() - 8;
  const auto write = [&](TextRole role, const QColor& color, double top, const QString& text) {
    painter.setFont(textFont(role));
    painter.setPen(color);
    painter.drawText(QRectF(x, top, width, 40), Qt::AlignLeft | Qt::AlignTop,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(width)));
  };
  write(TextRole::kSection, theme.text1, kPicture + 4, tr(kBodyRows[static_cast<std::size_t>(body)]));
  write(TextRole::kSecond, theme.text2, kPicture + 22, lengthText(at.figure.body[mannequin::Dimension::kStature], 0));
  const bool by_reba = method_ == ergonomics::ColourMethod::kReba;
  const int score = by_reba ? at.scores.reba() : at.scores.rula();
  write(TextRole::kScore, theme.text1, kScoreTop, QString::number(score));
  paintBand(painter, QRectF(x + (score > 9 ? 42 : 26), kScoreTop + 10, 28, 17),
            by_reba ? ergonomics::bandOfReba(score) : ergonomics::bandOfRula(score), theme);
  write(
      TextRole::kSecond, theme.text1, kScoreTop + 38,
      shown(by_reba ? ergonomics::rebaAdvice(score, shownLanguage()) : ergonomics::rulaAdvice(score, shownLanguage())));
  const auto driver = ergonomics::mainDriver(at.scores, shownLanguage());
  QString part = shown(driver.part);
  part[0] = part[0].toUpper();
  write(TextRole::kSecond, theme.text1, kDriverTop, part);
  write(TextRole::kSecond, theme.text1, kDriverTop + kLine, shown(driver.reason));
  const auto row = [&](double top, int band, const QString& text) {
    paintBand(painter, QRectF(x, top + 3, 14, 10), band, theme);
    painter.setFont(textFont(TextRole::kSecond));
    painter.setPen(theme.text1);
    painter.drawText(QRectF(x + 20, top, width - 20, kLine), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(width - 20)));
  };
  row(kRebaTop - 1, ergonomics::bandOfReba(at.scores.reba()),
      QStringLiteral("%1 %2")
          .arg(at.scores.reba())
          .arg(shown(ergonomics::rebaAdvice(at.scores.reba(), shownLanguage()))));
  row(kRebaTop + kLine + 1, ergonomics::bandOfOwas(at.scores.owas_category),
      tr("%1 cat. %2").arg(at.scores.owasCode()).arg(at.scores.owas_category));
  write(TextRole::kSecond, at.is_reached ? theme.text1 : theme.words.limit, kRebaTop + 2 * kLine + 4,
        at.is_reached ? tr("%1 left").arg(lengthText(at.reach_left_m, 0))
                      : tr("%1 short").arg(lengthText(at.short_m, 0)));
}

}  // namespace hapticell::app
