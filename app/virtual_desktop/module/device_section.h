// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class VirtualDesktopController;
class DeviceCombo;
class InputPanel;

/// The section *Device*: stylus, station, state of the connection, second stylus, glove and 3-D mouse. GUI thread.
class DeviceSection : public QObject {
  Q_OBJECT
 public:
  /// The controller must outlive it.
  DeviceSection(VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent = nullptr);

  void showConnection();
  void showSecond();
  /// Shows the button that adds a hand for the glove if the cell has none.
  void showFreeHand();

 signals:
  void checkWanted();

 private:
  void addSecond(QVBoxLayout& section);
  void listDevices();

  VirtualDesktopController& controller_;
  QLabel *state_, *icon_, *second_state_;
  InputPanel* inputs_;
  DeviceCombo *stylus_, *second_;
  QPushButton *connect_, *check_;
};

}  // namespace hapticell::app
