// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/report/report_findings.h"

#include <cstdio>

#include "geometry/system/listed.h"

namespace hapticell::ergonomics {

std::string numberWords(const char* form, double value) {
  char text[64];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

std::string phaseWords(const MotionPhase& phase, bool with_frame, Language language) {
  const std::string words = phrase("Worst phase: %1 s to %2 s (%3 s), RULA %4",
                                   {numberWords("%.2f", phase.from_s), numberWords("%.2f", phase.to_s),
                                    numberWords("%.2f", phase.to_s - phase.from_s), std::to_string(phase.rula)},
                                   language);
  return with_frame ? phrase("%1; shown at %2 s", {words, numberWords("%.2f", phase.at_s)}, language) : words;
}

ReportBlock workplaceBlock(const WorkplaceFinding& found, Language language) {
  ReportBlock block{word("Search of the workplace", language), {}};
  block.lines.push_back(phrase("Moved, and nothing else: %1", {listed(found.moves)}, language));
  if (!found.is_found) {
    block.lines.push_back(word("No place was found that suits all four bodies.", language));
    return block;
  }
  const char* const bodies[]{"P5F", "P50F", "P50M", "P95M"};
  std::string rula;
  for (std::size_t i = 0; i < found.rula.size(); ++i)
    rula += (i == 0 ? "" : ", ") + std::string(bodies[i]) + " " + std::to_string(found.rula[i]);
  block.lines.push_back(phrase("Best place: %1 mm up, %2 mm away, %3; RULA %4",
                               {numberWords("%+.0f", 1000.0 * found.rise), numberWords("%+.0f", 1000.0 * found.away),
                                word(found.is_seated ? "sitting" : "standing", language), rula},
                               language));
  return block;
}

}  // namespace hapticell::ergonomics
