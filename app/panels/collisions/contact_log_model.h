// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>

#include "app/panels/collisions/contact_log.h"

namespace hapticell::app {

/// "12.40 s contact began, Housing 4711 – Locator 2": an event in one line.
QString eventLine(const ContactEvent& event);

/// The log as a table, newest first. GUI thread.
class ContactLogModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kTime, kEvent, kMoved, kAgainst, kDistance, kForce, kDuration, kColumns };
  explicit ContactLogModel(const ContactLog& log, QObject* parent = nullptr) : QAbstractTableModel(parent), log_(log) {}
  /// The log may have changed.
  void refresh();
  int rowCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : shown_; }
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  const ContactLog& log_;
  int shown_ = 0;
  std::size_t count_ = 0;
};

}  // namespace hapticell::app
