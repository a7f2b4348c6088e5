// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hapticell::driver {

/// One value of an input report; for an array, one slot that contains a usage.
struct HidField {
  std::uint8_t report = 0;  ///< Its id; 0 if the device does not number its reports.
  std::size_t bit = 0;      ///< Its first bit, counted after the report's id.
  std::uint8_t bits = 0;
  std::uint16_t page = 0;
  std::uint16_t usage = 0;         ///< Arrays: the usage of the logical minimum.
  std::int32_t low = 0, high = 0;  ///< Logical minimum and maximum.
  bool array = false;
};

/// Layout of a device's input reports, from its report descriptor (USB, "Device Class Definition for HID 1.11", 6.2.2).
/// A plain value.
class HidLayout {
 public:
  static constexpr std::uint16_t kDesktop = 0x01, kButtons = 0x09;
  static constexpr std::uint16_t kFirstAxis = 0x30;  ///< X; then Y, Z, Rx, Ry, Rz.

  /// Empty if the descriptor is invalid or has no input.
  static HidLayout parse(std::span<const std::uint8_t> descriptor);

  const std::vector<HidField>& fields() const { return fields_; }
  bool hasReportIds() const { return has_ids_; }
  /// Whether all six axes, X to Rz, are present.
  bool statesAxes() const;
  /// The field's value in a report (with its id first, if it has one); false if the report ends before it.
  bool read(const HidField& field, std::span<const std::uint8_t> report, std::int32_t& value) const;

 private:
  std::vector<HidField> fields_;
  bool has_ids_ = false;
};

}  // namespace hapticell::driver
