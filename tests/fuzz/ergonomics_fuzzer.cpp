// SPDX-License-Identifier: Apache-2.0
// Any bytes as the JSON that `hapticell-cli ergonomics` is given, for every method: refused in words, or scored.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "cli/ergonomics/ergonomics_input.h"
#include "cli/ergonomics/ergonomics_posture_input.h"
#include "mannequin/ergonomics/methods/niosh.h"
#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/ergonomics/methods/reba.h"
#include "mannequin/ergonomics/methods/rula.h"

namespace {

using namespace hapticell;

template <class Result>
bool isRead(const Expected<Result>& result) {
  if (!result && (result.error().message().empty() || result.error().message().find('\n') != std::string::npos))
    std::abort();
  return result.has_value();
}

void score(const ergonomics::ScoredMethod& method, const Expected<cli::ScoredInput>& input) {
  if (!isRead(input)) return;
  const auto assessment = ergonomics::assess(method, input->values);
  if (assessment.least_score > assessment.greatest_score) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) return 0;
  score(ergonomics::Rula(), cli::rulaInput(json));
  score(ergonomics::Reba(), cli::rebaInput(json));
  score(ergonomics::Owas(), cli::owasInput(json));
  if (const auto lifting = cli::liftingInput(json); isRead(lifting)) {
    for (const auto& task : lifting->tasks) isRead(ergonomics::lift(task, lifting->conditions));
  }
  isRead(cli::workTaskInput(json));
  isRead(cli::zonesReport("en1005-4", json));
  isRead(cli::zonesReport("iso11226", json));
  isRead(cli::eawsReport(json));
  return 0;
}
