// SPDX-License-Identifier: Apache-2.0
#include "app/kit/written_file.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QImageWriter>
#include <QPdfWriter>

namespace hapticell::app {

namespace {

Expected<void> writeBytes(const QString& path, const QByteArray& bytes) {
  return writeFileAtomically(path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace

Expected<void> writePicture(const QImage& picture, const QString& path, int quality) {
  const QByteArray format = QFileInfo(path).suffix().toLatin1().toLower();
  if (!QImageWriter::supportedImageFormats().contains(format)) {
    return makeError({.file = path.toStdString(),
                      .found = "an unsupported picture format",
                      .expected = "png, jpg, bmp or tiff",
                      .fix = "Use another file extension."});
  }
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  if (!picture.save(&buffer, format.constData(), quality))
    return makeError({.file = path.toStdString(), .found = "an empty picture", .expected = "a drawn view"});
  return writeBytes(path, buffer.data());
}

Expected<void> writePdf(const QString& path, const std::function<void(QPdfWriter&)>& draw) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    draw(writer);
  }
  return writeBytes(path, buffer.data());
}

}  // namespace hapticell::app
