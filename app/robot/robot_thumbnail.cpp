// SPDX-License-Identifier: Apache-2.0
#include "app/robot/robot_thumbnail.h"

#include <QPainter>
#include <utility>

#include "app/kit/form.h"
#include "app/robot/robot_context.h"
#include "app/style/icon.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kHeight = 120;
// ms after a change until it is drawn again. Half: drawn while one drags; twice: it lags.
constexpr int kLaterMilliseconds = 250;

}  // namespace

RobotThumbnail::RobotThumbnail(RobotContext& context, QWidget* parent) : QWidget(parent), context_(context) {
  setFixedHeight(kHeight);
  setAccessibleName(tr("Picture of the robot"));
  later_.setSingleShot(true);
  later_.setInterval(kLaterMilliseconds);
  connect(&later_, &QTimer::timeout, this, &RobotThumbnail::draw);
  connect(&context_, &RobotContext::documentChanged, this, [this] {
    if (context_.robot() && context_.robot()->joints() != joints_) later_.start();
  });
}

QSize RobotThumbnail::sizeHint() const {
  return {300, kHeight};
}

void RobotThumbnail::showRobot() {
  picture_ = {};
  later_.start();
  update();
}

void RobotThumbnail::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  later_.start();
}

void RobotThumbnail::draw() {
  const workcell::Entity* robot = context_.robot();
  if (!robot) return;
  // Behind another tab it would only hold the window up.
  if (!isSeen(*this)) return void(wanted_ = true);
  if (context_.isHeld()) return later_.start();
  workcell::Entity alone = *robot;
  alone.visible = true;
  const double scale = devicePixelRatioF();
  joints_ = robot->joints();
  picture_ = painter_.draw({std::move(alone)}, (QSizeF(size()) * scale).toSize(), themeOf(palette()));
  picture_.setDevicePixelRatio(scale);
  update();
}

void RobotThumbnail::paintEvent(QPaintEvent*) {
  if (std::exchange(wanted_, false)) later_.start();
  QPainter painter(this);
  if (!picture_.isNull()) {
    painter.drawImage(0, 0, picture_);
    return;
  }
  painter.fillRect(rect(), themeOf(palette()).field);
  const QPixmap symbol = icon("robot", themeOf(palette()).text3).pixmap(48, 48);
  painter.drawPixmap((width() - 48) / 2, (height() - 48) / 2, symbol);
}

}  // namespace hapticell::app
