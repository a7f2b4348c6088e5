// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "app/import/import_facts.h"

namespace hapticell::app {

class SizeCard;

/// Asks for the unit of a file that states none: shows the part in metres and in millimetres, each next to a person of
/// 1.75 m, to choose from. GUI thread.
class UnitQuestion : public QWidget {
  Q_OBJECT
 public:
  explicit UnitQuestion(QWidget* parent = nullptr);
  /// `metres_per_unit`: the choice; empty: not chosen yet.
  void setFile(const ImportFacts& facts, std::optional<double> metres_per_unit);

 signals:
  void chosen(double metres_per_unit);

 private:
  std::array<SizeCard*, 2> cards_{};
};

}  // namespace hapticell::app
