// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "app/controls/robot_picture.h"

namespace hapticell::app {

class RobotContext;

/// A small picture of the panel's robot in its present pose; drawn shortly after it moved, never while it is held.
class RobotThumbnail : public QWidget {
  Q_OBJECT
 public:
  explicit RobotThumbnail(RobotContext& context, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  /// Call it when another robot is shown.
  void showRobot();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void draw();
  RobotContext& context_;
  RobotPicture painter_;
  QImage picture_;
  QTimer later_;
  bool wanted_ = false;         ///< Draw as soon as the widget is visible.
  std::vector<double> joints_;  ///< The joint values in the picture.
};

}  // namespace hapticell::app
