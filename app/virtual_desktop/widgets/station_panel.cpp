// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/widgets/station_panel.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/style/segmented.h"

namespace hapticell::app {
namespace {

const QString kThisStation = QStringLiteral("127.0.0.1");

}  // namespace

StationPanel::StationPanel(const QString& host, int port, QWidget* parent) : QWidget(parent), port_now_(port) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  where_ = new Segmented({tr("This station"), tr("Another")});
  where_->setObjectName("segmentsStation");
  where_->setToolTip(tr("Where the stylus is plugged in and its haptic server runs"));
  addRow(*column, tr("Plugged in at"), where_);
  addFields();
  const bool other = !isThisStation(host);
  where_->setCurrent(other ? 1 : 0);
  if (other) host_->setText(host);
  port_->setValue(port);
  showFields(other);
  connect(where_, &Segmented::chosen, this, [this](int index) {
    pairing_.cancel();
    showFields(index == 1);
    if (index == 0) emit stationChosen(kThisStation, port_now_);
  });
  connect(&pairing_, &StationPairing::tried, this, [this](bool fits, const QString& sentence) {
    use_->setText(tr("Pair and use"));
    say(sentence);
    if (!fits) return;
    code_->clear();
    showKnown();
    emit stationChosen(host_->text().trimmed(), port_->value());
  });
}

void StationPanel::addFields() {
  fields_ = new QWidget;
  auto* column = new QVBoxLayout(fields_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  host_ = new QLineEdit;
  host_->setObjectName("editStationHost");
  host_->setPlaceholderText(tr("Name, or 192.168.1.20"));
  port_ = new QSpinBox;
  port_->setObjectName("spinStationPort");
  port_->setRange(1, 65535);
  port_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  port_->setFixedWidth(60);
  port_->setAccessibleName(tr("Port"));
  port_->setToolTip(tr("Port of the server. Default: 4747"));
  auto* address = new QWidget;
  auto* row = new QHBoxLayout(address);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(host_, 1);
  row->addWidget(port_);
  addRow(*column, tr("Address"), address);
  code_ = new QLineEdit;
  code_->setObjectName("editStationCode");
  addRow(*column, tr("Code"), code_);
  use_ = new QPushButton(tr("Pair and use"));
  use_->setObjectName("buttonPairStation");
  column->addWidget(sideBySide({use_}));
  line_ = makeLive(3, TextRole::kSecond, true);
  line_->setObjectName("labelStation");
  column->addWidget(line_);
  layout()->addWidget(fields_);
  connect(host_, &QLineEdit::textChanged, this, &StationPanel::showKnown);
  connect(port_, &QSpinBox::valueChanged, this, &StationPanel::showKnown);
  connect(use_, &QPushButton::clicked, this, [this] {
    if (pairing_.isRunning()) {
      pairing_.cancel();
      use_->setText(tr("Pair and use"));
      return showKnown();
    }
    use_->setText(tr("Cancel"));
    say(tr("Connecting to %1…").arg(host_->text().trimmed()));
    pairing_.start(host_->text(), port_->value(), code_->text());
  });
}

void StationPanel::showFields(bool other) {
  fields_->setVisible(other);
  if (other) showKnown();
}

void StationPanel::showKnown() {
  const bool known = StationPairing::knows(host_->text().trimmed(), port_->value());
  code_->setPlaceholderText(known ? tr("Saved. Type another to replace it") : QStringLiteral("K7QM-2F9X-…"));
  if (!pairing_.isRunning())
    say(known ? QString()
              : tr("On the other station, run hapticell-haptic-server --pair once to see the code, then "
                   "hapticell-haptic-server --listen with its address."));
}

void StationPanel::say(const QString& sentence) {
  line_->setText(sentence);
}

}  // namespace hapticell::app
