// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/report_budget.h"

#include <algorithm>

#include "geometry/system/plain_text.h"
#include "haptic/server/clock.h"

namespace hapticell::haptic {

bool ReportBudget::allows(Allowance& allowance, std::int64_t now_ns) {
  const std::int64_t period = toNanoseconds(kLinePeriod);
  if (allowance.used == 0) allowance.since_ns = now_ns;
  const std::int64_t regained = std::max<std::int64_t>(0, now_ns - allowance.since_ns) / period;
  allowance.used -= std::min(allowance.used, static_cast<std::size_t>(regained));
  allowance.since_ns += regained * period;
  if (allowance.used >= kLinesAtOnce) return false;
  ++allowance.used;
  return true;
}

void ReportBudget::tell(Kind kind, const std::string& sentence, std::int64_t now_ns) {
  if (!allows(allowances_[static_cast<std::size_t>(kind)], now_ns)) {
    ++counted(kind);
    return;
  }
  if (say_) say_(plainText(sentence, kLongestSentence));
}

void ReportBudget::summarize(std::int64_t now_ns) {
  const std::uint64_t refused = counted(Kind::kRefused);
  const std::uint64_t others = counted(Kind::kWatcher) + counted(Kind::kController);
  if (refused + others == 0 || now_ns - summarized_ns_ < toNanoseconds(kSummaryPeriod)) return;
  std::string text = "Besides, since the last such line: ";
  if (refused > 0) text += std::to_string(refused) + " connections refused or given up";
  if (refused > 0 && others > 0) text += ", ";
  if (others > 0) text += std::to_string(others) + " comings and goings of clients";
  if (say_) say_(text + ".");
  for (Allowance& allowance : allowances_) allowance.counted = 0;
  summarized_ns_ = now_ns;
}

}  // namespace hapticell::haptic
