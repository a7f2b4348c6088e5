// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QString>

namespace hapticell::app {

/// The thumbnail of a cell from when it was last saved or left; null if it has no thumbnail. It is in the user's
/// cache, under a name made from the cell's path.
QImage keptPicture(const QString& path);
/// Stores the picture of the cell at `path` in place of an older one; does nothing if it cannot be written.
void storePicture(const QString& path, const QImage& picture);

}  // namespace hapticell::app
