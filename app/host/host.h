// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMainWindow>
#include <QString>
#include <functional>
#include <memory>
#include <optional>

#include "config/configuration.h"
#include "manipulation/engine/scene_snapshot.h"

class QAction;
class QDockWidget;
class QMenu;

namespace hapticell::manipulation {
class PreparedScene;
class SceneService;
}

namespace hapticell::app {

class DocumentModel;
class HoldChoice;
class MessageLog;
class RecordingHub;
class Selection;
class UserSettings;
class ViewportWidget;

/// What the window offers to panels and to modules. Everything here belongs to the GUI thread.
class Host {
 public:
  virtual ~Host() = default;
  virtual QMainWindow& window() = 0;
  virtual ViewportWidget& viewport() = 0;
  virtual DocumentModel& documentModel() = 0;
  virtual Selection& selection() = 0;
  /// What of an entity the hand takes.
  virtual HoldChoice& holdChoice() = 0;
  virtual MessageLog& messages() = 0;
  /// Orders recordings and delivers them.
  virtual RecordingHub& recording() = 0;
  virtual const config::Configuration& configuration() const = 0;
  /// The user's settings for this window, and what is remembered (layouts, keys, recent files).
  virtual UserSettings& userSettings() = 0;

  /// True while letters, digits and Space are commands, not text: the pointer or a part held by the stylus is in the
  /// scene, and no field waits for text. Everything that reads keys itself must check this.
  virtual bool typedKeysAct() const = 0;

  /// Adds a dock (see makeDock()) to an area, as a tab next to `onto` if given. The Window menu lists it.
  virtual void addDock(QDockWidget* dock, Qt::DockWidgetArea area, QDockWidget* onto = nullptr) = 0;
  virtual void removeDock(QDockWidget* dock) = 0;
  /// Adds a widget at the right end of the tool bar. The tool bar owns it; its maker removes it by deleting it.
  virtual void addToToolBar(QWidget* widget) = 0;

  /// Sets the newest state of the cell from a running module; empty: only the document is shown. Cheap; call it each
  /// frame.
  virtual void setSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot) = 0;
  virtual const std::optional<manipulation::SceneSnapshot>& snapshot() const = 0;
  /// The owner of prepared scenes, for all queries in any thread (manipulation/scene/scene_service.h). Never null.
  virtual std::shared_ptr<manipulation::SceneService> scenes() = 0;
  /// Sets the cell as a running module has prepared it for queries; null: no module has. Never newer than the document.
  virtual void setPreparedScene(std::shared_ptr<const manipulation::PreparedScene> scene) = 0;
  virtual std::shared_ptr<const manipulation::PreparedScene> preparedScene() const = 0;
  /// Sets the device part of the status bar, e.g. "Phantom Desktop, simulated · forces off". Empty: no device. `works`:
  /// shows a tick, else a warning.
  virtual void setDeviceText(const QString& text, bool works) = 0;
  /// Sets the text of the sound part in the status bar; `on` chooses the icon. Empty: no such part.
  virtual void setSoundText(const QString& text, bool on) = 0;
  /// Sets how many times a second the window takes the newest scene.
  virtual void setGuiRate(double hertz) = 0;
  /// Starts to open a workcell in place of the present one, without a question. Calls `opened` when it was read or
  /// could not be read (a message says why), unless `context` no longer exists.
  virtual void openCell(const QString& path, QObject* context, const std::function<void()>& opened) = 0;
};

}  // namespace hapticell::app
