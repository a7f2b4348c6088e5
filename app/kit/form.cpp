// SPDX-License-Identifier: Apache-2.0
#include "app/kit/form.h"

#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "app/style/theme.h"

namespace hapticell::app {

QLabel* makeLabel(const QString& text, TextRole role, bool quiet) {
  auto* label = new QLabel(text);
  label->setTextFormat(Qt::PlainText);  // A name in a file may look like HTML.
  label->setFont(textFont(role));
  if (quiet) label->setForegroundRole(kQuietText);
  return label;
}

LiveLabel* makeLive(int lines, TextRole role, bool quiet) {
  auto* label = new LiveLabel(lines);
  label->setFont(textFont(role));
  if (quiet) label->setForegroundRole(kQuietText);
  return label;
}

QVBoxLayout* addSection(QVBoxLayout& column, const QString& heading) {
  auto* section = new QVBoxLayout;
  section->setContentsMargins(12, 10, 12, 10);
  section->setSpacing(6);
  if (!heading.isEmpty()) section->addWidget(makeLabel(heading, TextRole::kSection, true));
  column.addLayout(section);
  auto* line = new QFrame;
  line->setFixedHeight(1);
  line->setBackgroundRole(QPalette::Mid);
  line->setAutoFillBackground(true);
  column.addWidget(line);
  return section;
}

QWidget* addRow(QVBoxLayout& section, const QString& name, QWidget* field, int label_width) {
  auto* holder = new QWidget;
  auto* row = new QHBoxLayout(holder);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  auto* label = makeLabel(name, TextRole::kText, true);
  label->setFixedWidth(label_width);
  label->setBuddy(field);
  field->setAccessibleName(name);
  // A long choice must not make the panel wider than its dock.
  QList<QComboBox*> choices = field->findChildren<QComboBox*>();
  if (auto* self = qobject_cast<QComboBox*>(field)) choices << self;
  for (QComboBox* choice : choices) {
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(std::max(choice->minimumContentsLength(), 4));
  }
  row->addWidget(label);
  row->addWidget(field, 1);
  section.addWidget(holder);
  return holder;
}

bool isSeen(const QWidget& widget) {
  return widget.isVisible() && !widget.visibleRegion().isEmpty();
}

QPushButton* makeButton(const char* name, const QString& text, const QString& tip) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  return button;
}

QWidget* sideBySide(std::initializer_list<QWidget*> fields) {
  auto* holder = new QWidget;
  auto* row = new QHBoxLayout(holder);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  for (QWidget* field : fields) row->addWidget(field, 1);
  return holder;
}

QScrollArea* scrolledPanel(QWidget* content, int minimum_width) {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(minimum_width);
  scroll->setWidget(content);
  return scroll;
}

}  // namespace hapticell::app
