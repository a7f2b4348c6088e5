// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QProcess>
#include <QSize>
#include <QString>
#include <memory>
#include <optional>

#include "geometry/system/atomic_file.h"
#include "geometry/system/error.h"

class QImage;

namespace hapticell::app {

/// Writes pictures, one after the other, into a video with the program `ffmpeg`, which must be on the path. The file is
/// written completely or not at all. Any one thread; add() waits while the program is behind.
class VideoWriter {
 public:
  /// True for "film.mp4", "film.webm", "film.mkv", "film.gif".
  static bool isVideo(const QString& file);
  /// Error: ffmpeg was not found; the size is empty or odd (the caller makes both sides even).
  static Expected<std::unique_ptr<VideoWriter>> open(const QString& file, const QSize& size, int frames_a_second);
  ~VideoWriter();

  /// Adds a picture of the size given to open(); other sizes are scaled.
  Expected<void> add(const QImage& picture);
  Expected<void> finish();

 private:
  VideoWriter() = default;
  Error failure(const Text& what);
  QProcess ffmpeg_;
  QString file_;
  std::optional<AtomicFile> part_;
  QSize size_;
};

}  // namespace hapticell::app
