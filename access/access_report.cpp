// SPDX-License-Identifier: Apache-2.0
#include "access/access_report.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "geometry/system/listed.h"
#include "mannequin/ergonomics/report/posture_report.h"

namespace hapticell::access {

namespace {

using ergonomics::Report;
using ergonomics::ReportBlock;
using Cell = ReportBlock::Cell;

class Page {
 public:
  Page(const AccessQuestion& question, const AccessAnswer& answer, const Saying& say)
      : question_(question), answer_(answer), say_(say) {}

  Report make(const ReportFrame& frame) const {
    Report report;
    report.title = say_(Text("Access for maintenance"));
    report.subtitle = frame.cell + ": " + question_.part;
    report.date = frame.date;
    report.language = frame.language;
    report.result_words = say_(resultText(question_.part, answer_));
    report.result_band = 0;
    if (!answer_.removable) report.result_band = answer_.order.empty() ? 3 : 1;
    if (const BodyAccess* worst = worstPerson())
      report.picture = ergonomics::reportPicture(worst->figure, worst->posture, worst->scores, ergonomics::ColourMethod::kRula);
    if (!answer_.order.empty()) report.blocks.push_back(order());
    if (!answer_.blocked_by.empty()) report.blocks.push_back(blockers());
    if (!answer_.order.empty()) report.blocks.push_back(neighbours());
    if (!answer_.people.empty()) report.blocks.push_back(people());
    report.blocks.push_back(assumptions());
    return report;
  }

 private:
  std::string length(double metres) const { return say_(Text("%1", Text::Length{metres})); }
  std::string yes(bool is) const { return is ? say_(Text("yes")) : say_(Text("no")); }

  const BodyAccess* worstPerson() const {
    const BodyAccess* worst = nullptr;
    for (const BodyAccess& person : answer_.people)
      if (person.reached && (worst == nullptr || person.scores.rula() > worst->scores.rula())) worst = &person;
    return worst;
  }

  ReportBlock order() const {
    ReportBlock block;
    block.heading = say_(Text("Order of removal"));
    block.columns = {say_(Text("Step")), say_(Text("Part")), say_(Text("Way")), say_(Text("Length"))};
    for (std::size_t i = 0; i < answer_.order.size(); ++i) {
      const RemovalStep& step = answer_.order[i];
      block.rows.push_back({{std::to_string(i + 1)}, {step.name}, {wayWords(step.way)}, {length(step.way.length())}});
    }
    return block;
  }

  std::string wayWords(const RemovalWay& way) const {
    switch (way.kind) {
      case RemovalWay::Kind::kStraight: return say_(Text("straight"));
      case RemovalWay::Kind::kBent: return say_(Text("in several pieces"));
      case RemovalWay::Kind::kPlanned: return say_(Text("planned"));
      case RemovalWay::Kind::kShown: return say_(Text("shown by hand"));
    }
    return {};
  }

  ReportBlock blockers() const {
    ReportBlock block;
    block.heading = say_(Text("What blocks it as the cell stands"));
    block.lines.push_back(listed(answer_.blocked_by) + ".");
    if (!answer_.overlaps.empty())
      block.lines.push_back(say_(Text("It overlaps %1 at rest, by more than counts as touching.", listed(answer_.overlaps))));
    return block;
  }

  ReportBlock neighbours() const {
    ReportBlock block;
    block.heading = say_(Text("Clearances on its way"));
    block.columns = {say_(Text("Neighbour")), say_(Text("Least clearance")), say_(Text("After")), say_(Text("Touches at rest"))};
    for (const NeighbourClearance& one : answer_.step()->clearances) {
      if (block.rows.size() == 10) break;  // The nearest; a page has no room for more.
      const bool known = std::isfinite(one.least_m);
      block.rows.push_back({{one.name},
                            {known ? length(one.least_m) : say_(Text("leaves at once"))},
                            {known ? length(one.at_m) : std::string()},
                            {yes(one.touches_at_rest)}});
    }
    return block;
  }

  ReportBlock people() const {
    ReportBlock block;
    block.heading = say_(Text("Persons"));
    block.columns = {say_(Text("Person")), say_(Text("Reaches")), say_(Text("Sees")), "RULA", "REBA", "OWAS", say_(Text("Remark"))};
    for (const BodyAccess& person : answer_.people) {
      const auto& scores = person.scores;
      std::vector<Cell> row{{person.name}, {yes(person.reached), person.reached ? 0 : 3}};
      row.push_back({std::to_string(std::lround(100.0 * person.sight.seen)) + " %"});
      row.push_back({std::to_string(scores.rula()), ergonomics::bandOfRula(scores.rula())});
      row.push_back({std::to_string(scores.reba()), ergonomics::bandOfReba(scores.reba())});
      row.push_back({std::to_string(scores.owas_category), ergonomics::bandOfOwas(scores.owas_category)});
      row.push_back({person.why.empty() ? say_(Text("stays with it on %1 % of the way", std::lround(100.0 * person.along)))
                                        : person.why});
      if (person.short_m > 2e-3)
        for (std::size_t i = 3; i < 6; ++i) row[i] = {"-"};
      block.rows.push_back(std::move(row));
    }
    return block;
  }

  ReportBlock assumptions() const {
    ReportBlock block;
    block.heading = say_(Text("What was assumed"));
    block.lines.push_back(say_(Text("Overlap of up to %1 counts as touching.", Text::Length{question_.tolerance})));
    block.lines.push_back(say_(Text("Parts are rigid; what holds a part only by friction or a thread holds nothing.")));
    if (!answer_.people.empty()) {
      block.lines.push_back(say_(Text("Room for a glove: %1 around the hand. The part weighs %2 kg.",
                                      Text::Length{question_.people.glove}, std::to_string(question_.people.load_kg))));
      if (question_.people.tool.length > 0.0)
        block.lines.push_back(say_(Text("With a tool, %1 long, %2 thick.", Text::Length{question_.people.tool.length},
                                        Text::Length{2.0 * question_.people.tool.radius})));
    }
    if (!answer_.is_shortest)
      block.lines.push_back(say_(Text("A shorter order may exist: this one was not proven to be the shortest.")));
    for (const Text& note : answer_.removal->notes()) block.lines.push_back(say_(note));
    return block;
  }

  const AccessQuestion& question_;
  const AccessAnswer& answer_;
  const Saying& say_;
};

}  // namespace

Report accessReport(const AccessQuestion& question, const AccessAnswer& answer, const ReportFrame& frame,
                    const Saying& say) {
  return Page(question, answer, say).make(frame);
}

Text resultText(const std::string& part, const AccessAnswer& answer) {
  if (!answer.is_complete) return Text("Cancelled before everything was answered.");
  if (answer.removable) return Text("%1 can be taken out as the cell stands.", part);
  if (answer.order.empty()) return Text("No way out was found for %1.", part);
  const std::size_t before = answer.order.size() - 1;
  return before == 1 ? Text("%1 can be taken out once %2 has gone.", part, answer.order.front().name)
                     : Text("%1 can be taken out once %2 parts have gone.", part, before);
}

Text personText(const BodyAccess& person) {
  const auto seen = std::lround(100.0 * person.sight.seen);
  if (!person.reached) return Text("%1: %2; sees %3 % of the part.", person.name, person.why, seen);
  return Text("%1 reaches it and stays with it on %2 % of the way; sees %3 % of the part.", person.name,
              std::lround(100.0 * person.along), seen);
}

}  // namespace hapticell::access
