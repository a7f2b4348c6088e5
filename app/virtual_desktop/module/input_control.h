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

/// What a glove and a 3D mouse do: polls them while there is one. GUI thread.
class InputControl : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  InputControl(VirtualDesktopController& owner, SecondStylusControl& second);

  InputDevices& devices() { return devices_; }
  GloveControl& glove() { return glove_; }
  /// If a real hand holds the first stylus, a 3D mouse that is set to move entities becomes the second stylus, until it
  /// moves the view again. Call it when a stylus was connected or removed.
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
  bool mouse_is_second_ = false;  // The 3D mouse is the second stylus, because it is set to move entities.
};

}  // namespace hapticell::app
