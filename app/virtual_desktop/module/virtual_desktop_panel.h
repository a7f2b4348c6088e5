// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace hapticell::app {

class AxesSection;
class DeviceCheckPanel;
class DeviceSection;
class FeelSection;
class ForceSection;
class HeldSection;
class Host;
class PlanSection;
class RateSection;
class VirtualDesktopController;
class WorkspaceSection;

/// The panel of the haptic module: switch and force first, then device, what is held, axes and scale, feel, the hand in
/// its workspace, loop rates. Shows the state of the controller and asks it for changes.
class VirtualDesktopPanel : public QWidget {
  Q_OBJECT
 public:
  VirtualDesktopPanel(Host& host, VirtualDesktopController& controller, QWidget* parent = nullptr);

  /// Shows the present device check.
  void showChecks(DeviceCheckPanel& checks) const;

 signals:
  void deviceCheckWanted();

 private:
  void showSnapshot();
  void showSettings();
  void showConnection();

  Host& host_;
  VirtualDesktopController& controller_;
  ForceSection* forces_;
  DeviceSection* device_;
  HeldSection* held_;
  AxesSection* axes_;
  FeelSection* feel_;
  PlanSection* plan_;
  WorkspaceSection* workspace_;
  RateSection* rates_;
};

}  // namespace hapticell::app
