// SPDX-License-Identifier: Apache-2.0
#include "app/shell/view_menus.h"

#include <QActionGroup>

#include "app/shell/actions.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

ViewMenus::ViewMenus(const Actions& actions, ViewportWidget& viewport, QObject* parent)
    : QObject(parent), actions_(actions), viewport_(viewport) {
  projection_.setObjectName("menuProjection");
  faces_.setObjectName("menuFaces");
  addChoice(projection_, actions.view.perspective, tr("Perspective"), tr("Orthographic"));
  addChoice(faces_, actions.view.edges, tr("Shaded, edges"), tr("Shaded"));
  addSection();
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

void ViewMenus::addSection() {
  section_.setObjectName("menuSection");
  for (int axis = 0; axis < 3; ++axis)
    section_.addAction(tr("Perpendicular to %1").arg(QChar('X' + axis)), this, [this, axis] { chooseAxis(axis); });
  only_cut_ = {section_.addAction(tr("Flip side"), this, [this] {
    if (viewport_.section()) viewport_.setSection(flipped(*viewport_.section()));
  })};
  section_.addSeparator();
  only_cut_ << section_.addAction(tr("Remove the section"), this, [this] { actions_.view.section->setChecked(false); });
  connect(actions_.view.section, &QAction::toggled, this, &ViewMenus::setSection);
}

void ViewMenus::setSection(bool on) {
  if (on)
    viewport_.setSection(sectionFacing(viewport_.camera(), viewport_.scene().bounds_W()));
  else
    viewport_.setSection({});
  show();
}

void ViewMenus::chooseAxis(int axis) {
  if (!actions_.view.section->isChecked()) actions_.view.section->setChecked(true);
  viewport_.setSection(sectionAcross(axis, viewport_.camera(), viewport_.scene().bounds_W()));
  show();
}

void ViewMenus::show() {
  std::vector<ViewStripCell> cells{
      {actions_.view.perspective->isChecked() ? tr("Perspective") : tr("Orthographic"), &projection_},
      {actions_.view.edges->isChecked() ? tr("Shaded, edges") : tr("Shaded"), &faces_}};
  const auto& plane = viewport_.section();
  cells.push_back({plane ? tr("Section %1").arg(QChar('X' + axisOf(*plane))) : tr("Section off"), &section_});
  for (QAction* action : only_cut_) action->setEnabled(plane.has_value());
  viewport_.setViewStrip(std::move(cells));
}

}  // namespace hapticell::app
