// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "app/guides/guide_stops.h"

class QComboBox;
class QLineEdit;
class QPushButton;

namespace hapticell::app {

class Host;

/// Name, entity, geometry and handle of the shown guide, and the buttons that change them. GUI thread.
class GuideGeometryFields : public QObject {
  Q_OBJECT
 public:
  /// The host must outlive it.
  GuideGeometryFields(Host& host, QVBoxLayout& column, GuideEdit edit, QObject* parent = nullptr);
  void show(const workcell::Guide& guide);

 signals:
  void pickWanted();
  void pathWanted();
  void reverseWanted();
  void placeWanted();
  void handlePickWanted();

 private:
  Host& host_;
  GuideEdit edit_;
  workcell::Guide shown_;
  QLineEdit *name_, *geometry_, *handle_;
  QComboBox* entity_;
  QPushButton *pick_, *path_, *handle_pick_, *reverse_, *place_;
  QWidget* path_row_;
};

}  // namespace hapticell::app
