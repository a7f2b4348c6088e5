// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "geometry/shapes/pose.h"

namespace hapticell::workcell {

/// Puts values behind each other, as this machine has them: for another process of the same build.
class PackedWriter {
 public:
  template <typename T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    raw(&value, sizeof value);
  }
  void text(const std::string& text) {
    number(static_cast<std::uint32_t>(text.size()));
    bytes.append(text);
  }
  void raw(const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); }
  void pose(const Pose& X) {
    for (double value : {X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z}) number(value);
  }
  std::string bytes;
};

/// Takes values off the front of any bytes; `failed` stays true from the first one that is not there or not sound, and
/// all that is read from then on is 0 or empty.
class PackedReader {
 public:
  explicit PackedReader(std::string_view bytes) : rest_(bytes) {}

  bool failed = false;
  std::size_t left() const { return rest_.size(); }

  /// Finite.
  template <typename T>
  T number() {
    const T value = anyNumber<T>();
    if constexpr (std::is_floating_point_v<T>) require(std::isfinite(value));
    return value;
  }
  template <typename T>
  T anyNumber() {
    static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);
    T value{};
    take(&value, sizeof value);
    return value;
  }
  std::string text() {
    const auto size = number<std::uint32_t>();
    if (!require(size <= rest_.size())) return {};
    std::string result(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return result;
  }
  /// How many of something of at least `smallest` bytes follow.
  std::size_t count(std::size_t smallest) {
    const auto n = number<std::uint64_t>();
    return require(n <= rest_.size() / smallest) ? static_cast<std::size_t>(n) : 0;
  }
  void take(void* data, std::size_t size) {
    if (!require(size <= rest_.size()) || size == 0) return;
    std::memcpy(data, rest_.data(), size);
    rest_.remove_prefix(size);
  }
  /// Finite, with a unit quaternion.
  Pose pose() {
    const Pose X = anyPose();
    require(X.isValid());
    return X;
  }
  Pose anyPose() {
    Pose X;
    for (int k = 0; k < 3; ++k) X.p[k] = anyNumber<double>();
    X.q.w = anyNumber<double>();
    X.q.x = anyNumber<double>();
    X.q.y = anyNumber<double>();
    X.q.z = anyNumber<double>();
    return X;
  }
  bool require(bool sound) {
    if (!sound) failed = true;
    if (failed) rest_ = {};
    return !failed;
  }

 private:
  std::string_view rest_;
};

}  // namespace hapticell::workcell
