// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace hapticell::haptic {

/// Counts durations from 1 us to about a minute in buckets of at most 6 % width, in fixed memory.
///
/// Below 16 us a bucket is one microsecond wide; above, each doubling is divided into 16. A value type; add() does not
/// allocate or throw.
class DurationHistogram {
 public:
  /// Adds one duration in nanoseconds; a negative one counts as zero.
  void add(std::int64_t nanoseconds) noexcept {
    const std::int64_t duration = std::max<std::int64_t>(nanoseconds, 0);
    ++buckets_[bucketOf(static_cast<std::uint64_t>(duration) / 1000)];
    ++count_;
    max_ = std::max(max_, duration);
  }

  std::uint64_t count() const { return count_; }

  /// The longest duration, exact, seconds; 0 when empty.
  double max() const { return 1e-9 * static_cast<double>(max_); }

  /// The duration below which the share `p` in [0, 1] of all durations lies, seconds (upper edge of its bucket); 0 when
  /// empty.
  double percentile(double p) const;

  /// How many durations lie in buckets that end at or below `seconds`.
  std::uint64_t countBelow(double seconds) const;

  void merge(const DurationHistogram& other) noexcept;
  void clear() noexcept { *this = {}; }

 private:
  // Buckets in a doubling: each at most 6 % wide. Half: percentiles are 12 % coarse; twice: 3 %, and twice the memory.
  static constexpr std::size_t kSteps = 16;
  static constexpr std::size_t kDoublings = 22;  // 16 us * 2^22 = 67 s.
  static constexpr std::size_t kBuckets = kSteps * (kDoublings + 1);

  static std::size_t bucketOf(std::uint64_t microseconds) noexcept;
  static std::uint64_t upperEdge(std::size_t bucket) noexcept;  ///< Microseconds, not included.

  std::array<std::uint32_t, kBuckets> buckets_{};
  std::uint64_t count_ = 0;
  std::int64_t max_ = 0;
};

}  // namespace hapticell::haptic
