// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/pair_delegate.h"

#include <QPainter>

#include "app/panels/collisions/pair_table_model.h"
#include "app/style/fonts.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"
#include "app/viewport/overlay/overlay_painter.h"

namespace hapticell::app {
namespace {

constexpr int kBarWidth = 64;

Mark markOf(const QModelIndex& index) {
  return static_cast<Mark>(index.data(PairTableModel::kMarkRole).toInt());
}

void paintBar(QPainter& painter, const QRect& bar, const QModelIndex& index, const Theme& theme) {
  const Mark mark = markOf(index);
  const double share = index.data(PairTableModel::kShareRole).toDouble();
  const int threshold =
      bar.left() + static_cast<int>(bar.width() * index.data(PairTableModel::kThresholdRole).toDouble());
  painter.fillRect(bar, theme.field);
  if (mark == Mark::kContact)
    paintMark(painter, mark, QPointF(bar.left() + 4.0, bar.center().y() + 0.5), 8, theme);
  else
    painter.fillRect(QRect(bar.left(), bar.top(), static_cast<int>(bar.width() * share), bar.height()),
                     mark == Mark::kNearMiss ? theme.near_miss : theme.text3);
  painter.setPen(QPen(theme.text1, 1.0, Qt::DotLine));
  painter.drawLine(threshold, bar.top() - 2, threshold, bar.bottom() + 2);
}

/// The mark in front of the state's word: the shape says it too.
void paintState(QPainter& painter, const QPointF& center, const QModelIndex& index, const Theme& theme) {
  painter.setPen(QPen(theme.text3, 1.3));
  if (!index.data(PairTableModel::kCheckedRole).toBool())
    painter.drawLine(center - QPointF(4, 0), center + QPointF(4, 0));
  else if (markOf(index) == Mark::kNone)
    painter.drawEllipse(center, 3.5, 3.5);
  else
    paintMark(painter, markOf(index), center, 11, theme);
}

void paintSwitch(QPainter& painter, const QStyleOptionViewItem& item, bool on) {
  QStyleOption option;
  option.rect = QRect(item.rect.right() - 46, item.rect.center().y() - 7, 30, 16);
  option.palette = item.palette;
  option.state = QStyle::State_Enabled | (on ? QStyle::State_On : QStyle::State_Off);
  drawSwitch(&painter, &option);
}

}  // namespace

void PairDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const Theme& theme = themeOf(option.palette);
  const bool checked = index.data(PairTableModel::kCheckedRole).toBool();
  const bool measured = index.data(PairTableModel::kShareRole).isValid();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (option.state.testFlag(QStyle::State_Selected)) {
    painter->fillRect(option.rect, theme.selected_row);
    if (index.column() == 0)
      painter->fillRect(QRect(option.rect.left(), option.rect.top(), 2, option.rect.height()), theme.selection);
  }
  painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), theme.header);
  QRect text = option.rect.adjusted(8, 0, -8, 0);
  QColor color = measured ? theme.text1 : theme.text2;
  if (!checked) color = theme.text3;
  if (index.column() == PairTableModel::kState) {
    paintState(*painter, QPointF(text.left() + 10.0, text.center().y() + 0.5), index, theme);
    if (checked && markOf(index) == Mark::kContact) color = theme.words.contact;
    if (checked && markOf(index) == Mark::kNearMiss) color = theme.words.near_miss;
    text.adjust(26, 0, 0, 0);
  } else if (index.column() == PairTableModel::kDistance) {
    const bool bar = option.rect.width() >= kDistanceRoom + kBarRoom;
    if (bar && measured)
      paintBar(*painter, QRect(text.right() - kBarWidth, text.center().y() - 4, kBarWidth, 9), index, theme);
    if (bar) text.adjust(0, 0, -kBarWidth - 10, 0);
  } else if (index.column() == PairTableModel::kOnContact && index.data(PairTableModel::kOwnRole).toBool()) {
    painter->setFont(textFont(TextRole::kSection));
  } else if (index.column() == PairTableModel::kCheck && !index.data(PairTableModel::kOneBodyRole).toBool()) {
    paintSwitch(*painter, option, checked);
  }
  painter->setPen(color);
  const QString words = painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, text.width());
  painter->drawText(text, index.data(Qt::TextAlignmentRole).toInt(), words);
  painter->restore();
}

}  // namespace hapticell::app
