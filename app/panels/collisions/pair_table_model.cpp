// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/pair_table_model.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace hapticell::app {
namespace {

// m where the distance bar is full; our choice. Half: farther pairs all look alike; twice: near ones do.
constexpr double kBarEnd = 0.050;

QString nameOf(const workcell::DocumentState& state, workcell::EntityId id, const std::string& part) {
  const workcell::Entity* entity = state.find(id);
  const QString name = entity ? QString::fromStdString(entity->name) : QString();
  return part.empty() ? name : name + QStringLiteral(" · ") + QString::fromStdString(part);
}

bool matches(const PairRow& row, PairTableModel::Show show) {
  if (!row.checked) return show == PairTableModel::Show::kAll;
  return show == PairTableModel::Show::kAll || (show == PairTableModel::Show::kContact && row.mark == Mark::kContact) ||
         (show == PairTableModel::Show::kNearMiss && row.mark == Mark::kNearMiss);
}

/// Makes rows for what moves: an entity and what hangs on it.
class RowMaker {
 public:
  RowMaker(const workcell::DocumentState& state, workcell::EntityId moved, const workcell::PairDefaults& defaults)
      : state_(state), defaults_(defaults) {
    entities_.reserve(state.entities.size());
    for (const auto& entity : state.entities) entities_.push_back(*entity);
    if (state.find(moved)) family_.push_back(moved);
    for (std::size_t k = 0; k < family_.size(); ++k) {
      for (const workcell::Entity& other : entities_)
        if (other.attachment.to == state.find(family_[k])->name && !goesAlong(other.id)) family_.push_back(other.id);
      pairs_[family_[k]] = workcell::effectivePairs(entities_, state_.pair_sets, family_[k], defaults);
    }
  }
  const std::vector<workcell::EntityId>& family() const { return family_; }
  bool goesAlong(workcell::EntityId id) const { return std::find(family_.begin(), family_.end(), id) != family_.end(); }
  const std::vector<workcell::EffectivePair>& pairs(workcell::EntityId moved) const { return pairs_.at(moved); }
  /// The choices for a pair that no set names, as the parts of one robot are.
  workcell::EffectivePair pairOf(workcell::EntityId moved, workcell::EntityId other) const {
    const auto& all = pairs(moved);
    const auto found = std::find_if(all.begin(), all.end(), [other](const auto& pair) { return pair.other == other; });
    if (found != all.end()) return *found;
    return {moved, other, defaults_.safety_distance, 0.0, state_.find(moved)->contact.on_contact};
  }
  PairRow row(const workcell::EffectivePair& pair, const std::string& moved_part, const std::string& other_part) const {
    PairRow row;
    row.moved = pair.moved;
    row.other = pair.other;
    row.moved_part = moved_part;
    row.other_part = other_part;
    row.moved_name = nameOf(state_, pair.moved, moved_part);
    row.other_name = nameOf(state_, pair.other, other_part);
    row.near_miss = pair.near_miss;
    row.safety_distance = pair.safety_distance;
    row.on_contact = pair.on_contact;
    if (const workcell::PairSet* set = workcell::lastSetFor(entities_, state_.pair_sets, pair.moved, pair.other))
      row.set = QString::fromStdString(set->name);
    const workcell::PairRule* rule = workcell::ruleFor(state_.pair_rules, {state_.find(pair.moved)->name, moved_part},
                                                       {state_.find(pair.other)->name, other_part});
    if (!rule) return row;
    row.checked = rule->checked;
    row.own_on_contact = rule->on_contact.has_value();
    if (rule->on_contact) row.on_contact = *rule->on_contact;
    return row;
  }
  static void measure(PairRow& row, const manipulation::PairState& now) {
    row.mark = pairMark(now);
    row.distance = now.distance;
    row.p_W = {now.p_WA, now.p_WB};
  }
  /// What hangs on something is never checked against the body it hangs on; the list says so.
  void appendAttached(workcell::EntityId id, std::vector<PairRow>& rows) const {
    const workcell::Entity* entity = state_.find(id);
    const workcell::Entity* carrier = entity ? state_.findByName(entity->attachment.to) : nullptr;
    if (!carrier) return;
    PairRow row = this->row(pairOf(id, carrier->id), {}, carrier->robot() ? entity->attachment.link : std::string());
    row.checked = false;
    row.one_body = true;
    rows.push_back(std::move(row));
  }
  /// Pairs of links that the user leaves out, where the entities as a whole are checked.
  void appendLeftOut(const workcell::EffectivePair& pair, std::vector<PairRow>& rows) const {
    const workcell::Entity* moved = state_.find(pair.moved);
    const workcell::Entity* other = state_.find(pair.other);
    for (const workcell::PairRule& rule : state_.pair_rules) {
      if (!moved || !other || rule.checked || (rule.first_part.empty() && rule.second_part.empty())) continue;
      if (rule.first == moved->name && rule.second == other->name)
        rows.push_back(row(pair, rule.first_part, rule.second_part));
      else if (rule.second == moved->name && rule.first == other->name)
        rows.push_back(row(pair, rule.second_part, rule.first_part));
    }
  }

 private:
  const workcell::DocumentState& state_;
  const workcell::PairDefaults defaults_;
  std::vector<workcell::Entity> entities_;
  std::vector<workcell::EntityId> family_;
  std::map<workcell::EntityId, std::vector<workcell::EffectivePair>> pairs_;  ///< Of each of the family.
};

/// Whether two carried things, or a carried thing and its carrier, are rows of their own: only against a robot's links.
bool isRowWithin(const workcell::DocumentState& state, const RowMaker& maker, const workcell::EffectivePair& pair) {
  if (!maker.goesAlong(pair.other)) return true;
  const workcell::EntityId top = maker.family().front();
  return pair.moved != top && pair.other == top && state.find(top)->robot() != nullptr;
}

}  // namespace

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

std::vector<PairRow> pairRows(const workcell::DocumentState& state, const PairSources& sources,
                              workcell::EntityId moved, const workcell::PairDefaults& defaults) {
  const RowMaker maker(state, moved, defaults);
  const bool held = sources.snapshot && sources.snapshot->stylus.held == moved;
  const std::vector<manipulation::PairState>* now = held ? &sources.snapshot->pairs : sources.at_rest;
  std::vector<PairRow> measured, far, off;
  std::set<std::pair<workcell::EntityId, workcell::EntityId>> seen;
  for (std::size_t i = 0; now && i < now->size(); ++i) {
    const manipulation::PairState& state_now = (*now)[i];
    if (!maker.goesAlong(state_now.moved) || !state.find(state_now.other)) continue;
    PairRow row = maker.row(maker.pairOf(state_now.moved, state_now.other), state_now.moved_part, state_now.other_part);
    if (row.checked) RowMaker::measure(row, state_now);
    (row.checked ? measured : off).push_back(std::move(row));
    seen.insert({state_now.moved, state_now.other});
  }
  for (const workcell::EntityId one : maker.family()) {
    for (const workcell::EffectivePair& pair : maker.pairs(one)) {
      if (!isRowWithin(state, maker, pair)) continue;
      if (!seen.contains({pair.moved, pair.other})) {
        PairRow row = maker.row(pair, {}, {});
        (row.checked ? far : off).push_back(std::move(row));
      }
      maker.appendLeftOut(pair, off);
    }
    maker.appendAttached(one, off);
  }
  std::stable_sort(measured.begin(), measured.end(),
                   [](const PairRow& a, const PairRow& b) { return *a.distance < *b.distance; });
  measured.insert(measured.end(), std::make_move_iterator(far.begin()), std::make_move_iterator(far.end()));
  measured.insert(measured.end(), std::make_move_iterator(off.begin()), std::make_move_iterator(off.end()));
  return measured;
}

QString markName(Mark mark) {
  if (mark == Mark::kContact) return QObject::tr("Contact");
  return mark == Mark::kNearMiss ? QObject::tr("Near miss") : QObject::tr("Free");
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
  return static_cast<int>(std::count_if(rows_.begin(), rows_.end(),
                                        [show](const PairRow& row) { return row.checked && matches(row, show); }));
}

int PairTableModel::find(const PairRow& pair) const {
  for (int i = 0; i < static_cast<int>(shown_.size()); ++i)
    if (row(i).isSamePair(pair)) return i;
  return -1;
}

QVariant PairTableModel::words(const PairRow& at, int column) const {
  switch (column) {
    case kState:
      if (at.checked) return markName(at.mark);
      return at.one_body ? tr("Attached") : tr("Off");
    case kMoved:
      return at.moved_name;
    case kAgainst:
      return at.other_name;
    case kDistance:
      if (!at.checked) return tr("not checked");
      return at.distance ? QString::fromStdString(millimetres(*at.distance)) : tr("far");
    case kNearMissWithin:
      return at.checked ? QString::fromStdString(millimetres(at.near_miss)) : QStringLiteral("—");
    case kOnContact:
      return at.checked ? onContactName(at.on_contact) : QStringLiteral("—");
    default:
      return {};
  }
}

QVariant PairTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const PairRow& at = row(index.row());
  switch (role) {
    case kMarkRole:
      return static_cast<int>(at.mark);
    case kShareRole:
      return at.distance ? QVariant(std::clamp(*at.distance / kBarEnd, 0.0, 1.0)) : QVariant();
    case kThresholdRole:
      return std::clamp(at.near_miss / kBarEnd, 0.0, 1.0);
    case kCheckedRole:
      return at.checked;
    case kOneBodyRole:
      return at.one_body;
    case kOwnRole:
      return at.own_on_contact;
    case Qt::TextAlignmentRole:
      return static_cast<int>(
          (index.column() == kDistance || index.column() == kNearMissWithin ? Qt::AlignRight : Qt::AlignLeft) |
          Qt::AlignVCenter);
    case Qt::ToolTipRole:
      if (index.column() == kOnContact && at.checked)
        return at.own_on_contact ? tr("Set for this pair; click to change it") : tr("Click to set it for this pair");
      if (at.one_body) return tr("One is attached to the other, so they move together");
      if (index.column() == kCheck) return at.checked ? tr("Exclude this pair") : tr("Include this pair");
      return at.set.isEmpty() ? tr("Everything against everything") : tr("Set: %1").arg(at.set);
    case Qt::AccessibleTextRole:
      if (index.column() == kCheck) return at.checked ? tr("checked") : tr("excluded");
      return words(at, index.column());
    case Qt::DisplayRole:
      return words(at, index.column());
    default:
      return {};
  }
}

QVariant PairTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((section == kDistance || section == kNearMissWithin ? Qt::AlignRight : Qt::AlignLeft) |
                            Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const QString names[kColumns]{tr("State"),     tr("Moved"),      tr("Against"), tr("Distance"),
                                tr("Near miss"), tr("On contact"), tr("Check")};
  return names[section];
}

}  // namespace hapticell::app
