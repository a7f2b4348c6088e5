// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include "trajectory/programs/reading/krl_parser.h"
#include "trajectory/programs/reading/program_readers.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {

namespace {

constexpr double kRadiansPerDegree = 0.017453292519943295;
constexpr double kMetresPerMillimetre = 1e-3;

using KrlWords = std::set<std::string, std::less<>>;

const KrlWords& moveWords() {
  static const KrlWords kWords{"ptp",  "lin",   "circ", "ptp_rel",  "lin_rel",  "circ_rel",  "sptp",
                               "slin", "scirc", "spl",  "sptp_rel", "slin_rel", "scirc_rel", "spl_rel"};
  return kWords;
}
const KrlWords& typeWords() {
  static const KrlWords kWords{"int",    "real", "bool", "char", "e6pos", "e3pos",   "pos",  "frame",  "axis", "e6axis",
                               "e3axis", "fdat", "pdat", "ldat", "load",  "inertia", "decl", "global", "const"};
  return kWords;
}
/// Declarations of what has no value here.
const KrlWords& otherDeclarations() {
  static const KrlWords kWords{"ext", "extfct", "extp", "extfctp", "import", "struc", "enum", "signal", "public"};
  return kWords;
}
/// Statements that move nothing by themselves.
const KrlWords& stillWords() {
  static const KrlWords kWords{"interrupt",  "trigger",   "brake",      "pulse",           "anout",
                               "anin",       "digin",     "continue",   "confirm",         "spline",
                               "ptp_spline", "endspline", "time_block", "on_error_proceed"};
  return kWords;
}

/// X, Y, Z (mm), A, B, C (deg) of a record; what it lacks is of `otherwise`.
std::optional<Pose> poseOf(const Value& value, const std::optional<Pose>& otherwise) {
  if (value.kind != Value::Kind::kRecord) return std::nullopt;
  static constexpr std::array<const char*, 6> kFields{"x", "y", "z", "a", "b", "c"};
  std::array<double, 6> numbers{};
  std::size_t found = 0;
  if (otherwise) {
    const dvec3 abc = kukaAngles(otherwise->q);
    for (int i = 0; i < 3; ++i) {
      numbers[static_cast<std::size_t>(i)] = otherwise->p[i] / kMetresPerMillimetre;
      numbers[static_cast<std::size_t>(i) + 3] = abc[i];
    }
  }
  for (std::size_t i = 0; i < 6; ++i) {
    if (!value.find(kFields[i])) continue;
    const auto number = value.numberOf(kFields[i]);
    if (!number) return std::nullopt;
    numbers[i] = *number;
    ++found;
  }
  if (found == 0 || (found < 6 && !otherwise)) return std::nullopt;
  return Pose{kMetresPerMillimetre * dvec3(numbers[0], numbers[1], numbers[2]),
              fromKukaAngles({numbers[3], numbers[4], numbers[5]})};
}

bool hasAxes(const Value& value) {
  return value.find("a1") || value.find("a2") || value.find("a3") || value.find("a4") || value.find("a5") ||
         value.find("a6");
}

std::optional<ProgramPath::Joints> jointsOf(const Value& value, const std::optional<ProgramPath::Joints>& otherwise) {
  ProgramPath::Joints joints{};
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string field = "a" + std::to_string(i + 1);
    const auto number = value.numberOf(field);
    if (number) {
      joints[i] = *number * kRadiansPerDegree;
    } else if (otherwise && !value.find(field)) {
      joints[i] = (*otherwise)[i];
    } else {
      return std::nullopt;
    }
  }
  return joints;
}

Value recordOf(const Pose& X) {
  const dvec3 p = X.p / kMetresPerMillimetre, abc = kukaAngles(X.q);
  Value record{Value::Kind::kRecord, 0.0, {}, {}, {"x", "y", "z", "a", "b", "c"}};
  for (const double number : {p.x, p.y, p.z, abc.x, abc.y, abc.z}) record.items.push_back(Value::of(number));
  return record;
}

class KrlRun final : public ProgramRun {
 public:
  explicit KrlRun(ProgramPath& path) : ProgramRun(krl(), path) {
    meaning_.compose = [](const Value& a, const Value& b) {
      const auto X = poseOf(a, Pose::identity()), Y = poseOf(b, Pose::identity());
      if (!a.isKnown()) return a;
      if (!b.isKnown()) return b;
      return X && Y ? recordOf(*X * *Y) : Value::unknown(Text("an invalid frame"));
    };
    meaning_.variable = [this](const std::string& name) { return word(name); };
    meaning_.call = [](const std::string& name, const std::vector<Argument>& given) { return function(name, given); };
    variables_["$nullframe"] = recordOf(Pose::identity());
  }

  void addRoutines(std::vector<Routine> routines) {
    for (Routine& routine : routines) routines_.emplace(routine.name, std::move(routine));
  }

 protected:
  bool isMove(const Statement& statement) const override {
    return !statement.tokens.empty() && moveWords().contains(statement.tokens.front().text);
  }

  Flow plain(const Statement& statement) override {
    const Tokens& tokens = statement.tokens;
    const std::string& word = tokens.front().text;
    if (isMove(statement)) {
      move(statement);
    } else if (word == "goto") {
      path_.fail(statement.line, Text::plain("GOTO"), Text("loops and branches instead of jumps"),
                 Text("Write the lines in the order in which they run."));
    } else if (word == "wait") {
      wait(statement);
    } else if (word == "halt" || stillWords().contains(word)) {
      if (word == "spline" || word == "ptp_spline")
        path_.noteLine(statement.line, Text("a spline; it is read as straight lines between its points."));
      path_.skip(statement.line);
    } else if (isDeclaration(tokens)) {
      declare(tokens);
    } else if (!assignment(statement)) {
      return callLine(statement);
    }
    return Flow::kNext;
  }

 private:
  Value word(const std::string& name) const {
    if (name == "$pos_act" || name == "$pos_act_mes" || name == "$pos_for") {
      if (const auto here = path_.current()) return recordOf(*here);
    }
    return Value::unknown(Text("'%1', which the file does not define", name));
  }

  static Value function(const std::string& name, const std::vector<Argument>& given) {
    if (given.empty() || !given.front().value.isNumber()) return Value::unknown(Text("the result of '%1'", name));
    const double x = given.front().value.number;
    if (name == "abs") return Value::of(std::abs(x));
    if (name == "sqrt") return Value::of(std::sqrt(std::max(0.0, x)));
    if (name == "sin") return Value::of(std::sin(x * kRadiansPerDegree));
    if (name == "cos") return Value::of(std::cos(x * kRadiansPerDegree));
    if (name == "tan") return Value::of(std::tan(x * kRadiansPerDegree));
    if (name == "acos") return Value::of(std::acos(std::clamp(x, -1.0, 1.0)) / kRadiansPerDegree);
    if (name == "asin") return Value::of(std::asin(std::clamp(x, -1.0, 1.0)) / kRadiansPerDegree);
    if (name == "atan2" && given.size() > 1 && given[1].value.isNumber())
      return Value::of(std::atan2(x, given[1].value.number) / kRadiansPerDegree);
    // SBASE(1), STOOL2(FP1), SVEL_CP(0.2,,LCPDAT1): what they set stands in their first argument.
    if (name == "sbase" || name == "svel_cp" || name == "svel_joint") return Value::of(x);
    return Value::unknown(Text("the result of '%1'", name));
  }

  static bool isDeclaration(const Tokens& tokens) {
    if (typeWords().contains(tokens.front().text) || otherDeclarations().contains(tokens.front().text)) return true;
    return tokens.size() > 1 && tokens[0].isWord() && tokens[1].isWord();
  }

  /// DECL E6POS XP1={...}, or INT I,J.
  void declare(const Tokens& tokens) {
    std::size_t at = 0;
    while (at < tokens.size() && (tokens[at].is("decl") || tokens[at].is("global") || tokens[at].is("const"))) ++at;
    if (at < tokens.size() && stillWords().contains(tokens[at].text)) return path_.skip(tokens.front().line);
    if (at < tokens.size() && otherDeclarations().contains(tokens[at].text)) return;
    ExpressionReader reader(tokens, at + 1, krl(), meaning_);
    while (!reader.isAtEnd()) {
      std::vector<AccessStep> steps;
      const std::string name = reader.path(steps);
      if (name.empty()) return;
      if (reader.take("=")) {
        set(name, {}, reader.expression(), tokens.front().line);
      } else if (!find(name)) {
        variables_[name] = Value::unknown(Text("'%1', which has no value", name));
      }
      if (!reader.take(",")) return;
    }
  }

  bool assignment(const Statement& statement) {
    ExpressionReader reader(statement.tokens, 0, krl(), meaning_);
    std::vector<AccessStep> steps;
    const std::string name = reader.path(steps);
    if (name.empty() || !reader.take("=")) return false;
    set(name, steps, reader.expression(), statement.line);
    return true;
  }

  void set(const std::string& name, const std::vector<AccessStep>& steps, const Value& value, std::size_t line) {
    if (name == "$base") {
      setBase(value);
    } else if (name == "$vel" && value.isNumber()) {
      path_.setLinearSpeed(value.number);  // of a spline's WITH
    } else if (name == "$vel_axis" && value.isNumber()) {
      path_.setJointShare(value.number / 100.0);
    }
    assign(name, steps, value);
    if (name != "$vel") {
      if (name.starts_with("$out") || name.starts_with("$anout") || name.starts_with("$timer")) path_.skip(line);
      return;
    }
    const Value* velocity = find("$vel");
    if (const auto cp = velocity->numberOf("cp")) path_.setLinearSpeed(*cp);
    if (const auto ori = velocity->numberOf("ori1")) path_.setAngularSpeed(*ori * kRadiansPerDegree);
  }

  void setBase(const Value& value) {
    if (value.isNumber()) return setBaseNumber(value);
    const auto X = poseOf(value, std::nullopt);
    path_.setFrame(X, Text("the base $BASE, set from %1", value.whyUnknown()));
  }

  void setBaseNumber(const Value& number) {
    if (number.isNumber() && number.number == 0.0) return path_.setFrame(Pose::identity(), "");
    if (number.isNumber() && number.number >= 1.0 && number.number < 1000.0) {
      const auto n = static_cast<std::size_t>(number.number);
      const Value* bases = find("base_data");
      if (bases && bases->items.size() >= n) {
        if (const auto X = poseOf(bases->items[n - 1], std::nullopt)) return path_.setFrame(X, "");
      }
      return path_.setFrame(std::nullopt, Text("the base BASE_DATA[%1]", n));
    }
    path_.setFrame(std::nullopt, Text("a base from %1", number.whyUnknown()));
  }

  void wait(const Statement& statement) {
    if (statement.tokens.size() > 2 && statement.tokens[1].is("sec")) {
      const Value seconds = ExpressionReader(statement.tokens, 2, krl(), meaning_).expression();
      if (seconds.isNumber()) return path_.wait(seconds.number);
    }
    path_.skip(statement.line);
  }

  Flow callLine(const Statement& statement) {
    const Tokens& tokens = statement.tokens;
    if (tokens.size() == 2 && tokens[0].isWord() && tokens[1].is(":")) return Flow::kNext;  // a label
    if (tokens.size() > 1 && tokens[0].isWord() && tokens[1].is("(")) {
      const auto given = ExpressionReader(tokens, 2, krl(), meaning_).arguments();
      if (tokens[0].is("bas")) return bas(given), Flow::kNext;
      const auto routine = routines_.find(tokens[0].text);
      if (routine != routines_.end()) return call(routine->second, given, statement.line);
      path_.noteLine(statement.line,
                     Text("'%1' is not in the file; if it moves the robot, these moves are missing.", textOf(tokens)));
      return Flow::kNext;
    }
    path_.noteLine(statement.line, Text("'%1' is not supported and is left out.", textOf(tokens)));
    return Flow::kNext;
  }

  /// BAS(#VEL_CP,0.2), BAS(#CP_PARAMS,2), BAS(#BASE,1) ...
  void bas(const std::vector<Argument>& given) {
    if (given.size() < 2) return;
    const std::string& what = given[0].value.text;
    const Value& value = given[1].value;
    if (what == "#base") return setBaseNumber(value);
    if ((what == "#vel_cp" || what == "#cp_params") && value.isNumber()) path_.setLinearSpeed(value.number);
    if ((what == "#vel_ptp" || what == "#ptp_params") && value.isNumber()) path_.setJointShare(value.number / 100.0);
    if (what != "#cp_params" && what != "#ptp_params") return;
    const Value* data = find("fdat_act");
    if (!data) return;
    const Value* number = data->find("base_no");
    setBaseNumber(number ? *number : Value::unknown(data->whyUnknown()));
  }

  /// SLIN XP1 WITH $VEL=SVEL_CP(0.2,,L1), $BASE=SBASE(1)
  void takeWith(ExpressionReader& reader, std::size_t line) {
    while (!reader.isAtEnd()) {
      std::vector<AccessStep> steps;
      const std::string name = reader.path(steps);
      if (name.empty() || !reader.take("=")) return;
      set(name, steps, reader.expression(), line);
      if (!reader.take(",")) return;
    }
  }

  void move(const Statement& statement) {
    const Tokens& tokens = statement.tokens;
    // WITH counts for this move and stands behind its target.
    for (std::size_t i = 1; i < tokens.size(); ++i) {
      if (!tokens[i].is("with")) continue;
      ExpressionReader with(tokens, i + 1, krl(), meaning_);
      takeWith(with, statement.line);
    }
    std::string word = tokens.front().text;
    const bool is_relative = word.ends_with("_rel");
    const bool is_joint_move = word.find("ptp") != std::string::npos;
    const bool in_tool = std::any_of(tokens.begin(), tokens.end(), [](const Token& t) { return t.is("#tool"); });
    ExpressionReader reader(tokens, 1, krl(), meaning_);
    const Value target = reader.term();
    if (word.find("circ") == std::string::npos) return moveTo(statement, target, is_relative, is_joint_move, in_tool);
    if (!reader.take(","))
      return path_.fail(statement.line, Text("one point"), Text("CIRC auxiliary point, end point"), "");
    const Value end = reader.term();
    std::optional<double> angle;
    while (reader.take(",")) {
      if (!reader.take("ca")) continue;
      const Value degrees = reader.term();
      if (!degrees.isNumber()) return path_.fail(statement.line, degrees.whyUnknown(), Text("the angle CA"), "");
      angle = degrees.number * kRadiansPerDegree;
    }
    const auto here = path_.current();
    const auto via_FT = placed(target, is_relative, in_tool), end_FT = placed(end, is_relative, in_tool);
    if (!here || !via_FT || !end_FT) return path_.missTarget(statement.line, whyMissing(!via_FT ? target : end));
    path_.moveArc(statement.line, *via_FT, *end_FT, angle);
  }

  static Text whyMissing(const Value& target) {
    const Text why = target.whyUnknown();
    return why.empty() ? Text("a target without all its coordinates") : Text("a target from %1", why);
  }

  std::optional<Pose> placed(const Value& target, bool is_relative, bool in_tool) const {
    const auto here = path_.current();
    if (!is_relative) return poseOf(target, here);
    const auto step = poseOf(target, Pose::identity());
    if (!step || !here) return std::nullopt;
    return in_tool ? *here * *step : Pose{here->p + step->p, glm::normalize(step->q * here->q)};
  }

  void noteExternalAxes(const Value& target) {
    for (const char* axis : {"e1", "e2", "e3", "e4", "e5", "e6"})
      if (target.numberOf(axis).value_or(0.0) != 0.0)
        path_.note(Text("External axes of the targets (E1 to E6) are not kept."));
  }

  void moveTo(const Statement& statement, const Value& target, bool is_relative, bool is_joint_move, bool in_tool) {
    noteExternalAxes(target);
    if (hasAxes(target)) {
      auto joints = jointsOf(target, is_relative ? ProgramPath::Joints{} : path_.currentJoints());
      if (joints && is_relative) {
        if (!path_.currentJoints())
          return path_.missTarget(statement.line, Text("relative axis values after a target without axis values"));
        for (std::size_t i = 0; i < joints->size(); ++i) (*joints)[i] += (*path_.currentJoints())[i];
      }
      if (!joints) return path_.missTarget(statement.line, whyMissing(target));
      return path_.moveJoints(statement.line, *joints, remarkedPose(statement.tokens));
    }
    if (const auto X = placed(target, is_relative, in_tool)) return path_.moveTo(statement.line, *X, is_joint_move);
    if (is_relative && target.whyUnknown().empty())
      return path_.fail(statement.line, Text("a move relative to a target that the file does not define"),
                        Text("a known target"), "");
    path_.missTarget(statement.line, whyMissing(target));
  }

  std::optional<Pose> remarkedPose(const Tokens& tokens) const {
    const auto mark = std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return t.is("@pose"); });
    if (mark == tokens.end()) return std::nullopt;
    const auto at = static_cast<std::size_t>(mark - tokens.begin()) + 1;
    return poseOf(ExpressionReader(tokens, at, krl(), meaning_).term(), std::nullopt);
  }
};

}  // namespace

Expected<ReadProgram> readKrl(const ProgramText& text, const ProgramReadOptions& options) {
  ProgramPath path(options);
  KrlRun run(path);
  std::vector<Routine> routines;
  for (const std::string* data : {&text.more_data, &text.data}) {
    Block block;
    std::vector<Routine> none;
    const Tokens tokens = tokensOf(*data, krl());
    parseKrl(tokens, path, none, block);
    run.allowSteps(tokens.size());
    // What data files say is no motion; a fault in one is found by the moves that need it.
    run.run(block);
  }
  Block loose;
  const Tokens tokens = tokensOf(text.source, krl());
  parseKrl(tokens, path, routines, loose);
  run.allowSteps(tokens.size());
  if (routines.empty()) return makeError({.found = "DEF is missing", .expected = "a KRL program: DEF NAME( )"});
  const Routine main = routines.front();
  run.addRoutines(std::move(routines));
  run.run(main.body);
  return path.finish(main.name);
}

}  // namespace hapticell::trajectory
