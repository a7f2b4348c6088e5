// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/system/text.h"
#include "manipulation/engine/manipulation_command.h"

namespace hapticell::manipulation {

/// What happened, in order, until somebody takes it. The manipulation thread's.
class ResultLog {
 public:
  /// One of what a Result can be.
  template <typename One>
  void add(One result) {
    results_.emplace_back(std::move(result));
  }
  /// A sentence for the user.
  void notice(Text sentence);
  /// Tells a sentence the first time only.
  void noticeOnce(Text sentence);
  /// What was added since the last call.
  std::vector<Result> take();

 private:
  std::vector<Result> results_;
  std::set<std::string> told_;
};

}  // namespace hapticell::manipulation
