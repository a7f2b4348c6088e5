// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "workcell/entity/entity.h"

namespace hapticell::app {

class Host;
class WorkcellPanel;

/// The right button's menu in the scene: a short click without a drag, while the mouse does not lead the stylus (its
/// button is the stylus's then) and nothing is picked. On a part: chooses it, unless it is one of several that are
/// chosen, and offers what the tree offers; on the floor: insert, paste, views. The scene goes on under it.
class SceneMenu : public QObject {
  Q_OBJECT
 public:
  /// `tree` is where names are edited.
  SceneMenu(Host& host, WorkcellPanel& tree);

 private:
  void open(workcell::EntityId entity, const QPoint& global);
  Host& host_;
  WorkcellPanel& tree_;
};

}  // namespace hapticell::app
