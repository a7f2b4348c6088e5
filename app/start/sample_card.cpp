// SPDX-License-Identifier: Apache-2.0
#include "app/start/sample_card.h"

#include <QPainter>
#include <QPainterPath>

#include "app/style/fonts.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {

SampleCard::SampleCard(const QPixmap& picture, const QString& title, const QString& sentence, QWidget* parent)
    : QAbstractButton(parent), picture_(picture), sentence_(sentence) {
  setText(title);
  setAccessibleName(title);
  setAccessibleDescription(sentence);
  setFocusPolicy(Qt::StrongFocus);
  setFixedSize(sizeHint());
  setAttribute(Qt::WA_Hover);
}

void SampleCard::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  const bool lit = underMouse() || hasFocus();
  drawBox(&painter, rect(), lit ? theme.selected_row : theme.dock, hasFocus() ? theme.selection : theme.line, 4);
  const QRect at(1, 1, width() - 2, 139);
  painter.save();
  QPainterPath round;
  round.addRoundedRect(QRectF(at), 4, 4);
  painter.setClipPath(round);
  if (picture_.isNull())
    painter.fillRect(at, theme.header);
  else
    painter.drawPixmap(at, picture_);
  painter.restore();
  painter.setPen(theme.text1);
  painter.setFont(textFont(TextRole::kSection));
  painter.drawText(QRect(12, 150, width() - 24, 20), Qt::AlignVCenter | Qt::AlignLeft, text());
  painter.setPen(theme.text2);
  painter.setFont(textFont(TextRole::kSecond));
  painter.drawText(QRect(12, 172, width() - 24, 52), Qt::AlignTop | Qt::TextWordWrap, sentence_);
}

}  // namespace hapticell::app
