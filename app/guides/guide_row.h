// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHBoxLayout>
#include <QWidget>
#include <initializer_list>

namespace hapticell::app {

/// A field and the widgets next to it, as a row in the forms of guides.
inline QWidget* guideRow(QWidget* field, std::initializer_list<QWidget*> more) {
  auto* holder = new QWidget;
  auto* row = new QHBoxLayout(holder);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(field, 1);
  for (QWidget* widget : more) row->addWidget(widget);
  return holder;
}

}  // namespace hapticell::app
