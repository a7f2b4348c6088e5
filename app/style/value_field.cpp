// SPDX-License-Identifier: Apache-2.0
#include "app/style/value_field.h"

#include <QLineEdit>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {

ValueField::ValueField(const Format& format, QWidget* parent) : QDoubleSpinBox(parent), unit_(format.unit) {
  setButtonSymbols(NoButtons);
  setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setDecimals(format.decimals);
  setRange(format.minimum, format.maximum);
  setSingleStep(format.step);
  setKeyboardTracking(false);
  setFocusPolicy(Qt::StrongFocus);
  setFixedHeight(kFieldHeight);
  setLocale(QLocale::c());
  const int room = unit_.isEmpty() ? 0 : fontMetrics().horizontalAdvance(unit_) + 4;
  lineEdit()->setTextMargins(0, 0, room, 0);
  // Not QLineEdit::isModified(): the box writes the typed number anew before it tells that editing has ended.
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] { typed_ = true; });
  connect(this, &QDoubleSpinBox::editingFinished, this, [this] {
    if (!std::exchange(typed_, false)) return;
    emit edited(value());
  });
}

QString ValueField::textFromValue(double value) const {
  const double unit_of_last_place = std::pow(10.0, -decimals());
  if (std::abs(value) < 0.5 * unit_of_last_place) value = 0.0;
  return QLocale::c().toString(value, 'f', decimals()).remove(QLatin1Char(','));
}

QSize ValueField::sizeHint() const { return {76, kFieldHeight}; }
QSize ValueField::minimumSizeHint() const { return {44, kFieldHeight}; }

void ValueField::paintEvent(QPaintEvent* event) {
  QDoubleSpinBox::paintEvent(event);
  if (unit_.isEmpty()) return;
  QPainter painter(this);
  painter.setPen(isEnabled() ? themeOf(palette()).text2 : themeOf(palette()).text3);
  painter.drawText(rect().adjusted(0, 0, -6, 0), Qt::AlignRight | Qt::AlignVCenter, unit_);
}

void ValueField::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QDoubleSpinBox::wheelEvent(event);
  else
    event->ignore();
}

void ValueField::stepBy(int steps) {
  QDoubleSpinBox::stepBy(steps);
  emit edited(value());
}

}  // namespace hapticell::app
