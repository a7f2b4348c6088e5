// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <optional>
#include <vector>

namespace hapticell::app {

/// A device as `hapticell-cli devices` lists it.
struct ListedDevice {
  QString device;  ///< As `--device` takes it.
  QString name, driver, place, firmware;
  QString kind;  ///< "stylus", "glove", "space_mouse".
  bool simulated = false, usable = false;
  QString problem, fix;
};

struct ListedDriver {
  QString name, title, version, library, note;
  bool usable = false;
  QString problem, fix;
};

struct ListedGrant {
  QString what, found, fix;
  bool granted = false;
};

/// All of it.
struct DeviceListing {
  std::vector<ListedDriver> drivers;
  std::vector<ListedDevice> devices;
  std::vector<ListedGrant> grants;
  QString versions;  ///< One line.
};

/// Reads the command's JSON; empty if it is invalid.
std::optional<DeviceListing> parseListing(const QByteArray& json);

/// What is plugged into one listing and was not into the one before.
std::vector<ListedDevice> newDevices(const DeviceListing& before, const DeviceListing& now);

/// Has the listing kept by a process of its own (`hapticell-cli devices --watch`): drivers load vendors' libraries,
/// which the window must not share. GUI thread; never waits.
class DeviceLister : public QObject {
  Q_OBJECT
 public:
  explicit DeviceLister(QObject* parent = nullptr);
  ~DeviceLister() override;
  /// Starts the search, which then continues; listed() or failed() follows. Another call asks every driver again.
  void look();
  /// The newest; nothing before the first.
  const std::optional<DeviceListing>& listing() const { return listing_; }

 signals:
  void listed();                             ///< Also whenever a device has come or gone.
  void plugged(const ListedDevice& device);  ///< After listed().
  void failed(const QString& sentence);

 private:
  void takeLines();

  QProcess process_;
  std::optional<DeviceListing> listing_;
};

}  // namespace hapticell::app
