// SPDX-License-Identifier: Apache-2.0
#include "app/shell/main_window.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QToolBar>
#include <algorithm>

#include "app/help/about_dialog.h"
#include "app/help/help_dock.h"
#include "app/import/file_work.h"
#include "app/kit/action_face.h"
#include "app/kit/command_finder.h"
#include "app/kit/dock_front.h"
#include "app/kit/tabbed_docks.h"
#include "app/measure/measure_dock.h"
#include "app/panels/tree/tree_edits.h"
#include "app/settings/settings_dock.h"
#include "app/shell/action_watch.h"
#include "app/shell/command_box.h"
#include "app/shell/crash_guard.h"
#include "app/shell/escape_key.h"
#include "app/shell/panels.h"
#include "app/shell/window_keys.h"
#include "app/shell/window_log.h"
#include "app/start/recent_files.h"
#include "app/start/start_page.h"
#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/theme.h"
#include "app/views/view_actions.h"
#include "manipulation/scene/scene_service.h"

namespace hapticell::app {

MainWindow::MainWindow(const config::Configuration& configuration, const QString& settings)
    : configuration_(configuration),
      settings_(settings),
      viewport_(new ViewportWidget(this)),
      status_(*this, *new StatusLine(this)),
      right_docks_(new TabbedDocks(*this)),
      start_(new StartPage(*viewport_, settings_, *new RecentFiles(settings_, this))),
      layouts_(*this, settings_),
      scenes_(std::make_shared<manipulation::SceneService>()),
      go_back_(*this),
      typed_keys_(*this) {
  setObjectName("mainWindow");
  QApplication::setWindowIcon(icon("hapticell"));
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setCentralWidget(viewport_);
  setStatusBar(&status_.line());
  actions_ = std::make_unique<Actions>(*this);
  auto* spacer = new QWidget(this);
  spacer->setObjectName("toolSpacer");
  spacer->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  actions_->tool_bar->addWidget(spacer);
  actions_->tool_bar->addWidget(layouts_.makeChoice(this));
  viewport_->setMotion(configuration_.gui.motion);
  viewport_->setEmptyState(EmptyState{
      tr("The cell is empty"), tr("Ctrl+I imports a solid, Ctrl+Shift+I adds a robot, Ctrl+O opens a workcell.")});
  connectViewActions();
  new ViewMenus(*actions_, *viewport_, this);
  connectScene();
  addPanels(*this);
  addMeasureDock(*this);
  addViewActions(*this, *actions_->menus.view);
  files_ = std::make_unique<FileWork>(*this);
  setAcceptDrops(true);
  connectFileActions();
  connectStart();
  addHelp(*this);
  addWindowKeys(*this, *viewport_);
  addEscape();
  addCorner();
  fillMenus();
  setTheme(configuration_.gui.theme != "light");
  addSettings(*this, [this](bool dark) { setTheme(dark); });
  connect(actions_->view.dark, &QAction::triggered, this, [this] { settings_.setValue("theme", "dark"); });
  connect(actions_->view.light, &QAction::triggered, this, [this] { settings_.setValue("theme", "light"); });
  documentChanged();
}

MainWindow::~MainWindow() {
  // Panels and modules use the host; they end while it is whole.
  hide();
  modules_.reset();
  crash_guard_.reset();
  files_.reset();
}

/// What is open, and the command finder, at the right end of the menu bar.
void MainWindow::addCorner() {
  auto* corner = new QWidget(this);
  auto* row = new QHBoxLayout(corner);
  row->setContentsMargins(0, 0, 8, 0);
  row->setSpacing(14);
  file_label_ = new QLabel;
  file_label_->setForegroundRole(kQuietText);
  row->addWidget(file_label_);
  row->addWidget(new CommandBox(*findChild<QAction*>("actionFindCommand")));
  corner->setMinimumHeight(28);
  menuBar()->setCornerWidget(corner, Qt::TopRightCorner);
}

void MainWindow::addEscape() {
  auto* escape = new EscapeKey(*this, *viewport_);
  escape->add([this] {
    auto* finder = findChild<CommandFinder*>();
    return finder && finder->dismiss();
  });
  escape->add([this] {
    if (!start_->isVisible()) return false;
    start_->hide();
    return true;
  });
  escape->add([this] {
    auto* help = findChild<QDockWidget*>("dockHelp");
    if (!help || !help->isAncestorOf(QApplication::focusWidget())) return false;
    help->hide();
    viewport_->setFocus();
    return true;
  });
}

/// Menus whose actions belong to several panels.
void MainWindow::fillMenus() {
  const auto add = [this](QMenu& menu, std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (auto* action = findChild<QAction*>(name)) menu.addAction(action);
  };
  add(*actions_->menus.insert, {"actionAddMannequin"});
  actions_->menus.insert->addSeparator();
  add(*actions_->menus.insert, {"actionMechanism", "actionImportMotion"});
  const auto opens = [this](const char* dock_name, const ActionFace& face) {
    QAction* action = makeAction(this, face);
    addAction(action);
    connect(action, &QAction::triggered, this, [this, dock_name] {
      if (auto* dock = findChild<QDockWidget*>(dock_name)) {
        bringToFront(dock);
      }
    });
    return action;
  };
  actions_->menus.insert->addAction(opens("dockGuides", {"actionGuides", tr("Guide…"), "guide_line", {}, {}}));
  actions_->menus.collision->insertAction(
      actions_->edit.mesh_care,
      opens("dockCollisions", {"actionCollisions", tr("Pairs, sets and log"), "contact", {}, {}}));
}

void MainWindow::connectViewActions() {
  const auto on = [this](QAction* action, auto&& slot) { connect(action, &QAction::triggered, this, slot); };
  on(actions_->edit.go_back, [this] { go_back_.start(); });
  on(actions_->view.fit_all, [this] { viewport_->fitAll(); });
  on(actions_->view.fit_selection, [this] {
    geometry::Bounds bounds;
    for (const auto id : selection_.all()) bounds.add(viewport_->scene().boundsOf_W(id));
    viewport_->fit(bounds.isEmpty() ? viewport_->scene().bounds_W() : bounds);
  });
  on(actions_->view.front, [this] { viewport_->setStandardView(StandardView::kFront); });
  on(actions_->view.right, [this] { viewport_->setStandardView(StandardView::kRight); });
  on(actions_->view.top, [this] { viewport_->setStandardView(StandardView::kTop); });
  on(actions_->view.isometric, [this] { viewport_->setStandardView(StandardView::kIsometric); });
  on(actions_->view.perspective, [this](bool checked) { viewport_->setPerspective(checked); });
  on(actions_->view.edges, [this](bool checked) { viewport_->setEdges(checked); });
  on(actions_->view.side_docks, [this](bool checked) { layouts_.showSides(checked); });
  connect(&layouts_, &Layouts::chosen, actions_->view.side_docks,
          [this] { actions_->view.side_docks->setChecked(true); });
  on(actions_->help.about, [this] { showAbout(*this); });
}

void MainWindow::setPreparedScene(std::shared_ptr<const manipulation::PreparedScene> scene) {
  scenes_->setShown(std::move(scene));
}

std::shared_ptr<const manipulation::PreparedScene> MainWindow::preparedScene() const {
  return scenes_->shown();
}

void MainWindow::connectScene() {
  connect(&document_, &DocumentModel::changed, this, &MainWindow::documentChanged);
  connect(&document_, &DocumentModel::refused, this,
          [this](const QString& sentence) { messages_.tell(Severity::kWarning, sentence); });
  // What the window itself keeps of a document; panels and modules drop theirs in the same way.
  connect(&document_, &DocumentModel::closing, this, [this] {
    keepPicture();
    hold_choice_.letGo();
    recording_.abandon();
    hold_choice_.forget();
    selection_.set(0);
    go_back_.cancel();
    actions_->view.section->setChecked(false);
    scenes_->forget();
    setSnapshot(std::nullopt);
    viewport_->forgetCell();
  });
  connect(&document_, &DocumentModel::opened, this, [this] { go_back_.forget(); });
  connect(&messages_, &MessageLog::told, &status_.line(), &StatusLine::show);
  connect(&status_.line(), &StatusLine::messageClicked, this,
          [this] { bringToFront(findChild<QDockWidget*>("dockMessages")); });
  connectSelection();
}

void MainWindow::connectSelection() {
  connect(&selection_, &Selection::allChanged, this, [this] {
    viewport_->scene().setSelected(selection_.all());
    for (QAction* action : {actions_->edit.remove, actions_->edit.duplicate, actions_->edit.isolate,
                            actions_->file.reload, actions_->file.export_selection})
      action->setEnabled(!selection_.all().empty());
    viewport_->refresh();
  });
  static constexpr auto kMore = Qt::ControlModifier | Qt::ShiftModifier;
  connect(viewport_, &ViewportWidget::picked, this, [this](workcell::EntityId entity, Qt::KeyboardModifiers held) {
    held& kMore ? selection_.toggle(entity) : selection_.set(entity);
  });
  connect(viewport_, &ViewportWidget::boxed, this,
          [this](const std::vector<workcell::EntityId>& entities, Qt::KeyboardModifiers held) {
            std::vector<workcell::EntityId> all = held & kMore ? selection_.all() : std::vector<workcell::EntityId>{};
            for (const auto id : entities)
              if (std::find(all.begin(), all.end(), id) == all.end()) all.push_back(id);
            selection_.setAll(std::move(all));
          });
  connect(actions_->edit.select_all, &QAction::triggered, this, [this] {
    std::vector<workcell::EntityId> all;
    for (const auto& entity : document_.document().state().entities)
      if (entity->visible) all.push_back(entity->id);
    selection_.setAll(std::move(all), selection_.current());
  });
  connect(actions_->edit.remove, &QAction::triggered, this, [this] {
    if (!selection_.all().empty() && removeEntities(document_, selection_.all())) selection_.set(0);
  });
  for (QAction* action : {actions_->edit.remove, actions_->edit.duplicate, actions_->edit.isolate,
                          actions_->file.reload, actions_->file.export_selection})
    action->setEnabled(false);
}

void MainWindow::documentChanged() {
  viewport_->scene().setEntities(document_.document().snapshotEntities());
  viewport_->scene().setPairSets(document_.document().state().pair_sets);
  viewport_->refresh();
  go_back_.look();
  std::vector<workcell::EntityId> left;
  for (const auto id : selection_.all())
    if (document_.document().find(id)) left.push_back(id);
  selection_.setAll(std::move(left), selection_.current());
  const workcell::Document& document = document_.document();
  const auto setStep = [](QAction* action, bool can, const QString& verb, const std::string& text) {
    action->setEnabled(can);
    action->setText(text.empty() ? verb : verb + ": " + QString::fromStdString(text));
    action->setIconText(verb);
  };
  setStep(actions_->edit.undo, document.canUndo(), tr("Undo"), document.undoText());
  setStep(actions_->edit.redo, document.canRedo(), tr("Redo"), document.redoText());
  updateTitle();
  status_.show();
}

void MainWindow::updateTitle() {
  const bool dirty = document_.isDirty();
  const bool read_only = files_ && files_->guard().isReadOnly();
  setWindowTitle(document_.title() + (read_only ? ' ' + tr("(open elsewhere)") : QString()) + (dirty ? " *" : "") +
                 " – HaptiCell");
  const bool has_file = !document_.document().path().empty();
  const QString state = dirty ? tr("changed") : tr("saved");
  file_label_->setText(document_.title() + (has_file ? QStringLiteral(".hcell") : QString()) + QStringLiteral("  ·  ") +
                       (has_file ? state : tr("not saved yet")));
  menuBar()->cornerWidget(Qt::TopRightCorner)->adjustSize();
  // Set again, the menu bar lays its corner out again.
  menuBar()->setCornerWidget(menuBar()->cornerWidget(Qt::TopRightCorner), Qt::TopRightCorner);
}

void MainWindow::addDock(QDockWidget* dock, Qt::DockWidgetArea area, QDockWidget* onto) {
  if (area == Qt::RightDockWidgetArea) {
    // All panels of the right share one place.
    for (QDockWidget* other : findChildren<QDockWidget*>())
      if (!onto && other != dock && !other->isFloating() && dockWidgetArea(other) == area) onto = other;
    right_docks_->add(dock);
  }
  // A tab's title is its title bar, wherever it stands.
  for (TabbedDocks* tabs : findChildren<TabbedDocks*>())
    if (area != Qt::RightDockWidgetArea && onto && tabs->has(onto)) tabs->add(dock);
  addDockWidget(area, dock);
  if (onto) tabifyDockWidget(onto, dock);
  actions_->menus.windows->addAction(dock->toggleViewAction());
  // Qt would show it behind the other tabs of its place.
  connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool on) {
    if (on) bringToFront(dock);
  });
}

void MainWindow::removeDock(QDockWidget* dock) {
  actions_->menus.windows->removeAction(dock->toggleViewAction());
  removeDockWidget(dock);
  for (TabbedDocks* tabs : findChildren<TabbedDocks*>()) tabs->remove(dock);
}

void MainWindow::addToToolBar(QWidget* widget) {
  actions_->tool_bar->addWidget(widget);
}

void MainWindow::setSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot) {
  const std::uint64_t before = viewport_->scene().revision();
  viewport_->scene().setSnapshot(snapshot);
  // Numbers change ten times a second; what moves, in the next frame.
  const bool numbers = status_.showNumbers(!snapshot);
  if (numbers && snapshot && snapshot->stylus.held != 0) go_back_.look();
  go_back_.snapshotCame();
  if (viewport_->scene().revision() != before)
    viewport_->refresh();
  else if (numbers)
    viewport_->refreshNumbers();
}

void MainWindow::setDeviceText(const QString& text, bool works) {
  status_.line().setDevice(text, works);
  if (log_) log_->noteDevice(text, works);
}
void MainWindow::setGuiRate(double hertz) {
  status_.setGuiRate(hertz);
}

void MainWindow::loadModules(const QStringList& folders) {
  modules_ = std::make_unique<ModuleLoader>();
  modules_->load(folders);
  for (Module* module : modules_->modules()) {
    QAction* action = makeAction(this, {"actionModule", module->name(), module->iconName(), {}, {}});
    action->setToolTip(module->purpose());
    actions_->menus.applications->addAction(action);
    connect(action, &QAction::triggered, this, [this, module] { module->start(*this); });
  }
  for (const QString& problem : modules_->problems()) messages_.tell(Severity::kWarning, problem);
  if (modules_->modules().empty()) {
    QAction* none = actions_->menus.applications->addAction(tr("No application was found in the program folder"));
    none->setEnabled(false);
  }
}

RecentFiles& MainWindow::recentFiles() {
  return start_->recentFiles();
}

void MainWindow::restoreLayout() {
  if (!layouts_.restore()) layouts_.reset();
}

bool MainWindow::startModule(const QString& name) {
  if (!modules_) return false;
  for (Module* module : modules_->modules()) {
    if (module->name() != name) continue;
    module->start(*this);
    return true;
  }
  return false;
}

void MainWindow::setTheme(bool dark) {
  const Theme& theme = dark ? darkTheme() : lightTheme();
  (dark ? actions_->view.dark : actions_->view.light)->setChecked(true);
  QApplication::setPalette(paletteOf(theme));
  update();
}

QPixmap MainWindow::picture() {
  const QImage scene = viewport_->finishedPicture();
  QPixmap whole = grab();
  QPainter painter(&whole);
  painter.drawImage(viewport_->mapTo(this, QPoint(0, 0)), scene);
  return whole;
}

}  // namespace hapticell::app
