// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/loop_statistics.h"

#include "haptic/server/clock.h"

namespace hapticell::haptic {

namespace {

// ns: figures are of the last one to two windows, 5 to 10 s. Our choice: a user sees what just happened. Half: p99 of
// 2500 ticks only; twice: a stall stays on show for 20 s.
constexpr std::int64_t kWindow = 5'000'000'000;

}  // namespace

ServerStatistics statisticsOf(const LoopFigures& figures, const LinkFigures& link) {
  ServerStatistics s;
  s.rate_hz = figures.rate_hz;
  s.late_p50_ms = 1e3 * figures.recent_lateness.percentile(0.5);
  s.late_p99_ms = 1e3 * figures.recent_lateness.percentile(0.99);
  s.late_max_ms = 1e3 * figures.recent_lateness.max();
  s.ticks = figures.ticks;
  s.missed_ticks = figures.missed;
  s.round_trip_ms = 1e3 * link.round_trip;
  s.set_age_p50_ms = 1e3 * figures.recent_set_age.percentile(0.5);
  s.set_age_p99_ms = 1e3 * figures.recent_set_age.percentile(0.99);
  s.late_sets = figures.late_sets;
  s.refused_sets = figures.refused_sets;
  s.dropped_sets = figures.dropped_sets;
  if (link.clock_offset) s.clock_offset_ms = 1e3 * *link.clock_offset;
  return s;
}

LoopStatistics::LoopStatistics(double rate_hz) noexcept
    : ticks_between_(static_cast<std::uint32_t>(std::max(1.0, rate_hz / 10.0))) {}

void LoopStatistics::addTick(std::int64_t now, std::int64_t late_ns, std::uint32_t skipped) noexcept {
  if (ticks_ == 0) {
    window_start_ = now;
    marks_.fill({now, 1});
  }
  ++ticks_;
  ++ticks_since_figures_;
  missed_ += skipped;
  lateness_.add(late_ns);
  recent_[newest_].lateness.add(late_ns);
}

void LoopStatistics::addSetAge(std::int64_t age_ns) noexcept {
  recent_[newest_].set_age.add(age_ns);
  if (age_ns > toNanoseconds(kLateSetAge)) ++late_sets_;
}

void LoopStatistics::collect(std::int64_t now, LoopFigures& figures) noexcept {
  ticks_since_figures_ = 0;
  Mark& oldest = marks_[next_mark_];
  const double elapsed = kSecondsPerNanosecond * static_cast<double>(now - oldest.stamp);
  figures.rate_hz = elapsed > 0.0 ? static_cast<double>(ticks_ - oldest.ticks) / elapsed : 0.0;
  oldest = {now, ticks_};
  next_mark_ = (next_mark_ + 1) % marks_.size();
  figures.ticks = ticks_;
  figures.missed = missed_;
  figures.late_sets = late_sets_;
  figures.refused_sets = refused_sets_;
  figures.dropped_sets = dropped_sets_;
  figures.refused_samples = refused_samples_;
  figures.lateness = lateness_;
  figures.recent_lateness = recent_[0].lateness;
  figures.recent_lateness.merge(recent_[1].lateness);
  figures.recent_set_age = recent_[0].set_age;
  figures.recent_set_age.merge(recent_[1].set_age);
  if (now - window_start_ < kWindow) return;
  window_start_ = now;
  newest_ = 1 - newest_;
  recent_[newest_] = {};
}

}  // namespace hapticell::haptic
