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

/// Reads the command's JSON; nothing where it is none.
std::optional<DeviceListing> parseListing(const QByteArray& json);

/// Asks for the listing in a process of its own: drivers load vendors' libraries, which the window must not share.
/// GUI thread; never waits.
class DeviceLister : public QObject {
  Q_OBJECT
 public:
  explicit DeviceLister(QObject* parent = nullptr);
  ~DeviceLister() override;
  /// Looks again; listed() follows, or failed().
  void look();
  bool isLooking() const { return process_.state() != QProcess::NotRunning; }
  const DeviceListing& listing() const { return listing_; }

 signals:
  void listed();
  void failed(const QString& sentence);

 private:
  QProcess process_;
  DeviceListing listing_;
};

}  // namespace hapticell::app
