// SPDX-License-Identifier: Apache-2.0
#include "app/style/narrow_words.h"

#include <QEvent>
#include <QLayout>
#include <QToolButton>
#include <utility>

namespace hapticell::app {

NarrowWords::NarrowWords(QWidget& row, std::vector<std::vector<QToolButton*>> groups)
    : QObject(&row), row_(row), groups_(std::move(groups)) {
  for (const auto& group : groups_)
    for (QToolButton* button : group) button->setMinimumWidth(1);  // The row may be narrower than its words.
  row_.installEventFilter(this);
}

bool NarrowWords::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &row_ && (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)) fit();
  return QObject::eventFilter(watched, event);
}

void NarrowWords::fit() {
  if (fitting_) return;
  fitting_ = true;
  // What all need with their words: the rest of the row keeps its least width.
  int needed = row_.layout()->totalMinimumSize().width();
  for (const auto& group : groups_)
    for (QToolButton* button : group) {
      if (!button->isVisibleTo(&row_)) continue;
      button->ensurePolished();
      const int icon = button->iconSize().width() + 14;
      needed += icon + button->fontMetrics().horizontalAdvance(button->text()) + 10 - button->minimumWidth();
    }
  for (auto group = groups_.rbegin(); group != groups_.rend(); ++group) {
    const bool words = needed <= row_.width();
    for (QToolButton* button : *group) {
      const auto style = words ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly;
      if (button->toolButtonStyle() != style) button->setToolButtonStyle(style);
      if (!words) needed -= button->fontMetrics().horizontalAdvance(button->text()) + 10;
    }
  }
  fitting_ = false;
}

}  // namespace hapticell::app
