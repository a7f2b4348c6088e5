// SPDX-License-Identifier: Apache-2.0
#include "app/style/segmented.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>

#include "app/style/fonts.h"
#include "app/style/key_step.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

class Segment final : public QAbstractButton {
 public:
  explicit Segment(const QString& text, QWidget* parent) : QAbstractButton(parent) {
    setText(text);
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);  // It may be narrower than it likes.
    setAttribute(Qt::WA_Hover);
    setAccessibleName(text);
  }
  QSize sizeHint() const override { return {wide(TextRole::kSection) + 14, kFieldHeight}; }
  QSize minimumSizeHint() const override { return {wide(TextRole::kKeyCap) + 2, kFieldHeight}; }

 protected:
  /// Where the dock is narrow the words become smaller before any is cut.
  void resizeEvent(QResizeEvent*) override {
    const QFont wanted = textFont(wide(TextRole::kSection) + 4 > width() ? TextRole::kKeyCap : TextRole::kText);
    if (wanted != font()) setFont(wanted);
  }
  void paintEvent(QPaintEvent*) override {
    const Theme& theme = themeOf(palette());
    QPainter painter(this);
    if (isChecked())
      drawBox(&painter, rect().adjusted(1, 1, -1, -1), isEnabled() ? theme.on : theme.line, QColor(), 3.0);
    else if (underMouse() && isEnabled())
      drawBox(&painter, rect().adjusted(1, 1, -1, -1), theme.header, QColor(), 3.0);
    const QColor& text_color = isChecked() ? theme.on_text : theme.text1;
    painter.setPen(isEnabled() ? text_color : theme.text3);
    QFont text_font = font();
    if (isChecked()) text_font.setWeight(QFont::Medium);
    painter.setFont(text_font);
    painter.drawText(rect(), Qt::AlignCenter, painter.fontMetrics().elidedText(text(), Qt::ElideRight, width()));
    if (hasFocus()) {
      painter.setRenderHint(QPainter::Antialiasing);
      painter.setPen(QPen(theme.selection, 2.0));
      painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), kRadius, kRadius);
    }
  }

 private:
  int wide(TextRole role) const { return QFontMetrics(textFont(role)).horizontalAdvance(text()); }
};

}  // namespace

Segmented::Segmented(const QStringList& choices, QWidget* parent, Kind kind)
    : QWidget(parent), group_(new QButtonGroup(this)) {
  group_->setExclusive(kind == Kind::kOne);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  for (const QString& choice : choices) {
    auto* segment = new Segment(choice, this);
    group_->addButton(segment, static_cast<int>(group_->buttons().size()));
    row->addWidget(segment, 1);
  }
  setFixedHeight(kFieldHeight);
  connect(group_, &QButtonGroup::idClicked, this, &Segmented::chosen);
}

int Segmented::current() const {
  return group_->checkedId();
}

void Segmented::setCurrent(int index) {
  if (QAbstractButton* wanted = button(index)) {
    wanted->setChecked(true);
    return;
  }
  group_->setExclusive(false);
  for (QAbstractButton* other : group_->buttons()) other->setChecked(false);
  group_->setExclusive(true);
}

void Segmented::setChoiceEnabled(int index, bool on, const QString& why) {
  if (QAbstractButton* wanted = button(index)) {
    wanted->setEnabled(on);
    wanted->setToolTip(on ? QString() : why);
  }
}

QAbstractButton* Segmented::button(int index) const {
  return group_->button(index);
}

QSize Segmented::sizeHint() const {
  int width = 0;
  for (const QAbstractButton* segment : group_->buttons()) width += segment->sizeHint().width();
  return {width, kFieldHeight};
}

void Segmented::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  drawBox(&painter, rect(), theme.button, theme.line);
  painter.setPen(theme.line);
  // Choices that do not apply are hidden: no line stands where they would begin.
  const QAbstractButton* left = nullptr;
  for (const QAbstractButton* segment : group_->buttons()) {
    if (segment->isHidden()) continue;
    if (left && left->isChecked() == segment->isChecked())
      painter.drawLine(segment->geometry().left(), 1, segment->geometry().left(), height() - 2);
    left = segment;
  }
}

void Segmented::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const int step = keyStep(key, Qt::Key_Left, Qt::Key_Right) + keyStep(key, Qt::Key_Up, Qt::Key_Down);
  if (step == 0) {
    QWidget::keyPressEvent(event);
    return;
  }
  int from = current();
  for (int i = 0; i < group_->buttons().size(); ++i)
    if (button(i)->hasFocus()) from = i;
  for (int i = from + step; i >= 0 && i < group_->buttons().size(); i += step) {
    if (!button(i)->isEnabled()) continue;
    button(i)->setFocus();
    if (group_->exclusive()) button(i)->click();
    return;
  }
}

}  // namespace hapticell::app
