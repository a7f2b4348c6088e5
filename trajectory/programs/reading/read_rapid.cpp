// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <set>

#include "trajectory/programs/reading/program_readers.h"
#include "trajectory/programs/reading/rapid_functions.h"
#include "trajectory/programs/reading/rapid_parser.h"
#include "trajectory/programs/reading/rapid_records.h"

namespace hapticell::trajectory {

namespace {

using RapidWords = std::set<std::string, std::less<>>;

/// Instructions that move to targets, and how many arguments stand before the target (via, to for circles).
struct RapidMove {
  const char* name;
  int before;
  bool is_joint, is_circle;
};
constexpr std::array<RapidMove, 40> kMoves{
    {{"movel", 0, false, false},     {"movej", 0, true, false},       {"movec", 0, false, true},
     {"moveabsj", 0, true, false},   {"moveldo", 0, false, false},    {"movejdo", 0, true, false},
     {"movecdo", 0, false, true},    {"movelsync", 0, false, false},  {"movejsync", 0, true, false},
     {"movecsync", 0, false, true},  {"movelao", 0, false, false},    {"movejao", 0, true, false},
     {"movelgo", 0, false, false},   {"movejgo", 0, true, false},     {"triggl", 0, false, false},
     {"triggj", 0, true, false},     {"triggc", 0, false, true},      {"trigglios", 0, false, false},
     {"searchl", 2, false, false},   {"searchc", 2, false, true},     {"arcl", 0, false, false},
     {"arclstart", 0, false, false}, {"arclend", 0, false, false},    {"arcc", 0, false, true},
     {"arccstart", 0, false, true},  {"arccend", 0, false, true},     {"arcj", 0, true, false},
     {"displ", 0, false, false},     {"displstart", 0, false, false}, {"displend", 0, false, false},
     {"dispc", 0, false, true},      {"paintl", 0, false, false},     {"paintc", 0, false, true},
     {"spotl", 0, false, false},     {"spotj", 0, true, false},       {"capl", 0, false, false},
     {"capc", 0, false, true},       {"moveextj", 0, true, false},    {"movepnp", 0, false, false},
     {"indamove", 0, true, false}}};

const RapidMove* rapidMove(const std::string& word) {
  const auto found = std::find_if(kMoves.begin(), kMoves.end(), [&](const RapidMove& m) { return word == m.name; });
  return found == kMoves.end() ? nullptr : &*found;
}

/// Instructions without motion that ordinary programs have.
const RapidWords& stillInstructions() {
  static const RapidWords kWords{
      "set",         "reset",        "setdo",         "setao",       "setgo",        "pulsedo",    "invertdo",
      "waitdi",      "waitdo",       "waitai",        "waituntil",   "waitgi",       "tpwrite",    "tperase",
      "tpreadfk",    "tpreadnum",    "tpshow",        "confl",       "confj",        "accset",     "velset",
      "singarea",    "clkstart",     "clkstop",       "clkreset",    "gripload",     "softact",    "softdeact",
      "errwrite",    "erase",        "open",          "close",       "write",        "print",      "pathaccel",
      "worldacclim", "speedrefresh", "idelete",       "isignaldi",   "iwatch",       "isleep",     "itimer",
      "connect",     "motionsup",    "waitsyncttask", "activate",    "deactivate",   "actunit",    "deactunit",
      "stopmove",    "startmove",    "storepath",     "restopath",   "waitrob",      "uishow",     "uimsgbox",
      "load",        "unload",       "startload",     "waitload",    "bookerrno",    "trigg",      "triggio",
      "triggequip",  "arcrefresh",   "stop",          "break",       "waitsynctask", "syncmoveon", "syncmoveoff",
      "vswrite",     "debug",        "setallsignals", "mecunitload", "eoffsoff",     "pdispoff",   "circpathmode",
      "moveindon"};
  return kWords;
}

class RapidRun final : public ProgramRun {
 public:
  explicit RapidRun(ProgramPath& path) : ProgramRun(rapid(), path) {
    meaning_.variable = [](const std::string& name) { return rapidWord(name); };
    meaning_.call = [this](const std::string& name, const std::vector<Argument>& given) {
      return rapidFunction(name, given, path_.current());
    };
    meaning_.field = [](const Value& whole, const std::string& field) {
      const auto found = whole.kind == Value::Kind::kList ? rapidField(whole.text, field) : std::nullopt;
      if (!found || found->first >= whole.items.size()) return Value::unknown(Text("the field '%1'", field));
      Value part = whole.items[found->first];
      if (part.kind == Value::Kind::kList) part.text = found->second;
      return part;
    };
  }

  void addRoutines(std::vector<Routine> routines) {
    for (Routine& routine : routines) routines_.emplace(routine.name, std::move(routine));
  }
  bool moves(const Block& block) const { return hasMoves(block); }

 protected:
  bool isMove(const Statement& statement) const override {
    return !statement.tokens.empty() && rapidMove(statement.tokens.front().text) != nullptr;
  }

  Flow plain(const Statement& statement) override {
    const Tokens& tokens = statement.tokens;
    if (tokens.empty()) return Flow::kNext;
    const std::string& word = tokens.front().text;
    if (const RapidMove* move = rapidMove(word)) {
      this->move(statement, *move);
    } else if (word == "const" || word == "pers" || word == "var" || word == "local" || word == "task") {
      declare(tokens);
    } else if (word == "goto") {
      path_.fail(statement.line, Text::plain("GOTO"), Text("loops and branches instead of jumps"),
                 Text("Write the lines in the order in which they run."));
    } else if (word == "pdispset" || word == "pdispon" || word == "eoffsset" || word == "eoffson") {
      path_.fail(statement.line, Text("'%1', which shifts all targets that follow", word),
                 Text("targets without a shift"), Text("Delete it in a copy of the program."));
    } else if (word == "waittime") {
      wait(statement);
    } else if (stillInstructions().contains(word)) {
      path_.skip(statement.line);
    } else if (!assignment(statement)) {
      return instruction(statement);
    }
    return Flow::kNext;
  }

 private:
  /// [LOCAL] CONST|PERS|VAR type name{dimensions} := value
  void declare(const Tokens& tokens) {
    std::size_t at = 0;
    while (at < tokens.size() && (tokens[at].is("local") || tokens[at].is("task"))) ++at;
    ExpressionReader reader(tokens, at + 2, rapid(), meaning_);
    const std::string type = at + 1 < tokens.size() ? tokens[at + 1].text : "";
    while (!reader.isAtEnd()) {
      std::vector<AccessStep> dimensions;
      const std::string name = reader.path(dimensions);
      if (name.empty()) return;
      Value value = Value::unknown(Text("'%1', which has no value", name));
      if (reader.take(":=")) value = reader.expression();
      if (type == "num" && !value.isKnown() && reader.at() == at + 3) value = Value::of(0.0);
      if (value.kind == Value::Kind::kList) {
        if (dimensions.empty()) {
          value.text = type;
        } else {
          for (Value& item : value.items) item.text = item.kind == Value::Kind::kList ? type : item.text;
        }
      }
      variables_[name] = std::move(value);
      if (!reader.take(",")) return;
    }
  }

  bool assignment(const Statement& statement) {
    ExpressionReader reader(statement.tokens, 0, rapid(), meaning_);
    std::vector<AccessStep> steps;
    const std::string name = reader.path(steps);
    if (name.empty() || !reader.take(":=")) return false;
    Value value = reader.expression();
    // Fields of records are places in lists here.
    std::string type = find(name) ? find(name)->text : "";
    for (AccessStep& step : steps) {
      if (step.field.empty()) {
        const Value* list = find(name);
        const auto i = static_cast<std::size_t>(std::clamp(step.index - 1.0, 0.0, 1e6));
        type = list && i < list->items.size() ? list->items[i].text : "";
        continue;
      }
      const auto place = rapidField(type, step.field);
      if (!place) return path_.noteLine(statement.line, Text("the field '%1' is not kept.", step.field)), true;
      step = {"", static_cast<double>(place->first + 1), true};
      type = place->second;
    }
    if (const Value* old = find(name); old && steps.empty() && value.kind == Value::Kind::kList && value.text.empty())
      value.text = old->text;
    assign(name, steps, std::move(value));
    return true;
  }

  void wait(const Statement& statement) {
    const auto given = ExpressionReader(statement.tokens, 1, rapid(), meaning_).arguments();
    for (const Argument& argument : given)
      if (argument.name.empty() && argument.value.isNumber()) return path_.wait(argument.value.number);
    path_.skip(statement.line);
  }

  /// A call of a routine; Incr, Decr, Add.
  Flow instruction(const Statement& statement) {
    const Tokens& tokens = statement.tokens;
    const std::string& word = tokens.front().text;
    const auto given = ExpressionReader(tokens, 1, rapid(), meaning_).arguments();
    if (const auto routine = routines_.find(word); routine != routines_.end())
      return call(routine->second, given, statement.line);
    if ((word == "incr" || word == "decr" || word == "add" || word == "clear") && !given.empty()) {
      ExpressionReader reader(tokens, 1, rapid(), meaning_);
      std::vector<AccessStep> steps;
      const std::string name = reader.path(steps);
      double step = rapidNumberAt(given, 1).value_or(0.0);
      if (word == "incr" || word == "decr") step = word == "incr" ? 1.0 : -1.0;
      if (!name.empty())
        assign(name, steps, word == "clear" ? Value::of(0.0) : binary("+", given.front().value, Value::of(step)));
      return Flow::kNext;
    }
    if (tokens.front().isWord()) {
      path_.noteLine(statement.line,
                     Text("'%1' is not in the file or not supported; if it moves the robot, these moves are missing.",
                          textOf(tokens)));
    } else {
      path_.noteLine(statement.line, Text("'%1' is not supported and is left out.", textOf(tokens)));
    }
    return Flow::kNext;
  }

  void setFrame(const std::vector<Argument>& given, const Tokens& tokens) {
    const auto wobj = std::find_if(given.begin(), given.end(), [](const Argument& a) { return a.name == "wobj"; });
    if (wobj == given.end()) return path_.setFrame(Pose::identity(), "");
    const Value& data = wobj->value;
    const auto user = data.items.size() > 4 ? rapidPose(data.items[3]) : std::nullopt;
    const auto object = data.items.size() > 4 ? rapidPose(data.items[4]) : std::nullopt;
    if (user && object) return path_.setFrame(*user * *object, "");
    Text name = "the work object, which the file does not define";
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i)
      if (tokens[i].is("wobj") && tokens[i + 1].is(":=")) name = Text("the work object '%1'", tokens[i + 2].text);
    path_.setFrame(std::nullopt, name);
  }

  void setSpeed(const std::vector<Argument>& given, std::size_t place, bool is_joint_move) {
    for (const Argument& argument : given)
      if (argument.name == "v" && argument.value.isNumber())
        path_.setLinearSpeed(kRapidMillimetre * argument.value.number);
    if (place >= given.size()) return;
    const auto speed = given[place].value.items.empty() ? std::nullopt : given[place].value.numbers(4);
    if (!speed) return;
    path_.setLinearSpeed(kRapidMillimetre * (*speed)[0]);
    path_.setAngularSpeed(kRapidDegree * (*speed)[1]);
    // A joint move runs about as fast as a line of that speed.
    if (is_joint_move) path_.setJointShare(std::min(1.0, kRapidMillimetre * (*speed)[0]));
  }

  static Text whyMissing(const Value& target) {
    const Text why = target.kind == Value::Kind::kUnknown ? target.whyUnknown() : Text();
    return why.empty() ? Text("a target that is not a robtarget or jointtarget") : Text("a target from %1", why);
  }

  /// 9E9 is an axis that is not there.
  void noteExternalAxes(const Value& target) {
    if (target.kind != Value::Kind::kList || target.items.empty()) return;
    const auto axes = target.items.back().numbers(6);
    if (axes && std::any_of(axes->begin(), axes->end(), [](double axis) { return axis < 8e9 && axis != 0.0; }))
      path_.note(Text("External axes of the targets are not kept."));
  }

  void move(const Statement& statement, const RapidMove& kind) {
    auto given = ExpressionReader(statement.tokens, 1, rapid(), meaning_).arguments();
    setFrame(given, statement.tokens);
    std::vector<Argument> plain;
    for (Argument& argument : given)
      if (argument.name.empty()) plain.push_back(argument);
    if (kind.before > 0)
      path_.noteLine(statement.line, Text("a search, which stops at a signal; it is read up to its end point."));
    const auto first = static_cast<std::size_t>(kind.before);
    const std::size_t last = first + (kind.is_circle ? 1 : 0);
    if (last >= plain.size()) return path_.missTarget(statement.line, Text("a move without target"));
    for (const Argument& argument : given)
      if (argument.name == "v") plain.push_back(argument);
    setSpeed(plain, last + 1, kind.is_joint);
    const Value& target = plain[first].value;
    noteExternalAxes(target);
    if (kind.is_circle) {
      const auto via = rapidPose(target), end = rapidPose(plain[last].value);
      if (!via || !end || !path_.current())
        return path_.missTarget(statement.line, whyMissing(via ? plain[last].value : target));
      return path_.moveArc(statement.line, *via, *end);
    }
    if (const auto X = rapidPose(target)) return path_.moveTo(statement.line, *X, kind.is_joint);
    if (const auto q =
            target.kind == Value::Kind::kList && !target.items.empty() ? target.items[0].numbers(6) : std::nullopt) {
      ProgramPath::Joints joints{};
      for (std::size_t i = 0; i < joints.size(); ++i) joints[i] = (*q)[i] * kRapidDegree;
      return path_.moveJoints(statement.line, joints, remarkedPose(statement.tokens));
    }
    path_.missTarget(statement.line, whyMissing(target));
  }

  std::optional<Pose> remarkedPose(const Tokens& tokens) const {
    const auto mark = std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return t.is("@pose"); });
    if (mark == tokens.end()) return std::nullopt;
    const auto at = static_cast<std::size_t>(mark - tokens.begin()) + 1;
    return rapidPose(ExpressionReader(tokens, at, rapid(), meaning_).expression());
  }
};

/// %%% VERSION:1 LANGUAGE:ENGLISH %%% before the module, its lines kept.
std::string withoutHead(std::string text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || text.compare(first, 3, "%%%") != 0) return text;
  const auto second = text.find("%%%", first + 3);
  if (second == std::string::npos) return text;
  for (std::size_t i = first; i < second + 3; ++i)
    if (text[i] != '\n') text[i] = ' ';
  return text;
}

std::string moduleName(const Tokens& tokens) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i)
    if (tokens[i].is("module")) return tokens[i + 1].text;
  return {};
}

}  // namespace

Expected<ReadProgram> readRapid(const std::string& text, const ProgramReadOptions& options) {
  const Tokens tokens = tokensOf(withoutHead(text), rapid());
  ProgramPath path(options);
  std::vector<Routine> routines;
  Block data;
  parseRapid(tokens, path, routines, data);
  if (path.hasFailed()) return path.finish("");
  RapidRun run(path);
  run.allowSteps(tokens.size());
  run.run(data);
  if (routines.empty()) return makeError({.found = "PROC is missing", .expected = "a RAPID module with a PROC"});
  run.addRoutines(routines);
  const auto moves = [&run](const Routine& r) { return run.moves(r.body); };
  auto main = std::find_if(routines.begin(), routines.end(), [](const Routine& r) { return r.name == "main"; });
  // A station's module often has an empty main() beside its paths.
  if (main == routines.end() || !moves(*main)) {
    main = std::find_if(routines.begin(), routines.end(),
                        [&](const Routine& r) { return r.parameters.empty() && moves(r); });
    if (main == routines.end())
      return makeError({.found = "no PROC has moves", .expected = "a PROC main(), or one with moves"});
    std::string others;
    for (const Routine& routine : routines)
      if (routine.name != main->name && moves(routine)) others += (others.empty() ? "" : ", ") + routine.name;
    path.note(others.empty()
                  ? Text("There is no PROC main() with moves: '%1', the first with moves, is read.", main->name)
                  : Text("There is no PROC main() with moves: '%1', the first with moves, is read. Procedures that it "
                         "does not call are not read: %2.",
                         main->name, others));
  }
  const Routine first = *main;
  run.run(first.body);
  const std::string name = moduleName(tokens);
  return path.finish(name.empty() ? first.name : name);
}

}  // namespace hapticell::trajectory
