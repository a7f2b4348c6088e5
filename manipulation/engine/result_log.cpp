// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/result_log.h"

namespace hapticell::manipulation {

void ResultLog::notice(Text sentence) {
  results_.emplace_back(result::Notice{std::move(sentence)});
}

void ResultLog::noticeOnce(Text sentence) {
  if (told_.insert(english(sentence)).second) notice(std::move(sentence));
}

std::vector<Result> ResultLog::take() {
  std::vector<Result> taken;
  taken.swap(results_);
  return taken;
}

}  // namespace hapticell::manipulation
