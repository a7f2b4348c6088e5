// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hapticell::driver {

/// One value (or, of an array, one slot for the usage that is on) of an input report.
struct HidField {
  std::uint8_t report = 0;  ///< Its id; 0 where the device numbers none.
  std::size_t bit = 0;      ///< Where it begins, behind the report's id.
  std::uint8_t bits = 0;
  std::uint16_t page = 0;
  std::uint16_t usage = 0;         ///< Arrays: the usage that the logical minimum stands for.
  std::int32_t low = 0, high = 0;  ///< Logical minimum and maximum.
  bool array = false;
};

/// Where a device's input reports have what, by its report descriptor (USB, "Device Class Definition for HID 1.11",
/// 6.2.2). A plain value.
class HidLayout {
 public:
  static constexpr std::uint16_t kDesktop = 0x01, kButtons = 0x09;
  static constexpr std::uint16_t kFirstAxis = 0x30;  ///< X; then Y, Z, Rx, Ry, Rz.

  /// Empty where the descriptor is broken or has no input.
  static HidLayout parse(std::span<const std::uint8_t> descriptor);

  const std::vector<HidField>& fields() const { return fields_; }
  bool hasReportIds() const { return has_ids_; }
  /// All six axes, X to Rz, are there.
  bool statesAxes() const;
  /// The field's value in a report (id first where there is one); false where the report ends before it.
  bool read(const HidField& field, std::span<const std::uint8_t> report, std::int32_t& value) const;

 private:
  std::vector<HidField> fields_;
  bool has_ids_ = false;
};

}  // namespace hapticell::driver
