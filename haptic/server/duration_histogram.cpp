// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/duration_histogram.h"

#include <cmath>

namespace hapticell::haptic {

std::size_t DurationHistogram::bucketOf(std::uint64_t microseconds) noexcept {
  if (microseconds < kSteps) return microseconds;
  const auto doubling = static_cast<std::size_t>(std::bit_width(microseconds)) - 5;
  const std::size_t step = (microseconds >> doubling) - kSteps;
  return std::min((doubling + 1) * kSteps + step, kBuckets - 1);
}

std::uint64_t DurationHistogram::upperEdge(std::size_t bucket) noexcept {
  if (bucket < kSteps) return bucket + 1;
  const std::size_t doubling = bucket / kSteps - 1;
  return (kSteps + bucket % kSteps + 1) << doubling;
}

double DurationHistogram::percentile(double p) const {
  if (count_ == 0) return 0.0;
  const auto wanted = static_cast<std::uint64_t>(std::ceil(std::clamp(p, 0.0, 1.0) * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    seen += buckets_[bucket];
    if (seen >= wanted && seen > 0) return std::min(1e-6 * static_cast<double>(upperEdge(bucket)), max());
  }
  return max();
}

std::uint64_t DurationHistogram::countBelow(double seconds) const {
  std::uint64_t below = 0;
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    if (1e-6 * static_cast<double>(upperEdge(bucket)) <= seconds * (1.0 + 1e-9)) below += buckets_[bucket];
  }
  return below;
}

void DurationHistogram::merge(const DurationHistogram& other) noexcept {
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) buckets_[bucket] += other.buckets_[bucket];
  count_ += other.count_;
  max_ = std::max(max_, other.max_);
}

}  // namespace hapticell::haptic
