// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QSize>
#include <QString>

namespace hapticell::app {

/// The share (0 to 1) of pixels that differ clearly from the most frequent colour of their row: 0 for an empty panel, and
/// for a scene without parts little more.
double drawnShare(const QImage& picture);

/// At most 256 colours, those that the picture uses most.
QImage withFewColours(const QImage& picture);

/// Saves a picture of the documents as PNG below kLargestFile, with 256 colours where it needs more. Empty if it was
/// saved; otherwise a sentence: it has another size, nothing is to be seen on it, or the file cannot be written.
QString savePicture(const QImage& picture, const QSize& size, const QString& file);

inline constexpr qint64 kLargestFile = 400'000;  ///< Bytes.

}  // namespace hapticell::app
