// SPDX-License-Identifier: Apache-2.0
#include "app/panels/pair_set_list.h"

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

PairSetList::PairSetList(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Pair sets"));
}

QSize PairSetList::sizeHint() const {
  return {180, kSetRow * std::max(1, static_cast<int>(rows_.size()))};
}

void PairSetList::setSets(const std::vector<workcell::PairSet>& sets) {
  rows_.clear();
  for (const auto& set : sets) rows_.push_back({QString::fromStdString(set.name), set.enabled});
  current_ = rows_.empty() ? -1 : std::clamp(current_, 0, static_cast<int>(rows_.size()) - 1);
  updateGeometry();
  update();
}

void PairSetList::setCurrent(int index) {
  if (index < 0 || index >= static_cast<int>(rows_.size()) || index == current_) return;
  current_ = index;
  setAccessibleDescription(rows_[static_cast<std::size_t>(index)].name);
  update();
  emit chosen(index);
}

void PairSetList::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  painter.setFont(textFont(TextRole::kText));
  if (rows_.empty()) {
    painter.setPen(theme.text2);
    painter.drawText(rect().adjusted(12, 0, -4, 0), Qt::AlignVCenter, tr("Everything against everything"));
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
    const QRect words = line.adjusted(52, 0, -6, 0);
    painter.drawText(words, Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(row.name, Qt::ElideRight, words.width()));
  }
}

void PairSetList::mousePressEvent(QMouseEvent* event) {
  const int row = event->pos().y() / kSetRow;
  if (event->button() != Qt::LeftButton || row < 0 || row >= static_cast<int>(rows_.size())) return;
  setCurrent(row);
  if (event->pos().x() < 48) emit switched(row, !rows_[static_cast<std::size_t>(row)].on);
}

void PairSetList::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
  if (step != 0) return setCurrent(current_ + step);
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && current_ >= 0)
    return emit switched(current_, !rows_[static_cast<std::size_t>(current_)].on);
  QWidget::keyPressEvent(event);
}

}  // namespace hapticell::app
