// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/panels/collisions/contact_log_model.h"

class QTableView;

namespace hapticell::app {

class Host;

/// The log of contacts as a table that can be cleared and saved.
class ContactLogPage : public QWidget {
  Q_OBJECT
 public:
  explicit ContactLogPage(Host& host, QWidget* parent = nullptr);
  /// Takes the contacts of a snapshot; emits changed() if there are new events.
  void take(const manipulation::SceneSnapshot& snapshot);
  void clear();
  /// Writes it as CSV; false, with a message, if the file cannot be written.
  bool save(const QString& path);
  const ContactLog& log() const { return log_; }
  /// The newest events in one line; empty if nothing has touched.
  QString lastLine() const;

 signals:
  void changed();

 private:
  Host& host_;
  ContactLog log_;
  ContactLogModel model_;
};

/// Gives the tables of the collisions' dock the same look.
void setUpPairTable(QTableView& table, QAbstractItemModel& model);

}  // namespace hapticell::app
