// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QString>

namespace hapticell::app {

/// The small picture of a cell that was kept when the cell was left or saved last; null where there is none. It lies in
/// the user's cache, under a name made of the cell's path.
QImage keptPicture(const QString& path);
/// Keeps the picture of the cell at `path` in place of an older one; nothing where that cannot be written.
void storePicture(const QString& path, const QImage& picture);

}  // namespace hapticell::app
