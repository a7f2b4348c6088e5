// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QPainter>

namespace hapticell::app {

/// One line of plain text. If there is no room, it shows its property "short" (if set) or ends with "…", and its tool
/// tip has the whole text; it never makes its panel wider.
class ElidingLabel : public QLabel {
 public:
  using QLabel::QLabel;
  QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    const QString brief = property("short").toString();
    const bool fits = fontMetrics().horizontalAdvance(text()) <= contentsRect().width();
    const QString shown =
        fontMetrics().elidedText(fits || brief.isEmpty() ? text() : brief, Qt::ElideRight, contentsRect().width());
    setToolTip(shown == text() ? QString() : text());
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    painter.drawText(contentsRect(), static_cast<int>(alignment()) | Qt::TextSingleLine, shown);
  }
};

}  // namespace hapticell::app
