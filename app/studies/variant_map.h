// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/viewport/scene/render_item.h"
#include "workcell/document/document_state.h"

namespace hapticell::app {

class ResultTable;

/// A place of the scene and the best variant there.
struct MapCell {
  std::int64_t number = 0;  ///< Of the variant.
  dvec3 p_W{0.0};           ///< Middle of the cell.
  bool feasible = false;
  std::optional<double> value;  ///< Of the column that is shown.
};

/// Results as coloured cells where the variants stand: on the floor for places along x and y, else upright at what is
/// moved. A value.
struct VariantMap {
  std::vector<MapCell> cells;
  dvec3 size{0.0};                     ///< Of one cell, m, along the axes below.
  double yaw = 0.0;                    ///< rad about z, of the first axis of the cells from x.
  double least = 0.0, greatest = 0.0;  ///< Of the values of feasible cells; of all where none is feasible.
  bool greater_is_better = false;

  bool isEmpty() const { return cells.empty(); }
  /// 0 to 1, 1 the best; nothing without a value.
  std::optional<double> shareOf(const MapCell& cell) const;
  /// The cell at a point of the plane of the cells (m); null: none.
  const MapCell* at(const dvec3& p_W) const;
  std::vector<RenderItem> items() const;
};

/// The map of a column. Places come from what varies: positions along axes of the cell and heights of parts; of several
/// variants at one place the best one counts (feasible, then by the column). Empty if nothing of the kind varies. `cell`
/// is the given one of the study.
VariantMap mapOf(const ResultTable& table, const workcell::DocumentState& cell, int column);

/// The colour of a share, 0 worst to 1 best: dark blue to yellow, distinct by lightness too.
QColor heatColor(double share);

}  // namespace hapticell::app
