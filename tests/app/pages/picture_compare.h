// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QDir>
#include <QImage>
#include <string>

namespace hapticell::app::test {

/// Mean square error of two pictures of one size, channels 0 to 1.
inline double meanSquareError(const QImage& a, const QImage& b) {
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      for (const int d : {qRed(p) - qRed(q), qGreen(p) - qGreen(q), qBlue(p) - qBlue(q)}) sum += d * d / 65025.0;
    }
  return sum / (3.0 * a.width() * a.height());
}

/// Where they differ, four times as strong, on grey.
inline QImage differenceOf(const QImage& a, const QImage& b) {
  QImage result(a.size(), QImage::Format_RGB32);
  const auto channel = [](int p, int q) { return qBound(0, 128 + 4 * (p - q), 255); };
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      result.setPixel(x, y,
                      qRgb(channel(qRed(p), qRed(q)), channel(qGreen(p), qGreen(q)), channel(qBlue(p), qBlue(q))));
    }
  return result;
}

/// The picture is that of tests/app/pictures/NAME.png, but for what drivers do differently. Where it is not, it and the
/// difference are kept in the folder "picture-differences" of the working directory. With HAPTICELL_UPDATE_PICTURES set
/// it becomes the reference.
inline void expectPicture(const QImage& picture, const std::string& reference) {
  const QString name = QString::fromStdString(reference);
  if (qEnvironmentVariableIsSet("HAPTICELL_UPDATE_PICTURES")) {
    ASSERT_TRUE(picture.save(name)) << reference;
    return;
  }
  const QImage wanted = QImage(name).convertToFormat(QImage::Format_RGB32);
  ASSERT_EQ(wanted.size(), picture.size()) << reference;
  constexpr double kBound = 0.002;
  const double error = meanSquareError(picture, wanted);
  EXPECT_LE(error, kBound) << reference;
  if (error <= kBound) return;
  QDir().mkpath("picture-differences");
  const QString stem = "picture-differences/" + QFileInfo(name).completeBaseName();
  picture.save(stem + ".png");
  differenceOf(picture, wanted).save(stem + "-difference.png");
}

}  // namespace hapticell::app::test
