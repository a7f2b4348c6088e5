// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/height_strips.h"

#include <QPainter>
#include <array>

#include "app/ergonomics/live_scores.h"
#include "app/ergonomics/score_painting.h"
#include "app/style/fonts.h"
#include "app/style/units.h"

namespace hapticell::app {
namespace {

constexpr int kHeightLabels = 76, kBodyStrip = 13, kStripLine = 18;
const std::array<const char*, 4> kStripBodies{
    QT_TRANSLATE_NOOP("HeightStrips", "P5 woman"), QT_TRANSLATE_NOOP("HeightStrips", "P50 woman"),
    QT_TRANSLATE_NOOP("HeightStrips", "P50 man"), QT_TRANSLATE_NOOP("HeightStrips", "P95 man")};

}  // namespace

HeightStrips::HeightStrips(const LiveScores& scores, QWidget* parent) : QWidget(parent), scores_(scores) {
  setObjectName("heightStrips");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("RULA by working height"));
}

void HeightStrips::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = themeOf(palette());
  painter.setFont(textFont(TextRole::kSecond));
  painter.setPen(theme.text2);
  for (int i = 0; i < 4; ++i)
    painter.drawText(QRectF(0, kStripLine * i, kHeightLabels - 6, kBodyStrip + 2), Qt::AlignLeft | Qt::AlignVCenter,
                     tr(kStripBodies[static_cast<std::size_t>(i)]));
  const auto& advice = scores_.advice();
  const QRectF area(kHeightLabels, 0, width() - kHeightLabels - 1, 4 * kStripLine - 4);
  if (!advice || advice->by_height.size() < 4) {
    painter.setPen(theme.text3);
    painter.drawText(area, Qt::AlignCenter, tr("Shown when the mannequin stops moving"));
    return;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<int> bands;
    for (const int score : advice->by_height[i]) bands.push_back(score == 0 ? -1 : ergonomics::bandOfRula(score));
    paintStrip(painter, QRectF(area.left(), kStripLine * static_cast<double>(i), area.width(), kBodyStrip), bands,
               theme);
  }
  const double first = advice->rises.front(), last = advice->rises.back();
  const double step = area.width() / static_cast<double>(advice->rises.size());
  const auto place = [&](double rise) {
    return area.left() + 0.5 * step + (area.width() - step) * (rise - first) / (last - first);
  };
  const auto mark = [&](double rise, const QString& words, Qt::PenStyle style, int line) {
    painter.setPen(QPen(theme.scene.force, 1.6, style));
    painter.drawLine(QPointF(place(rise), -2), QPointF(place(rise), area.bottom() + 3));
    painter.setPen(theme.text1);
    const double wide = painter.fontMetrics().horizontalAdvance(words) + 8.0;
    const double x = std::clamp(place(rise) - 0.5 * wide, 0.0, std::max(0.0, width() - wide));
    painter.drawText(QRectF(x, area.bottom() + 4 + 15 * line, wide, 15), Qt::AlignCenter, words);
  };
  const auto height = [&](double rise) { return lengthText(advice->target_height + rise, 0); };
  mark(0.0, tr("now %1").arg(height(0.0)), Qt::SolidLine, 0);
  if (advice->best_rise && std::abs(*advice->best_rise) > 1e-6)
    mark(*advice->best_rise, tr("best %1").arg(height(*advice->best_rise)), Qt::DashLine, 1);
  painter.setPen(theme.text2);
  painter.drawText(QRectF(area.left(), area.bottom() + 34, 80, 15), Qt::AlignLeft, height(first));
  painter.drawText(QRectF(width() - 90.0, area.bottom() + 34, 89, 15), Qt::AlignRight, height(last));
}

}  // namespace hapticell::app
