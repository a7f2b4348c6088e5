// SPDX-License-Identifier: Apache-2.0
#include "app/shell/file_opening.h"

#include <QFileInfo>

#include "app/shell/main_window.h"
#include "app/trajectory/motions/motion_export.h"
#include "app/trajectory/training/training_panel.h"

namespace hapticell::app {

namespace {

QString endingOf(const QString& path) {
  return QFileInfo(path).suffix().toLower();
}

}  // namespace

bool isOwnFile(const QString& path) {
  const QString ending = endingOf(path);
  return ending == "htraj" || ending == "hexercise" || ending == "htrain";
}

void openAny(MainWindow& window, const QString& path) {
  const QString ending = endingOf(path);
  auto* const motions = window.findChild<MotionExport*>();
  auto* const training = window.findChild<TrainingPanel*>();
  if (ending == "hcell") {
    window.openFile(path);
  } else if (ending == "htraj" && motions != nullptr) {
    motions->importFrom({path}, {});
  } else if (ending == "hexercise" && training != nullptr) {
    training->openExercise(path);
  } else if (ending == "htrain" && training != nullptr) {
    training->openResults(path);
  } else {
    window.importFiles({path}, false);
  }
}

}  // namespace hapticell::app
