// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <vector>

namespace hapticell::app {

struct ListedDevice;

/// A list to choose a device from, whose entries come and go while the program runs. While it is open it stays as it
/// is: nothing moves under the pointer. GUI thread.
class DeviceCombo : public QComboBox {
  Q_OBJECT
 public:
  struct Entry {
    QString text, device, tip;
    friend bool operator==(const Entry&, const Entry&) = default;
  };
  using QComboBox::QComboBox;

  static Entry entryOf(const ListedDevice& device);

  /// From now on these. The chosen device stays in the list where it is not among them any more, as unplugged.
  void setEntries(std::vector<Entry> entries);
  /// As a listing names it; empty: the entry without a device.
  void setChosen(const QString& device);
  void hidePopup() override;

 private:
  int indexOfChosen() const;
  void fill();

  std::vector<Entry> entries_, shown_;
  QString chosen_, chosen_name_;
};

}  // namespace hapticell::app
