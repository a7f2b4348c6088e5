// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QPainter>

#include "app/style/fonts.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {

/// A key as on the keyboard: its name in a small frame.
class KeyCap final : public QLabel {
 public:
  explicit KeyCap(QWidget* parent = nullptr) : QLabel(parent) {
    setFont(textFont(TextRole::kKeyCap));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  }
  QSize sizeHint() const override { return {fontMetrics().horizontalAdvance(text()) + 12, 20}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme& theme = themeOf(palette());
    QPainter painter(this);
    drawBox(&painter, rect(), theme.field, theme.line, 3.0);
    painter.setPen(theme.text1);
    painter.drawText(rect(), Qt::AlignCenter, text());
  }
};

}  // namespace hapticell::app
