// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

namespace hapticell::mannequin {

/// The processors whose number formats C3D files use, by the code in the file.
enum class C3dProcessor : std::uint8_t { kIntel = 84, kDec = 85, kMips = 86 };

/// Numbers at positions of a file; empty if the file ends before. Real numbers are finite and below 1e12.
class C3dBytes {
 public:
  C3dBytes(std::string_view bytes, C3dProcessor processor) : bytes_(bytes), processor_(processor) {}

  std::size_t size() const { return bytes_.size(); }
  std::string_view text(std::size_t at, std::size_t count) const {
    return at <= bytes_.size() && count <= bytes_.size() - at ? bytes_.substr(at, count) : std::string_view();
  }
  bool holds(std::size_t at, std::size_t count) const { return at <= bytes_.size() && count <= bytes_.size() - at; }

  std::optional<std::uint8_t> byte(std::size_t at) const {
    if (!holds(at, 1)) return std::nullopt;
    return static_cast<std::uint8_t>(bytes_[at]);
  }
  std::optional<std::uint16_t> word(std::size_t at) const {
    if (!holds(at, 2)) return std::nullopt;
    const auto a = static_cast<std::uint8_t>(bytes_[at]), b = static_cast<std::uint8_t>(bytes_[at + 1]);
    const bool big = processor_ == C3dProcessor::kMips;
    return static_cast<std::uint16_t>(big ? a << 8 | b : b << 8 | a);
  }
  std::optional<std::int16_t> whole(std::size_t at) const {
    const auto value = word(at);
    return value ? std::optional(static_cast<std::int16_t>(*value)) : std::nullopt;
  }
  std::optional<double> real(std::size_t at) const {
    const auto first = word(at), second = word(at + 2);
    if (!first || !second) return std::nullopt;
    // DEC's F format: the words swapped, the exponent two higher. Intel's low word comes first.
    const bool high_first = processor_ != C3dProcessor::kIntel;
    const std::uint32_t high = high_first ? *first : *second, low = high_first ? *second : *first;
    const std::uint32_t bits = high << 16 | low;
    float value = 0.0f;
    std::memcpy(&value, &bits, sizeof value);
    const double wide = static_cast<double>(value) * (processor_ == C3dProcessor::kDec ? 0.25 : 1.0);
    if (!std::isfinite(wide) || std::abs(wide) > 1e12) return std::nullopt;
    return wide;
  }

 private:
  std::string_view bytes_;
  C3dProcessor processor_;
};

}  // namespace hapticell::mannequin
