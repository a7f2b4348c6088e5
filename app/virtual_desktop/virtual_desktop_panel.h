// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class ForceMeter;
class Host;
class Segmented;
class VirtualDesktopController;
class WorkspaceView;

/// The panel of the haptic module: switch and force first, then device, what is held, axes and scale, feel, the hand in
/// its workspace, loop rates. Shows what the controller says and asks it for changes.
class VirtualDesktopPanel : public QWidget {
  Q_OBJECT
 public:
  VirtualDesktopPanel(Host& host, VirtualDesktopController& controller, QWidget* parent = nullptr);

 private:
  void addForces(QVBoxLayout& column);
  void addDevice(QVBoxLayout& column);
  void addHeld(QVBoxLayout& column);
  void addAxes(QVBoxLayout& column);
  void addFeel(QVBoxLayout& column);
  void addHand(QVBoxLayout& column);
  void addRates(QVBoxLayout& column);
  void showSnapshot();
  void showSettings();
  void showConnection();
  void showForces();
  void listEntities();

  Host& host_;
  VirtualDesktopController& controller_;
  QCheckBox* forces_;
  QLabel *forces_state_, *forces_why_, *force_now_, *device_state_, *device_icon_, *stylus_, *scale_note_,
      *workspace_text_;
  QLabel* rates_[3][2];
  ForceMeter* meter_;
  WorkspaceView* workspace_;
  QPushButton* connect_;
  QComboBox* entity_;
  Segmented *moved_by_, *on_contact_, *axes_, *free_, *scale_, *force_class_;
  QCheckBox *translates_, *rotates_;
  bool filling_ = false;
};

}  // namespace hapticell::app
