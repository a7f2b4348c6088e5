// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/widgets/input_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/style/library_text.h"
#include "app/style/segmented.h"
#include "app/virtual_desktop/devices/device_listing.h"
#include "app/virtual_desktop/widgets/device_combo.h"

namespace hapticell::app {
namespace {

QLabel* line(const char* name, int lines) {
  QLabel* label = makeLive(lines, TextRole::kSecond, true);
  label->setObjectName(name);
  label->setContentsMargins(kLabelColumn, 0, 0, 2);
  label->hide();
  return label;
}

std::vector<DeviceCombo::Entry> entriesOf(const DeviceListing& listing, const QString& kind) {
  std::vector<DeviceCombo::Entry> entries{{QObject::tr("None"), QString(), QString()}};
  for (const ListedDevice& device : listing.devices)
    if (device.kind == kind) entries.push_back(DeviceCombo::entryOf(device));
  return entries;
}

}  // namespace

InputPanel::InputPanel(InputDevices& inputs, QWidget* parent) : QWidget(parent), inputs_(inputs) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  glove_ = new DeviceCombo;
  glove_->setObjectName("comboGlove");
  addRow(*column, tr("Glove"), glove_);
  column->addWidget(glove_line_ = line("labelGlove", 2));
  addCalibration();
  mouse_ = new DeviceCombo;
  mouse_->setObjectName("comboSpaceMouse");
  addRow(*column, tr("3D mouse"), mouse_);
  column->addWidget(mouse_line_ = line("labelSpaceMouse", 2));
  moves_ = new Segmented({tr("View"), tr("Entity")});
  moves_->setObjectName("segmentsMouseMoves");
  moves_->setToolTip(tr("What the 3D mouse moves; its second button changes it"));
  moves_row_ = addRow(*column, tr("Moves"), moves_);
  setListing({});
  connect(glove_, &QComboBox::activated, this, [this] { inputs_.chooseGlove(glove_->currentData().toString()); });
  connect(mouse_, &QComboBox::activated, this, [this] { inputs_.chooseMouse(mouse_->currentData().toString()); });
  connect(moves_, &Segmented::chosen, this, [this](int index) {
    inputs_.setMouseMoves(index == 0 ? InputDevices::MouseMoves::kView : InputDevices::MouseMoves::kEntity);
  });
  connect(&inputs_, &InputDevices::changed, this, &InputPanel::refresh);
  // ms between two looks for devices. Half: twice the work; twice: a plugged one appears later.
  constexpr int kLook = 250;
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, [this] {
    if (!inputs_.glove().isEmpty() || !inputs_.mouse().isEmpty()) refresh();
  });
  timer->start(kLook);
  refresh();
}

void InputPanel::addCalibration() {
  auto* column = static_cast<QVBoxLayout*>(layout());
  instruction_ = line("labelCalibration", 3);
  column->addWidget(instruction_);
  calibrate_ = new QPushButton(tr("Calibrate glove…"));
  next_ = new QPushButton(tr("I am holding it: next"));
  cancel_ = new QPushButton(tr("Cancel"));
  calibrate_->setObjectName("buttonCalibrateGlove");
  next_->setObjectName("buttonCalibrateNext");
  next_->setProperty("main", true);
  column->addWidget(sideBySide({calibrate_, next_, cancel_}));
  free_hand_ = new QPushButton(tr("Add a free hand"));
  free_hand_->setObjectName("buttonAddFreeHand");
  free_hand_->setToolTip(tr("A free hand with the fingers of the glove; the stylus moves it"));
  column->addWidget(sideBySide({free_hand_}));
  connect(free_hand_, &QPushButton::clicked, this, &InputPanel::freeHandWanted);
  connect(calibrate_, &QPushButton::clicked, this, [this] {
    calibrator_.emplace();
    showCalibration();
  });
  connect(next_, &QPushButton::clicked, this, &InputPanel::stepCalibration);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    calibrator_.reset();
    showCalibration();
  });
}

void InputPanel::stepCalibration() {
  const auto readings = inputs_.gloveReadings();
  if (!calibrator_ || !readings) return instruction_->setText(tr("The glove is not responding. Nothing was recorded."));
  calibrator_->take(*readings);
  if (calibrator_->next() < GloveCalibrator::kPoses) return showCalibration();
  QString words = tr("Calibrated for you.");
  if (!calibrator_->result()) {
    words =
        tr("Sensor %1 hardly moved between the poses. The calibration is unchanged.").arg(calibrator_->badSensor() + 1);
  } else if (const auto kept = inputs_.keepCalibration(*calibrator_->result()); !kept) {
    words = shownText(kept.error());
  }
  calibrator_.reset();
  showCalibration();
  instruction_->setText(words);
}

void InputPanel::showCalibration() {
  const bool runs = calibrator_.has_value();
  inputs_.setCalibrating(runs);
  const bool any = !inputs_.glove().isEmpty();
  calibrate_->parentWidget()->setVisible(any);
  calibrate_->setVisible(!runs);
  calibrate_->setEnabled(inputs_.gloveReadings().has_value());
  next_->setVisible(runs);
  cancel_->setVisible(runs);
  instruction_->setText(runs ? tr("Pose %1 of %2: %3")
                                   .arg(calibrator_->next() + 1)
                                   .arg(GloveCalibrator::kPoses)
                                   .arg(GloveCalibrator::instruction(calibrator_->next()))
                             : QString());
}

void InputPanel::setFreeHandMissing(bool missing) {
  free_hand_missing_ = missing;
  free_hand_->parentWidget()->setVisible(missing && !inputs_.glove().isEmpty());
}

void InputPanel::setListing(const DeviceListing& listing) {
  glove_->setEntries(entriesOf(listing, QStringLiteral("glove")));
  mouse_->setEntries(entriesOf(listing, QStringLiteral("space_mouse")));
}

void InputPanel::refresh() {
  glove_->setChosen(inputs_.glove());
  mouse_->setChosen(inputs_.mouse());
  glove_line_->setText(inputs_.gloveLine());
  mouse_line_->setText(inputs_.mouseLine());
  setFreeHandMissing(free_hand_missing_);
  glove_line_->setVisible(!inputs_.glove().isEmpty());
  instruction_->setVisible(!inputs_.glove().isEmpty());
  mouse_line_->setVisible(!inputs_.mouse().isEmpty());
  moves_row_->setVisible(!inputs_.mouse().isEmpty());
  moves_->setCurrent(inputs_.mouseMoves() == InputDevices::MouseMoves::kView ? 0 : 1);
  if (!calibrator_) {
    const QString said = instruction_->text();
    showCalibration();
    if (!inputs_.glove().isEmpty()) instruction_->setText(said);
  } else {
    calibrate_->setEnabled(inputs_.gloveReadings().has_value());
  }
}

}  // namespace hapticell::app
