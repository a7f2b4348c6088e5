// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/virtual_desktop_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"
#include "app/virtual_desktop/force_meter.h"
#include "app/virtual_desktop/virtual_desktop_controller.h"

namespace hapticell::app {
namespace {

constexpr int kLabelColumn = 84;

QLabel* makeLabel(const QString& text, TextRole role, bool quiet = false) {
  auto* label = new QLabel(text);
  label->setFont(textFont(role));
  if (quiet) label->setForegroundRole(QPalette::PlaceholderText);
  return label;
}

/// A section: its own margins, a heading, a line below.
QVBoxLayout* addSection(QVBoxLayout& column, const QString& heading) {
  auto* section = new QVBoxLayout;
  section->setContentsMargins(12, 10, 12, 10);
  section->setSpacing(6);
  if (!heading.isEmpty()) section->addWidget(makeLabel(heading, TextRole::kSection));
  column.addLayout(section);
  auto* line = new QFrame;
  line->setFixedHeight(1);
  line->setBackgroundRole(QPalette::Mid);
  line->setAutoFillBackground(true);
  column.addWidget(line);
  return section;
}

void addRow(QVBoxLayout& section, const QString& name, QWidget* field) {
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  auto* label = makeLabel(name, TextRole::kText, true);
  label->setFixedWidth(kLabelColumn);
  label->setBuddy(field);
  field->setAccessibleName(name);
  row->addWidget(label);
  row->addWidget(field, 1);
  section.addLayout(row);
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
  connect(&host_.documentModel(), &DocumentModel::changed, this, &VirtualDesktopPanel::listEntities);
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
  forces_why_ = makeLabel({}, TextRole::kSecond, true);
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
  section->addWidget(meter_);
  connect(forces_, &QCheckBox::clicked, this, [this](bool on) {
    controller_.setForces(on);
    showForces();
  });
}

void VirtualDesktopPanel::addDevice(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Device"));
  stylus_ = makeLabel({}, TextRole::kText);
  addRow(*section, tr("Stylus"), stylus_);
  auto* state = new QWidget;
  auto* row = new QHBoxLayout(state);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  device_icon_ = new QLabel;
  device_state_ = makeLabel({}, TextRole::kText);
  device_state_->setWordWrap(true);
  row->addWidget(device_icon_, 0, Qt::AlignTop);
  row->addWidget(device_state_, 1);
  addRow(*section, tr("State"), state);
  connect_ = new QPushButton;
  connect_->setObjectName("buttonConnect");
  section->addWidget(connect_);
  connect(connect_, &QPushButton::clicked, this, [this] {
    if (controller_.isStarted())
      controller_.disconnectDevice();
    else
      controller_.connectDevice();
  });
}

void VirtualDesktopPanel::addHeld(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("What is held"));
  entity_ = new QComboBox;
  entity_->setObjectName("comboEntity");
  addRow(*section, tr("Entity"), entity_);
  moved_by_ = new Segmented({tr("TCP"), tr("Base"), tr("Own origin"), tr("Centre")});
  moved_by_->setObjectName("segmentsMovedBy");
  addRow(*section, tr("Moved by"), moved_by_);
  on_contact_ = new Segmented({tr("Stop"), tr("Slide"), tr("Pass")});
  on_contact_->setObjectName("segmentsOnContact");
  addRow(*section, tr("On contact"), on_contact_);
  connect(entity_, &QComboBox::activated, this, [this](int index) {
    VirtualDesktopSettings settings = controller_.settings();
    settings.entity = entity_->itemData(index).toULongLong();
    settings.moved_by = manipulation::MovedBy::Kind::kDefault;
    if (const workcell::Entity* entity = host_.documentModel().document().find(settings.entity))
      settings.on_contact = entity->on_contact;
    controller_.change(settings);
  });
  connect(moved_by_, &Segmented::chosen, this, [this](int index) {
    using Kind = manipulation::MovedBy::Kind;
    VirtualDesktopSettings settings = controller_.settings();
    settings.moved_by = index == 0   ? Kind::kTcp
                        : index == 1 ? Kind::kBase
                        : index == 2 ? Kind::kSelfOrigin
                                     : Kind::kGeometricCenter;
    controller_.change(settings);
  });
  connect(on_contact_, &Segmented::chosen, this, [this](int index) {
    VirtualDesktopSettings settings = controller_.settings();
    settings.on_contact = static_cast<workcell::OnContact>(index);
    controller_.change(settings);
  });
}

void VirtualDesktopPanel::addAxes(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Axes and scale"));
  axes_ = new Segmented({tr("Screen"), tr("Cell")});
  axes_->setObjectName("segmentsAxes");
  addRow(*section, tr("Axes of"), axes_);
  auto* free = new QWidget;
  auto* row = new QHBoxLayout(free);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(14);
  translates_ = new QCheckBox(tr("Move"));
  rotates_ = new QCheckBox(tr("Turn"));
  for (QCheckBox* box : {translates_, rotates_}) {
    box->setProperty("switch", true);
    box->setMinimumHeight(kFieldHeight);
    row->addWidget(box);
  }
  row->addStretch(1);
  addRow(*section, tr("Free to"), free);
  scale_ = new Segmented({tr("Rough"), tr("Medium"), tr("Fine"), tr("Screen")});
  scale_->setObjectName("segmentsScale");
  addRow(*section, tr("Scale"), scale_);
  scale_note_ = makeLabel({}, TextRole::kSecond, true);
  scale_note_->setContentsMargins(kLabelColumn, 2, 0, 0);
  section->addWidget(scale_note_);
  connect(axes_, &Segmented::chosen, this, [this](int index) {
    VirtualDesktopSettings settings = controller_.settings();
    settings.axes = index == 0 ? manipulation::AxesMode::kScreen : manipulation::AxesMode::kCell;
    controller_.change(settings);
  });
  connect(scale_, &Segmented::chosen, this, [this](int index) {
    VirtualDesktopSettings settings = controller_.settings();
    settings.scale = static_cast<manipulation::ScaleLevel>(index);
    controller_.change(settings);
  });
  for (QCheckBox* box : {translates_, rotates_})
    connect(box, &QCheckBox::clicked, this, [this] {
      VirtualDesktopSettings settings = controller_.settings();
      settings.translates = translates_->isChecked();
      settings.rotates = rotates_->isChecked();
      controller_.change(settings);
    });
}

void VirtualDesktopPanel::addFeel(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Feel of this entity"));
  force_class_ = new Segmented({tr("Constant"), tr("Contact"), tr("Dynamics")});
  force_class_->setObjectName("segmentsForce");
  addRow(*section, tr("Force"), force_class_);
  connect(force_class_, &Segmented::chosen, this, [this](int index) {
    VirtualDesktopSettings settings = controller_.settings();
    settings.force_class = static_cast<workcell::ForceClass>(index);
    controller_.change(settings);
  });
}

void VirtualDesktopPanel::addHand(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Hand in the device's workspace"));
  auto* row = new QHBoxLayout;
  workspace_ = new WorkspaceView;
  workspace_text_ = makeLabel({}, TextRole::kSecond, true);
  workspace_text_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
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
    grid->addWidget(rates_[i][0], 1, i);
    grid->addWidget(rates_[i][1], 2, i);
    grid->setColumnStretch(i, 1);
  }
  section->addLayout(grid);
}

}  // namespace hapticell::app
