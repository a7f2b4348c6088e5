// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "app/controls/reference_choice.h"
#include "geometry/system/error.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace hapticell::app {

/// The frames of the cell that a path passes, in their order: added, removed, moved up and down. A frame may be in it
/// more than once. GUI thread.
class ThroughList : public QWidget {
  Q_OBJECT
 public:
  explicit ThroughList(Host& host, QWidget* parent = nullptr);

  /// Where the frames are now. Error: one of them no longer exists.
  Expected<std::vector<Pose>> poses() const;
  /// As in a new cell.
  void clear();

 private:
  void add();
  void remove();
  void move(int by);
  void refresh();

  ReferenceChoice* choice_;
  QListWidget* list_;
  QLabel* empty_;  ///< Over the list while it is empty: what that means.
  std::vector<Reference> frames_;  ///< One a row.
  QPushButton *add_, *remove_, *up_, *down_;
};

}  // namespace hapticell::app
