// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace hapticell::exchange {

/// Appends a number, low byte first, as MCAP has all of them. T is an unsigned integer.
template <typename T>
void appendNumber(std::string& bytes, T value) {
  static_assert(std::is_unsigned_v<T>);
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xff);
}

/// A text with its length (32 bits) before it.
inline void appendText(std::string& bytes, std::string_view text) {
  appendNumber(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}

/// Reads numbers and texts off the front of bytes that somebody else wrote. Once something is missing, isGood() is
/// false for good and every further answer is zero or empty. The bytes must outlive it.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  T number() {
    static_assert(std::is_unsigned_v<T>);
    const std::string_view raw = take(sizeof(T));
    T value = 0;
    for (std::size_t i = 0; i < raw.size(); ++i)
      value = static_cast<T>(value | static_cast<T>(static_cast<T>(static_cast<unsigned char>(raw[i])) << (8 * i)));
    return value;
  }
  /// With a length of 32 bits before it.
  std::string_view text() { return take(number<std::uint32_t>()); }
  std::string_view take(std::uint64_t count) {
    if (count > bytes_.size()) is_good_ = false;
    if (!is_good_) return {};
    const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(count));
    bytes_.remove_prefix(taken.size());
    return taken;
  }
  std::string_view rest() const { return bytes_; }
  bool isEmpty() const { return bytes_.empty(); }
  bool isGood() const { return is_good_; }

 private:
  std::string_view bytes_;
  bool is_good_ = true;
};

}  // namespace hapticell::exchange
