// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/device_listing.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace hapticell::app {

std::optional<DeviceListing> parseListing(const QByteArray& json) {
  const QJsonObject root = QJsonDocument::fromJson(json).object();
  if (!root["devices"].isArray() || !root["drivers"].isArray()) return std::nullopt;
  DeviceListing listing;
  for (const auto& value : root["drivers"].toArray()) {
    const QJsonObject driver = value.toObject();
    listing.drivers.push_back({driver["name"].toString(), driver["title"].toString(), driver["version"].toString(),
                               driver["library"].toString(), driver["note"].toString(), driver["usable"].toBool(),
                               driver["problem"].toString(), driver["fix"].toString()});
  }
  for (const auto& value : root["devices"].toArray()) {
    const QJsonObject device = value.toObject();
    listing.devices.push_back({device["device"].toString(), device["name"].toString(), device["driver"].toString(),
                               device["place"].toString(), device["firmware"].toString(), device["kind"].toString(),
                               device["simulated"].toBool(), device["usable"].toBool(), device["problem"].toString(),
                               device["fix"].toString()});
  }
  for (const auto& value : root["permissions"].toArray()) {
    const QJsonObject grant = value.toObject();
    listing.grants.push_back(
        {grant["what"].toString(), grant["found"].toString(), grant["fix"].toString(), grant["granted"].toBool()});
  }
  const QJsonObject versions = root["versions"].toObject();
  listing.versions =
      QCoreApplication::translate("DeviceListing", "HaptiCell %1, driver interface %2, protocol %3, kernel %4")
          .arg(versions["hapticell"].toString())
          .arg(versions["driver_interface"].toInt())
          .arg(versions["protocol"].toInt())
          .arg(versions["kernel"].toString());
  return listing;
}

std::vector<ListedDevice> newDevices(const DeviceListing& before, const DeviceListing& now) {
  std::vector<ListedDevice> fresh;
  for (const ListedDevice& device : now.devices) {
    const bool known = std::any_of(before.devices.begin(), before.devices.end(),
                                   [&](const ListedDevice& one) { return one.device == device.device; });
    if (!known) fresh.push_back(device);
  }
  return fresh;
}

DeviceLister::DeviceLister(QObject* parent) : QObject(parent) {
  connect(&process_, &QProcess::readyReadStandardOutput, this, &DeviceLister::takeLines);
  connect(&process_, &QProcess::finished, this, [this] {
    emit failed(
        tr("The devices could not be listed: %1").arg(QString::fromUtf8(process_.readAllStandardError()).trimmed()));
  });
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) emit failed(tr("%1 was not found or cannot be run.").arg(process_.program()));
  });
}

DeviceLister::~DeviceLister() {
  process_.disconnect(this);
  process_.kill();
  process_.waitForFinished(500);
}

void DeviceLister::look() {
  if (process_.state() != QProcess::NotRunning) {
    process_.write("look\n");
    return;
  }
  process_.start(QDir(QCoreApplication::applicationDirPath()).filePath("hapticell-cli"), {"devices", "--watch"});
}

void DeviceLister::takeLines() {
  while (process_.canReadLine()) {
    auto read = parseListing(process_.readLine());
    if (!read) continue;
    const std::vector<ListedDevice> fresh = listing_ ? newDevices(*listing_, *read) : std::vector<ListedDevice>{};
    listing_ = std::move(*read);
    emit listed();
    for (const ListedDevice& device : fresh) emit plugged(device);
  }
}

}  // namespace hapticell::app
