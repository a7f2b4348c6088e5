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
    // Queued: the style of the buttons lays the bar out again.
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
  for (QAction* action : {view.perspective, view.edges, view.section, view.side_docks, view.dark, view.light,
                          edit.select, edit.move, edit.rotate, edit.snap})
    action->setCheckable(true);
  for (QAction* action : {view.perspective, view.edges, view.side_docks, edit.select}) action->setChecked(true);
  auto* tools = new QActionGroup(&window);
  for (QAction* action : {edit.select, edit.move, edit.rotate}) tools->addAction(action);
  auto* themes = new QActionGroup(&window);
  themes->addAction(view.dark);
  themes->addAction(view.light);
  fillMenus(window);
  fillToolBar(window);
}

void Actions::makeActions(QMainWindow& window) {
  const auto make = [&window](const ActionFace& face) {
    QAction* action = makeAction(&window, face);
    window.addAction(action);
    return action;
  };
  file.new_cell = make({"actionNew", tr("New workcell"), "new", QKeySequence::New, {}});
  file.open = make({"actionOpen", tr("Open…"), "open", QKeySequence::Open, {}});
  file.save = make({"actionSave", tr("Save"), "save", QKeySequence::Save, {}});
  file.save_as = make({"actionSaveAs", tr("Save as…"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), {}});
  file.import_mesh = make({"actionImport", tr("Import…"), "import", QKeySequence(Qt::CTRL | Qt::Key_I), tr("Import")});
  file.add_robot =
      make({"actionAddRobot", tr("Add robot…"), "robot", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I), tr("Robot")});
  file.export_cell = make({"actionExport", tr("Export cell…"), {}, QKeySequence(Qt::CTRL | Qt::Key_E), {}});
  file.export_selection =
      make({"actionExportSelection", tr("Export selection…"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E), {}});
  file.reload = make({"actionReload", tr("Reload from disk"), {}, QKeySequence(Qt::Key_F5), {}});
  edit.mesh_care = make({"actionMeshCare", tr("Mesh and collision shape…"), {}, {}, {}});
  file.pack = make({"actionPack", tr("Pack with all files…"), {}, {}, {}});
  file.report_saved = make({"actionReportSaved", tr("Compared with the saved cell…"), {}, {}, {}});
  file.report_import = make({"actionReportImport", tr("Compared with the imported files…"), {}, {}, {}});
  file.report_other = make({"actionReportOther", tr("Compared with another workcell…"), {}, {}, {}});
  edit.duplicate = make({"actionDuplicate", tr("Duplicate"), {}, QKeySequence(Qt::CTRL | Qt::Key_D), {}});
  edit.isolate = make({"actionIsolate", tr("Isolate"), {}, {}, {}});
  edit.show_all = make({"actionShowAll", tr("Show all"), {}, {}, {}});
  insert.part = make({"actionInsertPart", tr("Part…"), "cube", {}, {}});
  insert.frame = make({"actionInsertFrame", tr("Frame"), "frame", {}, {}});
  file.add_robot_file = make({"actionAddRobotFile", tr("Add robot from a file…"), {}, {}, {}});
  file.quit = make({"actionQuit", tr("Quit"), {}, QKeySequence::Quit, {}});
  edit.undo = make({"actionUndo", tr("Undo"), "undo", QKeySequence(Qt::CTRL | Qt::Key_Z), tr("Undo")});
  edit.redo = make({"actionRedo", tr("Redo"), "redo", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), tr("Redo")});
  edit.go_back = make({"actionGoBack", tr("Go back 10 seconds of motion"), "history",
                       QKeySequence(Qt::CTRL | Qt::Key_G), tr("Go back")});
  edit.remove =
      make({"actionRemove", tr("Remove from the cell"), "delete", QKeySequence(Qt::Key_Delete), tr("Remove")});
  edit.select = make({"actionSelect", tr("Select"), "select", QKeySequence(Qt::Key_Q), {}});
  edit.move = make({"actionMove", tr("Move"), "move", QKeySequence(Qt::Key_W), {}});
  edit.rotate = make({"actionRotate", tr("Rotate"), "rotate", QKeySequence(Qt::Key_E), {}});
  edit.snap = make({"actionSnap", tr("Snap to corner, edge, face, frame"), "snap", {}, tr("Snap")});
  edit.move_by = make({"actionMoveBy", tr("Move by values…"), {}, {}, {}});
  edit.measure = make({"actionMeasure", tr("Measure…"), "measure", QKeySequence(Qt::CTRL | Qt::Key_M), tr("Measure")});
  edit.select_all = make({"actionSelectAll", tr("Select all"), {}, QKeySequence::SelectAll, {}});
  view.fit_selection = make({"actionFit", tr("Fit selection"), "fit", QKeySequence(Qt::Key_F), tr("Fit")});
  view.fit_all = make({"actionFitAll", tr("Fit all"), {}, QKeySequence(Qt::SHIFT | Qt::Key_F), {}});
  view.front = make({"actionFront", tr("Front"), {}, pad(Qt::Key_1), {}});
  view.right = make({"actionRight", tr("Right"), {}, pad(Qt::Key_3), {}});
  view.top = make({"actionTop", tr("Top"), {}, pad(Qt::Key_7), {}});
  view.isometric = make({"actionIso", tr("Isometric"), "cube", pad(Qt::Key_9), tr("Iso")});
  view.perspective = make({"actionPerspective", tr("Perspective"), {}, pad(Qt::Key_5), {}});
  view.edges = make({"actionEdges", tr("Edges"), "grid", {}, {}});
  view.section = make({"actionSection", tr("Section plane"), "section", QKeySequence(Qt::Key_V), tr("Section")});
  view.side_docks = make({"actionSideDocks", tr("Side panels"), {}, QKeySequence(Qt::Key_D), {}});
  view.dark = make({"actionDark", tr("Dark"), {}, {}, {}});
  view.light = make({"actionLight", tr("Light"), {}, {}, {}});
  edit.settings = make({"actionSettings", tr("Settings…"), "settings", QKeySequence(Qt::CTRL | Qt::Key_Comma), {}});
  help.panel_help = make({"actionHelp", tr("Help on this panel"), "help", QKeySequence(Qt::Key_F1), {}});
  help.manual = make({"actionManual", tr("Manual"), {}, QKeySequence(Qt::SHIFT | Qt::Key_F1), {}});
  help.scene_text = make({"actionSceneText", tr("Scene description"), "text", QKeySequence(Qt::CTRL | Qt::Key_F1), {}});
  help.first_page = make({"actionFirstPage", tr("Start page"), "home", {}, {}});
  view.reset_layout = make({"actionResetLayout", tr("Reset layout"), "layout", {}, {}});
  help.about = make({"actionAbout", tr("About HaptiCell"), {}, {}, {}});
}

void Actions::fillMenus(QMainWindow& window) {
  QMenu* file_menu = topMenu(window, "menuFile", tr("File"));
  file_menu->addActions({file.new_cell, file.open});
  menus.recent = file_menu->addMenu(tr("Open recent"));
  menus.recent->setObjectName("menuRecent");
  file_menu->addActions({file.save, file.save_as});
  file_menu->addSeparator();
  file_menu->addActions({file.import_mesh, file.add_robot, file.add_robot_file, file.reload});
  file_menu->addSeparator();
  file_menu->addActions({file.export_cell, file.export_selection, file.pack});
  file_menu->addMenu(tr("Report changes"))->addActions({file.report_saved, file.report_import, file.report_other});
  file_menu->addSeparator();
  file_menu->addAction(file.quit);
  QMenu* edit_menu = topMenu(window, "menuEdit", tr("Edit"));
  edit_menu->addActions({edit.undo, edit.redo, edit.go_back});
  edit_menu->addSeparator();
  edit_menu->addActions({edit.select, edit.move, edit.rotate, edit.snap, edit.move_by, edit.measure});
  edit_menu->addSeparator();
  edit_menu->addActions({edit.select_all, edit.duplicate, edit.isolate, edit.show_all, edit.mesh_care, edit.remove});
  edit_menu->addSeparator();
  edit_menu->addAction(edit.settings);
  menus.view = topMenu(window, "menuView", tr("View"));
  menus.view->addActions({view.fit_selection, view.fit_all});
  menus.view->addSeparator();
  menus.view->addActions({view.front, view.right, view.top, view.isometric});
  menus.view->addSeparator();
  menus.view->addActions({view.perspective, view.edges, view.section});
  menus.view->addSeparator();
  menus.view->addActions({view.dark, view.light});
  menus.insert = topMenu(window, "menuInsert", tr("Insert"));
  menus.insert->addActions({file.import_mesh, insert.part, insert.frame, file.add_robot, file.add_robot_file});
  menus.collision = topMenu(window, "menuCollision", tr("Collision"));
  menus.collision->addAction(edit.mesh_care);
  menus.applications = topMenu(window, "menuApplications", tr("Applications"));
  menus.applications->setToolTipsVisible(true);
  menus.windows = topMenu(window, "menuWindow", tr("Window"));
  menus.windows->addActions({view.side_docks, view.reset_layout});
  menus.windows->addSeparator();
  menus.help = topMenu(window, "menuHelp", tr("Help"));
  menus.help->addActions({help.manual, help.panel_help, help.scene_text, help.first_page});
  menus.help->addSeparator();
  menus.help->addAction(help.about);
}

void Actions::fillToolBar(QMainWindow& window) {
  tool_bar = window.addToolBar(tr("Tools"));
  tool_bar->setObjectName("toolMain");
  tool_bar->setMovable(false);
  tool_bar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  tool_bar->setIconSize(QSize(20, 20));
  tool_bar->setFixedHeight(54);
  tool_bar->setFont(textFont(TextRole::kKeyCap));
  tool_bar->addActions({file.open, file.import_mesh, file.save});
  tool_bar->addSeparator();
  tool_bar->addActions({edit.undo, edit.redo});
  tool_bar->addSeparator();
  tool_bar->addActions({edit.select, edit.move, edit.rotate, edit.snap});
  tool_bar->addSeparator();
  tool_bar->addActions({edit.measure, view.section, view.fit_selection});
  tool_bar->addSeparator();
  tool_bar->addAction(edit.go_back);
  new ToolFit(*tool_bar);
}

}  // namespace hapticell::app
