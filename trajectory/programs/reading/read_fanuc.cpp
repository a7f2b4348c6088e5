// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <map>

#include "trajectory/motion/csv_table.h"
#include "trajectory/programs/reading/fanuc_file.h"
#include "trajectory/programs/reading/fanuc_registers.h"
#include "trajectory/programs/reading/program_readers.h"

namespace hapticell::trajectory {

namespace {

constexpr double kFanucDegree = 0.017453292519943295;  // rad
// Lines run: guards against loops without end. Half: programs with long loops are refused; twice: twice the time until
// an endless one is.
constexpr std::size_t kMostSteps = 500'000;

/// Runs the lines of /MN.
class FanucRun {
 public:
  FanucRun(const FanucFile& file, ProgramPath& path) : file_(file), path_(path) {
    for (std::size_t i = 0; i < file_.lines.size(); ++i)
      if (const auto label = fanucBracketed(file_.lines[i].text, "LBL["); label && starts(file_.lines[i].text, "LBL["))
        labels_[*label] = i;
  }

  void run() {
    std::size_t rounds = 0;
    for (at_ = 0; at_ < file_.lines.size() && !path_.hasFailed();) {
      const FanucLine& line = file_.lines[at_++];
      if (++rounds > kMostSteps + file_.lines.size())
        return path_.fail(line.line, Text("an endless loop"), Text("a program that ends"), "");
      step(line);
    }
  }

 private:
  static bool starts(const std::string& text, const char* word) { return text.starts_with(word); }

  void step(const FanucLine& line) {
    const std::string& text = line.text;
    if (starts(text, "J P") || starts(text, "L P") || starts(text, "C P") || starts(text, "A P") || starts(text, "S P"))
      return move(line);
    if (starts(text, "LBL[")) return;
    if (starts(text, "JMP")) return jump(line, fanucBracketed(text, "LBL["));
    if (starts(text, "IF")) return condition(line);
    if (starts(text, "FOR")) return beginFor(line);
    if (starts(text, "ENDFOR")) return endFor(line);
    if (starts(text, "SELECT"))
      return path_.fail(line.line, Text::plain("SELECT"), Text("lines that run one after the other"),
                        Text("In a copy of the program, delete the branches that you do not need."));
    if (starts(text, "ELSE")) return skipTo(line, {"ENDIF"});
    if (starts(text, "ENDIF")) return;
    if (starts(text, "WAIT")) return wait(line);
    if (starts(text, "R[")) return assign(line);
    if (starts(text, "PR[")) return assignPosition(line);
    if (starts(text, "END") || starts(text, "ABORT")) {
      at_ = file_.lines.size();
      return;
    }
    if (starts(text, "CALL") || starts(text, "RUN")) {
      path_.noteLine(line.line, Text("'%1' is not in the file; if it moves the robot, these moves are missing.", text));
    } else if (starts(text, "OFFSET") || starts(text, "TOOL_OFFSET") || starts(text, "VOFFSET")) {
      path_.fail(line.line, Text("'%1', which shifts the targets that follow", text), Text("targets without a shift"),
                 "");
    } else if (isStill(text)) {
      path_.skip(line.line);
    } else {
      path_.noteLine(line.line, Text("'%1' is not supported and is left out.", text.substr(0, 60)));
    }
  }

  static bool isStill(const std::string& text) {
    static constexpr std::array<const char*, 37> kWords{
        "UFRAME",     "UTOOL",       "DO[",       "RO[",       "GO[",      "AO[",    "SO[",     "FLG[",
        "F[",         "SR[",         "M[",        "TIMER",     "OVERRIDE", "UALM",   "MESSAGE", "PAYLOAD",
        "$",          "COL ",        "PAUSE",     "CALIBRATE", "LOCK",     "UNLOCK", "MONITOR", "JOINT_MAX",
        "LINEAR_MAX", "SOFTFLOAT",   "TC_ONLINE", "------",    "COND",     "CANCEL", "ARC ",    "WEAVE",
        "WELD",       "POINT_LOGIC", "RSR",       "--EG",      "COLL"};
    return std::any_of(kWords.begin(), kWords.end(), [&](const char* word) { return starts(text, word); });
  }

  void assign(const FanucLine& line) {
    if (!registers_.assign(fanucWithoutBlanks(line.text))) path_.skip(line.line);
  }

  void assignPosition(const FanucLine& line) {
    std::optional<FanucPosition> here;
    if (path_.current()) here = FanucPosition{line.line, path_.current(), {}, frame_, false, false};
    if (!registers_.assignPosition(fanucWithoutBlanks(line.text), here)) path_.skip(line.line);
  }

  void wait(const FanucLine& line) {
    const std::string text = fanucWithoutBlanks(line.text);
    const auto unit = text.find("(SEC)");
    const auto seconds = unit == std::string::npos ? std::nullopt : registers_.number(text.substr(4, unit - 4));
    if (seconds)
      path_.wait(*seconds);
    else
      path_.skip(line.line);
  }

  void jump(const FanucLine& line, const std::optional<int>& label) {
    const auto found = label ? labels_.find(*label) : labels_.end();
    if (found == labels_.end())
      return path_.fail(line.line, Text("a jump to a label that does not exist"), Text("a LBL in the program"), "");
    if (found->second < at_ && !is_decided_) {
      path_.noteLine(line.line, Text("a jump back; the repeated lines are read once."));
      return;
    }
    at_ = found->second;
  }

  /// IF condition,JMP LBL[1] | CALL X; IF (condition) THEN.
  void condition(const FanucLine& line) {
    const std::string& text = line.text;
    const auto then = text.rfind("THEN");
    const auto comma = text.rfind(',');
    const bool is_block = then != std::string::npos;
    const std::size_t end = is_block ? then : comma;
    if (end == std::string::npos || end < 2)
      return path_.noteLine(line.line, Text("'%1' is not supported and is left out.", text.substr(0, 60)));
    const auto is_true = registers_.holds(text.substr(2, end - 2));
    if (is_block) {
      if (!is_true) return undecidedBlock(line);
      if (!*is_true) skipTo(line, {"ELSE", "ENDIF"});
      return;
    }
    if (!is_true) {
      path_.noteLine(line.line,
                     Text("'%1' depends on values that the file does not define; the condition is read as false.",
                          text.substr(0, 60)));
      return;
    }
    if (!*is_true) return;
    const std::string rest = text.substr(comma + 1);
    is_decided_ = true;
    if (rest.find("JMP") != std::string::npos)
      jump(line, fanucBracketed(rest, "LBL["));
    else
      path_.noteLine(line.line, Text("'%1' is not in the file; if it moves the robot, these moves are missing.", rest));
    is_decided_ = false;
  }

  void undecidedBlock(const FanucLine& line) {
    const std::size_t from = at_;
    skipTo(line, {"ENDIF"});
    for (std::size_t i = from; i < at_ && i < file_.lines.size(); ++i) {
      const std::string& text = file_.lines[i].text;
      if (text.size() > 2 && text[1] == ' ' && text[2] == 'P')
        return path_.fail(line.line, Text("moves that depend on '%1'", line.text.substr(0, 60)),
                          Text("a condition with values that the file defines"),
                          Text("In a copy of the program, delete the branch that you do not need."));
    }
    path_.skip(line.line);
  }

  /// Behind the matching one of these lines.
  void skipTo(const FanucLine& line, std::initializer_list<const char*> words) {
    for (int depth = 0; at_ < file_.lines.size(); ++at_) {
      const std::string& text = file_.lines[at_].text;
      if (starts(text, "IF") && text.find("THEN") != std::string::npos) ++depth;
      for (const char* word : words) {
        if (depth != 0 || !starts(text, word)) continue;
        ++at_;
        return;
      }
      if (starts(text, "ENDIF")) --depth;
    }
    path_.fail(line.line, Text("an IF without its ENDIF"), Text::plain("ENDIF"), "");
  }

  struct Loop {
    std::size_t first;
    int register_number;
    double to, step;
  };

  /// FOR R[1]=1 TO 3
  void beginFor(const FanucLine& line) {
    const std::string text = fanucWithoutBlanks(line.text.substr(3));
    const bool is_down = text.find("DOWNTO") != std::string::npos;
    const auto to = text.find(is_down ? "DOWNTO" : "TO"), equals = text.find('=');
    const auto r = fanucBracketed(text, "R[");
    if (!r || to == std::string::npos || equals == std::string::npos || equals > to)
      return path_.fail(line.line, Text("an invalid FOR"), Text::plain("FOR R[1]=1 TO 3"), "");
    const auto from = registers_.number(text.substr(equals + 1, to - equals - 1)),
               last = registers_.number(text.substr(to + (is_down ? 6 : 2)));
    if (!from || !last)
      return path_.fail(line.line, Text("a FOR with limits that the file does not define"),
                        Text("numbers, or registers that the program sets"), "");
    registers_.set(*r, *from);
    loops_.push_back({at_, *r, *last, is_down ? -1.0 : 1.0});
    if ((*last - *from) * loops_.back().step >= 0.0) return;
    loops_.pop_back();
    for (int depth = 1; at_ < file_.lines.size() && depth > 0; ++at_) {
      if (starts(file_.lines[at_].text, "FOR ")) ++depth;
      if (starts(file_.lines[at_].text, "ENDFOR")) --depth;
    }
  }

  void endFor(const FanucLine& line) {
    if (loops_.empty()) return path_.fail(line.line, Text("ENDFOR without FOR"), Text::plain("FOR"), "");
    const Loop loop = loops_.back();
    const double value = registers_.value(loop.register_number).value_or(0.0);
    if ((loop.to - value - loop.step) * loop.step >= 0.0) {
      registers_.set(loop.register_number, value + loop.step);
      at_ = loop.first;
    } else {
      loops_.pop_back();
    }
  }

  void setSpeed(const std::string& text) {
    struct Unit {
      const char* name;
      double scale;
    };
    for (const Unit& unit : {Unit{"MM/SEC", 1e-3}, Unit{"CM/MIN", 1e-2 / 60.0}, Unit{"INCH/MIN", 0.0254 / 60.0},
                             Unit{"DEG/SEC", kFanucDegree}, Unit{"%", 0.01}}) {
      const auto at = text.find(unit.name);
      if (at == std::string::npos) continue;
      auto begin = at;
      while (begin > 0 && std::string_view("0123456789.").find(text[begin - 1]) != std::string_view::npos) --begin;
      const auto value = parseNumber(text.substr(begin, at - begin));
      if (!value) return;
      if (*unit.name == '%')
        path_.setJointShare(unit.scale * *value);
      else if (*unit.name == 'D')
        path_.setAngularSpeed(unit.scale * *value);
      else
        path_.setLinearSpeed(unit.scale * *value);
      return;
    }
  }

  const FanucPosition* positionIn(const FanucLine& line, std::size_t from, Text& why) const {
    const std::size_t place = line.text.find('P', from);
    if (place == std::string::npos) {
      why = Text("a move without target");
      return nullptr;
    }
    if (line.text.compare(place, 2, "PR") == 0) {
      const auto pr = fanucRegisterIn(line.text.substr(place));
      if (const FanucPosition* held = pr ? registers_.position(pr->first) : nullptr) return held;
      why = Text("a target in a position register, which the program does not set");
      return nullptr;
    }
    auto number = fanucBracketed(line.text, "P[", place);
    if (!number) {
      // P[R[1]]
      const auto r = fanucBracketed(line.text, "P[R[", place);
      if (const auto value = r ? registers_.value(*r) : std::nullopt) number = static_cast<int>(*value);
    }
    const auto found = number ? file_.positions.find(*number) : file_.positions.end();
    if (found == file_.positions.end()) {
      why = number ? Text("P[%1], which is not in /POS", *number) : Text("a position from a register");
      return nullptr;
    }
    if (!found->second.X && !found->second.joints) {
      why = Text("P[%1], which has no value", *number);
      return nullptr;
    }
    return &found->second;
  }

  void move(const FanucLine& line) {
    const std::string& text = line.text;
    if (text.find("OFFSET") != std::string::npos) {
      return path_.fail(line.line, Text("a target with an offset by a position register"),
                        Text("targets without a shift"),
                        Text("In a copy of the program, delete the offset, or add it to the targets."));
    }
    setSpeed(text);
    if (text.find(" COORD") != std::string::npos)
      path_.note(Text(
          "COORD: poses are relative to the part on the other motion group; the motion of that group is not read."));
    Text why;
    const FanucPosition* position = positionIn(line, 2, why);
    if (!position) return path_.missTarget(line.line, why);
    if (position->has_more_groups) path_.note(Text("Only motion group 1 is read."));
    if (position->has_external_axes) path_.note(Text("External axes of the targets (E1 ...) are not kept."));
    if (text.front() == 'C') {
      const auto behind = text.find(']', 2);
      const std::size_t second = behind == std::string::npos ? behind : text.find('P', behind);
      if (second == std::string::npos || text.compare(second, 2, "P[") != 0)
        return path_.fail(line.line, Text("C with only one position"), Text("two positions"), "");
      const FanucPosition* end = positionIn(line, second, why);
      setFrame(*position);
      if (!end || !end->X || !position->X || !path_.current())
        return path_.missTarget(line.line, end ? Text("an arc with undefined points") : why);
      return path_.moveArc(line.line, *position->X, *end->X);
    }
    if (text.front() == 'A' || text.front() == 'S')
      path_.noteLine(
          line.line,
          Text("an arc or spline with one point per line; it is read as straight lines between the points."));
    const bool is_relative = text.find(" INC") != std::string::npos;
    if (position->joints) return moveJoints(line, *position->joints, is_relative);
    setFrame(*position);
    Pose X = *position->X;
    if (is_relative) {
      const auto here = path_.current();
      if (!here)
        return path_.fail(line.line, Text("a move relative to a target that the file does not define"),
                          Text("a known target"), "");
      X = {here->p + X.p, glm::normalize(X.q * here->q)};
    }
    path_.moveTo(line.line, X, text.front() == 'J');
  }

  void setFrame(const FanucPosition& position) {
    frame_ = position.frame;
    if (position.frame == 0) return path_.setFrame(Pose::identity(), "");
    path_.setFrame(std::nullopt,
                   position.frame < 0 ? Text("the active frame") : Text("the user frame %1", position.frame));
  }

  void moveJoints(const FanucLine& line, ProgramPath::Joints joints, bool is_relative) {
    if (is_relative) return path_.missTarget(line.line, Text("joints relative to the target before"));
    // FANUC counts axis 3 from the horizontal, models from axis 2.
    joints[2] += joints[1];
    path_.note(Text("FANUC measures J3 from the horizontal: J2 is added to J3."));
    path_.moveJoints(line.line, joints);
  }

  const FanucFile& file_;
  ProgramPath& path_;
  std::map<int, std::size_t> labels_;
  FanucRegisters registers_{file_.positions};
  int frame_ = 0;  // of the last target
  std::vector<Loop> loops_;
  std::size_t at_ = 0;
  bool is_decided_ = false;
};

}  // namespace

Expected<ReadProgram> readFanuc(const std::string& text, const ProgramReadOptions& options) {
  const FanucFile file = parseFanuc(text);
  if (file.lines.empty())
    return makeError({.place = Text::plain("/MN"),
                      .found = "the program has no lines",
                      .expected = "a FANUC program in LS form: /PROG, /MN, /POS"});
  ProgramPath path(options);
  FanucRun(file, path).run();
  return path.finish(file.name);
}

}  // namespace hapticell::trajectory
