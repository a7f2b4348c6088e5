// SPDX-License-Identifier: Apache-2.0
#include "app/style/live_label.h"

#include <QPainter>
#include <QTextLayout>

namespace hapticell::app {

LiveLabel::LiveLabel(int lines, QWidget* parent) : QLabel(parent), lines_(lines) {
  setTextFormat(Qt::PlainText);
  setAlignment(Qt::AlignLeft | Qt::AlignTop);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize LiveLabel::minimumSizeHint() const {
  const QMargins room = contentsMargins();
  return {room.left() + room.right(), lines_ * fontMetrics().lineSpacing() + room.top() + room.bottom()};
}

QSize LiveLabel::sizeHint() const {
  constexpr int kUsual = 80;  // Pixels; it takes what there is.
  return minimumSizeHint() + QSize(kUsual, 0);
}

QStringList LiveLabel::shownLines() const {
  const int width = contentsRect().width();
  QStringList shown;
  const QStringList paragraphs = text().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  for (qsizetype at = 0; at < paragraphs.size(); ++at) {
    const QString& words = paragraphs[at];
    QTextLayout layout(words, font());
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
      line.setLineWidth(width);
      const int end = line.textStart() + line.textLength();
      if (shown.size() + 1 == lines_ && (end < words.size() || at + 1 < paragraphs.size())) {
        QString rest = words.mid(line.textStart());
        for (qsizetype next = at + 1; next < paragraphs.size(); ++next) rest += QLatin1Char(' ') + paragraphs[next];
        layout.endLayout();
        return shown << fontMetrics().elidedText(rest, Qt::ElideRight, width);
      }
      shown << words.mid(line.textStart(), line.textLength()).trimmed();
    }
    layout.endLayout();
  }
  return shown;
}

void LiveLabel::paintEvent(QPaintEvent*) {
  const QStringList shown = shownLines();
  const QString tip = isWhole() ? QString() : text();
  if (tip != tip_ && (!tip.isEmpty() || toolTip() == tip_)) setToolTip(tip);  // A tip of its own stays.
  tip_ = tip;
  QPainter painter(this);
  painter.setFont(font());
  painter.setPen(palette().color(foregroundRole()));
  const int step = fontMetrics().lineSpacing();
  QRect row = contentsRect();
  if (alignment() & Qt::AlignVCenter) row.translate(0, (row.height() - static_cast<int>(shown.size()) * step) / 2);
  row.setHeight(step);
  for (const QString& line : shown) {
    painter.drawText(
        row, static_cast<int>(alignment() & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter | Qt::TextSingleLine, line);
    row.translate(0, step);
  }
}

}  // namespace hapticell::app
