// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "workcell/entity.h"

namespace hapticell::app {

/// The selected entity: one for the tree, the viewport and all panels. GUI thread.
class Selection : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  workcell::EntityId current() const { return current_; }  ///< 0: nothing.
  void set(workcell::EntityId entity) {
    if (entity == current_) return;
    current_ = entity;
    emit changed(entity);
  }

 signals:
  void changed(hapticell::workcell::EntityId entity);

 private:
  workcell::EntityId current_ = 0;
};

}  // namespace hapticell::app
