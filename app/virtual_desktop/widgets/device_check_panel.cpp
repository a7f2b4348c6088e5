// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/widgets/device_check_panel.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/kit/form.h"
#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/theme.h"
#include "app/virtual_desktop/devices/device_listing.h"
#include "app/virtual_desktop/devices/device_watch.h"
#include "app/virtual_desktop/widgets/calibration_section.h"
#include "app/virtual_desktop/widgets/rate_graph.h"

namespace hapticell::app {
namespace {

constexpr int kCheckRow = 84;  // Title and three lines.

/// Something to type, not a sentence of advice.
bool isCommand(const QString& fix) {
  return fix.contains(QLatin1String("sudo "));
}

/// Wraps, and is never lower than its lines are high: layouts within layouts do not pass that on.
class WrappedLabel : public QLabel {
 public:
  WrappedLabel(const QString& text, TextRole role, bool quiet) : QLabel(text) {
    setFont(textFont(role));
    setWordWrap(true);
    if (quiet) setForegroundRole(kQuietText);
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QLabel::resizeEvent(event);
    setMinimumHeight(heightForWidth(width()));
  }
};

QLabel* quietLabel(const QString& text) {
  QLabel* label = makeLabel(text, TextRole::kSecond, true);
  label->setWordWrap(true);
  return label;
}

const char* resultIcon(DeviceCheck::Result result) {
  switch (result) {
    case DeviceCheck::Result::kGood:
      return "check";
    case DeviceCheck::Result::kProblem:
      return "crossed";
    case DeviceCheck::Result::kWarning:
      return "warning";
    case DeviceCheck::Result::kOpen:
      break;
  }
  return "info";
}

QColor resultColor(DeviceCheck::Result result, const Theme& theme) {
  switch (result) {
    case DeviceCheck::Result::kGood:
      return theme.scene.axis_z;
    case DeviceCheck::Result::kProblem:
      return theme.contact;
    case DeviceCheck::Result::kWarning:
      return theme.near_miss;
    case DeviceCheck::Result::kOpen:
      break;
  }
  return theme.text3;
}

}  // namespace

CheckRows::CheckRows(QWidget* parent) : QWidget(parent) {
  setObjectName("checkRows");
  setMinimumWidth(320);
}

void CheckRows::setChecks(std::vector<DeviceCheck> checks) {
  checks_ = std::move(checks);
  setMinimumHeight(static_cast<int>(checks_.size()) * kCheckRow + 8);
  QStringList words;
  for (const DeviceCheck& check : checks_) words << check.title + QStringLiteral(": ") + check.detail;
  setAccessibleDescription(words.join(QStringLiteral(". ")));
  update();
}

QSize CheckRows::sizeHint() const {
  return {340, static_cast<int>(checks_.size()) * kCheckRow + 8};
}

void CheckRows::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  int top = 4;
  for (const DeviceCheck& check : checks_) {
    icon(resultIcon(check.result), resultColor(check.result, theme)).paint(&painter, QRect(12, top + 10, 20, 20));
    painter.setFont(textFont(TextRole::kSection));
    painter.setPen(theme.text1);
    painter.drawText(QRect(44, top + 6, width() - 56, 20), Qt::AlignVCenter, check.title);
    painter.setFont(textFont(TextRole::kSecond));
    painter.setPen(theme.text2);
    painter.drawText(QRect(44, top + 26, width() - 56, kCheckRow - 28), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                     check.detail);
    painter.fillRect(QRect(12, top + kCheckRow - 1, width() - 24, 1), theme.line);
    top += kCheckRow;
  }
}

DeviceCheckPanel::DeviceCheckPanel(DeviceLister& lister, QWidget* parent) : QWidget(parent), lister_(lister) {
  setObjectName("deviceCheck");
  setMinimumWidth(320);
  watch_ = new DeviceWatch(this);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addReason(*column);
  rows_ = new CheckRows;
  column->addWidget(rows_);
  addRates(*column);
  addRange(*column);
  addForceTest(*column);
  addCalibration(*column);
  addPlugged(*column);
  column->addStretch(1);
  connect(watch_, &DeviceWatch::changed, this, &DeviceCheckPanel::showWatch);
  connect(watch_, &DeviceWatch::forceTestEnded, this, [this](const QString& sentence, double pushed) {
    force_result_ = !sentence.isEmpty() ? sentence
                                        : tr("%1 N were commanded. If you felt nothing, check that the device is "
                                             "powered, its emergency stop released and calibrated.")
                                              .arg(pushed, 0, 'f', 1);
    emit stylusWanted(false);
    showForceTest();
  });
  connect(&lister_, &DeviceLister::listed, this, &DeviceCheckPanel::showListing);
  connect(&lister_, &DeviceLister::failed, this, [this](const QString& sentence) {
    looking_->setText(sentence);
    looking_->show();
  });
  showListing();
  showForceTest();
}

void DeviceCheckPanel::setChecks(std::vector<DeviceCheck> checks) {
  rows_->setChecks(std::move(checks));
}

void DeviceCheckPanel::setReason(const ForceReason& reason) {
  state_->setText(reason.state);
  why_->setText(reason.why);
}

/// A scroll area asks for a height without telling the width: wrapped lines would be cut.
void DeviceCheckPanel::fitHeight() {
  if (layout()->hasHeightForWidth()) setMinimumHeight(layout()->totalHeightForWidth(width()));
}

void DeviceCheckPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitHeight();
}

bool DeviceCheckPanel::event(QEvent* event) {
  const bool done = QWidget::event(event);
  if (event->type() == QEvent::LayoutRequest) fitHeight();
  return done;
}

void DeviceCheckPanel::addReason(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  state_ = makeLabel({}, TextRole::kPanelState);
  why_ = quietLabel({});
  why_->setObjectName("labelWhyNoForce");
  section->addWidget(state_);
  section->addWidget(why_);
}

void DeviceCheckPanel::addRates(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Rate and lateness of the force loop"));
  graph_ = new RateGraph;
  section->addWidget(graph_);
}

void DeviceCheckPanel::addRange(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Range of motion and buttons"));
  section->addWidget(quietLabel(tr("Move the stylus in all directions and press each button once.")));
  range_ = new RangeView;
  section->addWidget(range_);
  auto* again = new QPushButton(tr("Restart"));
  again->setObjectName("buttonRangeAgain");
  section->addWidget(sideBySide({again}));
  connect(again, &QPushButton::clicked, this, [this] {
    watch_->range().reset();
    showWatch();
  });
}

void DeviceCheckPanel::addForceTest(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Force test"));
  force_words_ = quietLabel({});
  section->addWidget(force_words_);
  force_ask_ = new QPushButton(tr("Test the force…"));
  force_go_ = new QPushButton(tr("I am holding it: start"));
  force_stop_ = new QPushButton(tr("Cancel"));
  force_ask_->setObjectName("buttonForceAsk");
  force_go_->setObjectName("buttonForceGo");
  force_go_->setProperty("main", true);
  force_stop_->setObjectName("buttonForceStop");
  section->addWidget(sideBySide({force_ask_, force_go_, force_stop_}));
  connect(force_ask_, &QPushButton::clicked, this, [this] {
    asked_ = true;
    showForceTest();
  });
  connect(force_go_, &QPushButton::clicked, this, [this] {
    asked_ = false;
    emit stylusWanted(true);
    watch_->startForceTest();
    showForceTest();
  });
  connect(force_stop_, &QPushButton::clicked, this, [this] {
    asked_ = false;
    watch_->stopForceTest();
    showForceTest();
  });
}

void DeviceCheckPanel::addCalibration(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Calibration"));
  calibration_ = new CalibrationSection;
  section->addWidget(calibration_);
  connect(calibration_, &CalibrationSection::stepDone, this, [this](unsigned step) { watch_->calibrate(step); });
}

void DeviceCheckPanel::showForceTest() {
  const bool runs = watch_->forceTestRuns();
  const bool forceless = watch_->device() && watch_->device()->driven_axes == 0;
  force_ask_->setVisible(!asked_ && !runs);
  force_ask_->setEnabled(watch_->isConnected() && !forceless);
  force_go_->setVisible(asked_ && !runs);
  force_stop_->setVisible(asked_ || runs);
  QString words = force_result_;
  if (runs) {
    words = tr("Pushing down, %1 %").arg(std::lround(100.0 * watch_->forceTestProgress()));
  } else if (asked_) {
    words = tr("The stylus will be pulled down, slowly up to %1 N, for 4 seconds. Hold it loosely in the middle of its "
               "workspace. What you hold in the cell is released first.")
                .arg(kTestPush, 0, 'f', 1);
  } else if (forceless) {
    words = tr("This device has no force feedback.");
  } else if (words.isEmpty()) {
    words = tr("Nothing moves until you confirm.");
  }
  force_words_->setText(words);
}

void DeviceCheckPanel::showWatch() {
  graph_->setSamples(watch_->history());
  range_->setTest(watch_->range(), watch_->device());
  calibration_->setCondition(watch_->condition(), watch_->isConnected());
  showForceTest();
}

void DeviceCheckPanel::addPlugged(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Devices and problems"));
  plugged_ = new QVBoxLayout;
  plugged_->setSpacing(6);
  section->addLayout(plugged_);
  looking_ = quietLabel(tr("Searching…"));
  section->addWidget(looking_);
  auto* again = new QPushButton(tr("Search again"));
  again->setObjectName("buttonLookAgain");
  section->addWidget(sideBySide({again}));
  section->addWidget(
      quietLabel(tr("The drivers are tested against models and recorded data formats, not on real devices.")));
  versions_ = quietLabel({});
  section->addWidget(versions_);
  connect(again, &QPushButton::clicked, this, [this] {
    looking_->setText(tr("Searching…"));
    looking_->show();
    lister_.look();
  });
}

void DeviceCheckPanel::addDeviceRow(const QString& title, const QString& detail, const QString& fix, bool good) {
  auto* row = new QWidget;
  auto* words = new QVBoxLayout(row);
  words->setContentsMargins(0, 0, 0, 0);
  words->setSpacing(1);
  const Theme& theme = themeOf(palette());
  auto* head = new QHBoxLayout;
  auto* mark = new QLabel;
  mark->setPixmap(icon(good ? "check" : "warning", good ? theme.scene.axis_z : theme.near_miss).pixmap(16, 16));
  head->addWidget(mark);
  head->addWidget(new WrappedLabel(title, TextRole::kText, false), 1);
  if (isCommand(fix)) {
    auto* copy = new QPushButton(tr("Copy"));
    copy->setToolTip(tr("Copy the command that fixes it"));
    copy->setAccessibleName(tr("Copy the command for %1").arg(title));
    const QString command = fix.section(QLatin1String(", then "), 0, 0);
    connect(copy, &QPushButton::clicked, copy, [command] { QGuiApplication::clipboard()->setText(command); });
    head->addWidget(copy);
  }
  words->addLayout(head);
  if (!detail.isEmpty()) words->addWidget(new WrappedLabel(detail, TextRole::kSecond, true));
  if (!fix.isEmpty()) {
    auto* command = new WrappedLabel(fix, TextRole::kSecond, true);
    command->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words->addWidget(command);
  }
  plugged_->addWidget(row);
}

void DeviceCheckPanel::showListing() {
  if (!lister_.listing()) return;
  while (QLayoutItem* item = plugged_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  const DeviceListing& listing = *lister_.listing();
  for (const ListedDevice& device : listing.devices) {
    if (device.simulated) continue;
    const QString where =
        device.place + (device.firmware.isEmpty() ? QString() : tr(", firmware %1").arg(device.firmware));
    addDeviceRow(device.name, device.usable ? where : where + QStringLiteral(": ") + device.problem, device.fix,
                 device.usable);
  }
  for (const ListedDriver& driver : listing.drivers) {
    if (driver.usable) continue;
    addDeviceRow(driver.title.isEmpty() ? driver.name : driver.title, driver.problem, driver.fix, false);
  }
  for (const ListedGrant& grant : listing.grants) {
    if (!grant.granted) addDeviceRow(grant.what.left(1).toUpper() + grant.what.mid(1), grant.found, grant.fix, false);
  }
  if (plugged_->count() == 0) plugged_->addWidget(quietLabel(tr("Only the simulated stylus. No problems found.")));
  looking_->hide();
  versions_->setText(listing.versions);
}

}  // namespace hapticell::app
