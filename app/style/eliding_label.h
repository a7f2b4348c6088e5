// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QPainter>

namespace hapticell::app {

/// One line of plain text that gives way to its property "short" (where it has one) or ends with "…" where it has no
/// room, and says all of it as its tip; it never makes its panel wider.
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
