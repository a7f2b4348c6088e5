// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

#include "kinematics/model/robot_model.h"

namespace hapticell::app {

/// One joint: name, a scale from limit to limit with a knob, the value. Dragging the knob is one change from began() to
/// ended(); each press of an arrow key is a change by one degree (or millimetre). Escape reverts a drag.
class JointRow : public QWidget {
  Q_OBJECT
 public:
  /// How the values of a joint are shown, in degrees or millimetres.
  struct Scale {
    QString name, unit;
    double lower = -180.0, upper = 180.0;
    bool ends = false;    ///< Shows the limits at both ends in place of the value.
    int name_width = 38;  ///< px
  };
  explicit JointRow(const Scale& scale, QWidget* parent = nullptr);

  void setValue(double value);
  double value() const { return value_; }
  bool isDragged() const { return dragged_; }
  /// True within a hundredth of the range (at most 2 units) of a limit.
  bool isAtLimit() const;
  /// "22.8°", in the units that the user chose.
  QString valueText() const;
  /// Pixel position of a value on the scale.
  int pixelOf(double value) const;
  QSize sizeHint() const override { return {200, 22}; }

 signals:
  void began();
  void moved(double value);
  void ended(bool keep);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool isAngle() const { return scale_.unit == QStringLiteral("°"); }
  QString textOf(double value) const;
  QString endText(double value) const;
  void paintEnds(QPainter& painter) const;
  void moveTo(double pixel);
  QRect track() const;
  Scale scale_;
  double value_ = 0.0;
  double shown_ = 0.0;  ///< The value that was painted last.
  bool dragged_ = false;
};

/// The scale of a joint: limits in degrees or millimetres; the joint's name if it is short, else "A1".
JointRow::Scale scaleOf(const kinematics::Joint& joint, std::size_t number);
/// Size of one unit of the scale, in radians or metres.
double unitOf(const kinematics::Joint& joint);

}  // namespace hapticell::app
