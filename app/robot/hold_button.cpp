// SPDX-License-Identifier: Apache-2.0
#include "app/robot/hold_button.h"

#include "app/style/icon.h"

namespace hapticell::app {
namespace {

// ms until a held button repeats, about as keyboards do. Half: a click makes two steps; twice: one waits.
constexpr int kFirstMilliseconds = 350;
// ms a step while held, 12 a second. Half: too fast to stop; twice: slow.
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
