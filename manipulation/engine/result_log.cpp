// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/result_log.h"

namespace hapticell::manipulation {

void ResultLog::notice(const std::string& sentence) {
  results_.emplace_back(result::Notice{sentence});
}

void ResultLog::noticeOnce(const std::string& sentence) {
  if (told_.insert(sentence).second) notice(sentence);
}

std::vector<Result> ResultLog::take() {
  std::vector<Result> taken;
  taken.swap(results_);
  return taken;
}

}  // namespace hapticell::manipulation
