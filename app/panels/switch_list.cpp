// SPDX-License-Identifier: Apache-2.0
#include "app/panels/switch_list.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyleOption>
#include <algorithm>

#include "app/style/fonts.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kSetRow = 26;

}  // namespace

SwitchList::SwitchList(const QString& empty, QWidget* parent) : QWidget(parent), empty_(empty) {
  setFocusPolicy(Qt::StrongFocus);
}

QSize SwitchList::sizeHint() const {
  return {180, kSetRow * std::max(1, static_cast<int>(rows_.size()))};
}

void SwitchList::setRows(std::vector<Row> rows) {
  rows_ = std::move(rows);
  current_ = rows_.empty() ? -1 : std::clamp(current_, 0, static_cast<int>(rows_.size()) - 1);
  updateGeometry();
  update();
}

void SwitchList::setAlerts(const std::map<QString, int>& alerts) {
  if (alerts == alerts_) return;
  alerts_ = alerts;
  update();
}

void SwitchList::setCurrent(int index) {
  if (index < 0 || index >= static_cast<int>(rows_.size()) || index == current_) return;
  current_ = index;
  setAccessibleDescription(rows_[static_cast<std::size_t>(index)].name);
  update();
  emit chosen(index);
}

void SwitchList::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  painter.setFont(textFont(TextRole::kText));
  if (rows_.empty()) {
    painter.setPen(theme.text2);
    painter.drawText(rect().adjusted(12, 0, -4, 0), Qt::AlignVCenter, empty_);
  }
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
    const Row& row = rows_[static_cast<std::size_t>(i)];
    const QRect line(0, i * kSetRow, width(), kSetRow);
    if (i == current_) {
      painter.fillRect(line, theme.selected_row);
      painter.fillRect(QRect(0, line.top(), 2, kSetRow), theme.selection);
    }
    QStyleOption option;
    option.rect = QRect(12, line.center().y() - 7, 30, 16);
    option.palette = palette();
    option.state = QStyle::State_Enabled | (row.on ? QStyle::State_On : QStyle::State_Off);
    drawSwitch(&painter, &option);
    painter.setPen(row.on ? theme.text1 : theme.text3);
    QRect words = line.adjusted(52, 0, -12, 0);
    if (const auto alerts = alerts_.find(row.name); alerts != alerts_.end() && alerts->second > 0) {
      painter.setPen(theme.text2);
      painter.drawText(words, Qt::AlignVCenter | Qt::AlignRight, QString::number(alerts->second));
      words.adjust(0, 0, -22, 0);
      painter.setPen(row.on ? theme.text1 : theme.text3);
    }
    painter.drawText(words, Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(row.name, Qt::ElideRight, words.width()));
  }
}

void SwitchList::mousePressEvent(QMouseEvent* event) {
  const int row = event->pos().y() / kSetRow;
  if (event->button() != Qt::LeftButton || row < 0 || row >= static_cast<int>(rows_.size())) return;
  setCurrent(row);
  if (event->pos().x() < 48) emit switched(row, !rows_[static_cast<std::size_t>(row)].on);
}

void SwitchList::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
  if (step != 0) return setCurrent(current_ + step);
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && current_ >= 0)
    return emit switched(current_, !rows_[static_cast<std::size_t>(current_)].on);
  QWidget::keyPressEvent(event);
}

}  // namespace hapticell::app
