// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <functional>

#include "geometry/system/atomic_file.h"

class QImage;
class QPdfWriter;

namespace hapticell::app {

// Everything that Qt draws is written like all other files: completely or not at all (geometry/system/atomic_file.h).

/// Writes a picture in the format that the name's ending says (png, jpg, ...). Error: Qt does not write this format, or
/// the file cannot be written.
Expected<void> writePicture(const QImage& picture, const QString& path, int quality = -1);

/// A PDF of what `draw` puts on its pages.
Expected<void> writePdf(const QString& path, const std::function<void(QPdfWriter&)>& draw);

}  // namespace hapticell::app
