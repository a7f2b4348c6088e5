// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/report/report_findings.h"

#include <cstdio>

#include "geometry/system/listed.h"

namespace hapticell::ergonomics {
namespace {

const char* colonOf(Language language) {
  return language == Language::kFrench ? " : " : ": ";
}

}  // namespace

std::string numberWords(const char* form, double value) {
  char text[64];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

std::string phaseWords(const MotionPhase& phase, bool with_frame, Language language) {
  const bool french = language == Language::kFrench;
  std::string words = word("Worst phase", language) + colonOf(language) + numberWords("%.2f s", phase.from_s);
  words += french ? " à " : " to ";
  words += numberWords("%.2f s", phase.to_s) + numberWords(" (%.2f s)", phase.to_s - phase.from_s);
  words += ", RULA " + std::to_string(phase.rula);
  if (with_frame) words += (french ? " ; montrée à " : "; shown at ") + numberWords("%.2f s", phase.at_s);
  return words;
}

ReportBlock workplaceBlock(const WorkplaceFinding& found, Language language) {
  const bool french = language == Language::kFrench;
  ReportBlock block{word("Search of the workplace", language), {}};
  block.lines.push_back(word("Moved, and nothing else", language) + colonOf(language) + listed(found.moves));
  if (!found.is_found) {
    block.lines.push_back(word("No place was found that suits all four bodies.", language));
    return block;
  }
  std::string place = word("Best place", language) + colonOf(language) + numberWords("%+.0f mm", 1000.0 * found.rise);
  place += french ? " en hauteur, " : " up, ";
  place += numberWords("%+.0f mm", 1000.0 * found.away) + (french ? " en profondeur, " : " away, ");
  place += word(found.is_seated ? "sitting" : "standing", language) + "; RULA ";
  const char* const bodies[]{"P5F", "P50F", "P50M", "P95M"};
  for (std::size_t i = 0; i < found.rula.size(); ++i)
    place += (i == 0 ? "" : ", ") + std::string(bodies[i]) + " " + std::to_string(found.rula[i]);
  block.lines.push_back(place);
  return block;
}

}  // namespace hapticell::ergonomics
