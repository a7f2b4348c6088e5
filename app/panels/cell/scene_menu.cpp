// SPDX-License-Identifier: Apache-2.0
#include "app/panels/cell/scene_menu.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <cmath>

#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/panels/cell/entity_menu.h"
#include "app/panels/cell/workcell_panel.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

/// Where the ray through a pixel meets the floor; what the camera looks at where it does not.
dvec3 floorUnder_W(const ViewportWidget& scene, const QPoint& place) {
  const Camera& camera = scene.camera();
  const ViewSize size{static_cast<double>(scene.width()), static_cast<double>(scene.height())};
  const Ray ray = camera.rayThrough({place.x(), place.y()}, size);
  const double along = -ray.origin_W.z / ray.direction_W.z;
  // m: beyond lies the horizon, and the point under the pointer is no place meant. Half, twice: no effect in cells
  // (kFarthest of command_checks.h is 2000).
  constexpr double kFar = 1e3;
  if (!std::isfinite(along) || along <= 0.0 || along > kFar) return {camera.target_W.x, camera.target_W.y, 0.0};
  return ray.origin_W + along * ray.direction_W;
}

}  // namespace

SceneMenu::SceneMenu(Host& host, WorkcellPanel& tree) : QObject(&tree), host_(host), tree_(tree) {
  connect(&host_.viewport(), &ViewportWidget::contextMenuWanted, this, &SceneMenu::open);
}

void SceneMenu::open(workcell::EntityId entity, const QPoint& global) {
  auto* menu = new QMenu(&host_.window());
  menu->setObjectName("menuScene");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (entity == 0) {
    fillFloorMenu(*menu, host_, floorUnder_W(host_.viewport(), host_.viewport().mapFromGlobal(global)));
  } else {
    if (!host_.selection().contains(entity)) host_.selection().set(entity);
    Entities ids{entity};
    for (const auto id : host_.selection().all())
      if (id != entity) ids.push_back(id);
    // Those of the mannequin, where one is in the cell: they show themselves.
    for (const char* name : {"actionLeftHandHere", "actionRightHandHere", "actionBothHandsHere", "actionSitHere"})
      if (auto* action = host_.window().findChild<QAction*>(name)) menu->addAction(action);
    menu->addSeparator();
    fillEntityMenu(*menu, host_, ids, [this, entity] { tree_.rename(entity); });
  }
  menu->popup(global);  // Returns at once.
}

}  // namespace hapticell::app
