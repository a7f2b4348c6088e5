// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>

#include "app/virtual_desktop/devices/station_pairing.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace hapticell::app {

class Segmented;

/// Where the stylus is plugged in: this station, or another one in the network with its address and pairing key. A
/// choice is offered once the server there has answered; the owner accepts it or says why not.
class StationPanel : public QWidget {
  Q_OBJECT
 public:
  /// `host` and `port`: the present server.
  StationPanel(const QString& host, int port, QWidget* parent = nullptr);

 signals:
  void stationChosen(const QString& host, int port);

 private:
  void addFields();
  void showFields(bool other);
  void showKnown();
  void say(const QString& sentence);

  int port_now_;
  StationPairing pairing_;
  Segmented* where_;
  QWidget* fields_;
  QLineEdit *host_, *code_;
  QSpinBox* port_;
  QPushButton* use_;
  QLabel* line_;
};

}  // namespace hapticell::app
