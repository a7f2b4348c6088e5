// SPDX-License-Identifier: Apache-2.0
#include "app/studies/studies_docks.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>

#include "app/host/host.h"
#include "app/kit/action_face.h"
#include "app/kit/dock_front.h"
#include "app/kit/form.h"
#include "app/kit/top_menus.h"
#include "app/studies/floor_area.h"
#include "app/studies/result_table.h"
#include "app/studies/results_panel.h"
#include "app/studies/study_draft.h"
#include "app/studies/study_panel.h"
#include "app/studies/study_runner.h"
#include "app/studies/variant_view.h"
#include "app/style/dock_title_bar.h"
#include "app/style/icon.h"

namespace hapticell::app {

namespace {

/// What of the window is the studies'; owned by the window.
class StudiesDocks : public QObject {
 public:
  explicit StudiesDocks(Host& host)
      : QObject(&host.window()), host_(host), view_(host, table_), area_(host, draft_) {
    panel_ = new StudyPanel(host, draft_, runner_);
    results_ = new ResultsPanel(host, table_, view_);
    study_dock_ = makeDock("dockStudy", tr("Study"), scrolledPanel(panel_, 332));
    study_dock_->setWindowIcon(icon("grid"));
    host.addDock(study_dock_, Qt::RightDockWidgetArea);
    results_dock_ = makeDock("dockStudyResults", tr("Study results"), results_);
    results_->setMinimumSize(480, 150);
    host.addDock(results_dock_, Qt::BottomDockWidgetArea, host.window().findChild<QDockWidget*>("dockCollisions"));
    for (QDockWidget* dock : {study_dock_, results_dock_}) dock->hide();
    markAsTask(study_dock_);
    connect(study_dock_->toggleViewAction(), &QAction::toggled, this, [this](bool on) { area_.setShown(on); });
    // Hidden, not only behind another tab: what it draws in the scene goes with it.
    connect(results_dock_->toggleViewAction(), &QAction::toggled, this, [this](bool on) {
      if (!on) view_.hide();
      view_.setDockShown(on);
    });
    connect(&runner_, &StudyRunner::began, this,
            [this](const QString& file, const std::shared_ptr<const studies::Study>& study,
                   const std::vector<studies::ResultRow>& rows) {
              table_.begin(study->head(), file);
              view_.setStudy(study);
              table_.add(rows);
              bringToFront(results_dock_);
            });
    connect(&runner_, &StudyRunner::rowsCame, &table_, &ResultTable::add);
    connect(&runner_, &StudyRunner::merged, this, [this](const QString& file) {
      results_->openFile(file);
      bringToFront(results_dock_);
    });
    addMenu();
  }

 private:
  void addMenu() {
    QMenu* menu = topMenu(host_.window(), "menuApplications", QObject::tr("Applications"));
    const auto entry = [&](const char* name, const QString& text, const std::function<void()>& act) {
      QAction* action = makeAction(&host_.window(), {name, text, {}, {}, {}});
      host_.window().addAction(action);
      menu->addAction(action);
      connect(action, &QAction::triggered, this, act);
    };
    entry("actionStudy", tr("Study"), [this] { bringToFront(study_dock_); });
    entry("actionOpenStudy", tr("Open a study…"), [this] {
      bringToFront(study_dock_);
      panel_->open();
    });
    entry("actionStudyResults", tr("Study results"), [this] { bringToFront(results_dock_); });
    entry("actionOpenStudyResults", tr("Open results of a study…"), [this] {
      bringToFront(results_dock_);
      results_->open();
    });
  }

  Host& host_;
  StudyDraft draft_;
  StudyRunner runner_;
  ResultTable table_;
  VariantView view_;
  FloorArea area_;
  StudyPanel* panel_;
  ResultsPanel* results_;
  QDockWidget *study_dock_, *results_dock_;
};

}  // namespace

void addStudiesDocks(Host& host) {
  new StudiesDocks(host);
}

}  // namespace hapticell::app
