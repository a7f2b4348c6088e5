// SPDX-License-Identifier: Apache-2.0
#include "app/live/live_panel.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/live/live_feed.h"
#include "app/style/segmented.h"

namespace hapticell::app {

LivePanel::LivePanel(LiveFeed& feed, QWidget* parent) : QWidget(parent), feed_(feed) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addChoices(*addSection(*column, {}));
  addAddress(*addSection(*column, tr("Address for viewers")));
  column->addStretch(1);
  connect(&feed_, &LiveFeed::viewersChanged, this, &LivePanel::show);
  show();
}

void LivePanel::addChoices(QVBoxLayout& column) {
  auto* purpose = makeLabel(tr("Trainees watch the cell, the contacts and the force in a browser, with Foxglove or Lichtblick."),
                            TextRole::kSecond, true);
  purpose->setWordWrap(true);
  column.addWidget(purpose);
  who_ = new Segmented({tr("This machine"), tr("Others too")});
  who_->setObjectName("segmentsLiveWho");
  who_->setToolTip(tr("Others need the code at the end of the address. The connection is not encrypted: whoever can "
                      "listen to the network can watch."));
  who_->setCurrent(0);
  addRow(column, tr("Viewers"), who_);
  port_ = new QSpinBox;
  port_->setObjectName("spinLivePort");
  port_->setRange(1, 65535);
  port_->setValue(8765);
  port_->setToolTip(tr("Port for viewers. Default: 8765"));
  addRow(column, tr("Port"), port_);
  start_ = new QPushButton;
  start_->setObjectName("buttonLive");
  column.addWidget(start_);
  line_ = makeLive(3, TextRole::kSecond, true);
  line_->setObjectName("labelLiveView");
  column.addWidget(line_);
  connect(start_, &QPushButton::clicked, this, &LivePanel::toggle);
}

void LivePanel::addAddress(QVBoxLayout& column) {
  address_ = new QPlainTextEdit;
  address_->setObjectName("textLiveAddress");
  address_->setReadOnly(true);
  address_->setFixedHeight(64);
  address_->setTabChangesFocus(true);
  address_->setAccessibleName(tr("Address for viewers"));
  column.addWidget(address_);
  copy_ = new QPushButton(tr("Copy"));
  copy_->setObjectName("buttonCopyLiveAddress");
  column.addWidget(sideBySide({copy_}));
  connect(copy_, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(feed_.addresses()); });
}

void LivePanel::toggle() {
  problem_.clear();
  if (feed_.isOn()) {
    feed_.stop();
  } else {
    problem_ = feed_.start(who_->current() == 1, port_->value());
  }
  show();
}

void LivePanel::show() {
  const bool is_on = feed_.isOn();
  start_->setText(is_on ? tr("Stop now") : tr("Start"));
  who_->setEnabled(!is_on);
  port_->setEnabled(!is_on);
  copy_->setEnabled(is_on);
  address_->setEnabled(is_on);
  address_->setPlainText(feed_.addresses());
  if (!problem_.isEmpty()) return line_->setText(problem_);
  if (!is_on) return line_->setText(tr("Off. Nobody can watch."));
  if (feed_.viewers() == 0) {
    line_->setText(tr("On. In Foxglove or Lichtblick, choose Open connection, Foxglove WebSocket, and enter the address "
                      "below."));
  } else {
    line_->setText(tr("On. Viewers watching: %1").arg(feed_.viewers()));
  }
}

}  // namespace hapticell::app
