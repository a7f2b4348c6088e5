// SPDX-License-Identifier: Apache-2.0
#include "app/shell/actions.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QMenu>
#include <QTimer>
#include <QToolBar>

#include "app/kit/action_face.h"
#include "app/kit/top_menus.h"
#include "app/style/fonts.h"
#include "app/style/icon.h"

namespace hapticell::app {
namespace {

QKeySequence pad(Qt::Key key) {
  return QKeySequence(QKeyCombination(Qt::KeypadModifier, key));
}

QString tr(const char* text) {
  return QObject::tr(text);
}

/// A tool bar whose words go before any of its tools does: icons alone where there is no room for the words too.
class ToolFit final : public QObject {
 public:
  explicit ToolFit(QToolBar& bar) : QObject(&bar), bar_(bar) { bar_.installEventFilter(this); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    // Queued: the style of the buttons lays the bar out anew.
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)
      QTimer::singleShot(0, this, [this] { fit(); });
    return QObject::eventFilter(watched, event);
  }

 private:
  void fit() {
    const int needed = bar_.layout()->sizeHint().width();
    if (bar_.toolButtonStyle() == Qt::ToolButtonTextUnderIcon) {
      if (needed <= bar_.width()) return;
      bar_.setToolButtonStyle(Qt::ToolButtonIconOnly);
      words_ = needed - bar_.layout()->sizeHint().width();
    } else if (needed + words_ <= bar_.width()) {
      bar_.setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    }
  }

  QToolBar& bar_;
  int words_ = 0;  ///< Pixels that the words took when they went.
};

}  // namespace

Actions::Actions(QMainWindow& window) {
  makeActions(window);
  for (QAction* action : {perspective, edges, section, side_docks, dark, light, select, move, rotate, snap})
    action->setCheckable(true);
  for (QAction* action : {perspective, edges, side_docks, select}) action->setChecked(true);
  auto* tools = new QActionGroup(&window);
  for (QAction* action : {select, move, rotate}) tools->addAction(action);
  auto* themes = new QActionGroup(&window);
  themes->addAction(dark);
  themes->addAction(light);
  fillMenus(window);
  fillToolBar(window);
}

void Actions::makeActions(QMainWindow& window) {
  const auto make = [&window](const ActionFace& face) {
    QAction* action = makeAction(&window, face);
    window.addAction(action);
    return action;
  };
  new_cell = make({"actionNew", tr("New workcell"), "new", QKeySequence::New, {}});
  open = make({"actionOpen", tr("Open…"), "open", QKeySequence::Open, {}});
  save = make({"actionSave", tr("Save"), "save", QKeySequence::Save, {}});
  save_as = make({"actionSaveAs", tr("Save as…"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), {}});
  import_mesh = make({"actionImport", tr("Import…"), "import", QKeySequence(Qt::CTRL | Qt::Key_I), tr("Import")});
  add_robot =
      make({"actionAddRobot", tr("Add robot…"), "robot", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I), tr("Robot")});
  export_cell = make({"actionExport", tr("Export cell…"), {}, QKeySequence(Qt::CTRL | Qt::Key_E), {}});
  export_selection =
      make({"actionExportSelection", tr("Export selection…"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E), {}});
  reload = make({"actionReload", tr("Read again from disk"), {}, QKeySequence(Qt::Key_F5), {}});
  mesh_care = make({"actionMeshCare", tr("Mesh and collision shape…"), {}, {}, {}});
  pack = make({"actionPack", tr("Pack with all files…"), {}, {}, {}});
  report_saved = make({"actionReportSaved", tr("Against the saved cell…"), {}, {}, {}});
  report_import = make({"actionReportImport", tr("Against the imported files…"), {}, {}, {}});
  report_other = make({"actionReportOther", tr("Against another workcell…"), {}, {}, {}});
  duplicate = make({"actionDuplicate", tr("Duplicate"), {}, QKeySequence(Qt::CTRL | Qt::Key_D), {}});
  isolate = make({"actionIsolate", tr("Isolate"), {}, {}, {}});
  show_all = make({"actionShowAll", tr("Show all"), {}, {}, {}});
  insert_part = make({"actionInsertPart", tr("Part…"), "cube", {}, {}});
  insert_frame = make({"actionInsertFrame", tr("Frame"), "frame", {}, {}});
  add_robot_file = make({"actionAddRobotFile", tr("Add robot from a file…"), {}, {}, {}});
  quit = make({"actionQuit", tr("Quit"), {}, QKeySequence::Quit, {}});
  undo = make({"actionUndo", tr("Undo"), "undo", QKeySequence(Qt::CTRL | Qt::Key_Z), tr("Undo")});
  redo = make({"actionRedo", tr("Redo"), "redo", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), tr("Redo")});
  go_back = make({"actionGoBack", tr("Go back ten seconds of motion"), "history", QKeySequence(Qt::CTRL | Qt::Key_G),
                  tr("Go back")});
  remove = make({"actionRemove", tr("Remove from the cell"), "delete", QKeySequence(Qt::Key_Delete), tr("Remove")});
  select = make({"actionSelect", tr("Select"), "select", QKeySequence(Qt::Key_Q), {}});
  move = make({"actionMove", tr("Move"), "move", QKeySequence(Qt::Key_W), {}});
  rotate = make({"actionRotate", tr("Rotate"), "rotate", QKeySequence(Qt::Key_E), {}});
  snap = make({"actionSnap", tr("Snap to corner, edge, face, frame"), "snap", {}, tr("Snap")});
  move_by = make({"actionMoveBy", tr("Move by numbers…"), {}, {}, {}});
  measure = make({"actionMeasure", tr("Measure…"), "measure", QKeySequence(Qt::CTRL | Qt::Key_M), tr("Measure")});
  select_all = make({"actionSelectAll", tr("Select all"), {}, QKeySequence::SelectAll, {}});
  fit_selection = make({"actionFit", tr("Fit selection"), "fit", QKeySequence(Qt::Key_F), tr("Fit")});
  fit_all = make({"actionFitAll", tr("Fit all"), {}, QKeySequence(Qt::SHIFT | Qt::Key_F), {}});
  front = make({"actionFront", tr("Front"), {}, pad(Qt::Key_1), {}});
  right = make({"actionRight", tr("Right"), {}, pad(Qt::Key_3), {}});
  top = make({"actionTop", tr("Top"), {}, pad(Qt::Key_7), {}});
  isometric = make({"actionIso", tr("Isometric"), "cube", pad(Qt::Key_9), tr("Iso")});
  perspective = make({"actionPerspective", tr("Perspective"), {}, pad(Qt::Key_5), {}});
  edges = make({"actionEdges", tr("Edges"), "grid", {}, {}});
  section = make({"actionSection", tr("Section plane"), "section", QKeySequence(Qt::Key_V), tr("Section")});
  side_docks = make({"actionSideDocks", tr("Side panels"), {}, QKeySequence(Qt::Key_D), {}});
  dark = make({"actionDark", tr("Dark"), {}, {}, {}});
  light = make({"actionLight", tr("Light"), {}, {}, {}});
  settings = make({"actionSettings", tr("Settings…"), "settings", QKeySequence(Qt::CTRL | Qt::Key_Comma), {}});
  help = make({"actionHelp", tr("Help on this panel"), "help", QKeySequence(Qt::Key_F1), {}});
  manual = make({"actionManual", tr("Manual"), {}, QKeySequence(Qt::SHIFT | Qt::Key_F1), {}});
  scene_text = make({"actionSceneText", tr("The scene in words"), "text", QKeySequence(Qt::CTRL | Qt::Key_F1), {}});
  first_page = make({"actionFirstPage", tr("First page"), "home", {}, {}});
  reset_layout = make({"actionResetLayout", tr("Layout as drawn"), "layout", {}, {}});
  about = make({"actionAbout", tr("About HaptiCell"), {}, {}, {}});
}

void Actions::fillMenus(QMainWindow& window) {
  QMenu* file = topMenu(window, "menuFile", tr("File"));
  file->addActions({new_cell, open});
  recent = file->addMenu(tr("Open recent"));
  recent->setObjectName("menuRecent");
  file->addActions({save, save_as});
  file->addSeparator();
  file->addActions({import_mesh, add_robot, add_robot_file, reload});
  file->addSeparator();
  file->addActions({export_cell, export_selection, pack});
  file->addMenu(tr("Report changes"))->addActions({report_saved, report_import, report_other});
  file->addSeparator();
  file->addAction(quit);
  QMenu* edit = topMenu(window, "menuEdit", tr("Edit"));
  edit->addActions({undo, redo, go_back});
  edit->addSeparator();
  edit->addActions({select, move, rotate, snap, move_by, measure});
  edit->addSeparator();
  edit->addActions({select_all, duplicate, isolate, show_all, mesh_care, remove});
  edit->addSeparator();
  edit->addAction(settings);
  view = topMenu(window, "menuView", tr("View"));
  view->addActions({fit_selection, fit_all});
  view->addSeparator();
  view->addActions({front, right, top, isometric});
  view->addSeparator();
  view->addActions({perspective, edges, section});
  view->addSeparator();
  view->addActions({dark, light});
  insert = topMenu(window, "menuInsert", tr("Insert"));
  insert->addActions({import_mesh, insert_part, insert_frame, add_robot, add_robot_file});
  collision = topMenu(window, "menuCollision", tr("Collision"));
  collision->addAction(mesh_care);
  applications = topMenu(window, "menuApplications", tr("Applications"));
  applications->setToolTipsVisible(true);
  windows = topMenu(window, "menuWindow", tr("Window"));
  windows->addActions({side_docks, reset_layout});
  windows->addSeparator();
  help_menu = topMenu(window, "menuHelp", tr("Help"));
  help_menu->addActions({manual, help, scene_text, first_page});
  help_menu->addSeparator();
  help_menu->addAction(about);
}

void Actions::fillToolBar(QMainWindow& window) {
  tool_bar = window.addToolBar(tr("Tools"));
  tool_bar->setObjectName("toolMain");
  tool_bar->setMovable(false);
  tool_bar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  tool_bar->setIconSize(QSize(20, 20));
  tool_bar->setFixedHeight(54);
  tool_bar->setFont(textFont(TextRole::kKeyCap));
  tool_bar->addActions({open, import_mesh, save});
  tool_bar->addSeparator();
  tool_bar->addActions({undo, redo});
  tool_bar->addSeparator();
  tool_bar->addActions({select, move, rotate, snap});
  tool_bar->addSeparator();
  tool_bar->addActions({measure, section, fit_selection});
  tool_bar->addSeparator();
  tool_bar->addAction(go_back);
  new ToolFit(*tool_bar);
}

}  // namespace hapticell::app
