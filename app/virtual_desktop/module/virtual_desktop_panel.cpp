// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/virtual_desktop_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"
#include "app/style/value_field.h"
#include "app/virtual_desktop/devices/device_listing.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"
#include "app/virtual_desktop/widgets/device_combo.h"
#include "app/virtual_desktop/widgets/force_meter.h"
#include "app/virtual_desktop/widgets/input_panel.h"
#include "app/virtual_desktop/widgets/station_panel.h"
#include "config/device_profile.h"

namespace hapticell::app {
namespace {

constexpr int kWorkspaceLines = 8;  // Size, way to the edge, and four keys with their margins.
constexpr int kMendHeight = 56;     // Three lines beside the button that mends it; the meter has the same room.

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

VirtualDesktopPanel::VirtualDesktopPanel(Host& host, VirtualDesktopController& controller, QWidget* parent)
    : QWidget(parent), host_(host), controller_(controller) {
  setMinimumWidth(320);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addForces(*column);
  addDevice(*column);
  addHeld(*column);
  addAxes(*column);
  addFeel(*column);
  addHand(*column);
  addRates(*column);
  column->addStretch(1);
  connect(&controller_, &VirtualDesktopController::snapshotChanged, this, &VirtualDesktopPanel::showSnapshot);
  connect(&controller_, &VirtualDesktopController::settingsChanged, this, &VirtualDesktopPanel::showSettings);
  connect(&controller_, &VirtualDesktopController::connectionChanged, this, &VirtualDesktopPanel::showConnection);
  connect(&host_.documentModel(), &DocumentModel::changed, this, [this] {
    listEntities();
    showSettings();
    inputs_->setFreeHandMissing(!controller_.hasFreeHand());
  });
  listEntities();
  showConnection();
  showSettings();
  showSnapshot();
}

void VirtualDesktopPanel::addForces(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  forces_ = new QCheckBox;
  forces_->setProperty("switch", "large");
  forces_->setObjectName("switchForces");
  forces_->setAccessibleName(tr("Forces"));
  forces_->setToolTip(tr("Forces on (Ctrl+Space), off (Esc)"));
  auto* words = new QVBoxLayout;
  words->setSpacing(0);
  forces_state_ = makeLabel({}, TextRole::kPanelState);
  forces_why_ = makeLive(2, TextRole::kSecond, true);
  words->addWidget(forces_state_);
  words->addWidget(forces_why_);
  auto* number = new QVBoxLayout;
  number->setSpacing(0);
  force_now_ = makeLabel({}, TextRole::kPanelNumber);
  force_now_->setAlignment(Qt::AlignRight);
  force_now_->setMinimumWidth(70);
  auto* now = makeLabel(tr("now"), TextRole::kSecond, true);
  now->setAlignment(Qt::AlignRight);
  number->addWidget(force_now_);
  number->addWidget(now);
  row->addWidget(forces_);
  row->addLayout(words, 1);
  row->addLayout(number);
  section->addLayout(row);
  meter_ = new ForceMeter;
  auto* mending = new QWidget;
  auto* mending_row = new QHBoxLayout(mending);
  mending_row->setContentsMargins(0, 4, 0, 4);
  mend_why_ = makeLive(3, TextRole::kSecond, true);
  mend_ = new QPushButton;
  mend_->setObjectName("buttonMend");
  mend_->setProperty("main", true);
  mending_row->addWidget(mend_why_, 1);
  mending_row->addWidget(mend_);
  meter_or_mend_ = new QStackedWidget;
  meter_or_mend_->addWidget(meter_);
  meter_or_mend_->addWidget(mending);
  meter_or_mend_->setFixedHeight(kMendHeight);
  section->addWidget(meter_or_mend_);
  connect(mend_, &QPushButton::clicked, this, &VirtualDesktopPanel::mend);
  connect(forces_, &QCheckBox::clicked, this, [this](bool on) {
    controller_.setForces(on);
    showForces();
  });
}

void VirtualDesktopPanel::change(const std::function<void(VirtualDesktopSettings&)>& edit) {
  VirtualDesktopSettings settings = controller_.settings();
  edit(settings);
  controller_.change(settings);
}

void VirtualDesktopPanel::addDevice(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Device"));
  stylus_ = new DeviceCombo;
  stylus_->setObjectName("comboStylus");
  addRow(*section, tr("Stylus"), stylus_);
  auto* station = new StationPanel(controller_.serverHost(), controller_.serverPort());
  section->addWidget(station);
  connect(station, &StationPanel::stationChosen, &controller_, &VirtualDesktopController::useServer);
  auto* state = new QWidget;
  auto* row = new QHBoxLayout(state);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  device_icon_ = new QLabel;
  device_state_ = makeLive(2, TextRole::kText);
  device_state_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  row->addWidget(device_icon_);
  row->addWidget(device_state_, 1);
  addRow(*section, tr("State"), state);
  addSecond(*section);
  inputs_ = new InputPanel(controller_.inputs());
  section->addWidget(inputs_);
  connect(inputs_, &InputPanel::freeHandWanted, &controller_, &VirtualDesktopController::addFreeHand);
  connect(&controller_.lister(), &DeviceLister::listed, this, &VirtualDesktopPanel::listDevices);
  listDevices();
  controller_.lister().look();
  connect_ = new QPushButton;
  connect_->setObjectName("buttonConnect");
  check_ = new QPushButton(tr("Check device…"));
  check_->setObjectName("buttonCheckDevice");
  section->addWidget(sideBySide({connect_, check_}));
  connect(stylus_, &QComboBox::activated, this,
          [this](int index) { controller_.chooseDevice(stylus_->itemData(index).toString()); });
  connect(check_, &QPushButton::clicked, this, &VirtualDesktopPanel::deviceCheckWanted);
  connect(connect_, &QPushButton::clicked, this, [this] {
    if (controller_.isStarted())
      controller_.disconnectDevice();
    else
      controller_.connectDevice();
  });
}

void VirtualDesktopPanel::addSecond(QVBoxLayout& section) {
  second_ = new DeviceCombo;
  second_->setObjectName("comboSecondStylus");
  second_->setToolTip(tr("For the mannequin's other hand, or whatever its tip touches"));
  addRow(section, tr("Second"), second_);
  second_state_ = makeLive(2, TextRole::kSecond, true);
  second_state_->setObjectName("labelSecondStylus");
  second_state_->setContentsMargins(kLabelColumn, 0, 0, 2);
  second_state_->hide();
  section.addWidget(second_state_);
  connect(second_, &QComboBox::activated, this,
          [this](int index) { controller_.chooseSecond(second_->itemData(index).toString()); });
}

void VirtualDesktopPanel::listDevices() {
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

void VirtualDesktopPanel::addHeld(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("What is held"));
  entity_ = new QComboBox;
  entity_->setObjectName("comboEntity");
  addRow(*section, tr("Entity"), entity_);
  moved_by_ = new Segmented({tr("TCP"), tr("Base"), tr("Origin"), tr("Centre"), tr("Frame"), tr("Whole"), tr("Left"),
                             tr("Right"), tr("Both"), tr("Head")});
  moved_by_->setObjectName("segmentsMovedBy");
  addRow(*section, tr("Moved by"), moved_by_);
  moved_frame_ = new QComboBox;
  moved_frame_row_ = addRow(*section, {}, moved_frame_);
  against_ = new QComboBox;
  against_->setObjectName("comboAgainst");
  addRow(*section, tr("Against"), against_);
  on_contact_ = new Segmented({tr("Stop"), tr("Slide"), tr("Pass")});
  on_contact_->setObjectName("segmentsOnContact");
  addRow(*section, tr("On contact"), on_contact_);
  connect(entity_, &QComboBox::activated, this, [this](int index) {
    change([&](auto& settings) {
      settings.entity = entity_->itemData(index).toULongLong();
      const workcell::Entity* entity = host_.documentModel().document().find(settings.entity);
      settings.moved_by = entity ? HoldChoice::usual(*entity) : HoldChoice::MovedBy();
      if (entity) settings.on_contact = entity->on_contact, settings.force_class = entity->force_class;
      if (entity) host_.selection().set(entity->id);
    });
  });
  connect(moved_by_, &Segmented::chosen, this, [this](int index) {
    change([&](auto& settings) {
      settings.moved_by = waysOffered()[static_cast<std::size_t>(index)];
      if (auto* frame = std::get_if<by::Frame>(&settings.moved_by))
        frame->name = moved_frame_->currentText().toStdString();
    });
  });
  connect(moved_frame_, &QComboBox::activated, this, [this] {
    change([&](auto& settings) { settings.moved_by = by::Frame{moved_frame_->currentText().toStdString()}; });
  });
  connect(against_, &QComboBox::activated, this, [this](int index) {
    change([&](auto& settings) { settings.against = against_->itemData(index).toString().toStdString(); });
  });
  connect(on_contact_, &Segmented::chosen, this,
          [this](int index) { controller_.setOnContact(static_cast<workcell::OnContact>(index)); });
}

void VirtualDesktopPanel::addAxes(QVBoxLayout& column) {
  using manipulation::AxesMode;
  QVBoxLayout* section = addSection(column, tr("Axes and scale"));
  axes_ = new Segmented({tr("Screen"), tr("Cell"), tr("Frame")});
  axes_->setObjectName("segmentsAxes");
  addRow(*section, tr("Axes of"), axes_);
  axes_frame_ = new QComboBox;
  axes_frame_->setObjectName("comboAxesFrame");
  axes_frame_row_ = addRow(*section, {}, axes_frame_);
  const char* const names[]{"X", "Y", "Z", "A", "B", "C"};
  Segmented* const groups[]{new Segmented({"X", "Y", "Z"}, nullptr, Segmented::Kind::kMany),
                            new Segmented({"A", "B", "C"}, nullptr, Segmented::Kind::kMany)};
  for (std::size_t i = 0; i < 6; ++i) {
    const QString axis = QString::fromLatin1(names[i % 3]);
    free_[i] = groups[i / 3]->button(static_cast<int>(i % 3));
    const QString tip = i < 3 ? tr("The hand moves it along %1 (%1: only that)").arg(axis)
                              : tr("The hand turns it about %1 (%1 twice: only that)").arg(axis);
    free_[i]->setToolTip(tip);
    free_[i]->setAccessibleName(tip);
    free_[i]->setObjectName(QStringLiteral("free") + QString::fromLatin1(names[i]));
  }
  addRow(*section, tr("Free to move"), sideBySide({groups[0], groups[1]}));
  scale_ = new Segmented({tr("Rough"), tr("Medium"), tr("Fine"), tr("Screen")});
  scale_->setObjectName("segmentsScale");
  addRow(*section, tr("Scale"), scale_);
  scale_note_ = makeLabel({}, TextRole::kSecond, true);
  scale_note_->setObjectName("labelScale");
  scale_note_->setContentsMargins(kLabelColumn, 2, 0, 2);
  section->addWidget(scale_note_);
  connect(axes_, &Segmented::chosen, this, [this](int index) {
    change([&](auto& settings) {
      settings.axes = index == 0 ? AxesMode::kScreen : index == 1 ? AxesMode::kCell : AxesMode::kFrame;
      settings.axes_frame = index == 2 ? axes_frame_->currentText().toStdString() : std::string();
    });
  });
  connect(axes_frame_, &QComboBox::activated, this,
          [this] { change([&](auto& settings) { settings.axes_frame = axes_frame_->currentText().toStdString(); }); });
  connect(scale_, &Segmented::chosen, this, [this](int index) {
    change([&](auto& settings) { settings.scale = static_cast<manipulation::ScaleLevel>(index); });
  });
  for (Segmented* group : groups)
    connect(group, &Segmented::chosen, this, [this] {
      change([&](auto& settings) {
        for (std::size_t i = 0; i < 3; ++i) {
          settings.free.moves[i] = free_[i]->isChecked();
          settings.free.turns[i] = free_[i + 3]->isChecked();
        }
      });
    });
}

void VirtualDesktopPanel::addFeel(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Feel of this entity"));
  force_class_ = new Segmented({tr("Constant"), tr("Contact"), tr("Dynamics")});
  force_class_->setObjectName("segmentsForce");
  addRow(*section, tr("Force"), force_class_);
  material_ = new QComboBox;
  material_->setObjectName("comboMaterial");
  for (const auto& [key, material] : host_.configuration().materials) {
    QString name = QString::fromStdString(key);
    name[0] = name[0].toUpper();
    material_->addItem(tr("%1, µ %2").arg(name).arg(material.friction, 0, 'f', 2), QString::fromStdString(key));
  }
  addRow(*section, tr("Material"), material_);
  stiffness_ = new ValueField({tr("N/mm"), 2, 0.0, 100.0, 0.1});
  damping_ = new ValueField({tr("N s/m"), 1, 0.0, 100.0, 0.1});
  for (ValueField* field : {stiffness_, damping_}) {
    field->setReadOnly(true);
    field->setFocusPolicy(Qt::NoFocus);
    field->setToolTip(tr("The material's, from hapticell.toml; the server lowers it to what the device bears"));
  }
  addRow(*section, tr("Stiffness"), sideBySide({stiffness_, damping_}));
  connect(force_class_, &Segmented::chosen, this,
          [this](int index) { controller_.setForceClass(static_cast<workcell::ForceClass>(index)); });
  connect(material_, &QComboBox::activated, this, [this](int index) {
    workcell::SetProperties wanted;
    wanted.id = controller_.settings().entity;
    wanted.material = material_->itemData(index).toString().toStdString();
    if (wanted.id) host_.documentModel().execute(wanted);
    showSettings();
  });
}

void VirtualDesktopPanel::addHand(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Hand in the device's workspace"));
  auto* row = new QHBoxLayout;
  workspace_ = new WorkspaceView;
  workspace_text_ = makeLabel({}, TextRole::kSecond, true);
  workspace_text_->setTextFormat(Qt::RichText);  // Numbers and words of our own only.
  workspace_text_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  workspace_text_->setMinimumHeight(kWorkspaceLines * workspace_text_->fontMetrics().lineSpacing());
  row->addWidget(workspace_);
  row->addWidget(workspace_text_, 1);
  section->addLayout(row);
}

void VirtualDesktopPanel::addRates(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  auto* grid = new QGridLayout;
  grid->setVerticalSpacing(1);
  const QString names[3]{tr("Haptic"), tr("Collision"), tr("Window")};
  for (int i = 0; i < 3; ++i) {
    grid->addWidget(makeLabel(names[i], TextRole::kSecond, true), 0, i);
    rates_[i][0] = makeLabel({}, TextRole::kSection);
    rates_[i][1] = makeLabel({}, TextRole::kSecond, true);
    for (QLabel* label : rates_[i]) label->setObjectName("labelRate");
    grid->addWidget(rates_[i][0], 1, i);
    grid->addWidget(rates_[i][1], 2, i);
    grid->setColumnStretch(i, 1);
  }
  section->addLayout(grid);
}

}  // namespace hapticell::app
