// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "trajectory/programs/reading/program_readers.h"
#include "trajectory/programs/reading/program_run.h"

namespace hapticell::trajectory {

namespace {

constexpr double kUrDegree = 0.017453292519943295;  // rad
// rad/s: 180 degrees a second, a UR5e's joints at full speed; the writer in program_numbers.cpp has it too. Half: joint
// moves are read twice as fast; twice: half as fast.
constexpr double kFastestJoint = 3.14;
// Blocks within each other, as kDeepestKrlBlock of krl_parser.cpp.
constexpr int kDeepestUrBlock = 100;

const Dialect& urscript() {
  static const Dialect kDialect{false, '#', true, true, false, true, 0};
  return kDialect;
}

using UrWords = std::set<std::string, std::less<>>;

bool isUrMove(const std::string& word) {
  static const UrWords kWords{"movej", "movel", "movep", "movec"};
  return kWords.contains(word);
}

/// Calls without motion that ordinary programs have.
bool isStillCall(const std::string& word) {
  static const UrWords kWords{"set_tcp",
                              "set_payload",
                              "set_gravity",
                              "set_payload_mass",
                              "set_payload_cog",
                              "set_target_payload",
                              "popup",
                              "textmsg",
                              "sync",
                              "stopl",
                              "stopj",
                              "halt",
                              "set_tool_voltage",
                              "set_safety_mode_transition_hardness",
                              "zero_ftsensor",
                              "set_analog_outputdomain",
                              "step_count_0",
                              "blend_radius",
                              "rpc_factory"};
  return kWords.contains(word) || word.starts_with("set_") || word.starts_with("socket_") || word.starts_with("get_") ||
         word.starts_with("write_") || word.starts_with("read_") || word.starts_with("modbus_") ||
         word.starts_with("rtde_");
}

class UrParser {
 public:
  UrParser(const Tokens& tokens, ProgramPath& path) : path_(path) {
    Tokens line;
    for (const Token& token : tokens) {
      if (token.kind == Token::Kind::kLineEnd || token.is(";")) {
        if (!line.empty()) lines_.push_back(std::exchange(line, {}));
      } else {
        line.push_back(token);
      }
    }
  }

  void parse(std::vector<Routine>& routines, Block& top) {
    routines_ = &routines;
    while (at_ < lines_.size() && !path_.hasFailed()) {
      if (lines_[at_].front().is("end")) {
        ++at_;
      } else {
        statement(top, 0);
      }
    }
  }

 private:
  static bool isDefinition(const Token& word) { return word.is("def") || word.is("sec") || word.is("thread"); }
  static Tokens condition(const Tokens& line) {
    Tokens result(line.begin() + 1, line.end());
    if (!result.empty() && result.back().is(":")) result.pop_back();
    return result;
  }

  void definition(int depth) {
    const Tokens head = lines_[at_++];
    Routine routine;
    routine.line = head.front().line;
    if (head.size() > 1) routine.name = head[1].text;
    for (std::size_t i = 3; i < head.size(); ++i)
      if (head[i].isWord() && (head[i - 1].is("(") || head[i - 1].is(","))) routine.parameters.push_back(head[i].text);
    routine.body = block({"end"}, depth + 1);
    if (at_ < lines_.size()) ++at_;
    routines_->push_back(std::move(routine));
  }

  bool isAt(const UrWords& words) const { return at_ < lines_.size() && words.contains(lines_[at_].front().text); }

  Block block(const UrWords& ends, int depth) {
    Block result;
    if (depth > kDeepestUrBlock) {
      path_.fail(lines_[std::min(at_, lines_.size() - 1)].front().line, Text("more than 100 nested blocks"),
                 Text("fewer"), "");
      at_ = lines_.size();
    }
    while (at_ < lines_.size() && !isAt(ends)) statement(result, depth);
    if (at_ >= lines_.size())
      path_.fail(lines_.back().front().line, Text("the file ends too early"), Text::plain("'end'"), "");
    return result;
  }

  void statement(Block& into, int depth) {
    const Tokens& line = lines_[at_];
    Statement made;
    made.line = line.front().line;
    if (isDefinition(line.front()) && line.size() > 1 && line[1].isWord()) return definition(depth);
    if (line.front().is("if")) return into.push_back(ifStatement(std::move(made), depth));
    if (line.front().is("while")) {
      made.kind = Statement::Kind::kWhile;
      std::vector<Tokens> asked{condition(line)};
      ++at_;
      made.branches.push_back({std::move(asked), block({"end"}, depth + 1)});
      if (at_ < lines_.size()) ++at_;
      return into.push_back(std::move(made));
    }
    if (line.front().is("break")) made.kind = Statement::Kind::kBreak;
    if (line.front().is("return")) made.kind = Statement::Kind::kReturn;
    if (line.front().is("halt")) made.kind = Statement::Kind::kEnd;
    made.tokens = line;
    ++at_;
    into.push_back(std::move(made));
  }

  Statement ifStatement(Statement made, int depth) {
    made.kind = Statement::Kind::kIf;
    std::vector<Tokens> asked{condition(lines_[at_++])};
    const UrWords ends{"elif", "else", "end"};
    made.branches.push_back({std::move(asked), block(ends, depth + 1)});
    while (isAt({"elif"})) {
      std::vector<Tokens> other{condition(lines_[at_++])};
      made.branches.push_back({std::move(other), block(ends, depth + 1)});
    }
    if (isAt({"else"})) {
      ++at_;
      made.branches.push_back({{}, block({"end"}, depth + 1)});
    }
    if (at_ < lines_.size()) ++at_;
    return made;
  }

  ProgramPath& path_;
  std::vector<Tokens> lines_;
  std::vector<Routine>* routines_ = nullptr;
  std::size_t at_ = 0;
};

std::optional<Pose> urPose(const Value& value) {
  if (value.text != "p") return std::nullopt;
  const auto n = value.numbers(6);
  if (!n) return std::nullopt;
  return Pose{{(*n)[0], (*n)[1], (*n)[2]}, quaternionFromRotationVector({(*n)[3], (*n)[4], (*n)[5]})};
}

Value urValue(const Pose& X) {
  const dvec3 r = rotationVector(X.q);
  return Value::list("p", {X.p.x, X.p.y, X.p.z, r.x, r.y, r.z});
}

std::optional<ProgramPath::Joints> urJoints(const Value& value) {
  if (value.text == "p") return std::nullopt;
  const auto n = value.numbers(6);
  if (!n) return std::nullopt;
  ProgramPath::Joints joints{};
  std::copy(n->begin(), n->end(), joints.begin());
  return joints;
}

class UrRun final : public ProgramRun {
 public:
  UrRun(ProgramPath& path, const ProgramReadOptions& options) : ProgramRun(urscript(), path), options_(options) {
    meaning_.call = [this](const std::string& name, const std::vector<Argument>& given) {
      return function(name, given);
    };
    variables_["pi"] = Value::of(std::numbers::pi);
  }

  void addRoutines(std::vector<Routine> routines) {
    for (Routine& routine : routines) routines_.emplace(routine.name, std::move(routine));
  }
  bool moves(const Block& block) const { return hasMoves(block); }

 protected:
  bool isMove(const Statement& statement) const override {
    return !statement.tokens.empty() &&
           (isUrMove(statement.tokens.front().text) || statement.tokens.front().text.starts_with("servo") ||
            statement.tokens.front().text.starts_with("speed"));
  }

  Flow plain(const Statement& statement) override {
    const Tokens& tokens = statement.tokens;
    const std::string& word = tokens.front().text;
    if (word == "$") return Flow::kNext;  // The pendant's label of a line: $ 2 "Robot Program"
    const bool is_call = tokens.size() > 1 && tokens[0].isWord() && tokens[1].is("(");
    if (is_call && isUrMove(word)) {
      move(statement);
    } else if (is_call && (word.starts_with("servo") || word.starts_with("speed"))) {
      path_.fail(statement.line, Text("'%1', whose motion depends on the controller's clock", word),
                 Text::plain("movej, movel, movep, movec"), "");
    } else if (is_call && (word == "force_mode" || word == "track_conveyor_linear" ||
                           word == "track_conveyor_circular" || word == "path_offset_set")) {
      path_.fail(statement.line, Text("'%1', which shifts the targets that follow", word),
                 Text("targets without a shift"), Text("Delete it in a copy of the program."));
    } else if (is_call) {
      return callLine(statement);
    } else if (word == "run" || word == "kill" || word == "join" || word == "enter_critical" ||
               word == "exit_critical" || word == "pass") {
      path_.noteLine(statement.line, word == "run" ? Text("'%1' is left out: threads are not read.", textOf(tokens))
                                                   : Text("'%1' is left out.", textOf(tokens)));
    } else if (!assignment(tokens)) {
      path_.noteLine(statement.line, Text("'%1' is not supported and is left out.", textOf(tokens)));
    }
    return Flow::kNext;
  }

 private:
  static std::optional<double> numberAt(const std::vector<Argument>& given, std::size_t i) {
    if (i >= given.size() || !given[i].value.isNumber()) return std::nullopt;
    return given[i].value.number;
  }

  Value function(const std::string& name, const std::vector<Argument>& given) const {
    if (name == "get_actual_tcp_pose" || name == "get_target_tcp_pose") {
      const auto here = path_.current();
      return here ? urValue(*here) : Value::unknown(Text("the current position of the robot"));
    }
    if (given.empty()) return Value::unknown(Text("the result of '%1'", name));
    const auto X = urPose(given[0].value);
    const auto Y = given.size() > 1 ? urPose(given[1].value) : std::nullopt;
    if (name == "get_inverse_kin" && X) return given[0].value;  // A move to these joints is one to that pose.
    if (name == "pose_trans" && X && Y) return urValue(*X * *Y);
    if (name == "pose_add" && X && Y) return urValue({X->p + Y->p, glm::normalize(X->q * Y->q)});
    if (name == "pose_sub" && X && Y) return urValue({X->p - Y->p, glm::normalize(glm::conjugate(Y->q) * X->q)});
    if (name == "pose_inv" && X) return urValue(X->inverse());
    if (name == "interpolate_pose" && X && Y && numberAt(given, 2))
      return urValue(interpolate(*X, *Y, *numberAt(given, 2)));
    if (name == "point_dist" && X && Y) return Value::of(glm::length(X->p - Y->p));
    if (name == "get_forward_kin" && options_.forward_kinematics) {
      if (const auto q = urJoints(given[0].value))
        if (const auto pose = options_.forward_kinematics(*q)) return urValue(*pose);
    }
    if (name == "length" || name == "size") return Value::of(static_cast<double>(given[0].value.items.size()));
    if (const auto a = numberAt(given, 0)) return ofNumber(name, *a, given);
    for (const Argument& argument : given)
      if (Text why = argument.value.whyUnknown(); !why.empty()) return Value::unknown(why);
    return Value::unknown(Text("the result of '%1'", name));
  }

  static Value ofNumber(const std::string& name, double a, const std::vector<Argument>& given) {
    if (name == "d2r") return Value::of(a * kUrDegree);
    if (name == "r2d") return Value::of(a / kUrDegree);
    if (name == "sin") return Value::of(std::sin(a));
    if (name == "cos") return Value::of(std::cos(a));
    if (name == "tan") return Value::of(std::tan(a));
    if (name == "asin") return Value::of(std::asin(std::clamp(a, -1.0, 1.0)));
    if (name == "acos") return Value::of(std::acos(std::clamp(a, -1.0, 1.0)));
    if (name == "atan") return Value::of(std::atan(a));
    if (name == "sqrt" && a >= 0.0) return Value::of(std::sqrt(a));
    if (name == "abs" || name == "norm") return Value::of(std::abs(a));
    if (name == "floor") return Value::of(std::floor(a));
    if (name == "ceil") return Value::of(std::ceil(a));
    if (name == "atan2" && numberAt(given, 1)) return Value::of(std::atan2(a, *numberAt(given, 1)));
    if (name == "pow" && numberAt(given, 1)) return Value::of(std::pow(a, *numberAt(given, 1)));
    return Value::unknown(Text("the result of '%1'", name));
  }

  bool assignment(const Tokens& tokens) {
    const std::size_t first = tokens.size() > 1 && (tokens[0].is("global") || tokens[0].is("local")) ? 1 : 0;
    ExpressionReader reader(tokens, first, urscript(), meaning_);
    std::vector<AccessStep> steps;
    const std::string name = reader.path(steps);
    if (name.empty() || !reader.take("=")) return false;
    assign(name, steps, reader.expression());
    return true;
  }

  Flow callLine(const Statement& statement) {
    const std::string& word = statement.tokens.front().text;
    const auto given = ExpressionReader(statement.tokens, 2, urscript(), meaning_).arguments();
    if (const auto routine = routines_.find(word); routine != routines_.end())
      return call(routine->second, given, statement.line);
    if (word == "sleep") {
      if (const auto seconds = numberAt(given, 0))
        path_.wait(*seconds);
      else
        path_.skip(statement.line);
    } else if (isStillCall(word)) {
      path_.skip(statement.line);
    } else {
      path_.noteLine(statement.line,
                     Text("'%1' is not in the file or not supported; if it moves the robot, these moves are missing.",
                          textOf(statement.tokens)));
    }
    return Flow::kNext;
  }

  static Text whyMissing(const Value& target) {
    const Text why = target.whyUnknown();
    return why.empty() ? Text("a target that is neither p[...] nor six joints") : Text("a target from %1", why);
  }

  void move(const Statement& statement) {
    const std::string& word = statement.tokens.front().text;
    const bool is_joint_move = word == "movej";
    const std::size_t targets = word == "movec" ? 2 : 1;
    const auto given = ExpressionReader(statement.tokens, 2, urscript(), meaning_).arguments();
    // In order: targets, a, v; movej and movel have t and r behind them.
    std::size_t place = 0;
    std::vector<Value> at(targets, Value::unknown(Text("no target")));
    for (const Argument& argument : given) {
      const bool is_speed = argument.name == "v" || (argument.name.empty() && place == targets + 1);
      if (argument.name == "pose" || argument.name == "q" || argument.name == "pose_via") at.front() = argument.value;
      if (argument.name == "pose_to") at.back() = argument.value;
      if (argument.name.empty() && place < targets) at[place] = argument.value;
      if (argument.name.empty()) ++place;
      if (!is_speed || !argument.value.isNumber()) continue;
      if (is_joint_move)
        path_.setJointShare(argument.value.number / kFastestJoint);
      else
        path_.setLinearSpeed(argument.value.number);
    }
    if (word == "movec") {
      const auto via = urPose(at[0]), end = urPose(at[1]);
      if (!via || !end || !path_.current()) return path_.missTarget(statement.line, whyMissing(via ? at[1] : at[0]));
      return path_.moveArc(statement.line, *via, *end);
    }
    if (const auto X = urPose(at[0])) return path_.moveTo(statement.line, *X, is_joint_move);
    if (const auto joints = urJoints(at[0]))
      return path_.moveJoints(statement.line, *joints, remarkedPose(statement.tokens));
    path_.missTarget(statement.line, whyMissing(at[0]));
  }

  std::optional<Pose> remarkedPose(const Tokens& tokens) const {
    const auto mark = std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return t.is("@pose"); });
    if (mark == tokens.end()) return std::nullopt;
    const auto at = static_cast<std::size_t>(mark - tokens.begin()) + 1;
    return urPose(ExpressionReader(tokens, at, urscript(), meaning_).expression());
  }

  const ProgramReadOptions& options_;
};

}  // namespace

/// What stands outside of definitions is run; where nothing moves there, the first definition that nobody calls.
Expected<ReadProgram> readUrScript(const std::string& text, const ProgramReadOptions& options) {
  ProgramPath path(options);
  std::vector<Routine> routines;
  Block top;
  const Tokens tokens = tokensOf(text, urscript());
  UrParser(tokens, path).parse(routines, top);
  if (path.hasFailed()) return path.finish("");
  UrRun run(path, options);
  run.allowSteps(tokens.size());
  run.addRoutines(routines);
  if (run.moves(top) || routines.empty()) {
    run.run(top);
    std::string name;
    for (const Statement& statement : top)
      for (const Routine& routine : routines)
        if (!statement.tokens.empty() && statement.tokens.front().text == routine.name) name = routine.name;
    return path.finish(name);
  }
  run.run(top);
  const auto outer =
      std::find_if(routines.rbegin(), routines.rend(), [&](const Routine& r) { return run.moves(r.body); });
  if (outer == routines.rend()) return path.finish("");
  run.run(outer->body);
  return path.finish(outer->name);
}

}  // namespace hapticell::trajectory
