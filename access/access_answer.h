// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "access/body_access.h"
#include "access/removal_way.h"
#include "access/straight_removal.h"

namespace hapticell::access {

/// What is asked about a part of a cell.
struct AccessQuestion {
  std::shared_ptr<const manipulation::PreparedScene> scene;
  std::string part;
  std::string within;  ///< See RemovalScene::make().
  /// m: overlap that counts as touching. CAD parts touch up to their tessellation (0.1 mm chord). Half: tessellated
  /// fits lock; twice: snaps of 0.2 mm hold nothing.
  double tolerance = 1e-4;
  BodyQuestion people;  ///< Without bodies no person is evaluated.
  /// A way shown by hand: checked and used instead of one that is searched; null: none.
  std::shared_ptr<const trajectory::Trajectory> shown;
};

/// One step of the order: a part that is taken out.
struct RemovalStep {
  std::size_t unit = 0;
  std::string name;
  UnitSet gone = 0;  ///< What went before.
  RemovalWay way;
  std::vector<NeighbourClearance> clearances{};  ///< Nearest first; with all before it gone.
};

/// Everything that is known about taking a part out.
struct AccessAnswer {
  std::shared_ptr<const RemovalScene> removal;
  bool removable = false;                 ///< As the cell stands.
  std::vector<std::string> blocked_by{};  ///< Of the straight way that the fewest block; empty if it is removable.
  std::vector<StraightWay> ways{};        ///< See straightWays(), of the part.
  std::vector<std::string> overlaps{};    ///< Units that it overlaps at rest, beyond the tolerance.
  std::vector<RemovalStep> order{};       ///< First to go first, the part last; empty: no order was found.
  bool is_shortest = true;                ///< No shorter order by single straight steps exists.
  std::vector<BodyAccess> people{};       ///< At the part in its turn.
  bool is_complete = true;                ///< False: cancelled.

  const RemovalStep* step() const { return order.empty() ? nullptr : &order.back(); }
  /// The nearest neighbour on the part's way; null: none within a metre.
  const NeighbourClearance* nearest() const;
};

/// Answers the question. `progress` (0 .. 1) is called in this thread; `cancel` ends it early. Errors: those of
/// RemovalScene::make(); a shown way that is not free. Any thread.
Expected<AccessAnswer> accessOf(const AccessQuestion& question, const std::function<void(double)>& progress,
                                const std::atomic<bool>& cancel);

}  // namespace hapticell::access
