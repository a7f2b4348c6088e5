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

/// The switch of the forces, the force now, and what would bring forces back where none can act. GUI thread.
class ForceSection : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  ForceSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent = nullptr);

  void show();
  /// What the connected device bears.
  void showDevice();

 private:
  void mend();

  Host& host_;
  VirtualDesktopController& controller_;
  QCheckBox* forces_;
  QLabel *state_, *why_, *force_now_, *mend_why_;
  QStackedWidget* meter_or_fix_;
  ForceMeter* meter_;
  QPushButton* mend_;
};

}  // namespace hapticell::app
