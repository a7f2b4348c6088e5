// SPDX-License-Identifier: Apache-2.0
#include "app/kit/video_writer.h"

#include <QFileInfo>
#include <QImage>

#include "config/user_folders.h"

namespace hapticell::app {
namespace {

// ms for one picture: ffmpeg on a busy machine. Half: slow machines fail; twice: a hung one is waited for longer.
constexpr int kPatience = 30000;
// ms for the last pictures and the index. Half: long videos fail at their end; twice: a hung one is waited for longer.
constexpr int kEndPatience = 120000;
// Bytes that may wait for the program, four pictures of full size. Half: drawing waits for it more often; twice:
// memory.
constexpr qint64 kMostWaiting = 1 << 25;

}  // namespace

bool VideoWriter::isVideo(const QString& file) {
  const QString suffix = QFileInfo(file).suffix().toLower();
  return suffix == "mp4" || suffix == "webm" || suffix == "mkv" || suffix == "gif";
}

Expected<std::unique_ptr<VideoWriter>> VideoWriter::open(const QString& file, const QSize& size, int frames_a_second) {
  const QString program = QString::fromStdString(config::systemProgram("ffmpeg").string());
  if (program.isEmpty()) {
    return makeError({.file = file.toStdString(),
                      .found = "the program ffmpeg is not installed",
                      .expected = "the program ffmpeg, to write videos",
                      .fix = "Install ffmpeg, or save a picture (.png)."});
  }
  if (size.isEmpty() || size.width() % 2 != 0 || size.height() % 2 != 0) {
    return makeError({.file = file.toStdString(),
                      .found = Text("a picture of %1 x %2", size.width(), size.height()),
                      .expected = "an even width and height"});
  }
  std::unique_ptr<VideoWriter> writer(new VideoWriter);
  writer->file_ = file;
  writer->size_ = size;
  const QFileInfo info(file);
  auto part = AtomicFile::begin(file.toStdString());
  HAPTICELL_TRY(part);
  writer->part_.emplace(std::move(*part));
  QStringList arguments{"-y",
                        "-loglevel",
                        "error",
                        "-f",
                        "rawvideo",
                        "-pix_fmt",
                        "rgb24",
                        "-s",
                        QStringLiteral("%1x%2").arg(size.width()).arg(size.height()),
                        "-r",
                        QString::number(frames_a_second),
                        "-i",
                        "-",
                        "-an"};
  if (info.suffix().toLower() != "gif")
    arguments << "-pix_fmt"
              << "yuv420p";
  arguments << QString::fromStdString(writer->part_->aside().string());
  writer->ffmpeg_.setProcessChannelMode(QProcess::MergedChannels);
  writer->ffmpeg_.start(program, arguments);
  if (!writer->ffmpeg_.waitForStarted(kPatience)) return makeError(writer->failure(Text("it could not be started")));
  return writer;
}

VideoWriter::~VideoWriter() {
  if (ffmpeg_.state() == QProcess::NotRunning) return;
  ffmpeg_.kill();
  ffmpeg_.waitForFinished(kPatience);
}

Error VideoWriter::failure(const Text& what) {
  const QString said = QString::fromLocal8Bit(ffmpeg_.readAll()).simplified();
  return {.file = file_.toStdString(),
          .place = "ffmpeg",
          .found = said.isEmpty() ? what : Text(said.toStdString()),
          .expected = "a video file that can be written",
          .fix = "Check that the folder exists and that ffmpeg supports this extension."};
}

Expected<void> VideoWriter::add(const QImage& picture) {
  const QImage frame =
      (picture.size() == size_ ? picture : picture.scaled(size_, Qt::IgnoreAspectRatio, Qt::SmoothTransformation))
          .convertToFormat(QImage::Format_RGB888);
  for (int row = 0; row < frame.height(); ++row)  // Rows of an image are padded.
    ffmpeg_.write(reinterpret_cast<const char*>(frame.constScanLine(row)), 3LL * frame.width());
  while (ffmpeg_.bytesToWrite() > kMostWaiting)
    if (!ffmpeg_.waitForBytesWritten(kPatience)) return makeError(failure(Text("it stopped accepting pictures")));
  if (ffmpeg_.state() == QProcess::NotRunning) return makeError(failure(Text("it ended too early")));
  return {};
}

Expected<void> VideoWriter::finish() {
  ffmpeg_.closeWriteChannel();
  if (!ffmpeg_.waitForFinished(kEndPatience)) return makeError(failure(Text("it did not finish")));
  if (ffmpeg_.exitStatus() != QProcess::NormalExit || ffmpeg_.exitCode() != 0) {
    return makeError(failure(Text("it ended with an error")));
  }
  return part_->commit();
}

}  // namespace hapticell::app
