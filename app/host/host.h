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
  /// Where recordings are ordered and delivered.
  virtual RecordingHub& recording() = 0;
  virtual const config::Configuration& configuration() const = 0;
  /// What the user chose for this window and what is remembered of it (layouts, keys, recent files).
  virtual UserSettings& userSettings() = 0;

  /// True while letters, digits and Space are commands rather than text: the hand is in the scene and nothing waits for
  /// text. What hears keys itself must ask.
  virtual bool typedKeysAct() const = 0;

  /// Takes a dock (see makeDock()) into an area, tabbed onto `onto` where that is given. The Window menu lists it.
  virtual void addDock(QDockWidget* dock, Qt::DockWidgetArea area, QDockWidget* onto = nullptr) = 0;
  virtual void removeDock(QDockWidget* dock) = 0;
  /// A place at the right end of the tool bar; the widget is owned by the tool bar until removed by its maker's delete.
  virtual void addToToolBar(QWidget* widget) = 0;

  /// The newest state of the cell from a running module; nothing: the document alone is shown. Cheap; call it each
  /// frame.
  virtual void setSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot) = 0;
  virtual const std::optional<manipulation::SceneSnapshot>& snapshot() const = 0;
  /// The owner of prepared scenes, for all queries, in any thread (manipulation/scene/scene_service.h). Never null.
  virtual std::shared_ptr<manipulation::SceneService> scenes() = 0;
  /// The cell as a running module has prepared it for queries; null: none does. Newer than the document it never is.
  virtual void setPreparedScene(std::shared_ptr<const manipulation::PreparedScene> scene) = 0;
  virtual std::shared_ptr<const manipulation::PreparedScene> preparedScene() const = 0;
  /// The device part of the status bar, e.g. "Phantom Desktop, simulated · forces off". Empty: no device. `works`: it
  /// has a tick, else a warning.
  virtual void setDeviceText(const QString& text, bool works) = 0;
  /// The sound part of the status bar: its words; `on` chooses the icon. Empty: no part.
  virtual void setSoundText(const QString& text, bool on) = 0;
  /// How often the window takes in the newest scene, a second.
  virtual void setGuiRate(double hertz) = 0;
  /// Begins to open a workcell in place of the present one, without a question. `opened` is called once it was read or
  /// could not be read (a message says why), unless `context` is gone by then.
  virtual void openCell(const QString& path, QObject* context, const std::function<void()>& opened) = 0;
};

}  // namespace hapticell::app
