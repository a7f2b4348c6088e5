// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/spacemouse/hid_layout.h"

#include <algorithm>
#include <array>
#include <map>

namespace hapticell::driver {

namespace {

constexpr std::size_t kMostFields = 4096;  // A descriptor that asks for more is broken.
constexpr std::uint32_t kMostBits = 32;

/// Items of the descriptor's language, by tag and type (the low two bits tell the length).
enum Item : std::uint8_t {
  kInput = 0x80,
  kOutput = 0x90,
  kFeature = 0xB0,
  kCollection = 0xA0,
  kEndCollection = 0xC0,
  kUsagePage = 0x04,
  kLogicalMinimum = 0x14,
  kLogicalMaximum = 0x24,
  kReportSize = 0x74,
  kReportId = 0x84,
  kReportCount = 0x94,
  kPush = 0xA4,
  kPop = 0xB4,
  kUsage = 0x08,
  kUsageMinimum = 0x18,
  kUsageMaximum = 0x28,
};

struct Globals {
  std::uint16_t page = 0;
  std::int32_t low = 0, high = 0;
  std::uint32_t size = 0, count = 0;
  std::uint8_t report = 0;
};

struct Locals {
  std::vector<std::uint32_t> usages;  ///< Page in the upper half where the item said it.
  std::uint32_t first = 0, last = 0;
  bool range = false;
};

class Parser {
 public:
  explicit Parser(std::vector<HidField>& fields) : fields_(fields) {}
  bool has_ids = false;

  /// False: broken.
  bool take(std::uint8_t item, std::uint32_t raw, std::size_t length) {
    switch (item) {
      case kUsagePage:
        now_.page = static_cast<std::uint16_t>(raw);
        return true;
      case kLogicalMinimum:
        now_.low = signedOf(raw, length);
        return true;
      case kLogicalMaximum:
        now_.high = signedOf(raw, length);
        return true;
      case kReportSize:
        now_.size = raw;
        return true;
      case kReportCount:
        now_.count = raw;
        return true;
      case kReportId:
        now_.report = static_cast<std::uint8_t>(raw);
        has_ids = true;
        return true;
      case kPush:
        kept_.push_back(now_);
        return kept_.size() < 64;
      case kPop:
        if (kept_.empty()) return false;
        now_ = kept_.back();
        kept_.pop_back();
        return true;
      case kUsage:
        local_.usages.push_back(length == 4 ? raw : raw & 0xFFFFu);
        return local_.usages.size() < kMostFields;
      case kUsageMinimum:
        local_.first = raw & 0xFFFFu;
        local_.range = true;
        return true;
      case kUsageMaximum:
        local_.last = raw & 0xFFFFu;
        return true;
      case kInput: {
        const bool fine = addInput(raw);
        local_ = {};
        return fine;
      }
      case kOutput:
      case kFeature:
      case kCollection:
      case kEndCollection:
        local_ = {};
        return true;
      default:
        return true;
    }
  }

 private:
  static std::int32_t signedOf(std::uint32_t raw, std::size_t length) {
    if (length == 1) return static_cast<std::int8_t>(raw);
    if (length == 2) return static_cast<std::int16_t>(raw);
    return static_cast<std::int32_t>(raw);
  }

  bool addInput(std::uint32_t flags) {
    if (now_.size > 4096 || now_.count > kMostFields || fields_.size() + now_.count > kMostFields) return false;
    std::size_t& at = end_[now_.report];
    const bool constant = (flags & 1u) != 0, variable = (flags & 2u) != 0;
    for (std::uint32_t i = 0; i < now_.count; ++i, at += now_.size) {
      if (constant || now_.size == 0 || now_.size > kMostBits) continue;
      HidField field;
      field.report = now_.report;
      field.bit = at;
      field.bits = static_cast<std::uint8_t>(now_.size);
      field.low = now_.low;
      // 255 written with one byte, as makers do.
      field.high = now_.high < now_.low && now_.size < 32 ? now_.high + (1 << now_.size) : now_.high;
      field.array = !variable;
      nameField(field, variable ? i : 0);
      fields_.push_back(field);
    }
    return true;
  }

  void nameField(HidField& field, std::uint32_t i) const {
    field.page = now_.page;
    if (!local_.usages.empty()) {
      const std::uint32_t usage = local_.usages[std::min<std::size_t>(i, local_.usages.size() - 1)];
      if (usage > 0xFFFFu) field.page = static_cast<std::uint16_t>(usage >> 16);
      field.usage = static_cast<std::uint16_t>(usage);
    } else if (local_.range) {
      field.usage = static_cast<std::uint16_t>(std::min(local_.first + i, std::max(local_.first, local_.last)));
    }
  }

  std::vector<HidField>& fields_;
  Globals now_;
  Locals local_;
  std::vector<Globals> kept_;
  std::map<std::uint8_t, std::size_t> end_;  ///< Bits of each report so far.
};

}  // namespace

HidLayout HidLayout::parse(std::span<const std::uint8_t> descriptor) {
  HidLayout layout;
  Parser parser(layout.fields_);
  for (std::size_t i = 0; i < descriptor.size();) {
    const std::uint8_t prefix = descriptor[i];
    if (prefix == 0xFE) {  // A long item: none is defined.
      if (i + 1 >= descriptor.size()) return {};
      i += 3u + descriptor[i + 1];
      continue;
    }
    constexpr std::array<std::size_t, 4> kLengths{0, 1, 2, 4};
    const std::size_t length = kLengths[prefix & 3u];
    if (i + 1 + length > descriptor.size()) return {};
    std::uint32_t raw = 0;
    for (std::size_t k = 0; k < length; ++k) raw |= static_cast<std::uint32_t>(descriptor[i + 1 + k]) << (8 * k);
    if (!parser.take(prefix & 0xFCu, raw, length)) return {};
    i += 1 + length;
  }
  layout.has_ids_ = parser.has_ids;
  return layout;
}

bool HidLayout::statesAxes() const {
  for (std::uint16_t axis = 0; axis < 6; ++axis) {
    const bool there = std::any_of(fields_.begin(), fields_.end(), [&](const HidField& f) {
      return f.page == kDesktop && f.usage == kFirstAxis + axis && !f.array;
    });
    if (!there) return false;
  }
  return true;
}

bool HidLayout::read(const HidField& field, std::span<const std::uint8_t> report, std::int32_t& value) const {
  const std::size_t begin = field.bit + (has_ids_ ? 8 : 0);
  if (begin + field.bits > 8 * report.size()) return false;
  std::uint64_t raw = 0;
  for (std::size_t k = 0; k < field.bits; ++k) {
    const std::size_t bit = begin + k;
    raw |= static_cast<std::uint64_t>(report[bit / 8] >> (bit % 8) & 1u) << k;
  }
  const std::uint64_t sign = std::uint64_t{1} << (field.bits - 1);
  const bool negative = field.low < 0 && (raw & sign) != 0;
  value =
      static_cast<std::int32_t>(static_cast<std::int64_t>(raw) - (negative ? static_cast<std::int64_t>(sign << 1) : 0));
  return true;
}

}  // namespace hapticell::driver
