// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/system/text.h"
#include "manipulation/engine/manipulation_command.h"

namespace hapticell::manipulation {

/// Results in order, until they are taken. Manipulation thread only.
class ResultLog {
 public:
  /// One alternative of Result.
  template <typename One>
  void add(One result) {
    results_.emplace_back(std::move(result));
  }
  /// A sentence for the user.
  void notice(Text sentence);
  /// Adds a sentence only if it was not added before.
  void noticeOnce(Text sentence);
  /// The results added since the last call.
  std::vector<Result> take();

 private:
  std::vector<Result> results_;
  std::set<std::string> told_;
};

}  // namespace hapticell::manipulation
