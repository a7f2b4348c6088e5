// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "workcell/entity/entity.h"

namespace hapticell::app {

class Host;
class WorkcellPanel;

/// The right button's menu in the scene: opened by a short click without a drag, unless the mouse leads the stylus
/// (whose button it then is) or something is being picked. On a part: selects it, unless it is one of several selected
/// parts, and offers the entries of the tree; on the floor: insert, paste, views. The scene keeps running under it.
class SceneMenu : public QObject {
  Q_OBJECT
 public:
  /// `tree` edits names.
  SceneMenu(Host& host, WorkcellPanel& tree);

 private:
  void open(workcell::EntityId entity, const QPoint& global);
  Host& host_;
  WorkcellPanel& tree_;
};

}  // namespace hapticell::app
