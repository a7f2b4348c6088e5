// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <QColor>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/scene/strip_text.h"
#include "manipulation/engine/scene_snapshot.h"
#include "workcell/document/document_state.h"
#include "workcell/entity/pair_policy.h"

namespace hapticell::app {

/// One line of the collisions table: two entities (or their parts) and their distance.
struct PairRow {
  workcell::EntityId moved = 0, other = 0;
  std::string moved_part, other_part;  ///< Link names; empty: a solid, or a whole robot.
  QString moved_name, other_name;
  Mark mark = Mark::kNone;
  bool checked = true;             ///< False: the user excluded the pair, or both are one body.
  bool one_body = false;           ///< One is attached to the other: they cannot move relative to each other.
  std::optional<double> distance;  ///< Metres; empty if not measured.
  std::array<dvec3, 2> p_W{};      ///< The nearest points, if a distance was measured.
  double near_miss = 0.0, safety_distance = 0.0;
  workcell::OnContact on_contact = workcell::OnContact::kSlide;
  bool own_on_contact = false;  ///< A pair rule sets the contact mode.
  QString set;                  ///< The pair set that applies; empty: none, everything is checked against everything.
  bool operator==(const PairRow&) const = default;
  /// Whether it is the same pair, whatever the numbers.
  bool isSamePair(const PairRow& row) const {
    return moved == row.moved && other == row.other && moved_part == row.moved_part && other_part == row.other_part;
  }
};

/// The source of distances: the loop while something is held, else the measurement at rest.
struct PairSources {
  const manipulation::SceneSnapshot* snapshot = nullptr;
  const std::vector<manipulation::PairState>* at_rest = nullptr;
};

/// What is checked against `moved` (0: nothing) and what is attached to it: first measured pairs, nearest first; then
/// pairs too far apart to be measured; then excluded pairs (by the user, or because one is attached to the other).
/// Every pair reported by the loop has a row, so that list, scene and sound agree. Each pair of entities has at least
/// one row; several parts have a row each.
std::vector<PairRow> pairRows(const workcell::DocumentState& state, const PairSources& sources,
                              workcell::EntityId moved, const workcell::PairDefaults& defaults);

/// "Contact", "Near miss" or "Free".
QString markName(Mark mark);
/// "Stop", "Slide", "Pass".
QString onContactName(workcell::OnContact on_contact);

/// The rows as a table. GUI thread.
class PairTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kState, kMoved, kAgainst, kDistance, kNearMissWithin, kOnContact, kCheck, kColumns };
  enum Role {
    kMarkRole = Qt::UserRole,
    kShareRole,
    kThresholdRole,  ///< Fractions of the bar's length, 0 to 1; invalid: none.
    kCheckedRole,    ///< bool
    kOneBodyRole,    ///< bool: one is attached to the other, so there is nothing to switch.
    kOwnRole         ///< bool: a pair rule sets the contact mode.
  };
  enum class Show { kAll, kContact, kNearMiss };
  using QAbstractTableModel::QAbstractTableModel;

  void setRows(std::vector<PairRow> rows);
  void setShow(Show show, const QString& filter);
  /// Number of rows of a kind, shown or not; excluded pairs do not count.
  int count(Show show) const;
  const PairRow& row(int index) const { return rows_[shown_[static_cast<std::size_t>(index)]]; }
  const std::vector<PairRow>& rows() const { return rows_; }
  /// The shown row of the same pair, or -1.
  int find(const PairRow& pair) const;

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(shown_.size());
  }
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<std::size_t> choose() const;
  QVariant words(const PairRow& row, int column) const;
  std::vector<PairRow> rows_;
  std::vector<std::size_t> shown_;
  Show show_ = Show::kAll;
  QString filter_;
};

}  // namespace hapticell::app
