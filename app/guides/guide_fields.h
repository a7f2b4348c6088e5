// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <array>

#include "app/guides/guide_stops.h"
#include "app/style/value_field.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;

namespace hapticell::app {

/// The numbers of a guide, as far as its kind has them: size, stops, detents, friction, guidance and locks. GUI thread.
class GuideFields : public QObject {
  Q_OBJECT
 public:
  GuideFields(QVBoxLayout& column, GuideEdit edit, QObject* parent = nullptr);
  void show(const workcell::Guide& guide);

 private:
  void addSizes(QVBoxLayout& section);
  void addDetents(QVBoxLayout& section);
  void addHelp(QVBoxLayout& section);
  void addLocks(QVBoxLayout& section);
  ValueField* field(const char* name, const ValueField::Format& format, double unit, double workcell::Guide::*what);
  void showDetents(const workcell::Guide& guide);

  GuideEdit edit_;
  workcell::Guide shown_;
  ValueField *radius_, *pitch_, *offset_, *friction_, *detent_width_, *detent_force_;
  GuideStops* stops_;
  QLineEdit* detents_;
  QSlider* help_;
  QLabel* help_value_;
  std::array<QPushButton*, 6> locks_{};
  QWidget *radius_row_, *pitch_row_, *offset_row_, *detents_row_, *detent_row_, *help_row_, *locks_row_;
};

}  // namespace hapticell::app
