// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <vector>

namespace hapticell::app {

struct ListedDevice;

/// A list to choose a device from; its entries change while the program runs. While it is open it does not change, so
/// that nothing moves under the pointer. GUI thread.
class DeviceCombo : public QComboBox {
  Q_OBJECT
 public:
  struct Entry {
    QString text, device, tip;
    friend bool operator==(const Entry&, const Entry&) = default;
  };
  using QComboBox::QComboBox;

  static Entry entryOf(const ListedDevice& device);

  /// Sets the entries. If the chosen device is no longer among them, it stays in the list as unplugged.
  void setEntries(std::vector<Entry> entries);
  /// Selects a device by its name in a listing; empty: the entry without a device.
  void setChosen(const QString& device);
  void hidePopup() override;

 private:
  int indexOfChosen() const;
  void fill();

  std::vector<Entry> entries_, shown_;
  QString chosen_, chosen_name_;
};

}  // namespace hapticell::app
