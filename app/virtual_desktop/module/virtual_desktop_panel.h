// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <span>

#include "app/style/steady_number.h"
#include "app/virtual_desktop/devices/virtual_desktop_settings.h"

class QAbstractButton;
class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace hapticell::manipulation {
struct SceneSnapshot;
}

namespace hapticell::app {

class DeviceCheckPanel;
class DeviceCombo;
class ForceMeter;
class Host;
class InputPanel;
class Segmented;
class ValueField;
class VirtualDesktopController;
class WorkspaceView;

/// The ways of moving an entity that can be chosen in the panel, in their order there.
std::span<const manipulation::MovedBy> waysOffered();

/// The panel of the haptic module: switch and force first, then device, what is held, axes and scale, feel, the hand in
/// its workspace, loop rates. Shows what the controller says and asks it for changes.
class VirtualDesktopPanel : public QWidget {
  Q_OBJECT
 public:
  VirtualDesktopPanel(Host& host, VirtualDesktopController& controller, QWidget* parent = nullptr);

  /// The device check as it stands now.
  void showChecks(DeviceCheckPanel& checks) const;

 signals:
  void deviceCheckWanted();

 private:
  void change(const std::function<void(VirtualDesktopSettings&)>& edit);
  void mend();
  void showMaterial(const workcell::Entity* entity);
  void listSets();
  void listFrames(const workcell::Entity* entity);
  void addForces(QVBoxLayout& column);
  void addDevice(QVBoxLayout& column);
  void addSecond(QVBoxLayout& section);
  void listDevices();
  void addHeld(QVBoxLayout& column);
  void addAxes(QVBoxLayout& column);
  void addFeel(QVBoxLayout& column);
  void addHand(QVBoxLayout& column);
  void addRates(QVBoxLayout& column);
  void showSnapshot();
  void showSettings();
  void showConnection();
  void showForces();
  void showRates(const manipulation::SceneSnapshot& now);
  void listEntities();

  Host& host_;
  VirtualDesktopController& controller_;
  QCheckBox* forces_;
  QLabel *forces_state_, *forces_why_, *force_now_, *device_state_, *second_state_, *device_icon_, *scale_note_,
      *workspace_text_;
  QLabel* rates_[3][2];
  /// Rates, and milliseconds beside them.
  SteadyNumber steady_rates_[3]{SteadyNumber(0.05), SteadyNumber(0.05), SteadyNumber(0.05)};
  SteadyNumber steady_times_[3]{SteadyNumber(0.3, 0.1), SteadyNumber(0.3, 0.3), SteadyNumber(0.3, 1.0)};
  QLabel* mend_why_;
  QStackedWidget* meter_or_mend_;
  ForceMeter* meter_;
  InputPanel* inputs_;
  WorkspaceView* workspace_;
  QPushButton *mend_, *connect_, *check_;
  std::array<QAbstractButton*, 6> free_{};
  DeviceCombo *stylus_, *second_;
  QComboBox *entity_, *against_, *material_, *moved_frame_, *axes_frame_;
  QWidget *moved_frame_row_, *axes_frame_row_;
  Segmented *moved_by_, *on_contact_, *axes_, *scale_, *force_class_;
  ValueField *stiffness_, *damping_;
};

}  // namespace hapticell::app
