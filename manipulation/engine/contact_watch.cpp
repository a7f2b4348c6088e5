// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/contact_watch.h"

#include <algorithm>

namespace hapticell::manipulation {

namespace {

/// ns between two looks at pairs that pass, as no row tells of them: 100 Hz. Half: twice the queries; twice: up to 20
/// ms late, a picture.
constexpr std::int64_t kPassedPeriod = 10'000'000;
/// m of gap at which a contact begins and ends: 0.05 is over the skin and the lag (0.02 mm), 0.2 over a trembling hand.
/// Half: light contacts are not shown, or chatter; twice: shown before they are felt.
constexpr double kContactIn = 5e-5, kContactOut = 2e-4;

bool isIn(const std::vector<std::size_t>& pairs, std::size_t pair) {
  return std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
}

}  // namespace

void ContactWatch::clear() {
  contacts_.clear();
  passed_.clear();
  passed_ns_ = -1;
}

bool ContactWatch::isInContact(std::size_t pair) const {
  return isIn(contacts_, pair);
}

void ContactWatch::look(HeldEntity& held, const BuiltConstraints& built, const Pose& X_DP, std::int64_t now_ns,
                        std::int64_t felt_ns) {
  gaps_.resize(held.pairs().size());
  pairGaps(built, X_DP, gaps_);
  std::vector<std::size_t> now;
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    if (gaps_[i] < (isInContact(i) ? kContactOut : kContactIn)) now.push_back(i);
  }
  lookAtPassed(held, now_ns);
  now.insert(now.end(), passed_.begin(), passed_.end());
  if (std::any_of(now.begin(), now.end(), [this](std::size_t i) { return !isInContact(i); })) felt_ns_ = felt_ns;
  contacts_.swap(now);
}

/// Pairs that pass have no row in the set that could tell of their contact: they are measured.
void ContactWatch::lookAtPassed(HeldEntity& held, std::int64_t now_ns) {
  if (passed_ns_ >= 0 && now_ns - passed_ns_ < kPassedPeriod && now_ns >= passed_ns_) return;
  passed_ns_ = now_ns;
  const auto passes = [](const HeldPair& pair) { return pair.on_contact == workcell::OnContact::kPass; };
  const auto& pairs = held.pairs();
  std::vector<FreeMotion::PairDistance> near;
  if (std::any_of(pairs.begin(), pairs.end(), passes)) held.distances(kContactOut, near);
  std::vector<std::size_t> now;
  for (const FreeMotion::PairDistance& one : near) {
    const double least = isIn(passed_, one.pair) ? kContactOut : kContactIn;
    if (passes(pairs[one.pair]) && (one.result.colliding || one.result.distance < least)) now.push_back(one.pair);
  }
  passed_.swap(now);
}

}  // namespace hapticell::manipulation
