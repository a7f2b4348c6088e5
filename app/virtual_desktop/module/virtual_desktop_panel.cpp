// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/virtual_desktop_panel.h"

#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/virtual_desktop/devices/device_watch.h"
#include "app/virtual_desktop/module/axes_section.h"
#include "app/virtual_desktop/module/device_section.h"
#include "app/virtual_desktop/module/feel_section.h"
#include "app/virtual_desktop/module/force_section.h"
#include "app/virtual_desktop/module/held_section.h"
#include "app/virtual_desktop/module/plan_section.h"
#include "app/virtual_desktop/module/rate_section.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"
#include "app/virtual_desktop/module/workspace_section.h"
#include "app/virtual_desktop/widgets/device_check_panel.h"

namespace hapticell::app {

VirtualDesktopPanel::VirtualDesktopPanel(Host& host, VirtualDesktopController& controller, QWidget* parent)
    : QWidget(parent), host_(host), controller_(controller) {
  setMinimumWidth(320);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  forces_ = new ForceSection(host, controller, *column, this);
  device_ = new DeviceSection(controller, *column, this);
  held_ = new HeldSection(host, controller, *column, this);
  axes_ = new AxesSection(host, controller, *column, this);
  feel_ = new FeelSection(host, controller, *column, this);
  plan_ = new PlanSection(host, controller, *column, this);
  workspace_ = new WorkspaceSection(controller, *column, this);
  rates_ = new RateSection(host, controller, *column, this);
  column->addStretch(1);
  connect(device_, &DeviceSection::checkWanted, this, &VirtualDesktopPanel::deviceCheckWanted);
  connect(&controller_, &VirtualDesktopController::snapshotChanged, this, &VirtualDesktopPanel::showSnapshot);
  connect(&controller_, &VirtualDesktopController::settingsChanged, this, &VirtualDesktopPanel::showSettings);
  connect(&controller_, &VirtualDesktopController::connectionChanged, this, &VirtualDesktopPanel::showConnection);
  connect(&host_.documentModel(), &DocumentModel::changed, this, [this] {
    held_->listEntities();
    showSettings();
    device_->showFreeHand();
  });
  held_->listEntities();
  showConnection();
  showSettings();
  showSnapshot();
}

void VirtualDesktopPanel::showChecks(DeviceCheckPanel& checks) const {
  ForceFacts facts = controller_.forceFacts();
  facts.device_fault = checks.watch().isConnected() && checks.watch().state().device_fault;
  checks.setReason(forceReason(facts));
  const auto& device = controller_.device();
  checks.setChecks(deviceChecks(
      controller_.serverAddress(), controller_.forceFacts(), device ? &*device : nullptr, controller_.snapshot(),
      {host_.viewport().touchFigures(), host_.viewport().isSoftware(), host_.viewport().lastFrameSeconds()}));
}

void VirtualDesktopPanel::showSnapshot() {
  forces_->show();
  axes_->showScale();
  plan_->show();
  workspace_->show();
  device_->showSecond();
  rates_->show();
}

void VirtualDesktopPanel::showSettings() {
  held_->showSettings();
  axes_->showSettings();
  feel_->showSettings();
  plan_->listGoals();
  forces_->show();
}

void VirtualDesktopPanel::showConnection() {
  device_->showConnection();
  forces_->showDevice();
  forces_->show();
}

}  // namespace hapticell::app
