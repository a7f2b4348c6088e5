// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/writing/program_numbers.h"

#include <algorithm>
#include <cmath>

#include "trajectory/motion/csv_table.h"
#include "trajectory/motion/number_text.h"

namespace hapticell::trajectory {

namespace {

constexpr double kMillimetresPerMetre = 1000.0;
constexpr double kPercent = 100.0;
// Of the number asked for: a speed or blend that a language rounds by more is reported. Half: messages on 0.05 %;
// twice: 0.2 % pass unsaid.
constexpr double kNotedRounding = 1e-3;
constexpr NumberRule kNoNumber{"", 1.0, 0.0, 0.0, 0};

// $VEL.CP up to the greatest $VEL_MA.CP, 3 m/s. $VEL_AXIS in whole percent.
constexpr ProgramNumbers kKrl{"KUKA KRL",
                              {"m/s", 1.0, 1e-4, 3.0, 6},
                              {"m/s2", 1.0, 1e-3, 1000.0, 4},
                              {"%", kPercent, 1.0, 100.0, 0},
                              {"mm", kMillimetresPerMetre, 1e-3, 10000.0, 3},
                              {"s", 1.0, 1e-3, 1e6, 3}};
// v_tcp and zones in mm; the first move has the lines' speed.
constexpr ProgramNumbers kRapid{"ABB RAPID", {"mm/s", kMillimetresPerMetre, 1e-2, 7000.0, 3}, kNoNumber,
                                kNoNumber,   {"mm", kMillimetresPerMetre, 1e-3, 10000.0, 3},  {"s", 1.0, 1e-3, 1e6, 3}};
// Whole mm/sec and percent; WAIT 0.01 to 327.67 sec. Rounding is CNT, a share of the way.
constexpr ProgramNumbers kFanuc{"FANUC",   {"mm/sec", kMillimetresPerMetre, 1.0, 4000.0, 0},
                                kNoNumber, {"%", kPercent, 1.0, 100.0, 0},
                                kNoNumber, {"sec", 1.0, 0.01, 327.67, 2}};
constexpr ProgramNumbers kUrScript{"URScript",
                                   {"m/s", 1.0, 1e-4, 10.0, 6},
                                   {"m/s2", 1.0, 1e-3, 1000.0, 4},
                                   {"rad/s", 3.14, 1e-3, 3.14, 4},
                                   {"m", 1.0, 1e-6, 10.0, 6},
                                   {"s", 1.0, 1e-3, 1e6, 3}};
constexpr ProgramNumbers kVal3{"Stäubli VAL3",
                               {"mm/s", kMillimetresPerMetre, 1e-2, 10000.0, 3},
                               kNoNumber,
                               {"%", kPercent, 0.01, 100.0, 2},
                               {"mm", kMillimetresPerMetre, 1e-3, 10000.0, 3},
                               {"s", 1.0, 1e-3, 1e6, 3}};
// V 0.1 to 1500.0 mm/s, VJ 0.01 to 100.00 %, TIMER 0.01 to 655.35 s.
constexpr ProgramNumbers kInform{"Motoman INFORM",
                                 {"mm/s", kMillimetresPerMetre, 0.1, 1500.0, 1},
                                 kNoNumber,
                                 {"%", kPercent, 0.01, 100.0, 2},
                                 {"mm", kMillimetresPerMetre, 0.1, 6553.5, 1},
                                 {"s", 1.0, 0.01, 655.35, 2}};

}  // namespace

const ProgramNumbers& programNumbers(ProgramFormat format) {
  switch (format) {
    case ProgramFormat::kKrl:
      return kKrl;
    case ProgramFormat::kRapid:
      return kRapid;
    case ProgramFormat::kFanuc:
      return kFanuc;
    case ProgramFormat::kUrScript:
      return kUrScript;
    case ProgramFormat::kVal3:
      return kVal3;
    case ProgramFormat::kInform:
      return kInform;
  }
  return kKrl;
}

std::string NumberWriter::text(const NumberRule& rule, double value, const Text& kind, const Text& place) {
  const double wanted = rule.scale * value;
  std::string written = fixedText(wanted, rule.decimals);
  const double got = parseNumber(written).value_or(0.0);
  // A hair of tolerance: 0.001 m is 1.0000000000000002e0 of something else.
  if (!std::isfinite(wanted) || wanted < rule.least * (1.0 - 1e-9) || wanted > rule.greatest * (1.0 + 1e-9)) {
    if (!error_) {
      error_ = Error{.place = place.empty() ? kind : Text("%1, %2", kind, place),
                     .found = Text("%1 %2", shortestText(wanted), rule.unit),
                     .expected = Text("%1 to %2 %3, the range of %4", shortestText(rule.least),
                                      shortestText(rule.greatest), rule.unit, numbers_.language),
                     .fix = Text("Choose another %1. Nothing was written.", kind)};
    }
    return written;
  }
  const bool is_noted = std::find(noted_kinds_.begin(), noted_kinds_.end(), kind) != noted_kinds_.end();
  if (std::abs(got - wanted) > kNotedRounding * wanted && !is_noted) {
    noted_kinds_.push_back(kind);
    const std::string given = shortestText(wanted);
    notes_.push_back(place.empty() ? Text("The %1, %2 %3, is rounded to %4 %3, because %5 allows no more digits.", kind,
                                          given, rule.unit, written, numbers_.language)
                                   : Text("The %1 of %6, %2 %3, is rounded to %4 %3, because %5 allows no more digits.",
                                          kind, given, rule.unit, written, numbers_.language, place));
  }
  return written;
}

}  // namespace hapticell::trajectory
