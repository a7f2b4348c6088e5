// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "manipulation/engine/manipulation_command.h"

class QCheckBox;
class QWidget;
class QVBoxLayout;

namespace hapticell::app {

class ValueField;
class Segmented;

/// How to record the next motion: a frame by time, by distance, by hand, or at every step. GUI thread.
class RecordingFields : public QObject {
  Q_OBJECT
 public:
  explicit RecordingFields(QVBoxLayout& section, QObject* parent = nullptr);

  /// The user's choices.
  manipulation::command::StartRecording wanted() const;
  double interval() const;  ///< Seconds between frames by time.

 private:
  void show();

  Segmented* mode_;
  ValueField *interval_, *spacing_, *turn_spacing_;
  QWidget *interval_row_, *spacing_row_;
  QCheckBox* second_button_;
};

}  // namespace hapticell::app
