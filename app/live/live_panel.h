// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace hapticell::app {

class LiveFeed;
class LiveLabel;
class Segmented;

/// Switches the live view on and off, says who may watch and at which address.
class LivePanel : public QWidget {
  Q_OBJECT
 public:
  explicit LivePanel(LiveFeed& feed, QWidget* parent = nullptr);

 private:
  void addChoices(QVBoxLayout& column);
  void addAddress(QVBoxLayout& column);
  void toggle();
  void show();

  LiveFeed& feed_;
  Segmented* who_;
  QSpinBox* port_;
  QPushButton *start_, *copy_;
  LiveLabel* line_;
  QPlainTextEdit* address_;
  QString problem_;
};

}  // namespace hapticell::app
