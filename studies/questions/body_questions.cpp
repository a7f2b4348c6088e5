// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include "geometry/system/listed.h"
#include "manipulation/checks/body_contacts.h"
#include "manipulation/checks/hand_targets.h"
#include "manipulation/checks/mannequin_sight.h"
#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/ergonomics/scores/posture_scores.h"
#include "mannequin/posture/posture_file.h"
#include "mannequin/posture/posture_solver.h"
#include "mannequin/shape/figure_model.h"
#include "studies/document/study_section.h"
#include "studies/questions/question_kinds.h"
#include "studies/variants/placed_entities.h"

namespace hapticell::studies {

namespace {

using ergonomics::PostureScores;
using manipulation::HandTargets;
using mannequin::Side;
using workcell::Entity;

/// A score over the steps of a task: the worst counts.
struct Method {
  const char* name;
  bool is_least = false;  ///< The least value is the worst (comfort).
  /// Empty where the method has no score there.
  std::optional<double> (*score)(const Entity& body, const mannequin::FigurePose& pose, const PostureScores& scores,
                                 const ergonomics::WorkTask& task);
};

constexpr Method kMethods[] = {
    {"rula", false, [](const auto&, const auto&, const auto& s, const auto&) { return std::optional<double>(s.rula()); }},
    {"reba", false, [](const auto&, const auto&, const auto& s, const auto&) { return std::optional<double>(s.reba()); }},
    {"owas", false,
     [](const auto&, const auto&, const auto& s, const auto&) { return std::optional<double>(s.owas_category); }},
    {"eaws", false,
     [](const auto&, const auto&, const auto& s, const auto&) { return std::optional<double>(s.eaws_points); }},
    {"comfort", true, [](const auto&, const auto&, const auto& s, const auto&) { return std::optional<double>(s.comfort); }},
    {"lifting_index", false,
     [](const Entity& body, const auto& pose, const auto& s, const auto& task) {
       const auto lift = ergonomics::scoreLift(*body.figure(), pose, s, task);
       return lift ? lift->lifting_index : std::nullopt;
     }},
};

struct PostureSettings {
  std::string body, frame;
  std::vector<std::string> bodies;  ///< "female:5": all of them are asked, and the worst counts; empty: the cell's.
  std::vector<HandTargets> targets;  ///< Of the grips' centres, or of the wrists.
  std::vector<const Method*> methods;
  ergonomics::WorkTask task;
  bool present = false;  ///< The targets are where the active hands are in the given cell; they move with `frame`.
  bool at_grip = true, orientation = true, may_step = false, balance = true;
  bool all_pairs = false;  ///< Also what the cell's rules leave out counts as entered.
  bool each_body = false, postures = false;  ///< Further columns for each of `bodies`; with their postures as text.
};

/// How a body does a task: whether it reaches every step, and the worst score of each method.
class PostureQuestion : public Question {
 public:
  /// How the mannequin stands in the given cell.
  struct Shown {
    std::shared_ptr<const mannequin::Figure> figure;
    mannequin::Posture posture;
    Pose X_WF;  ///< Of `frame` there.
  };
  PostureQuestion(std::string name, PostureSettings settings, Shown shown)
      : Question(std::move(name)), settings_(std::move(settings)), shown_(std::move(shown)) {}

  std::vector<Column> columns() const override {
    std::vector<Column> columns{{"steps", Column::Kind::kWhole, ""},
                                {"reached", Column::Kind::kWhole, ""},
                                {"share", Column::Kind::kNumber, ""},
                                {"touching", Column::Kind::kWhole, ""},
                                {"touched", Column::Kind::kText, ""},
                                {"short", Column::Kind::kNumber, "m"}};
    for (const Method* method : settings_.methods) columns.push_back({method->name, Column::Kind::kNumber, ""});
    for (const std::string& source : settings_.each_body ? settings_.bodies : std::vector<std::string>())
      addColumns(columnEnding(source), columns);
    return columns;
  }

  Expected<std::vector<Answer>> answer(VariantCell& cell) const override {
    const bool seated = cell.stances.count(settings_.body) != 0;
    Tally whole;
    whole.worst.resize(settings_.methods.size());
    if (settings_.bodies.empty()) count({*cell.scene(), cell.document, seated}, whole);
    std::vector<Answer> each;
    for (const std::string& source : settings_.bodies) {
      workcell::Document document = cell.document;
      const workcell::EntityId id = document.findByName(settings_.body)->id;
      HAPTICELL_TRY(replaceBody(document, id, cell.inputs().shapes.at("mannequin:" + source)));
      Tally one;
      one.worst.resize(settings_.methods.size());
      count({*cell.sceneOf(document), document, seated}, one);
      if (settings_.each_body) addAnswers(one, each);
      add(one, whole);
    }
    std::vector<Answer> answers{whole.steps,
                                whole.reached,
                                static_cast<double>(whole.reached) / static_cast<double>(whole.steps),
                                whole.touching,
                                wordAnswer(whole.touched),
                                whole.short_m};
    for (const auto& one : whole.worst) answers.push_back(one ? Answer(*one) : Answer());
    std::move(each.begin(), each.end(), std::back_inserter(answers));
    return answers;
  }

 private:
  /// What became of all steps of one body, or of all.
  struct Tally {
    std::int64_t steps = 0, solved = 0, reached = 0, touching = 0;
    std::string touched;  ///< The first that is entered.
    double short_m = 0.0;
    std::vector<std::optional<double>> worst;
    std::string posture;  ///< Of the last step that is solved, as text.
  };
  /// A body in the cell of its variant.
  struct Stands {
    const manipulation::PreparedScene& scene;
    const workcell::Document& document;
    bool seated = false;
  };

  static Answer wordAnswer(const std::string& word) { return word.empty() ? Answer() : Answer(word); }
  /// "female:5" as columns are called after it.
  static std::string columnEnding(std::string source) {
    std::replace(source.begin(), source.end(), ':', '_');
    return "_" + source;
  }

  void addColumns(const std::string& ending, std::vector<Column>& columns) const {
    columns.push_back({"solved" + ending, Column::Kind::kWhole, ""});
    columns.push_back({"reached" + ending, Column::Kind::kWhole, ""});
    columns.push_back({"touched" + ending, Column::Kind::kText, ""});
    columns.push_back({"short" + ending, Column::Kind::kNumber, "m"});
    for (const Method* method : settings_.methods)
      columns.push_back({method->name + ending, Column::Kind::kNumber, ""});
    if (settings_.postures) columns.push_back({"posture" + ending, Column::Kind::kText, ""});
  }

  void addAnswers(const Tally& one, std::vector<Answer>& answers) const {
    answers.insert(answers.end(), {one.solved, one.reached, wordAnswer(one.touched), one.short_m});
    for (const auto& score : one.worst) answers.push_back(score ? Answer(*score) : Answer());
    if (settings_.postures) answers.push_back(wordAnswer(one.posture));
  }

  void add(const Tally& one, Tally& whole) const {
    whole.steps += one.steps;
    whole.solved += one.solved;
    whole.reached += one.reached;
    whole.touching += one.touching;
    if (whole.touched.empty()) whole.touched = one.touched;
    whole.short_m = std::max(whole.short_m, one.short_m);
    for (std::size_t i = 0; i < one.worst.size(); ++i) {
      if (one.worst[i]) takeWorse(i, *one.worst[i], whole);
    }
  }

  void takeWorse(std::size_t method, double value, Tally& tally) const {
    std::optional<double>& worst = tally.worst[method];
    if (!worst) worst = value;
    worst = settings_.methods[method]->is_least ? std::min(*worst, value) : std::max(*worst, value);
  }

  void count(const Stands& stands, Tally& tally) const {
    const Entity& body = *stands.document.findByName(settings_.body);
    const mannequin::Figure& figure = *body.figure();
    const mannequin::Posture given = mannequin::toPosture(figure, {body.X_WE, body.joints()});
    const Pose X_WF = settings_.frame.empty() ? Pose() : stands.document.findByName(settings_.frame)->X_WE;
    if (settings_.present) return countPresent(stands, body, X_WF, tally);
    const mannequin::Posture start = stands.seated ? ergonomics::seatedAt(given, figure) : given;
    for (const HandTargets& step : settings_.targets)
      countStep(stands, body, taskOf(figure, X_WF, step), start, tally);
  }

  /// The work that the mannequin of the given cell does there, done by this body where `frame` stands now.
  void countPresent(const Stands& stands, const Entity& body, const Pose& X_WF, Tally& tally) const {
    const mannequin::Figure& figure = *body.figure();
    mannequin::PostureTask task =
        ergonomics::taskAt(*shown_.figure, shown_.posture, figure, X_WF.p - shown_.X_WF.p);
    task.may_step = settings_.may_step;
    task.balance = task.balance && settings_.balance;  // Who sits does not balance.
    countStep(stands, body, task,
              stands.seated ? ergonomics::seatedAt(shown_.posture, figure)
                            : ergonomics::standingAt(*shown_.figure, shown_.posture, figure),
              tally);
  }

  void countStep(const Stands& stands, const Entity& body, mannequin::PostureTask task,
                 const mannequin::Posture& start, Tally& tally) const {
    if (stands.seated) {
      task.pelvis_locked = true;
      task.balance = false;
    }
    const auto found = mannequin::PostureSolver(*body.figure()).solve(task, start);
    const bool solved = found.status == mannequin::PostureStatus::kSolved;
    for (const double error : found.hand_position_error) tally.short_m = std::max(tally.short_m, error);
    const auto pairs = settings_.all_pairs ? manipulation::BodyPairs::kAll : manipulation::BodyPairs::kChecked;
    const std::string entered = manipulation::enteredByBody(stands.scene, body, found.posture, pairs);
    if (tally.touched.empty()) tally.touched = entered;
    ++tally.steps;
    tally.touching += entered.empty() ? 0 : 1;
    tally.solved += solved ? 1 : 0;
    tally.reached += solved && entered.empty() ? 1 : 0;
    if (!solved) return;
    score(body, found.posture, tally);
    if (settings_.postures) tally.posture = mannequin::postureText(found.posture);
  }

  mannequin::PostureTask taskOf(const mannequin::Figure& figure, const Pose& X_WF, const HandTargets& step) const {
    mannequin::PostureTask task;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!step.hands[i]) continue;
      Pose X_WH = X_WF * *step.hands[i];
      if (settings_.at_grip) X_WH = X_WH * Pose::translation(-figure.p_HandGrip[i]);
      task.hands[i] = X_WH;
      if (settings_.task.load_kg[i]) task.loads[i] = {*settings_.task.load_kg[i], figure.p_HandGrip[i]};
    }
    task.orientation = {settings_.orientation, settings_.orientation};
    task.may_step = settings_.may_step;
    task.balance = settings_.balance;
    return task;
  }

  void score(const Entity& body, const mannequin::Posture& posture, Tally& tally) const {
    const auto pose = mannequin::forwardKinematics(*body.figure(), posture);
    const PostureScores scores = ergonomics::scorePosture(*body.figure(), posture, pose, settings_.task);
    for (std::size_t i = 0; i < settings_.methods.size(); ++i) {
      const auto value = settings_.methods[i]->score(body, pose, scores, settings_.task);
      if (value) takeWorse(i, *value, tally);
    }
  }

  PostureSettings settings_;
  Shown shown_;
};

/// How well a mannequin in its posture of the cell sees an entity.
class SightQuestion : public Question {
 public:
  SightQuestion(std::string name, std::string body, std::string target)
      : Question(std::move(name)), body_(std::move(body)), target_(std::move(target)) {}

  std::vector<Column> columns() const override {
    return {{"seen", Column::Kind::kNumber, ""},
            {"zone", Column::Kind::kText, ""},
            {"distance", Column::Kind::kNumber, "m"},
            {"hidden_by", Column::Kind::kText, ""}};
  }

  Expected<std::vector<Answer>> answer(VariantCell& cell) const override {
    const Entity& body = *cell.document.findByName(body_);
    const Entity& target = *cell.document.findByName(target_);
    const auto posture = mannequin::toPosture(*body.figure(), {body.X_WE, body.joints()});
    const auto sight = manipulation::sightOfTarget(*cell.scene(), body, posture, target.id);
    std::vector<Answer> answers{sight.seen, std::string(mannequin::wordOf(sight.zone)), sight.distance, Answer()};
    if (!sight.hidden_by.empty()) answers[3] = sight.hidden_by;
    return answers;
  }

 private:
  std::string body_, target_;
};

Expected<std::string> readBody(SectionReader& reader, const StudySection& section, const StudyInputs& inputs) {
  std::string name;
  reader.fields().require("entity");
  reader.fields().read("entity", name);
  HAPTICELL_TRY(reader.check());
  const auto entity = inputs.entityNamed(section, name);
  HAPTICELL_TRY(entity);
  if (!(*entity)->figure())
    return makeError(section.fault(Text("entity '%1' of another kind", name), Text("a mannequin")));
  return name;
}

/// The task of that name: of the cell, else of the presets.
Expected<ergonomics::WorkTask> taskNamed(const StudySection& section, const StudyInputs& inputs,
                                         const std::string& name) {
  if (name.empty()) return ergonomics::WorkTask();
  if (const ergonomics::WorkTask* own = inputs.cell.state().findWorkTask(name)) return *own;
  const auto& presets = ergonomics::workTaskPresets();
  const auto preset = std::find_if(presets.begin(), presets.end(), [&](const auto& one) { return one.name == name; });
  if (preset != presets.end()) return *preset;
  const std::string known = listed(presets, [](const auto& one) { return one.name; });
  return makeError(section.fault(Text("no work task is named '%1'", name),
                                 Text("a work task of the cell, or one of %1", known)));
}

Expected<std::vector<const Method*>> readMethods(SectionReader& reader) {
  std::vector<std::string> names{"rula", "reba", "owas", "eaws", "comfort"};
  reader.fields().readList("methods", names);
  HAPTICELL_TRY(reader.check());
  std::vector<const Method*> methods;
  for (const std::string& name : names) {
    const auto* found = std::find_if(std::begin(kMethods), std::end(kMethods), [&](const Method& one) {
      return one.name == name;
    });
    if (found == std::end(kMethods)) {
      const std::string known = listed(kMethods, [](const Method& one) { return std::string(one.name); });
      reader.fields().failKey("methods", Text("the method '%1'", name), Text("one of %1", known));
      HAPTICELL_TRY(reader.check());
    }
    methods.push_back(found);
  }
  return methods;
}

Expected<void> readTargets(const std::filesystem::path& file, PostureSettings& settings, StudyInputs& inputs) {
  auto read = manipulation::readHandTargets(file);
  HAPTICELL_TRY(read);
  settings.targets = std::move(*read);
  if (std::find(inputs.files.begin(), inputs.files.end(), file) == inputs.files.end()) inputs.files.push_back(file);
  return {};
}

}  // namespace

MadeQuestion makePosture(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  PostureSettings settings;
  auto body = readBody(reader, section, inputs);
  HAPTICELL_TRY(body);
  settings.body = std::move(*body);
  std::string targets, task;
  int at = 0;
  reader.fields().read("targets", targets);
  reader.fields().read("frame", settings.frame);
  reader.fields().read("task", task);
  reader.fields().readWord("at", {"grip", "wrist"}, at);
  reader.fields().read("orientation", settings.orientation);
  reader.fields().read("may_step", settings.may_step);
  reader.fields().read("balance", settings.balance);
  reader.fields().read("all_pairs", settings.all_pairs);
  reader.fields().read("each_body", settings.each_body);
  reader.fields().read("postures", settings.postures);
  reader.fields().readList("bodies", settings.bodies);
  if (settings.each_body && settings.bodies.empty())
    reader.fields().failKey("each_body", Text("columns of each body without bodies"), Text("bodies = [...]"));
  if (settings.postures && !settings.each_body)
    reader.fields().failKey("postures", Text("postures without each_body"), Text("each_body = true"));
  auto methods = readMethods(reader);
  HAPTICELL_TRY(methods);
  HAPTICELL_TRY(reader.end());
  for (const std::string& source : settings.bodies) {
    const auto shape = inputs.shapeOf("mannequin:" + source);
    if (!shape)
      return makeError(section.fault(shape.error().text(), Text("bodies such as \"female:5\" or \"male:1750mm\"")));
  }
  settings.at_grip = at == 0;
  settings.methods = std::move(*methods);
  if (!settings.frame.empty()) {
    HAPTICELL_TRY(inputs.entityNamed(section, settings.frame));
  }
  auto work = taskNamed(section, inputs, task);
  HAPTICELL_TRY(work);
  settings.task = std::move(*work);
  settings.present = targets.empty();
  if (!settings.present) {
    HAPTICELL_TRY(readTargets(section.fileNamed(targets), settings, inputs));
  }
  const Entity& shown = *inputs.cell.findByName(settings.body);
  PostureQuestion::Shown given{shown.figure(), mannequin::toPosture(*shown.figure(), {shown.X_WE, shown.joints()}),
                               settings.frame.empty() ? Pose() : inputs.cell.findByName(settings.frame)->X_WE};
  return std::make_unique<PostureQuestion>(section.name, std::move(settings), std::move(given));
}

MadeQuestion makeSight(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  auto body = readBody(reader, section, inputs);
  HAPTICELL_TRY(body);
  std::string target;
  reader.fields().require("target");
  reader.fields().read("target", target);
  HAPTICELL_TRY(reader.end());
  HAPTICELL_TRY(inputs.entityNamed(section, target));
  return std::make_unique<SightQuestion>(section.name, std::move(*body), std::move(target));
}

}  // namespace hapticell::studies
