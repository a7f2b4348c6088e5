// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QMainWindow>
#include <functional>
#include <memory>
#include <string>

#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/recording_hub.h"
#include "app/host/selection.h"
#include "app/host/user_settings.h"
#include "app/shell/action_trail.h"
#include "app/shell/actions.h"
#include "app/shell/go_back.h"
#include "app/shell/layouts.h"
#include "app/shell/module_loader.h"
#include "app/shell/status_line.h"
#include "app/shell/status_text.h"
#include "app/shell/typed_keys.h"
#include "app/shell/view_menus.h"
#include "app/viewport/widget/viewport_widget.h"
#include "config/log_level.h"
#include "workcell/files/autosave.h"

namespace hapticell::app {

class ActionWatch;
class CrashGuard;
class FileWork;
class RecentFiles;
class StartPage;
class TabbedDocks;
class WindowLog;

/// The host window: scene in the middle, docks around it, modules from the Applications menu. It has no code for
/// devices or forces, and works without any module.
class MainWindow : public QMainWindow, public Host {
  Q_OBJECT
 public:
  /// `settings` is the file with the user's choices; empty: they are not kept.
  explicit MainWindow(const config::Configuration& configuration, const QString& settings = {});
  ~MainWindow() override;

  QMainWindow& window() override { return *this; }
  ViewportWidget& viewport() override { return *viewport_; }
  DocumentModel& documentModel() override { return document_; }
  Selection& selection() override { return selection_; }
  HoldChoice& holdChoice() override { return hold_choice_; }
  MessageLog& messages() override { return messages_; }
  RecordingHub& recording() override { return recording_; }
  const config::Configuration& configuration() const override { return configuration_; }
  UserSettings& userSettings() override { return settings_; }
  bool typedKeysAct() const override { return typed_keys_.act(); }
  void addDock(QDockWidget* dock, Qt::DockWidgetArea area, QDockWidget* onto) override;
  void removeDock(QDockWidget* dock) override;
  void addToToolBar(QWidget* widget) override;
  void setSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot) override;
  const std::optional<manipulation::SceneSnapshot>& snapshot() const override { return viewport_->scene().snapshot(); }
  std::shared_ptr<manipulation::SceneService> scenes() override { return scenes_; }
  void setPreparedScene(std::shared_ptr<const manipulation::PreparedScene> scene) override;
  std::shared_ptr<const manipulation::PreparedScene> preparedScene() const override;
  void setDeviceText(const QString& text, bool works) override;
  void setSoundText(const QString& text, bool on) override { status_.line().setSound(text, on); }
  void setGuiRate(double hertz) override;
  void openCell(const QString& path, QObject* context, const std::function<void()>& opened) override;

  /// Starts to open a workcell; files().opened() reports when it is open. The messages show problems.
  void openFile(const QString& path);
  /// Starts to import files, each one undo step; `ask`: after showing what they are. files().imported() reports the
  /// result.
  void importFiles(const QStringList& paths, bool ask = true);
  FileWork& files() { return *files_; }
  void loadModules(const QStringList& folders);
  /// Shows the page with samples and recent files, over the scene.
  void showStartPage();
  RecentFiles& recentFiles();
  /// Starts the module of that name; false if it does not exist.
  bool startModule(const QString& name);
  void setTheme(bool dark);
  Actions& actions() { return *actions_; }
  Layouts& layouts() { return layouts_; }
  /// Restores window and docks as they were left; call it at start, when the modules' docks exist.
  void restoreLayout();
  const StatusLine& statusLine() const { return status_.line(); }
  /// Ends the program without a question, as at a system shutdown: adds a running recording to the cell, keeps unsaved
  /// changes as after a crash (offered at the next start), and ends modules with their server.
  void endNow();
  /// From now on, keeps unsaved changes up to the last edit if the program crashes (CrashGuard), notes the cause for
  /// the next start, and writes a report file. Says once where the report of an earlier crash is. `program`: version,
  /// commit, compiler and libraries, in lines. For the program itself; once.
  void guardAgainstCrash(const std::string& program);
  /// From now on, writes the log file of the window; shows a message if it cannot. For the program itself; once.
  void keepLog(config::LogLevel level, const std::string& program);
  /// The whole window with the finished picture of the scene.
  QPixmap picture();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void connectFileActions();
  void addCorner();
  void addEscape();
  void fillMenus();
  void connectViewActions();
  void connectScene();
  void openFromDialog();
  void importFromDialog();
  void addRobotFromDialog();
  bool saveDocument(bool ask_where);
  /// Empty: the user cancelled.
  QString placeToSave(bool ask_where);
  bool mayDiscard();
  /// Calls `then` once a running recording is in the cell and the user has agreed to lose unsaved changes.
  void replaceDocument(const std::function<void()>& then);
  /// Calls `then` once a running recording, if any, is in the cell.
  void whenRecorded(const std::function<void()>& then);
  void showSavedView();
  void connectSelection();
  void connectStart();
  void connectLeftWork();
  /// Stores a picture of the cell, for the start page.
  void keepPicture();
  void watchActions();
  void reportImport(const std::filesystem::path& folder);
  bool mayDiscardCopy(const workcell::LeftWork& left);
  void documentChanged();
  void updateTitle();

  config::Configuration configuration_;
  UserSettings settings_;
  DocumentModel document_;
  Selection selection_;
  HoldChoice hold_choice_;
  MessageLog messages_;
  RecordingHub recording_;
  ViewportWidget* viewport_;
  StatusText status_;
  TabbedDocks* right_docks_;
  StartPage* start_;
  QLabel* file_label_;
  std::unique_ptr<Actions> actions_;
  Layouts layouts_;
  std::unique_ptr<ModuleLoader> modules_;
  std::unique_ptr<FileWork> files_;
  ActionTrail trail_;
  std::unique_ptr<CrashGuard> crash_guard_;
  std::unique_ptr<ActionWatch> action_watch_;
  std::unique_ptr<WindowLog> log_;
  const std::shared_ptr<manipulation::SceneService> scenes_;  ///< Shared with threads of queries.
  GoBack go_back_;
  TypedKeys typed_keys_;
};

}  // namespace hapticell::app
