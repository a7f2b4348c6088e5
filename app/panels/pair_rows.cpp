// SPDX-License-Identifier: Apache-2.0
#include "app/panels/pair_rows.h"

#include <algorithm>

namespace hapticell::app {
namespace {

constexpr double kBarEnd = 0.050;  // Metres: where the distance bar is full.

QString nameOf(const workcell::DocumentState& state, workcell::EntityId id, const std::string& part) {
  const workcell::Entity* entity = state.find(id);
  const QString name = entity ? QString::fromStdString(entity->name) : QString();
  return part.empty() ? name : name + QStringLiteral(" · ") + QString::fromStdString(part);
}

QString onContactName(workcell::OnContact on_contact) {
  switch (on_contact) {
    case workcell::OnContact::kStop:
      return QObject::tr("Stop");
    case workcell::OnContact::kSlide:
      return QObject::tr("Slide");
    case workcell::OnContact::kPass:
      return QObject::tr("Pass");
  }
  return {};
}

bool matches(const PairRow& row, PairTableModel::Show show) {
  return show == PairTableModel::Show::kAll || (show == PairTableModel::Show::kContact && row.mark == Mark::kContact) ||
         (show == PairTableModel::Show::kNearMiss && row.mark == Mark::kNearMiss);
}

}  // namespace

std::vector<PairRow> pairRows(const workcell::DocumentState& state,
                              const std::optional<manipulation::SceneSnapshot>& snapshot, workcell::EntityId moved,
                              const workcell::PairDefaults& defaults) {
  std::vector<workcell::Entity> entities;
  entities.reserve(state.entities.size());
  for (const auto& entity : state.entities) entities.push_back(*entity);
  std::vector<PairRow> measured, far;
  for (const auto& pair : workcell::effectivePairs(entities, state.pair_sets, moved, defaults)) {
    PairRow row{moved,          pair.other, nameOf(state, moved, {}), nameOf(state, pair.other, {}),
                Mark::kNone,    {},         pair.near_miss,           pair.safety_distance,
                pair.on_contact};
    bool seen = false;
    if (snapshot && snapshot->held == moved) {
      for (const auto& now : snapshot->pairs) {
        if (now.moved != moved || now.other != pair.other) continue;
        PairRow part = row;
        part.moved_name = nameOf(state, moved, now.moved_part);
        part.other_name = nameOf(state, pair.other, now.other_part);
        part.mark = now.contact ? Mark::kContact : now.near_miss ? Mark::kNearMiss : Mark::kNone;
        part.distance = now.distance;
        measured.push_back(std::move(part));
        seen = true;
      }
    }
    if (!seen) far.push_back(std::move(row));
  }
  std::stable_sort(measured.begin(), measured.end(),
                   [](const PairRow& a, const PairRow& b) { return *a.distance < *b.distance; });
  measured.insert(measured.end(), std::make_move_iterator(far.begin()), std::make_move_iterator(far.end()));
  return measured;
}

QString markName(Mark mark) {
  return mark == Mark::kContact    ? QObject::tr("Contact")
         : mark == Mark::kNearMiss ? QObject::tr("Near miss")
                                   : QObject::tr("Free");
}

std::vector<std::size_t> PairTableModel::choose() const {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool named = filter_.isEmpty() || rows_[i].moved_name.contains(filter_, Qt::CaseInsensitive) ||
                       rows_[i].other_name.contains(filter_, Qt::CaseInsensitive);
    if (named && matches(rows_[i], show_)) shown.push_back(i);
  }
  return shown;
}

void PairTableModel::setRows(std::vector<PairRow> rows) {
  if (rows == rows_) return;
  const std::size_t before = shown_.size();
  rows_.swap(rows);
  std::vector<std::size_t> fresh = choose();
  if (fresh.size() == before) {
    // The selection stays on its line while the numbers change.
    shown_ = std::move(fresh);
    if (before > 0) emit dataChanged(index(0, 0), index(static_cast<int>(before) - 1, kColumns - 1));
    return;
  }
  beginResetModel();
  shown_ = std::move(fresh);
  endResetModel();
}

void PairTableModel::setShow(Show show, const QString& filter) {
  beginResetModel();
  show_ = show;
  filter_ = filter;
  shown_ = choose();
  endResetModel();
}

int PairTableModel::count(Show show) const {
  return static_cast<int>(
      std::count_if(rows_.begin(), rows_.end(), [show](const PairRow& row) { return matches(row, show); }));
}

QVariant PairTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const PairRow& at = row(index.row());
  if (role == kMarkRole) return static_cast<int>(at.mark);
  if (role == kShareRole) return at.distance ? QVariant(std::clamp(*at.distance / kBarEnd, 0.0, 1.0)) : QVariant();
  if (role == kThresholdRole) return std::clamp(at.near_miss / kBarEnd, 0.0, 1.0);
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>(
        (index.column() == kDistance || index.column() == kNearMiss ? Qt::AlignRight : Qt::AlignLeft) |
        Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kState:
      return markName(at.mark);
    case kMoved:
      return at.moved_name;
    case kAgainst:
      return at.other_name;
    case kDistance:
      return at.distance ? QString::fromStdString(millimetres(*at.distance)) : tr("not near");
    case kNearMiss:
      return QString::fromStdString(millimetres(at.near_miss));
    case kOnContact:
      return onContactName(at.on_contact);
    default:
      return {};
  }
}

QVariant PairTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((section == kDistance || section == kNearMiss ? Qt::AlignRight : Qt::AlignLeft) |
                            Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const QString names[kColumns]{tr("State"),    tr("Moved"),     tr("Against"),
                                tr("Distance"), tr("Near miss"), tr("On contact")};
  return names[section];
}

}  // namespace hapticell::app
