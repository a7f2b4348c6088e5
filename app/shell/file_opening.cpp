// SPDX-License-Identifier: Apache-2.0
#include "app/shell/file_opening.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QTimer>

#include "app/kit/dock_front.h"
#include "app/shell/main_window.h"
#include "app/studies/results_panel.h"
#include "app/studies/study_panel.h"
#include "app/trajectory/motions/motion_export.h"
#include "app/trajectory/training/training_panel.h"

namespace hapticell::app {

namespace {

QString endingOf(const QString& path) {
  return QFileInfo(path).suffix().toLower();
}

void show(MainWindow& window, const char* dock) {
  auto* const found = window.findChild<QDockWidget*>(dock);
  if (found == nullptr) return;
  bringToFront(found);
}

/// The study with its cell, where that is not open already and nothing would be lost.
void openStudy(MainWindow& window, StudyPanel& panel, const QString& path) {
  panel.openFile(path);
  const QString cell = panel.cell();
  const workcell::Document& document = window.documentModel().document();
  if (cell.isEmpty() || QFileInfo(cell) == QFileInfo(QString::fromStdString(document.path().string())))
    return show(window, "dockStudy");
  if (window.documentModel().isDirty()) {
    window.messages().tell(Severity::kInformation, QObject::tr("The study is open, its workcell is not"),
                           QObject::tr("Save this workcell, then open %1.").arg(QFileInfo(cell).fileName()));
    return show(window, "dockStudy");
  }
  // What a cell brings to the front when it is opened comes first.
  window.openCell(cell, &panel,
                  [&window, &panel] { QTimer::singleShot(0, &panel, [&window] { show(window, "dockStudy"); }); });
}

}  // namespace

bool isOwnFile(const QString& path) {
  const QString ending = endingOf(path);
  return ending == "htraj" || ending == "mcap" || ending == "hexercise" || ending == "htrain" || ending == "hstudy" ||
         ending == "hresults";
}

void openAny(MainWindow& window, const QString& path) {
  const QString ending = endingOf(path);
  auto* const motions = window.findChild<MotionExport*>();
  auto* const training = window.findChild<TrainingPanel*>();
  auto* const study = window.findChild<StudyPanel*>();
  auto* const results = window.findChild<ResultsPanel*>();
  if (ending == "hcell") {
    window.openFile(path);
  } else if ((ending == "htraj" || ending == "mcap") && motions != nullptr) {
    motions->importFrom({path}, {});
  } else if (ending == "hexercise" && training != nullptr) {
    training->openExercise(path);
  } else if (ending == "htrain" && training != nullptr) {
    training->openResults(path);
  } else if (ending == "hstudy" && study != nullptr) {
    openStudy(window, *study, path);
  } else if (ending == "hresults" && results != nullptr) {
    results->openFile(path);
    show(window, "dockStudyResults");
  } else {
    window.importFiles({path}, false);
  }
}

}  // namespace hapticell::app
