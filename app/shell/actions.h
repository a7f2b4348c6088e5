// SPDX-License-Identifier: Apache-2.0
#pragma once

class QAction;
class QMainWindow;
class QMenu;
class QToolBar;

namespace hapticell::app {

/// All actions of the host window, in menus and tool bar of `window`. They only exist here; who listens connects to
/// them.
struct Actions {
  explicit Actions(QMainWindow& window);
  QAction *new_cell, *open, *save, *save_as, *import_mesh, *insert_part, *insert_frame, *add_robot, *add_robot_file,
      *quit;
  QAction *export_cell, *export_selection, *reload, *pack, *mesh_care, *report_saved, *report_import, *report_other;
  QAction* go_back;  ///< Ten seconds of motion.
  QAction *undo, *redo, *remove, *duplicate, *isolate, *show_all;
  QAction *select, *move, *rotate, *snap, *move_by, *measure, *select_all;
  QAction *fit_all, *fit_selection, *front, *right, *top, *isometric, *perspective, *edges, *section, *side_docks;
  QAction *dark, *light;
  QAction *about, *settings, *help, *manual, *scene_text, *first_page, *reset_layout;
  QMenu *recent, *view, *insert, *collision, *applications, *windows, *help_menu;
  QToolBar* tool_bar;

 private:
  void makeActions(QMainWindow& window);
  void fillMenus(QMainWindow& window);
  void fillToolBar(QMainWindow& window);
};

}  // namespace hapticell::app
