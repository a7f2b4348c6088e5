// SPDX-License-Identifier: Apache-2.0
#include "app/kit/swatch_row.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "app/style/key_step.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {

std::vector<QColor> quietColors() {
  return {QColor("#B8BDC2"), QColor("#8D949B"), QColor("#4D545C"),
          QColor("#A99A86"), QColor("#7F93A8"), QColor("#93A48C")};
}

SwatchRow::SwatchRow(std::vector<QColor> colors, QWidget* parent) : QWidget(parent), colors_(std::move(colors)) {
  setFixedHeight(kFieldHeight);
  setFocusPolicy(Qt::StrongFocus);
}

void SwatchRow::setCurrent(const QColor& color) {
  if (color.rgb() == current_.rgb() && current_.isValid()) return;
  current_ = color;
  setAccessibleDescription(color.name());
  update();
}

int SwatchRow::currentIndex() const {
  const auto found = std::find_if(colors_.begin(), colors_.end(),
                                  [this](const QColor& color) { return color.rgb() == current_.rgb(); });
  return found == colors_.end() ? -1 : static_cast<int>(found - colors_.begin());
}

void SwatchRow::offerOther() {
  offers_other_ = true;
  update();
}

QRect SwatchRow::swatch(int index) const {
  const int count = static_cast<int>(colors_.size()) + (offers_other_ ? 2 : 1);
  const int pitch = std::min(26, width() / std::max(1, count));
  return {(index + 1) * pitch, 3, pitch - 4, height() - 6};
}

void SwatchRow::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  const int chosen = currentIndex();
  // The entity's own colour stands first, so that nothing is lost by trying another.
  drawBox(&painter, swatch(-1), current_, hasFocus() ? theme.selection : theme.line, 3.0);
  for (int i = 0; i < static_cast<int>(colors_.size()); ++i) {
    drawBox(&painter, swatch(i), colors_[static_cast<std::size_t>(i)], theme.line, 3.0);
    if (i != chosen) continue;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.selection, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(swatch(i)).adjusted(-1, -1, 1, 1), 4, 4);
  }
  if (!offers_other_) return;
  const QRect other = swatch(static_cast<int>(colors_.size()));
  drawBox(&painter, other, theme.button, theme.line, 3.0);
  painter.setPen(theme.text1);
  painter.drawText(other, Qt::AlignCenter, QStringLiteral("…"));
}

bool SwatchRow::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && offers_other_) {
    const auto* help = static_cast<QHelpEvent*>(event);
    if (swatch(static_cast<int>(colors_.size())).contains(help->pos()))
      QToolTip::showText(help->globalPos(), tr("Another colour…"), this);
    else
      QToolTip::hideText();
    return true;
  }
  return QWidget::event(event);
}

void SwatchRow::mousePressEvent(QMouseEvent* event) {
  for (int i = 0; i < static_cast<int>(colors_.size()); ++i)
    if (swatch(i).adjusted(-2, -3, 2, 3).contains(event->pos())) emit chosen(colors_[static_cast<std::size_t>(i)]);
  if (offers_other_ && swatch(static_cast<int>(colors_.size())).adjusted(-2, -3, 2, 3).contains(event->pos()))
    emit otherWanted();
}

void SwatchRow::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && offers_other_) return emit otherWanted();
  const int step = keyStep(event->key(), Qt::Key_Left, Qt::Key_Right);
  if (step == 0) return QWidget::keyPressEvent(event);
  const int next = std::clamp(currentIndex() + step, 0, static_cast<int>(colors_.size()) - 1);
  emit chosen(colors_[static_cast<std::size_t>(next)]);
}

}  // namespace hapticell::app
