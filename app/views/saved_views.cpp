// SPDX-License-Identifier: Apache-2.0
#include "app/views/saved_views.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QUrl>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "app/host/user_settings.h"

namespace hapticell::app {

QString SavedViews::group() const {
  const QByteArray hash = QCryptographicHash::hash(cell_.toUtf8(), QCryptographicHash::Sha1).toHex().left(16);
  return QStringLiteral("views/") + QString::fromLatin1(hash);
}

void SavedViews::setCell(const QString& path) {
  if (path == cell_) return;
  std::vector<std::pair<QString, Camera>> own;
  if (cell_.isEmpty())
    for (const QString& name : names())
      if (const auto camera = find(name)) own.emplace_back(name, *camera);
  if (cell_.isEmpty()) removeAll();
  cell_ = path;
  for (const auto& [name, camera] : own) keep(name, camera);
}

void SavedViews::closeCell() {
  if (cell_.isEmpty()) removeAll();
  cell_.clear();
}

void SavedViews::removeAll() {
  for (const QString& name : names()) remove(name);
}

QStringList SavedViews::names() const {
  QStringList names;
  for (const QString& key : settings_.keysBelow(group())) names << QUrl::fromPercentEncoding(key.toLatin1());
  return names;
}

std::optional<Camera> SavedViews::find(const QString& name) const {
  const QString key = group() + '/' + QString::fromLatin1(QUrl::toPercentEncoding(name));
  return cameraFromText(settings_.value(key).toString());
}

void SavedViews::keep(const QString& name, const Camera& camera) {
  if (name.isEmpty()) return;
  settings_.setValue(group() + '/' + QString::fromLatin1(QUrl::toPercentEncoding(name)), cameraText(camera));
}

void SavedViews::remove(const QString& name) {
  settings_.remove(group() + '/' + QString::fromLatin1(QUrl::toPercentEncoding(name)));
}

QString SavedViews::freeName() const {
  const QStringList taken = names();
  for (int number = 1;; ++number) {
    const QString name = QCoreApplication::translate("SavedViews", "View %1").arg(number);
    if (!taken.contains(name)) return name;
  }
}

QString cameraText(const Camera& camera) {
  const std::array<double, 7> numbers{camera.target_W.x, camera.target_W.y, camera.target_W.z,   camera.azimuth,
                                      camera.elevation,  camera.distance,   camera.field_of_view};
  QStringList words;
  for (const double number : numbers) words << QString::number(number, 'g', 12);
  words << (camera.perspective ? "perspective" : "parallel");
  return words.join(QLatin1Char(' '));
}

std::optional<Camera> cameraFromText(const QString& text) {
  const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  if (words.size() != 8) return std::nullopt;
  std::array<double, 7> numbers{};
  for (int i = 0; i < 7; ++i) {
    bool read = false;
    numbers[static_cast<std::size_t>(i)] = words[i].toDouble(&read);
    if (!read || !std::isfinite(numbers[static_cast<std::size_t>(i)])) return std::nullopt;
  }
  Camera camera;
  camera.target_W = {numbers[0], numbers[1], numbers[2]};
  camera.azimuth = numbers[3];
  camera.elevation = numbers[4];
  camera.distance = numbers[5];
  camera.field_of_view = numbers[6];
  camera.perspective = words[7] == QLatin1String("perspective");
  if (camera.distance <= 0.0 || camera.field_of_view <= 0.0 || camera.field_of_view >= 3.1) return std::nullopt;
  return camera;
}

}  // namespace hapticell::app
