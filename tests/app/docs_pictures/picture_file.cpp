// SPDX-License-Identifier: Apache-2.0
#include "tests/app/docs_pictures/picture_file.h"

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace hapticell::app {
namespace {

constexpr double kLeastDrawn = 0.02;  // Of all pixels: an empty window with its menus has more than an empty panel.

/// Colours of a picture that lie close together, counted.
struct Shade {
  std::array<std::uint64_t, 3> sum{};
  std::uint64_t count = 0;
  double mean(std::size_t channel) const { return double(sum[channel]) / double(count); }
};
using Shades = std::vector<Shade>;

Shades shadesOf(const QImage& picture) {
  constexpr int kBits = 6;  // Of each channel.
  Shades all(std::size_t(1) << (3 * kBits));
  for (int y = 0; y < picture.height(); ++y) {
    const auto* row = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
    for (int x = 0; x < picture.width(); ++x) {
      const std::array<int, 3> rgb{qRed(row[x]), qGreen(row[x]), qBlue(row[x])};
      Shade& shade = all[std::size_t(((rgb[0] >> 2) << 2 * kBits) | ((rgb[1] >> 2) << kBits) | (rgb[2] >> 2))];
      for (std::size_t c = 0; c < 3; ++c) shade.sum[c] += std::uint64_t(rgb[c]);
      ++shade.count;
    }
  }
  std::erase_if(all, [](const Shade& shade) { return shade.count == 0; });
  return all;
}

struct Extent {
  std::size_t channel = 0;
  double width = 0.0;
};

Extent widest(const Shades& shades) {
  Extent found;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto [low, high] = std::minmax_element(
        shades.begin(), shades.end(), [c](const Shade& a, const Shade& b) { return a.mean(c) < b.mean(c); });
    if (high->mean(c) - low->mean(c) > found.width) found = {c, high->mean(c) - low->mean(c)};
  }
  return found;
}

QRgb meanOf(const Shades& shades) {
  std::array<double, 3> sum{};
  double count = 0.0;
  for (const Shade& shade : shades) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += double(shade.sum[c]);
    count += double(shade.count);
  }
  return qRgb(qRound(sum[0] / count), qRound(sum[1] / count), qRound(sum[2] / count));
}

/// Two halves about the middle of the widest channel.
std::pair<Shades, Shades> halves(Shades shades) {
  const std::size_t c = widest(shades).channel;
  const auto middle = shades.begin() + std::ptrdiff_t(shades.size() / 2);
  std::nth_element(shades.begin(), middle, shades.end(),
                   [c](const Shade& a, const Shade& b) { return a.mean(c) < b.mean(c); });
  return {Shades(shades.begin(), middle), Shades(middle, shades.end())};
}

QByteArray encoded(const QImage& picture) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  picture.save(&buffer, "PNG", 0);  // 0: the smallest file.
  return buffer.data();
}

}  // namespace

double drawnShare(const QImage& picture) {
  const QImage image = picture.convertToFormat(QImage::Format_RGB32);
  constexpr int kClearly = 24;  // Of 255.
  std::uint64_t differ = 0;
  for (int y = 0; y < image.height(); ++y) {
    const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    std::vector<QRgb> sorted(row, row + image.width());
    std::sort(sorted.begin(), sorted.end());
    QRgb most = sorted.front();
    for (std::size_t i = 0, longest = 0; i < sorted.size();) {
      std::size_t end = i;
      while (end < sorted.size() && sorted[end] == sorted[i]) ++end;
      if (end - i > longest) longest = end - i, most = sorted[i];
      i = end;
    }
    for (int x = 0; x < image.width(); ++x) {
      const int off = std::max({std::abs(qRed(row[x]) - qRed(most)), std::abs(qGreen(row[x]) - qGreen(most)),
                                std::abs(qBlue(row[x]) - qBlue(most))});
      if (off > kClearly) ++differ;
    }
  }
  const double pixels = double(image.width()) * image.height();
  return pixels > 0.0 ? double(differ) / pixels : 0.0;
}

QImage withFewColours(const QImage& picture) {
  constexpr std::size_t kColours = 256;
  const QImage image = picture.convertToFormat(QImage::Format_RGB32);
  std::vector<Shades> boxes{shadesOf(image)};
  while (boxes.size() < kColours) {
    const auto widest_box = std::max_element(boxes.begin(), boxes.end(), [](const Shades& a, const Shades& b) {
      return widest(a).width < widest(b).width;
    });
    if (widest(*widest_box).width < 1.0) break;
    auto [low, high] = halves(std::move(*widest_box));
    *widest_box = std::move(low);
    boxes.push_back(std::move(high));
  }
  QList<QRgb> colours;
  for (const Shades& box : boxes) colours << meanOf(box);
  return image.convertToFormat(QImage::Format_Indexed8, colours, Qt::ThresholdDither);
}

QString savePicture(const QImage& picture, const QSize& size, const QString& file) {
  if (picture.size() != size)
    return QStringLiteral("%1: the picture has %2 x %3 pixels, not %4 x %5")
        .arg(file)
        .arg(picture.width())
        .arg(picture.height())
        .arg(size.width())
        .arg(size.height());
  if (const double drawn = drawnShare(picture); drawn < kLeastDrawn)
    return QStringLiteral("%1: nothing is to be seen: %2 % of the pixels differ from the background")
        .arg(file)
        .arg(100.0 * drawn, 0, 'f', 2);
  QByteArray png = encoded(picture.convertToFormat(QImage::Format_RGB888));
  if (png.size() > kLargestFile) png = encoded(withFewColours(picture));
  if (png.size() > kLargestFile) return QStringLiteral("%1: %2 bytes are too many").arg(file).arg(png.size());
  QDir().mkpath(QFileInfo(file).path());
  QFile out(file);
  if (!out.open(QIODevice::WriteOnly) || out.write(png) != png.size())
    return QStringLiteral("%1: %2").arg(file, out.errorString());
  return {};
}

}  // namespace hapticell::app
