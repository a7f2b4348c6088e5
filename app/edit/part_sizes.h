// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>

#include "workcell/entity/entity.h"

class QLabel;

namespace hapticell::app {

class Host;
class ValueField;

/// The sizes of a built-in part that is in the cell already, to be changed again: a bench's height. What is attached to
/// it goes up and down with its top. Hidden for anything else. Each edit is one step of undo. GUI thread.
class PartSizes : public QWidget {
  Q_OBJECT
 public:
  explicit PartSizes(Host& host, QWidget* parent = nullptr);
  /// Takes the newest sizes of the chosen solid.
  void showPart(const workcell::Entity& solid);

 private:
  static constexpr std::size_t kMost = 3;
  void resize();
  Host& host_;
  workcell::EntityId id_ = 0;
  std::array<QWidget*, kMost> rows_{};
  std::array<QLabel*, kMost> names_{};
  std::array<ValueField*, kMost> fields_{};
};

}  // namespace hapticell::app
