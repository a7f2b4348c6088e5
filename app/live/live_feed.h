// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>

#include "bridge/foxglove/cell_feed.h"
#include "bridge/foxglove/viewer_server.h"

namespace hapticell::app {

class Host;

/// Serves the open cell to viewers while it is on: shapes as the document has them, and what moves 30 times a second.
/// GUI thread.
class LiveFeed : public QObject {
  Q_OBJECT
 public:
  explicit LiveFeed(Host& host, QObject* parent = nullptr);

  /// Starts to serve. `for_others`: other machines too, with a code that the addresses then have. Returns a sentence
  /// that says why it cannot; empty: it serves.
  QString start(bool for_others, int port);
  void stop();
  bool isOn() const { return server_ != nullptr; }
  /// Where viewers find it, one address a line: this machine's, or those that other machines can reach.
  QString addresses() const;
  int viewers() const;

 signals:
  void viewersChanged();

 private:
  void send();

  Host& host_;
  std::unique_ptr<bridge::ViewerServer> server_;
  std::unique_ptr<bridge::CellFeed> feed_;  // Uses the server.
  QTimer timer_;
  QString code_;
  bool for_others_ = false;
  int viewers_ = 0;
};

}  // namespace hapticell::app
