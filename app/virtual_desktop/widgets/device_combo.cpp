// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/widgets/device_combo.h"

#include <QAbstractItemView>
#include <utility>

#include "app/virtual_desktop/devices/device_listing.h"

namespace hapticell::app {

DeviceCombo::Entry DeviceCombo::entryOf(const ListedDevice& device) {
  return {device.usable ? device.name : tr("%1 (not usable)").arg(device.name), device.device,
          device.usable ? device.place : device.problem};
}

void DeviceCombo::setEntries(std::vector<Entry> entries) {
  entries_ = std::move(entries);
  if (!view()->isVisible()) fill();
}

void DeviceCombo::setChosen(const QString& device) {
  if (device != chosen_) chosen_name_.clear();
  chosen_ = device;
  if (!view()->isVisible()) fill();
}

void DeviceCombo::hidePopup() {
  QComboBox::hidePopup();
  // After the choice that closed it.
  QMetaObject::invokeMethod(
      this,
      [this] {
        if (!view()->isVisible()) fill();
      },
      Qt::QueuedConnection);
}

int DeviceCombo::indexOfChosen() const {
  for (std::size_t i = 0; i < shown_.size(); ++i)
    if (shown_[i].device == chosen_) return static_cast<int>(i);
  // One without a serial number has another id when it was plugged in again; its driver takes it all the same.
  for (std::size_t i = 0; i < shown_.size(); ++i)
    if (!chosen_name_.isEmpty() && shown_[i].text == chosen_name_) return static_cast<int>(i);
  return -1;
}

void DeviceCombo::fill() {
  std::vector<Entry> before = std::exchange(shown_, entries_);
  if (indexOfChosen() < 0 && !chosen_.isEmpty())
    shown_.push_back({chosen_name_.isEmpty() ? chosen_ : tr("%1 (unplugged)").arg(chosen_name_), chosen_, chosen_});
  if (shown_ != before) {
    clear();
    for (const Entry& entry : shown_) {
      addItem(entry.text, entry.device);
      setItemData(count() - 1, entry.tip, Qt::ToolTipRole);
    }
  }
  const int index = indexOfChosen();
  setCurrentIndex(index);
  const bool is_there = index >= 0 && static_cast<std::size_t>(index) < entries_.size();
  if (is_there) chosen_name_ = shown_[static_cast<std::size_t>(index)].text;
}

}  // namespace hapticell::app
