// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>

#include "workcell/entity/entity.h"

class QLabel;

namespace hapticell::app {

class Host;
class ValueField;

/// The sizes of a built-in part that is already in the cell, such as a bench's height, for changing. What is attached
/// to its top moves with the top. Hidden for anything else. Each edit is one undo step. GUI thread.
class PartSizes : public QWidget {
  Q_OBJECT
 public:
  explicit PartSizes(Host& host, QWidget* parent = nullptr);
  /// Shows the present sizes of the chosen solid.
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
