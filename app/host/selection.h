// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <algorithm>
#include <utility>
#include <vector>

#include "workcell/entity/entity.h"

namespace hapticell::app {

/// The selected entities: one selection for the tree, the viewport and all panels. One of them is the current one,
/// which panels about a single entity show. GUI thread.
class Selection : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  workcell::EntityId current() const { return current_; }  ///< 0: nothing.
  /// All selected entities, in the order in which they were chosen; empty exactly if current() is 0.
  const std::vector<workcell::EntityId>& all() const { return all_; }
  bool contains(workcell::EntityId entity) const { return std::find(all_.begin(), all_.end(), entity) != all_.end(); }

  /// Selects this entity alone; 0: nothing.
  void set(workcell::EntityId entity) {
    setAll(entity != 0 ? std::vector<workcell::EntityId>{entity} : std::vector<workcell::EntityId>{}, entity);
  }
  /// Selects all of these; `current` is one of them, or 0 for the last.
  void setAll(std::vector<workcell::EntityId> entities, workcell::EntityId current = 0) {
    const bool known = std::find(entities.begin(), entities.end(), current) != entities.end();
    if (!known) current = entities.empty() ? 0 : entities.back();
    if (entities == all_ && current == current_) return;
    const bool other = current != current_;
    all_ = std::move(entities);
    current_ = current;
    emit allChanged();
    if (other) emit changed(current_);
  }
  /// Adds an entity and makes it the current one, or removes it.
  void toggle(workcell::EntityId entity) {
    if (entity == 0) return;
    std::vector<workcell::EntityId> entities = all_;
    const auto found = std::find(entities.begin(), entities.end(), entity);
    found == entities.end() ? entities.push_back(entity) : void(entities.erase(found));
    const bool in = std::find(entities.begin(), entities.end(), entity) != entities.end();
    setAll(std::move(entities), in ? entity : current_);
  }

 signals:
  void changed(hapticell::workcell::EntityId entity);  ///< The current entity changed.
  void allChanged();                                   ///< The selected set changed; before changed().

 private:
  std::vector<workcell::EntityId> all_;
  workcell::EntityId current_ = 0;
};

}  // namespace hapticell::app
