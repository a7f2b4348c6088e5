// SPDX-License-Identifier: Apache-2.0
#pragma once

class QAction;
class QMainWindow;
class QMenu;
class QToolBar;

namespace hapticell::app {

/// Actions of the menu File.
struct FileActions {
  QAction *new_cell, *open, *save, *save_as, *import_mesh, *add_robot, *add_robot_file, *reload, *quit;
  QAction *export_cell, *export_selection, *pack, *report_saved, *report_import, *report_other;
};

/// Actions of the menu Edit.
struct EditActions {
  QAction *undo, *redo;
  QAction* go_back;  ///< Ten seconds of motion.
  QAction *remove, *duplicate, *isolate, *show_all, *select_all, *mesh_care;
  QAction *select, *move, *rotate, *snap, *move_by, *measure;
  QAction* settings;
};

/// Actions of the menu Insert, except those of files.
struct InsertActions {
  QAction *part, *frame;
};

/// How the scene and the window are seen.
struct ViewSettingActions {
  QAction *fit_all, *fit_selection, *front, *right, *top, *isometric, *perspective, *edges, *section;
  QAction *dark, *light, *side_docks, *reset_layout;
};

/// Actions of the menu Help.
struct HelpActions {
  QAction *about, *panel_help, *manual, *scene_text, *first_page;
};

/// Menus to which other classes add.
struct WindowMenus {
  QMenu *recent, *view, *insert, *collision, *applications, *windows, *help;
};

/// All actions of the host window, in menus and tool bar of `window`. This only defines them; classes that react to
/// them connect to them.
struct Actions {
  explicit Actions(QMainWindow& window);
  FileActions file;
  EditActions edit;
  InsertActions insert;
  ViewSettingActions view;
  HelpActions help;
  WindowMenus menus;
  QToolBar* tool_bar;

 private:
  void makeActions(QMainWindow& window);
  void fillMenus(QMainWindow& window);
  void fillToolBar(QMainWindow& window);
};

}  // namespace hapticell::app
