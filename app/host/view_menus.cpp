// SPDX-License-Identifier: Apache-2.0
#include "app/host/view_menus.h"

#include <QActionGroup>

#include "app/host/actions.h"
#include "app/viewport/viewport_widget.h"

namespace hapticell::app {

ViewMenus::ViewMenus(const Actions& actions, ViewportWidget& viewport) : actions_(actions), viewport_(viewport) {
  projection_.setObjectName("menuProjection");
  faces_.setObjectName("menuFaces");
  addChoice(projection_, actions.perspective, tr("Perspective"), tr("Orthographic"));
  addChoice(faces_, actions.edges, tr("Shaded, edges"), tr("Shaded"));
  show();
}

void ViewMenus::addChoice(QMenu& menu, QAction* action, const QString& on, const QString& off) {
  auto* group = new QActionGroup(&menu);
  for (const bool wanted : {true, false}) {
    QAction* choice = group->addAction(menu.addAction(wanted ? on : off));
    choice->setCheckable(true);
    choice->setChecked(action->isChecked() == wanted);
    connect(choice, &QAction::triggered, action, [action, wanted] {
      if (action->isChecked() != wanted) action->trigger();
    });
    connect(action, &QAction::toggled, choice, [choice, wanted](bool checked) {
      if (checked == wanted) choice->setChecked(true);
    });
  }
  connect(action, &QAction::toggled, this, &ViewMenus::show);
}

void ViewMenus::show() {
  viewport_.setViewStrip({{actions_.perspective->isChecked() ? tr("Perspective") : tr("Orthographic"), &projection_},
                          {actions_.edges->isChecked() ? tr("Shaded, edges") : tr("Shaded"), &faces_}});
}

}  // namespace hapticell::app
