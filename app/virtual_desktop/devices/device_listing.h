// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <optional>
#include <vector>

namespace hapticell::app {

/// A device as in the list of `hapticell-cli devices`.
struct ListedDevice {
  QString device;  ///< As for `--device`.
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

/// The complete list.
struct DeviceListing {
  std::vector<ListedDriver> drivers;
  std::vector<ListedDevice> devices;
  std::vector<ListedGrant> grants;
  QString versions;  ///< One line.
};

/// Reads the JSON of the command; empty if it is invalid.
std::optional<DeviceListing> parseListing(const QByteArray& json);

/// Devices that are plugged in now and were not in the list before.
std::vector<ListedDevice> newDevices(const DeviceListing& before, const DeviceListing& now);

/// Keeps the list up to date with a separate process (`hapticell-cli devices --watch`): drivers load vendors'
/// libraries, which must not run in the window's process. GUI thread; never waits.
class DeviceLister : public QObject {
  Q_OBJECT
 public:
  explicit DeviceLister(QObject* parent = nullptr);
  ~DeviceLister() override;
  /// Starts the search, which then continues; listed() or failed() follows. Another call queries every driver again.
  void look();
  /// The newest list; empty before the first one.
  const std::optional<DeviceListing>& listing() const { return listing_; }

 signals:
  void listed();                             ///< Also whenever a device was plugged in or removed.
  void plugged(const ListedDevice& device);  ///< After listed().
  void failed(const QString& sentence);

 private:
  void takeLines();

  QProcess process_;
  std::optional<DeviceListing> listing_;
};

}  // namespace hapticell::app
