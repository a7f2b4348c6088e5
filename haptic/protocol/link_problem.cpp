// SPDX-License-Identifier: Apache-2.0
#include "haptic/protocol/link_problem.h"

namespace hapticell::haptic {

Text wholeText(const LinkProblem& problem) {
  if (problem.what.empty()) return problem.fix;
  return problem.fix.empty() ? problem.what : Text("%1 %2", problem.what, problem.fix);
}

std::string english(const LinkProblem& problem) {
  return hapticell::english(wholeText(problem));
}

LinkProblem problemOf(const Refusal& refusal) {
  const std::string& subject = refusal.subject;
  switch (refusal.reason) {
    case RefusalReason::kControlled:
      return {Text("Another program (%1) controls the stylus.", subject), Text("Close it, or connect as a watcher.")};
    case RefusalReason::kTakenOver:
      return {Text("%1 took the stylus.", subject)};
    case RefusalReason::kSilent:
      return {Text("Silent for too long: %1 controls the stylus now.", subject)};
    case RefusalReason::kFull:
      return {Text("The haptic server has its %1 connections already.", subject),
              Text("Close a window or program that watches.")};
    case RefusalReason::kFullOfMachine:
      return {Text("The haptic server has %1 connections from this machine already.", subject),
              Text("Close a window or program that watches.")};
    case RefusalReason::kOther:
      break;
  }
  return {Text::plain(refusal.sentence)};
}

}  // namespace hapticell::haptic
