// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/device_section.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/style/icon.h"
#include "app/style/theme.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"
#include "app/virtual_desktop/widgets/device_combo.h"
#include "app/virtual_desktop/widgets/input_panel.h"
#include "app/virtual_desktop/widgets/station_panel.h"
#include "config/device_profile.h"

namespace hapticell::app {
namespace {

std::vector<DeviceCombo::Entry> simulatedStyluses() {
  std::vector<DeviceCombo::Entry> entries;
  for (const char* profile : {"phantom_desktop", "touch", "touch_x", "premium", "premium_6dof"}) {
    const auto file = config::findShippedFile(std::string("devices/") + profile + ".toml");
    const auto read =
        file ? config::readDeviceProfile(*file) : Expected<config::DeviceProfile>(config::DeviceProfile{});
    if (file && read) entries.push_back({QString::fromStdString(read->name), QString::fromLatin1(profile), {}});
  }
  return entries;
}

}  // namespace

DeviceSection::DeviceSection(VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent)
    : QObject(parent), controller_(controller) {
  QVBoxLayout* section = addSection(column, tr("Device"));
  stylus_ = new DeviceCombo;
  stylus_->setObjectName("comboStylus");
  addRow(*section, tr("Stylus"), stylus_);
  auto* station = new StationPanel(controller_.serverHost(), controller_.serverPort());
  section->addWidget(station);
  connect(station, &StationPanel::stationChosen, &controller_, &VirtualDesktopController::useServer);
  auto* state_row = new QWidget;
  auto* row = new QHBoxLayout(state_row);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  icon_ = new QLabel;
  state_ = makeLive(2, TextRole::kText);
  state_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  row->addWidget(icon_);
  row->addWidget(state_, 1);
  addRow(*section, tr("State"), state_row);
  addSecond(*section);
  inputs_ = new InputPanel(controller_.inputs());
  section->addWidget(inputs_);
  connect(inputs_, &InputPanel::freeHandWanted, &controller_, &VirtualDesktopController::addFreeHand);
  connect(&controller_.lister(), &DeviceLister::listed, this, &DeviceSection::listDevices);
  listDevices();
  controller_.lister().look();
  connect_ = new QPushButton;
  connect_->setObjectName("buttonConnect");
  check_ = new QPushButton(tr("Check device…"));
  check_->setObjectName("buttonCheckDevice");
  section->addWidget(sideBySide({connect_, check_}));
  connect(stylus_, &QComboBox::activated, this,
          [this](int index) { controller_.chooseDevice(stylus_->itemData(index).toString()); });
  connect(check_, &QPushButton::clicked, this, &DeviceSection::checkWanted);
  connect(connect_, &QPushButton::clicked, this, [this] {
    if (controller_.isStarted())
      controller_.disconnectDevice();
    else
      controller_.connectDevice();
  });
}

void DeviceSection::addSecond(QVBoxLayout& section) {
  second_ = new DeviceCombo;
  second_->setObjectName("comboSecondStylus");
  second_->setToolTip(tr("For the mannequin's other hand, or the part that its tip touches"));
  addRow(section, tr("Second"), second_);
  second_state_ = makeLive(2, TextRole::kSecond, true);
  second_state_->setObjectName("labelSecondStylus");
  second_state_->setContentsMargins(kLabelColumn, 0, 0, 2);
  second_state_->hide();
  section.addWidget(second_state_);
  connect(second_, &QComboBox::activated, this,
          [this](int index) { controller_.chooseSecond(second_->itemData(index).toString()); });
}

void DeviceSection::listDevices() {
  std::vector<DeviceCombo::Entry> styluses = simulatedStyluses();
  if (const auto& listing = controller_.lister().listing()) {
    inputs_->setListing(*listing);
    for (const ListedDevice& device : listing->devices) {
      if (!device.simulated && device.kind != QStringLiteral("glove")) styluses.push_back(DeviceCombo::entryOf(device));
    }
  }
  stylus_->setEntries(styluses);
  stylus_->setChosen(controller_.deviceProfile());
  styluses.insert(styluses.begin(), {tr("None"), QString(), QString()});
  second_->setEntries(std::move(styluses));
  second_->setChosen(controller_.secondProfile());
}

void DeviceSection::showFreeHand() {
  inputs_->setFreeHandMissing(!controller_.hasFreeHand());
}

void DeviceSection::showSecond() {
  second_state_->setText(controller_.secondLine());
}

void DeviceSection::showConnection() {
  const bool connected = controller_.isConnected();
  const Theme& theme = themeOf(inputs_->palette());
  icon_->setPixmap(
      icon(connected ? "check" : "warning", connected ? theme.scene.axis_z : theme.near_miss).pixmap(16, 16));
  state_->setText(controller_.deviceLine());
  stylus_->setChosen(controller_.deviceProfile());
  second_->setChosen(controller_.secondProfile());
  showSecond();
  second_state_->setVisible(!controller_.secondProfile().isEmpty());
  showFreeHand();
  inputs_->refresh();
  connect_->setText(controller_.isStarted() ? tr("Disconnect") : tr("Connect"));
}

}  // namespace hapticell::app
