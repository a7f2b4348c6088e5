// SPDX-License-Identifier: Apache-2.0
#include "app/studies/heat_legend.h"

#include <QPainter>

#include "app/studies/variant_view.h"
#include "app/style/fonts.h"
#include "app/style/theme.h"

namespace hapticell::app {

HeatLegend::HeatLegend(const VariantView& view, QWidget* parent) : QWidget(parent), view_(view) {
  setObjectName("heatLegend");
  setAccessibleName(QObject::tr("Colours of the map"));
}

void HeatLegend::paintEvent(QPaintEvent*) {
  const VariantMap& map = view_.map();
  if (map.isEmpty()) return;
  QPainter painter(this);
  const Theme& theme = themeOf(palette());
  painter.setFont(textFont(TextRole::kKeyCap));
  const QString worst = QString::number(map.greater_is_better ? map.least : map.greatest, 'g', 4);
  const QString best = QString::number(map.greater_is_better ? map.greatest : map.least, 'g', 4);
  const int left = painter.fontMetrics().horizontalAdvance(worst) + 6;
  const int right = painter.fontMetrics().horizontalAdvance(best) + 6;
  const QRect bar(left, 4, width() - left - right, height() - 8);
  for (int x = 0; x < bar.width(); ++x)
    painter.fillRect(QRect(bar.left() + x, bar.top(), 1, bar.height()),
                     heatColor(static_cast<double>(x) / std::max(1, bar.width() - 1)));
  painter.setPen(theme.text2);
  painter.drawText(QRect(0, 0, left - 4, height()), Qt::AlignRight | Qt::AlignVCenter, worst);
  painter.drawText(QRect(width() - right + 4, 0, right, height()), Qt::AlignLeft | Qt::AlignVCenter, best);
}

}  // namespace hapticell::app
