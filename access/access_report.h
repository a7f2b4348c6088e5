// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "access/access_answer.h"
#include "mannequin/ergonomics/report/report.h"

namespace hapticell::access {

/// Translates the texts of the page: english(), or the window's language.
using Saying = std::function<std::string(const Text&)>;

/// What the page needs besides the answer.
struct ReportFrame {
  std::string cell;             ///< Name of the workcell.
  std::string date;             ///< As it shall be printed.
  std::string language = "en";  ///< "en" or "fr": that of `say`.
};

/// The page about an answer: result, order, what blocks, persons with their scores, what was assumed. The figure beside
/// it is the person with the highest RULA of those that reach. Write it with ergonomics::writeReport().
ergonomics::Report accessReport(const AccessQuestion& question, const AccessAnswer& answer, const ReportFrame& frame,
                                const Saying& say);

/// The result in one sentence: "Cover can be taken out as the cell stands."
Text resultText(const std::string& part, const AccessAnswer& answer);

/// One sentence about a person: reach, hand, sight.
Text personText(const BodyAccess& person);

}  // namespace hapticell::access
