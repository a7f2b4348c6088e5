// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace hapticell::app {

// Questions for files, in a dialog of the window's theme and language that shows the picture, size and time of the file
// that is looked at. Each returns when it is answered; an empty answer: cancelled. `start` is a folder, a file, or a
// mere name in the folder of last time; `filter` as QFileDialog has it, "Workcells (*.hcell);;All files (*)". GUI
// thread.

QString askToOpen(QWidget* parent, const QString& title, const QString& start, const QString& filter);
QStringList askToOpenSeveral(QWidget* parent, const QString& title, const QString& start, const QString& filter);
/// A name without an ending gets the first one of the chosen filter; before another file is replaced it asks.
QString askToSave(QWidget* parent, const QString& title, const QString& start, const QString& filter);
QString askForFolder(QWidget* parent, const QString& title, const QString& start);

}  // namespace hapticell::app
