// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "app/viewport/strip_text.h"
#include "manipulation/scene_snapshot.h"
#include "workcell/document_state.h"
#include "workcell/pair_policy.h"

namespace hapticell::app {

/// One line of the collisions table: two entities (or their parts) and how near they are.
struct PairRow {
  workcell::EntityId moved = 0, other = 0;
  QString moved_name, other_name;
  Mark mark = Mark::kNone;
  std::optional<double> distance;  ///< Metres; nothing where none was measured.
  double near_miss = 0.0, safety_distance = 0.0;
  workcell::OnContact on_contact = workcell::OnContact::kSlide;
  bool operator==(const PairRow&) const = default;
};

/// What is checked against `moved` (0: nothing): measured pairs first, nearest first, then those that are further away
/// than the loop measures. Each pair of entities stands there at least once; several parts have a row each.
std::vector<PairRow> pairRows(const workcell::DocumentState& state,
                              const std::optional<manipulation::SceneSnapshot>& snapshot, workcell::EntityId moved,
                              const workcell::PairDefaults& defaults);

/// "Contact", "Near miss" or "Free".
QString markName(Mark mark);

/// The rows as a table. GUI thread.
class PairTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kState, kMoved, kAgainst, kDistance, kNearMiss, kOnContact, kColumns };
  enum Role {
    kMarkRole = Qt::UserRole,
    kShareRole,
    kThresholdRole
  };  ///< Shares of the bar's length, 0 .. 1; invalid: none.
  enum class Show { kAll, kContact, kNearMiss };
  using QAbstractTableModel::QAbstractTableModel;

  void setRows(std::vector<PairRow> rows);
  void setShow(Show show, const QString& filter);
  /// How many rows there are of a kind, shown or not.
  int count(Show show) const;
  const PairRow& row(int index) const { return rows_[shown_[static_cast<std::size_t>(index)]]; }

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(shown_.size());
  }
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<std::size_t> choose() const;
  std::vector<PairRow> rows_;
  std::vector<std::size_t> shown_;
  Show show_ = Show::kAll;
  QString filter_;
};

}  // namespace hapticell::app
