// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>

#include "app/virtual_desktop/devices/mouse_stylus.h"

namespace hapticell::app {

class VirtualDesktopController;

/// The mouse as the hand of a simulated first stylus. GUI thread.
class MouseHand : public QObject {
 public:
  /// The owner must outlive it.
  explicit MouseHand(VirtualDesktopController& owner);

  MouseStylus& stylus() { return mouse_; }
  /// Updates the pen from the newest snapshot and the view.
  void update();

 private:
  void post(const haptic::HandTarget& target);

  VirtualDesktopController& owner_;
  MouseStylus mouse_;
  QElapsedTimer pressed_;
};

}  // namespace hapticell::app
