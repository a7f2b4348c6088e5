// SPDX-License-Identifier: Apache-2.0
#include "app/host/user_settings.h"

#include <QStandardPaths>

namespace hapticell::app {

UserSettings::UserSettings(const QString& file, QObject* parent) : QObject(parent) {
  if (file.isEmpty()) return;
  file_ = std::make_unique<QSettings>(file, QSettings::IniFormat);
  for (const QString& key : file_->allKeys()) values_.insert(key, file_->value(key));
}

UserSettings::~UserSettings() {
  flush();
}

QString UserSettings::defaultFile() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
         QStringLiteral("/hapticell/window.ini");
}

QVariant UserSettings::value(const QString& key, const QVariant& otherwise) const {
  return values_.value(key, otherwise);
}

void UserSettings::setValue(const QString& key, const QVariant& value) {
  if (values_.contains(key) && values_.value(key) == value) return;
  values_.insert(key, value);
  if (file_) file_->setValue(key, value);
  emit changed(key);
}

void UserSettings::remove(const QString& key) {
  if (values_.remove(key) == 0) return;
  if (file_) file_->remove(key);
  emit changed(key);
}

QStringList UserSettings::keysBelow(const QString& group) const {
  QStringList keys;
  const QString prefix = group + QLatin1Char('/');
  for (auto it = values_.begin(); it != values_.end(); ++it)
    if (it.key().startsWith(prefix)) keys.append(it.key().mid(prefix.size()));
  keys.sort();
  return keys;
}

bool UserSettings::flush() {
  if (!file_) return true;
  file_->sync();
  return file_->status() == QSettings::NoError;
}

}  // namespace hapticell::app
