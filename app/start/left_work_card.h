// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "workcell/files/autosave.h"

class QHBoxLayout;

namespace hapticell::app {

/// Unsaved work after a crash, on the start page: picture, name, time, cause of the crash, and possible actions.
class LeftWorkCard : public QWidget {
  Q_OBJECT
 public:
  explicit LeftWorkCard(const workcell::LeftWork& left, QWidget* parent = nullptr);

 signals:
  void restoreWanted();
  void discardWanted();
  void laterWanted();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void addPicture(QHBoxLayout& row, const workcell::LeftWork& left);
  void addWords(QHBoxLayout& row, const workcell::LeftWork& left);
  void addButtons(QHBoxLayout& row, bool has_copy);
};

}  // namespace hapticell::app
