// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/report/posture_report.h"

#include <cmath>
#include <cstdio>
#include <optional>

#include "mannequin/ergonomics/advice/advice_words.h"
#include "mannequin/ergonomics/report/report_findings.h"
#include "mannequin/ergonomics/scores/hand_force.h"
#include "mannequin/shape/figure_outline.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Dimension;
using mannequin::Side;
using Cell = ReportBlock::Cell;

/// Writes one report; keeps the language.
class Writer {
 public:
  explicit Writer(const PostureReportInput& input)
      : input_(input),
        pose_(mannequin::forwardKinematics(input.figure, input.posture)),
        scores_(scorePosture(input.figure, input.posture, pose_, input.task)) {}

  Report posture() const {
    Report report = head("Posture assessment");
    if (!input_.bodies.empty()) report.blocks.push_back(bodies());
    report.blocks.push_back(drives());
    if (!input_.history.empty()) report.blocks.push_back(history());
    report.blocks.push_back(subScores());
    report.blocks.push_back(zones());
    ReportBlock assumed = limits();
    assumed.lines.push_back(sourceLine());
    report.blocks.push_back(std::move(assumed));
    report.blocks.push_back(joints());
    return report;
  }

  Report taskPage() const {
    Report report = head("Task assessment");
    if (!input_.history.empty()) report.blocks.push_back(history());
    if (!input_.bodies.empty()) report.blocks.push_back(bodies());
    report.blocks.push_back(drives());
    if (input_.workplace) report.blocks.push_back(workplaceBlock(*input_.workplace, language()));
    if (input_.task.is_lift) report.blocks.push_back(lifting());
    report.blocks.push_back(forces());
    report.blocks.push_back(limits());
    report.blocks.back().lines.push_back(sourceLine());
    return report;
  }

 private:
  Language language() const { return input_.language; }
  std::string say(std::string_view english) const { return word(english, language()); }
  std::string say(std::string_view form, const std::vector<std::string>& values) const {
    return phrase(form, values, language());
  }

  Report head(std::string_view title) const {
    Report report;
    report.title = say(title);
    report.subtitle = input_.subtitle;
    report.date = input_.date;
    report.language = codeOf(language());
    report.company = input_.company;
    report.logo = input_.logo;
    report.scene = input_.scene;
    report.picture = reportPicture(input_.figure, input_.posture, scores_, ColourMethod::kRula);
    report.beside = {body(), task()};
    report.result = std::to_string(scores_.rula());
    report.result_band = bandOfRula(scores_.rula());
    report.result_words = "RULA, " + rulaAdvice(scores_.rula(), language());
    report.under_result = {methods()};
    report.signatures = {say("Assessed by"), say("Date"), say("Signature")};
    return report;
  }

  ReportBlock body() const {
    ReportBlock block{say("Body"), {}};
    const auto& figure = input_.figure;
    const double stature = figure.body[Dimension::kStature];
    block.lines.push_back(say(figure.sex == mannequin::Sex::kMale ? "man" : "woman") + ", P" +
                          numberWords("%.0f", mannequin::percentileOfStature(figure.sex, stature)) + ", ANSUR II");
    block.lines.push_back(say("Stature") + " " + numberWords("%.0f mm", 1000.0 * stature) + ", " +
                          numberWords("%.0f kg", figure.totalMass()));
    return block;
  }

  std::string known(const std::optional<double>& value, const char* form) const {
    return value ? numberWords(form, *value) : say("not entered");
  }

  ReportBlock task() const {
    const WorkTask& task = input_.task;
    ReportBlock block{say("Task"), {task.name == WorkTask{}.name ? say("Task") : task.name}};
    block.lines.push_back(
        say("Load left %1, right %2", {known(task.load_kg[0], "%.1f kg"), known(task.load_kg[1], "%.1f kg")}));
    block.lines.push_back(say("Repetitions %1, shift %2",
                              {known(task.repetitions_per_min, "%.1f / min"), known(task.duration_h, "%.1f h")}));
    std::string held = say("not entered");
    if (task.is_static) held = say(*task.is_static ? "yes" : "no");
    block.lines.push_back(say("Held for over a minute: %1", {held}));
    if (!task.note.empty()) block.lines.push_back(task.note);
    return block;
  }

  ReportBlock methods() const {
    ReportBlock block{{}, {}, {say("Method"), say("left"), say("right"), say("Level")}};
    const auto& left = scores_.sides[0];
    const auto& right = scores_.sides[1];
    block.rows.push_back({{"RULA"},
                          {std::to_string(left.rula_score), bandOfRula(left.rula_score)},
                          {std::to_string(right.rula_score), bandOfRula(right.rula_score)},
                          {rulaAdvice(scores_.rula(), language())}});
    block.rows.push_back({{"REBA"},
                          {std::to_string(left.reba_score), bandOfReba(left.reba_score)},
                          {std::to_string(right.reba_score), bandOfReba(right.reba_score)},
                          {rebaAdvice(scores_.reba(), language())}});
    block.rows.push_back(
        {{"OWAS"},
         {std::to_string(scores_.owasCode()), bandOfOwas(scores_.owas_category)},
         {},
         {std::to_string(scores_.owas_category) + ", " + owasAdvice(scores_.owas_category, language())}});
    block.rows.push_back({{"EN 1005-4"},
                          zoneCell(left.en1005),
                          zoneCell(right.en1005),
                          {zoneWord(std::max(left.en1005.worst, right.en1005.worst))}});
    block.rows.push_back({{"ISO 11226"},
                          zoneCell(left.iso11226),
                          zoneCell(right.iso11226),
                          {zoneWord(std::max(left.iso11226.worst, right.iso11226.worst))}});
    block.rows.push_back(
        {{"EAWS"},
         {numberWords("%.0f", scores_.eaws_points), bandOf(zoneOfLevel(eawsLevel(scores_.eaws_points)))},
         {},
         {say(nameOf(scores_.eaws))}});
    return block;
  }

  Cell zoneCell(const PartVerdicts& verdicts) const { return {"", bandOf(verdicts.worst)}; }
  std::string zoneWord(Zone zone) const { return say(nameOf(zone)); }

  ReportBlock bodies() const {
    ReportBlock block{say("Four bodies at the same task"),
                      {},
                      {say("Body size"), "RULA", "REBA", "OWAS", say("Driver"), say("Reach")}};
    for (const BodyAtTask& body : input_.bodies) {
      const MainDriver driver = mainDriver(body.scores, language());
      const std::string reach = body.is_reached
                                    ? numberWords("%.0f mm", 1000.0 * body.reach_left_m)
                                    : say("not reached, short by") + numberWords(" %.0f mm", 1000.0 * body.short_m);
      block.rows.push_back({{body.name + numberWords(", %.0f mm", 1000.0 * body.figure.body[Dimension::kStature])},
                            {std::to_string(body.scores.rula()), bandOfRula(body.scores.rula())},
                            {std::to_string(body.scores.reba()), bandOfReba(body.scores.reba())},
                            {std::to_string(body.scores.owasCode()), bandOfOwas(body.scores.owas_category)},
                            {driver.part + " " + driver.reason},
                            {reach}});
    }
    return block;
  }

  ReportBlock drives() const {
    ReportBlock block{say("What drives the score"),
                      {whySentence(scores_, language())},
                      {say("Method"), say("Driven by (with that alone)"),
                       say("Nearest posture of the next lower level"), say("Nearest place of the work")}};
    for (const PostureMethod method : kPostureMethods) {
      const MethodAdvice advice = advise(scores_, method, input_.task);
      const auto& place = input_.places[static_cast<std::size_t>(method)];
      block.rows.push_back({{std::string(nameOf(method))},
                            {orNone(driverWords(advice, language(), 2))},
                            {orNone(nextLevelWords(advice, language()))},
                            {orNone(place ? placeWords(*place, input_.posture, method, language()) : "")}});
    }
    if (const auto lift = lifted())
      block.rows.push_back({{"NIOSH"},
                            {orNone(liftingDriverWords(lift->advice))},
                            {orNone(liftingNextWords(lift->advice, language()))},
                            {"–"}});
    return block;
  }

  static std::string orNone(const std::string& text) { return text.empty() ? "–" : text; }

  ReportBlock history() const {
    ReportBlock block{say("Over the recorded motion"), {}};
    block.strips = input_.history;
    block.scale_first = "0 s";
    block.scale_last = numberWords("%.1f s", input_.history_seconds);
    if (input_.phase) block.lines.push_back(phaseWords(*input_.phase, false, language()));
    return block;
  }

  std::string sourceLine() const {
    std::string source = input_.source.empty() ? say("As it stands in the cell.") : input_.source;
    if (input_.is_of_phase && input_.phase)
      source = input_.phase->motion + ", " + phaseWords(*input_.phase, true, language()) + ".";
    return say("Source of the posture: %1", {source});
  }

  ReportBlock subScores() const {
    ReportBlock block{
        say("Sub-scores"),
        {},
        {"RULA, " + say("Part"), say("Score"), say("Reason"), "REBA, " + say("Part"), say("Score"), say("Reason")}};
    const SideScores& side = scores_.worse();
    const Side which = scores_.worseSide();
    const Rula rula;
    const Reba reba;
    for (std::size_t i = 0; i < Rula::kCount; ++i) {
      std::vector<Cell> row;
      const auto r = static_cast<Rula::Index>(i);
      row.push_back({rulaPart(r, which, language())});
      row.push_back(side.rula[i]
                        ? Cell{std::to_string(*side.rula[i]), bandOfSubScore(rula.subScores()[i], *side.rula[i])}
                        : Cell{"-"});
      row.push_back({rulaReason(side, r, language())});
      if (i < Reba::kCount) {
        const auto e = static_cast<Reba::Index>(i);
        row.push_back({rebaPart(e, which, language())});
        row.push_back(side.reba[i]
                          ? Cell{std::to_string(*side.reba[i]), bandOfSubScore(reba.subScores()[i], *side.reba[i])}
                          : Cell{"-"});
        row.push_back({rebaReason(side, e, language())});
      } else {
        row.insert(row.end(), 3, Cell{});
      }
      block.rows.push_back(std::move(row));
    }
    return block;
  }

  /// Both standards side by side.
  ReportBlock zones() const {
    ReportBlock block{say("Zones by part"), {}, {}};
    const SideScores& side = scores_.worse();
    for (const char* standard : {"EN 1005-4", "ISO 11226"}) {
      for (const std::string& name : {std::string(standard), say("Angle"), say("Zone"), say("Condition")})
        block.columns.push_back(name);
    }
    const auto& en = side.en1005.parts;
    const auto& iso = side.iso11226.parts;
    for (std::size_t i = 0; i < std::max(en.size(), iso.size()); ++i) {
      std::vector<Cell> row;
      addZone(i < en.size() ? &en[i] : nullptr, row);
      addZone(i < iso.size() ? &iso[i] : nullptr, row);
      block.rows.push_back(std::move(row));
    }
    return block;
  }

  void addZone(const PartVerdict* part, std::vector<Cell>& row) const {
    if (part == nullptr) return void(row.insert(row.end(), 4, Cell{}));
    std::string condition = say(part->condition);
    if (part->holding_time_min) condition = numberWords("%.1f min", *part->holding_time_min);
    row.insert(row.end(), {Cell{say(part->part)}, Cell{numberWords("%.0f°", part->angle)},
                           Cell{zoneWord(part->zone), bandOf(part->zone)}, Cell{condition}});
  }

  struct Lifted {
    LiftingTask task;
    LiftingResult result;
    LiftingAdvice advice;
  };
  /// Empty where the task is no lift, or the equation refuses it.
  std::optional<Lifted> lifted() const {
    if (!input_.task.is_lift) return std::nullopt;
    const auto task = liftOf(input_.figure, pose_, scores_, input_.task);
    const auto result = task ? lift(*task) : tl::unexpected(task.error());
    if (!result) return std::nullopt;
    return Lifted{*task, *result, adviseLift(*task, *result)};
  }

  ReportBlock lifting() const {
    ReportBlock block{say("Lifting"), {}};
    const auto found = lifted();
    if (!found) {
      const auto refused = scoreLift(input_.figure, pose_, scores_, input_.task);
      block.lines.push_back("NIOSH: " + (refused ? std::string() : refused.error().message()));
      return block;
    }
    const LiftingResult& result = found->result;
    block.lines.push_back(
        "NIOSH (DHHS 94-110, rev. 9/2021): RWL " + numberWords("%.1f kg", result.recommended_weight_limit_kg) +
        (result.lifting_index ? ", LI " + numberWords("%.2f", *result.lifting_index) : std::string()));
    if (const auto next = liftingNextWords(found->advice, language()); !next.empty())
      block.lines.push_back(say("What would bring it down: %1", {next}));
    block.columns = {"H", "V", "D", "A", "HM", "VM", "DM", "AM", "FM", "CM"};
    block.rows.push_back({{numberWords("%.0f cm", found->task.h_cm)},
                          {numberWords("%.0f cm", found->task.v_cm)},
                          {numberWords("%.0f cm", found->task.d_cm)},
                          {numberWords("%.0f°", found->task.asymmetry_deg)},
                          {numberWords("%.3f", result.hm)},
                          {numberWords("%.3f", result.vm)},
                          {numberWords("%.3f", result.dm)},
                          {numberWords("%.3f", result.am)},
                          {numberWords("%.3f", result.fm)},
                          {numberWords("%.3f", result.cm)}});
    return block;
  }

  ReportBlock forces() const {
    const HandForces found = handForces(input_.figure, pose_, input_.task, input_.own_limits);
    ReportBlock block{say("Forces on the hands"), {}, {say("Method"), say("Part"), say("Force"), say("Limit")}};
    for (const ForceLimit& limit : found.limits) {
      const bool own = limit.method == "own";
      std::string hand = say("both hands");
      if (limit.hand >= 0) hand = say(limit.hand == 0 ? "left" : "right");
      block.rows.push_back({{own ? say("own table") : std::string(limit.method)},
                            {hand},
                            {numberWords("%.0f N", limit.force_n)},
                            {limit.limit_n ? numberWords("%.0f N", *limit.limit_n) : say("heaviest class"), limit.band}});
    }
    if (!input_.own_limits.isEmpty()) block.lines.push_back(say("Own limits:") + " " + input_.own_limits.source);
    for (const std::string_view name : found.missing) {
      if (name == "force_limits")
        block.lines.push_back(say("Partial: no own limit of the hands' force is entered for this place."));
    }
    return block;
  }

  ReportBlock limits() const {
    ReportBlock block{say("Method and limits of this report"), assumptionsOf(scores_, input_.task, language())};
    std::string standards =
        "RULA McAtamney & Corlett 1993; REBA Hignett & McAtamney 2000;"
        " OWAS Karhu, Kansi & Kuorinka 1977; EN 1005-4:2005; ISO 11226:2000; EAWS " +
        say("1.3.6, posture outline only");
    if (input_.task.is_lift) standards += "; NIOSH DHHS 94-110, rev. 9/2021";
    block.lines.insert(block.lines.begin(), say("Standards and editions: %1", {standards + "."}));
    return block;
  }

  ReportBlock joints() const {
    ReportBlock block{say("Joint angles"), {}, {say("Joint"), "°"}, true};
    for (std::size_t i = 0; i < mannequin::kDofCount; ++i) {
      block.rows.push_back({{mannequin::dofInfo(static_cast<mannequin::Dof>(i)).name},
                            {numberWords("%.1f", 57.295779513082323 * input_.posture.angles[i] + 0.0)}});
    }
    return block;
  }

  const PostureReportInput& input_;
  mannequin::FigurePose pose_;
  PostureScores scores_;
};

}  // namespace

Report postureReport(const PostureReportInput& input) {
  return Writer(input).posture();
}

Report taskReport(const PostureReportInput& input) {
  return Writer(input).taskPage();
}

std::vector<ReportShape> reportPicture(const mannequin::Figure& figure, const mannequin::Posture& posture,
                                       const PostureScores& scores, ColourMethod method) {
  const auto bands = segmentBands(scores, method);
  std::vector<ReportShape> shapes;
  const auto flesh = mannequin::fleshOf(figure);
  std::size_t group = 0;
  for (const auto& part : mannequin::outlineOf(figure, posture, flesh, mannequin::OutlineView::besides(posture))) {
    for (const auto& outline : part.shapes) shapes.push_back({outline, bands[part.body], group});
    ++group;
  }
  return shapes;
}

ReportBlock::Strip stripOf(const std::string& name, const std::vector<int>& bands) {
  ReportBlock::Strip strip{name, {}};
  const double share = bands.empty() ? 0.0 : 1.0 / static_cast<double>(bands.size());
  for (const int band : bands) {
    if (!strip.pieces.empty() && strip.pieces.back().second == band) {
      strip.pieces.back().first += share;
    } else {
      strip.pieces.emplace_back(share, band);
    }
  }
  return strip;
}

}  // namespace hapticell::ergonomics
