// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractListModel>
#include <QListView>

#include "app/host/document_model.h"

namespace hapticell::app {

/// The undo steps as a list: row 0 is the cell as it was opened, each further row one step. Undone steps are below the
/// current row until something new is done.
class HistoryModel : public QAbstractListModel {
  Q_OBJECT
 public:
  explicit HistoryModel(DocumentModel& document, QObject* parent = nullptr);
  enum Role { kUndoneRole = Qt::UserRole, kCurrentRole };
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  /// Number of steps that are done, which is the current row.
  int current() const { return current_; }

 private:
  void read();
  DocumentModel& document_;
  QStringList texts_;
  int current_ = 0;
};

/// The list; a click goes to that step.
class HistoryPanel : public QListView {
  Q_OBJECT
 public:
  explicit HistoryPanel(DocumentModel& document, QWidget* parent = nullptr);

 private:
  HistoryModel model_;
};

}  // namespace hapticell::app
