// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace hapticell::app {

// Dialogs that ask for files, in the window's theme and language, with the picture, size and time of the
// selected file. Each returns when it is answered; an empty answer: cancelled. `start` is a folder, a file, or
// just a name in the folder that was used last; `filter` as in QFileDialog: "Workcells (*.hcell);;All files
// (*)". GUI thread.

QString askToOpen(QWidget* parent, const QString& title, const QString& start, const QString& filter);
QStringList askToOpenSeveral(QWidget* parent, const QString& title, const QString& start, const QString& filter);
/// Adds the first ending of the chosen filter to a name without one; asks before it replaces another file.
QString askToSave(QWidget* parent, const QString& title, const QString& start, const QString& filter);
QString askForFolder(QWidget* parent, const QString& title, const QString& start);

}  // namespace hapticell::app
