// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QCheckBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class VirtualDesktopController;
class ForceMeter;

/// The switch of the forces, the present force, and the remedy if forces cannot act. GUI thread.
class ForceSection : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  ForceSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent = nullptr);

  void show();
  /// Shows the limits of the connected device.
  void showDevice();

 private:
  void fix();

  Host& host_;
  VirtualDesktopController& controller_;
  QCheckBox* forces_;
  QLabel *state_, *why_, *force_now_, *mend_why_;
  QStackedWidget* meter_or_fix_;
  ForceMeter* meter_;
  QPushButton* fix_;
};

}  // namespace hapticell::app
