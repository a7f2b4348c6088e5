// SPDX-License-Identifier: Apache-2.0
#include "app/controls/joint_row.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/style/fonts.h"
#include "app/style/key_step.h"
#include "app/style/theme.h"
#include "app/style/units.h"

namespace hapticell::app {
JointRow::JointRow(const Scale& scale, QWidget* parent) : QWidget(parent), scale_(scale) {
  setFixedHeight(22);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(scale.name);
}

bool JointRow::event(QEvent* event) {
  // When it is wanted: the units in force may be others by then.
  if (event->type() == QEvent::ToolTip)
    setToolTip(tr("%1, %2 to %3").arg(scale_.name, textOf(scale_.lower), textOf(scale_.upper)));
  return QWidget::event(event);
}

void JointRow::setValue(double value) {
  value_ = value;
  if (std::abs(value - shown_) < 0.005) return;
  shown_ = value;
  setAccessibleDescription(valueText());
  update();
}

bool JointRow::isAtLimit() const {
  const double near = std::min(2.0, 0.01 * (scale_.upper - scale_.lower));
  return value_ <= scale_.lower + near || value_ >= scale_.upper - near;
}

QString JointRow::valueText() const {
  return textOf(value_);
}

QString JointRow::textOf(double value) const {
  return isAngle() ? angleText(value * kDegree) : lengthText(0.001 * value);
}

/// An end of the scale, short: whole degrees and millimetres, of larger units as many decimals as say the same.
QString JointRow::endText(double value) const {
  const Units units = unitsNow();
  const double factor = isAngle() ? kDegree * units.perRadian() : 0.001 * units.perMetre();
  const int decimals = factor >= 0.9 ? 0 : static_cast<int>(std::ceil(-std::log10(factor)));
  return numberText(factor * value, decimals) + (isAngle() && decimals == 0 ? units.angleUnit() : QString());
}

void JointRow::paintEnds(QPainter& painter) const {
  const Theme& theme = themeOf(palette());
  const QRect rail = track();
  const auto end = [&](double limit, const QRect& box, Qt::Alignment side) {
    const bool hit = isAtLimit() && std::abs(value_ - limit) < 0.5 * (scale_.upper - scale_.lower);
    painter.setPen(hit ? theme.words.limit : theme.text2);
    painter.drawText(box, Qt::AlignVCenter | side, endText(limit));
  };
  end(scale_.lower, QRect(scale_.name_width - 14, 0, rail.left() - scale_.name_width + 6, height()), Qt::AlignRight);
  end(scale_.upper, QRect(rail.right() + 10, 0, width() - rail.right() - 10, height()), Qt::AlignLeft);
}

QRect JointRow::track() const {
  const int left = scale_.name_width + (scale_.ends ? 28 : 2), right = scale_.ends ? 44 : 74;
  return {left, height() / 2, std::max(20, width() - left - right), 1};
}

int JointRow::pixelOf(double value) const {
  const QRect rail = track();
  const double share = (value - scale_.lower) / std::max(1e-9, scale_.upper - scale_.lower);
  return rail.left() + static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * rail.width()));
}

void JointRow::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(textFont(TextRole::kText));
  painter.setPen(isEnabled() ? theme.text1 : theme.text3);
  painter.drawText(QRect(0, 0, scale_.name_width, height()), Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(scale_.name, Qt::ElideRight, scale_.name_width));
  if (scale_.ends)
    paintEnds(painter);
  else
    painter.drawText(rect(), Qt::AlignVCenter | Qt::AlignRight, valueText());
  const QRect rail = track();
  const double y = rail.top() + 0.5;
  const bool limit = isAtLimit();
  painter.fillRect(QRectF(rail.left(), y - 1.0, rail.width(), 2.0), theme.line);
  for (const double end : {scale_.lower, scale_.upper}) {
    const bool hit = limit && std::abs(value_ - end) < 0.5 * (scale_.upper - scale_.lower);
    painter.fillRect(QRectF(pixelOf(end) - 1.0, y - 6.0, 2.0, 12.0), hit ? theme.limit : theme.text3);
  }
  if (scale_.lower < 0.0 && scale_.upper > 0.0)
    painter.fillRect(QRectF(pixelOf(0.0) - 0.5, y - 3.0, 1.0, 6.0), theme.text3);
  painter.setPen(Qt::NoPen);
  const QColor& place = limit ? theme.limit : theme.selection;
  painter.setBrush(isEnabled() ? place : theme.text3);
  painter.drawEllipse(QPointF(pixelOf(value_), y), 4.5, 4.5);
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.selection, 1.5));
  painter.drawEllipse(QPointF(pixelOf(value_), y), 7.5, 7.5);
}

void JointRow::moveTo(double pixel) {
  const QRect rail = track();
  const double share = std::clamp((pixel - rail.left()) / rail.width(), 0.0, 1.0);
  setValue(scale_.lower + share * (scale_.upper - scale_.lower));
  emit moved(value_);
}

void JointRow::mousePressEvent(QMouseEvent* event) {
  const QRect rail = track();
  if (event->button() != Qt::LeftButton || !rail.adjusted(-8, -12, 8, 12).contains(event->pos())) return;
  dragged_ = true;
  emit began();
  if (std::abs(event->position().x() - pixelOf(value_)) > 7.0) moveTo(event->position().x());
}

void JointRow::mouseMoveEvent(QMouseEvent* event) {
  if (dragged_) moveTo(event->position().x());
}

void JointRow::mouseReleaseEvent(QMouseEvent*) {
  if (!dragged_) return;
  dragged_ = false;
  emit ended(true);
}

void JointRow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && dragged_) {
    dragged_ = false;
    emit ended(false);
    return;
  }
  const int key = event->key();
  const int step = keyStep(key, Qt::Key_Left, Qt::Key_Right) + keyStep(key, Qt::Key_Down, Qt::Key_Up);
  if (step == 0 || dragged_) return QWidget::keyPressEvent(event);
  emit began();
  setValue(std::clamp(value_ + step, scale_.lower, scale_.upper));
  emit moved(value_);
  emit ended(true);
}

double unitOf(const kinematics::Joint& joint) {
  return joint.type == kinematics::JointType::kPrismatic ? 0.001 : kDegree;
}

JointRow::Scale scaleOf(const kinematics::Joint& joint, std::size_t number) {
  const double unit = unitOf(joint);
  const bool linear = joint.type == kinematics::JointType::kPrismatic;
  const double full = linear ? 1000.0 : 360.0;
  const double lower = std::isfinite(joint.lower) ? joint.lower / unit : -full;
  const double upper = std::isfinite(joint.upper) ? joint.upper / unit : full;
  const QString name =
      joint.name.size() <= 4 ? QString::fromStdString(joint.name) : QStringLiteral("A%1").arg(number + 1);
  return {name, linear ? QStringLiteral("mm") : QStringLiteral("°"), lower, upper};
}

}  // namespace hapticell::app
