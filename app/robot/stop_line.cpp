// SPDX-License-Identifier: Apache-2.0
#include "app/robot/stop_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include "app/kit/form.h"
#include "app/style/theme.h"
#include "app/viewport/overlay/overlay_painter.h"

namespace hapticell::app {

StopLine::StopLine(QWidget* parent) : QWidget(parent), words_(makeLive(2, TextRole::kSecond)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(20, 0, 0, 0);
  words_->setObjectName("labelStop");
  row->addWidget(words_);
  setMinimumHeight(34);
}

QString StopLine::sentence() const {
  return words_->text();
}

void StopLine::show(Mark mark, const QString& sentence) {
  if (mark == mark_ && sentence == words_->text()) return;
  mark_ = mark;
  words_->setText(sentence);
  const Theme& theme = themeOf(this->palette());
  QPalette colors = words_->palette();
  QColor color = theme.text2;
  if (mark == Mark::kLimit) color = theme.words.limit;
  if (mark == Mark::kContact) color = theme.words.contact;
  colors.setColor(QPalette::WindowText, color);
  words_->setPalette(colors);
  update();
}

void StopLine::paintEvent(QPaintEvent*) {
  if (mark_ == Mark::kNone || words_->text().isEmpty()) return;
  QPainter painter(this);
  paintMark(painter, mark_, QPointF(7, 9), 11, themeOf(palette()));
}

}  // namespace hapticell::app
