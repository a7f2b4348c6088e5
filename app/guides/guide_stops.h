// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <array>
#include <functional>

#include "workcell/entity/guide.h"

class QCheckBox;
class QVBoxLayout;
class QWidget;

namespace hapticell::app {

class ValueField;

/// A function that receives a change of the shown guide.
using GuideEdit = std::function<void(const std::function<void(workcell::Guide&)>&)>;

/// True for kinds that have stops: line, hinge, slider, screw.
bool hasStops(workcell::GuideKind kind);

/// The row of a guide's lower and upper stop, in mm or degrees. GUI thread.
class GuideStops : public QObject {
  Q_OBJECT
 public:
  GuideStops(QVBoxLayout& section, GuideEdit edit, QObject* parent = nullptr);
  void show(const workcell::Guide& guide);

 private:
  void editStop(bool upper);

  GuideEdit edit_;
  workcell::Guide shown_;
  std::array<QCheckBox*, 2> has_stop_{};
  std::array<ValueField*, 2> mm_stop_{}, degree_stop_{};
  QWidget* row_;
};

}  // namespace hapticell::app
