// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "app/virtual_desktop/devices/input_devices.h"
#include "app/virtual_desktop/devices/mouse_stylus.h"
#include "app/virtual_desktop/module/glove_control.h"
#include "app/virtual_desktop/module/second_stylus_control.h"

namespace hapticell::app {

/// What a glove and a 3-D mouse do: looks at them while there is one. GUI thread.
class InputControl : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  InputControl(VirtualDesktopController& owner, SecondStylusControl& second);

  InputDevices& devices() { return devices_; }
  GloveControl& glove() { return glove_; }
  /// Where a real hand holds the first stylus the 3-D mouse that is to move entities is the second one, until it moves
  /// the view again. To be called when a stylus came or went.
  void settleMouse();
  /// See VirtualDesktopController.
  void addFreeHand();
  bool hasFreeHand() const;

 private:
  void take();
  void driveByMouse(double seconds);
  MouseStylus* penOfMouse();

  VirtualDesktopController& owner_;
  SecondStylusControl& second_;
  InputDevices devices_;
  GloveControl glove_;
  QTimer timer_;
  QElapsedTimer clock_;
  std::uint32_t buttons_ = 0;
  bool mouse_is_second_ = false;  // The 3-D mouse, since it is to move entities.
};

}  // namespace hapticell::app
