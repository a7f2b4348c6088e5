// SPDX-License-Identifier: Apache-2.0
#include "app/panels/cell/entity_menu.h"

#include <QAction>
#include <QDockWidget>
#include <algorithm>
#include <utility>

#include "app/controls/color_choice.h"
#include "app/controls/entity_icon.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/action_face.h"
#include "app/kit/dock_front.h"
#include "app/kit/swatch_row.h"
#include "app/kit/top_menus.h"
#include "app/panels/collisions/collisions_panel.h"
#include "app/style/icon.h"
#include "app/style/style_painting.h"
#include "app/viewport/widget/viewport_widget.h"
#include "geometry/shapes/bounds.h"

namespace hapticell::app {
namespace {

using workcell::Entity;

/// "Folder", "Folder 2" ...: one that is not there.
QString freeFolderName(const DocumentModel& document) {
  const auto& entities = document.document().state().entities;
  const auto isUsed = [&](const QString& name) {
    return std::any_of(entities.begin(), entities.end(), [text = name.toStdString()](const auto& entity) {
      return entity->name == text || entity->parent == text;
    });
  };
  QString name = QObject::tr("Folder");
  for (int number = 2; isUsed(name); ++number) name = QObject::tr("Folder %1").arg(number);
  return name;
}

/// Actions of the window by their names; those that are not there are left out.
void addNamed(QMenu& menu, Host& host, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (auto* action = host.window().findChild<QAction*>(name)) menu.addAction(action);
}

/// Makes the entries of one menu.
class EntityMenu {
 public:
  EntityMenu(QMenu& menu, Host& host, Entities ids)
      : menu_(menu), host_(host), document_(host.documentModel()), ids_(std::move(ids)) {
    first_ = ids_.empty() ? nullptr : document_.document().find(ids_.front());
  }

  void addLooking() {
    add("treeFit", QObject::tr("Fit"), "fit", [&host = host_, ids = ids_] {
      geometry::Bounds bounds;
      for (const auto id : ids) bounds.add(host.viewport().scene().boundsOf_W(id));
      if (!bounds.isEmpty()) host.viewport().fit(bounds);
    });
    const bool shown = !first_ || first_->visible;
    add("treeShow", shown ? QObject::tr("Hide") : QObject::tr("Show"), shown ? "eye_closed" : "eye",
        [&document = document_, ids = ids_, shown] { showEntities(document, ids, !shown); });
    add("treeIsolate", QObject::tr("Isolate"), "select",
        [&document = document_, ids = ids_] { isolateEntities(document, ids); });
    add("treeShowAll", QObject::tr("Show all"), "eye", [&document = document_] {
      showAll(document);
    })->setEnabled(true);
  }

  void addProperties() {
    const bool locked = first_ && first_->locked, checked = first_ && first_->checked;
    add("treeLock", locked ? QObject::tr("Unlock") : QObject::tr("Lock"), locked ? "unlock" : "lock",
        [&document = document_, ids = ids_, locked] { lockEntities(document, ids, !locked); });
    if (first_ && first_->kind() == workcell::EntityKind::kFrame) return;  // It is neither checked nor coloured.
    QAction* check = add("treeCheck", QObject::tr("Checked for collision"), {},
                         [&document = document_, ids = ids_, checked] { checkEntities(document, ids, !checked); });
    check->setCheckable(true);
    check->setChecked(checked);
    QMenu* colors = menu_.addMenu(QObject::tr("Colour"));
    colors->setEnabled(!ids_.empty());
    for (const QColor& color : quietColors()) {
      QPixmap swatch(16, 16);
      swatch.fill(color);
      colors->addAction(QIcon(swatch), color.name().toUpper(), &menu_, [&document = document_, ids = ids_, color] {
        colorEntities(document, ids, channelsOf(color));
      });
    }
    QAction* other = colors->addAction(QObject::tr("Another colour…"), &menu_, [&host = host_, ids = ids_] {
      const workcell::Entity* first = host.documentModel().document().find(ids.front());
      if (!first) return;
      choosePartColor(host, QColor::fromRgbF(first->color[0], first->color[1], first->color[2]),
                      [&host, ids](const QColor& color) {
                        colorEntities(host.documentModel(), ids, channelsOf(color));
                      });
    });
    other->setObjectName("treeOtherColor");
  }

  /// A part hangs on another, or on a robot's tip, and goes with it.
  void addAttaching() {
    QMenu* carriers = menu_.addMenu(QObject::tr("Attach to"));
    carriers->setObjectName("treeAttach");
    for (const auto& entity : document_.document().state().entities) {
      const bool meant = std::find(ids_.begin(), ids_.end(), entity->id) != ids_.end();
      if (meant || entity->kind() == workcell::EntityKind::kAssembly || entity->figure()) continue;
      const auto to = entity->id;
      carriers->addAction(icon(entityIcon(*entity)), QString::fromStdString(entity->name), &menu_,
                          [&document = document_, ids = ids_, to] { attachEntities(document, ids, to); });
    }
    carriers->setEnabled(first_ && !first_->figure() && !carriers->isEmpty());
    add("treeDetach", QObject::tr("Detach"), {}, [&document = document_, ids = ids_] {
      detachEntities(document, ids);
    })->setEnabled(first_ && !first_->attachment.to.empty());
  }

  void addEditing(const std::function<void()>& rename) {
    if (rename) add("treeRename", QObject::tr("Rename"), {}, rename);
    addNamed(menu_, host_, {"actionCopy"});
    add("treeDuplicate", QObject::tr("Duplicate"), "plus", [&host = host_, ids = ids_] {
      const auto copies = duplicateEntities(host.documentModel(), ids);
      if (!copies.empty()) host.selection().set(copies.front());
    });
    add("treeGroup", QObject::tr("Move to a new folder"), "folder",
        [&document = document_, ids = ids_] { moveBelow(document, ids, freeFolderName(document)); });
    add("treeRemove", QObject::tr("Remove from the cell"), "delete",
        [&document = document_, ids = ids_] { removeEntities(document, ids); });
  }

  void addPanels() {
    add("treeProperties", QObject::tr("Properties"), {}, [&window = host_.window()] {
      auto* dock = window.findChild<QDockWidget*>("dockProperties");
      if (!dock) return;
      bringToFront(dock);
    });
    if (first_ && (first_->mesh() || first_->robot()))
      add("treePairs", QObject::tr("Pairs and sets"), "contact", [&host = host_, id = first_->id] {
        auto* dock = host.window().findChild<QDockWidget*>("dockCollisions");
        if (!dock) return;
        host.selection().set(id);
        bringToFront(dock);
        if (auto* panel = dock->findChild<CollisionsPanel*>()) panel->showPairs();
      });
    if (first_ && first_->figure())
      addNamed(menu_, host_, {"actionMannequinPanel"});
    else if (first_ && first_->robot())
      addNamed(menu_, host_, {"actionRobotPanel", "actionTools"});
    addNamed(menu_, host_, {"actionReload", "actionMeshCare", "actionExportSelection"});
  }

 private:
  template <class Act>
  QAction* add(const char* name, const QString& text, const QString& icon_name, Act&& act) {
    QAction* action =
        menu_.addAction(icon_name.isEmpty() ? QIcon() : icon(icon_name), text, &menu_, std::forward<Act>(act));
    action->setObjectName(QString::fromLatin1(name));
    action->setEnabled(first_);
    return action;
  }

  QMenu& menu_;
  Host& host_;
  DocumentModel& document_;
  Entities ids_;
  const Entity* first_;
};

/// What was copied, for all windows of the program: entities are values, their meshes are shared.
std::vector<Entity>& copied() {
  static std::vector<Entity> entities;
  return entities;
}

void paste(Host& host, const std::optional<dvec3>& p_W) {
  const Entities pasted = pasteEntities(host.documentModel(), copied(), p_W);
  if (!pasted.empty()) host.selection().set(pasted.front());
}

}  // namespace

void fillEntityMenu(QMenu& menu, Host& host, const Entities& ids, const std::function<void()>& rename) {
  EntityMenu made(menu, host, ids);
  made.addLooking();
  menu.addSeparator();
  made.addProperties();
  made.addAttaching();
  menu.addSeparator();
  made.addEditing(rename);
  menu.addSeparator();
  made.addPanels();
}

void fillFloorMenu(QMenu& menu, Host& host, const dvec3& p_W) {
  QMenu* insert = menu.addMenu(QObject::tr("Insert"));
  insert->setObjectName("floorInsert");
  addNamed(*insert, host,
           {"actionImport", "actionInsertPart", "actionInsertFrame", "actionAddRobot", "actionAddRobotFile",
            "actionAddMannequin", "actionGuides"});
  QAction* here = menu.addAction(icon("import"), QObject::tr("Paste here"), &menu, [&host, p_W] { paste(host, p_W); });
  here->setObjectName("floorPaste");
  here->setEnabled(!copied().empty());
  menu.addSeparator();
  addNamed(menu, host, {"actionSelectAll", "actionShowAll", "actionFitAll"});
  QMenu* views = menu.addMenu(QObject::tr("View"));
  views->setObjectName("floorViews");
  addNamed(*views, host,
           {"actionFront", "actionBack", "actionLeft", "actionRight", "actionTop", "actionBottom", "actionIso",
            "actionPerspective", "actionEdges", "actionSection"});
}

void addCopyAndPaste(Host& host) {
  const auto add = [&host](const ActionFace& face, auto&& act) {
    QAction* action = makeAction(&host.window(), face);
    host.window().addAction(action);
    QObject::connect(action, &QAction::triggered, &host.window(), act);
    return action;
  };
  QAction* copy = add({"actionCopy", QObject::tr("Copy"), "copy", QKeySequence::Copy, {}}, [&host] {
    auto chosen = copiesOf(host.documentModel().document().state(), host.selection().all());
    if (!chosen.empty()) copied() = std::move(chosen);
  });
  QAction* insert =
      add({"actionPaste", QObject::tr("Paste"), {}, QKeySequence::Paste, {}}, [&host] { paste(host, std::nullopt); });
  QMenu* edit = topMenu(host.window(), "menuEdit", QObject::tr("Edit"));
  QAction* before = host.window().findChild<QAction*>("actionDuplicate");
  edit->insertActions(before, {copy, insert});
}

}  // namespace hapticell::app
