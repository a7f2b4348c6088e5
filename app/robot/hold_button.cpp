// SPDX-License-Identifier: Apache-2.0
#include "app/robot/hold_button.h"

#include "app/style/icon.h"

namespace hapticell::app {
namespace {

constexpr int kFirstMilliseconds = 350;
constexpr int kAgainMilliseconds = 80;

}  // namespace

HoldButton::HoldButton(const QString& icon_name, const QString& purpose, QWidget* parent) : QPushButton(parent) {
  setIcon(app::icon(icon_name));
  setIconSize(QSize(12, 12));
  setFixedSize(26, 26);
  setToolTip(purpose);
  setAccessibleName(purpose);
  setFocusPolicy(Qt::TabFocus);
  connect(this, &QPushButton::pressed, this, [this] {
    emit began();
    emit stepped();
    repeat_.start(kFirstMilliseconds);
  });
  connect(this, &QPushButton::released, this, [this] {
    repeat_.stop();
    emit ended();
  });
  connect(&repeat_, &QTimer::timeout, this, [this] {
    repeat_.setInterval(kAgainMilliseconds);
    emit stepped();
  });
}

}  // namespace hapticell::app
