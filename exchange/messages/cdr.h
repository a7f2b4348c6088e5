// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hapticell::exchange {

/// Writes the common data representation that ROS 2 uses on the wire and in files (OMG CDR, plain, low byte first, XCDR
/// version 1): numbers at multiples of their size, counted from the end of the four bytes of the header.
class CdrWriter {
 public:
  CdrWriter();
  void add(std::uint8_t value);
  void add(std::int32_t value);
  void add(std::uint32_t value);
  void add(float value);
  void add(double value);
  /// With its length and a closing zero.
  void add(std::string_view value);
  void add(std::span<const double> values);
  void add(std::span<const float> values);
  void add(std::span<const std::int32_t> values);
  void add(std::span<const std::string> values);
  /// Number of elements of a sequence whose elements follow.
  void addCount(std::size_t count);
  std::string take() { return std::move(bytes_); }

 private:
  template <typename Unsigned>
  void put(Unsigned value);

  std::string bytes_;
};

/// Reads it, in either byte order. Once something is missing, isGood() is false for good and every further answer is
/// zero or empty. The bytes must outlive it.
class CdrReader {
 public:
  /// Not good: fewer than four bytes, or another representation than plain CDR.
  explicit CdrReader(std::string_view bytes);
  std::uint8_t byte();
  std::int32_t int32();
  std::uint32_t uint32();
  float float32();
  double float64();
  std::string text();
  std::vector<double> doubles();
  std::vector<float> floats();
  std::vector<std::int32_t> ints();
  std::vector<std::string> texts();
  /// Elements that follow; not good where the rest cannot hold that many of at least `least_size` bytes.
  std::size_t count(std::size_t least_size);
  bool isGood() const { return is_good_; }

 private:
  template <typename Unsigned>
  Unsigned get();

  std::string_view bytes_;  // Behind the header.
  std::size_t at_ = 0;
  bool is_good_ = true, is_swapped_ = false;
};

}  // namespace hapticell::exchange
