// SPDX-License-Identifier: Apache-2.0
#include "tests/trajectory/programs/writing/program_grammar.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>

namespace hapticell::test {

namespace {

struct Wrong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A cursor over a text; what is asked for and not there is Wrong.
class Cursor {
 public:
  explicit Cursor(std::string text, bool skips_lines = false) : text_(std::move(text)), skips_lines_(skips_lines) {}

  bool isAtEnd() { return blanks(), at_ >= text_.size(); }
  bool isNext(const std::string& what) { return blanks(), text_.compare(at_, what.size(), what) == 0; }
  bool maybe(const std::string& what) {
    if (!isNext(what)) return false;
    at_ += what.size();
    return true;
  }
  void need(const std::string& what) {
    if (!maybe(what)) fail("'" + what + "'");
  }
  /// A word that is not the begin of a longer one.
  bool maybeWord(const std::string& what) {
    if (!isNext(what) || isWordSign(at_ + what.size())) return false;
    at_ += what.size();
    return true;
  }
  void needWord(const std::string& what) {
    if (!maybeWord(what)) fail("the word '" + what + "'");
  }
  std::string word() {
    blanks();
    std::string result;
    while (isWordSign(at_)) result += text_[at_++];
    if (result.empty() || std::isdigit(static_cast<unsigned char>(result.front())) != 0) fail("a word");
    return result;
  }
  double number() {
    blanks();
    const std::size_t begin = at_;
    if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
    std::size_t digits = 0;
    while (isDigit()) ++at_, ++digits;
    if (at_ < text_.size() && text_[at_] == '.') ++at_;
    while (isDigit()) ++at_, ++digits;
    if (digits > 0 && at_ < text_.size() && (text_[at_] == 'E' || text_[at_] == 'e')) {
      ++at_;
      if (text_[at_] == '-' || text_[at_] == '+') ++at_;
      while (isDigit()) ++at_;
    }
    if (digits == 0) fail("a number");
    return std::stod(text_.substr(begin, at_ - begin));
  }
  /// "[a,b,c]" of numbers, all in one list.
  void numbers(const std::string& open, const std::string& close, std::vector<double>& into) {
    need(open);
    do into.push_back(number());
    while (maybe(","));
    need(close);
  }
  std::string restOfLine() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string rest = text_.substr(at_, end - at_);
    at_ = end;
    return rest;
  }
  void line() {
    blanks();
    maybe("\r");
    if (at_ < text_.size() && text_[at_] != '\n') fail("the line's end");
    if (at_ < text_.size()) ++at_;
  }
  [[noreturn]] void fail(const std::string& expected) {
    const auto number =
        1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size())), '\n');
    throw Wrong("line " + std::to_string(number) + ": '" + text_.substr(std::min(at_, text_.size()), 30) +
                "' instead of " + expected);
  }

 private:
  bool isDigit() const { return at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9'; }
  bool isWordSign(std::size_t at) const {
    return at < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at])) != 0 || text_[at] == '_') &&
           static_cast<unsigned char>(text_[at]) < 128;
  }
  void blanks() {
    while (at_ < text_.size() &&
           (text_[at_] == ' ' || text_[at_] == '\t' || (skips_lines_ && (text_[at_] == '\n' || text_[at_] == '\r'))))
      ++at_;
  }
  std::string text_;
  bool skips_lines_;
  std::size_t at_ = 0;
};

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

void needName(const std::string& name, std::size_t longest, const std::set<std::string>& reserved) {
  if (name.size() > longest) throw Wrong("the name " + name + " is too long");
  if (std::isalpha(static_cast<unsigned char>(name.front())) == 0)
    throw Wrong("the name " + name + " begins with no letter");
  if (reserved.contains(upper(name))) throw Wrong("the name " + name + " is reserved");
}

template <class Parse>
std::string guarded(Parse&& parse) {
  try {
    parse();
  } catch (const Wrong& wrong) {
    return wrong.what();
  } catch (const std::exception& other) {
    return std::string("a number out of range: ") + other.what();
  }
  return {};
}

/// The tokens of krl.g4 that are words.
const std::set<std::string>& krlTokens() {
  static const std::set<std::string> kWords{
      "AND",      "ANIN",    "ANOUT",    "B_AND",     "B_NOT",  "B_OR",      "B_EXOR",  "BOOL",    "BRAKE",
      "C_DIS",    "C_ORI",   "C_PTP",    "C_VEL",     "CASE",   "CAST_FROM", "CAST_TO", "CHAR",    "CIRC_REL",
      "CIRC",     "CONST",   "CONTINUE", "DELAY",     "DECL",   "DEF",       "DEFAULT", "DEFDAT",  "DEFFCT",
      "DO",       "ELSE",    "END",      "ENDDAT",    "ENDFCT", "ENDFOR",    "ENDIF",   "ENDLOOP", "ENDSWITCH",
      "ENDWHILE", "ENUM",    "EXIT",     "EXT",       "EXTFCT", "FALSE",     "FOR",     "GLOBAL",  "GOTO",
      "HALT",     "IF",      "IMPORT",   "INTERRUPT", "INT",    "IS",        "LIN_REL", "LIN",     "LOOP",
      "MAXIMUM",  "MINIMUM", "NOT",      "OR",        "PRIO",   "PTP_REL",   "PTP",     "PUBLIC",  "REAL",
      "REPEAT",   "RETURN",  "SEC",      "SIGNAL",    "STRUC",  "SWITCH",    "THEN",    "TO",      "TRIGGER",
      "TRUE",     "UNTIL",   "WAIT",     "WHEN",      "WHILE",  "EXOR"};
  return kWords;
}

/// X 1,Y 2,...; the names in this order.
std::vector<double> krlRecord(Cursor& at, const std::vector<std::string>& names) {
  std::vector<double> numbers;
  at.need("{");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) at.need(",");
    at.needWord(names[i]);
    numbers.push_back(at.number());
  }
  return numbers;
}

/// CONST|PERS data of RAPID: [[x,y,z],[q1..q4],[c1..c4],[e1..e6]].
std::vector<double> rapidTarget(Cursor& at) {
  std::vector<double> numbers, rest;
  at.need("[");
  at.numbers("[", "]", numbers);
  at.need(",");
  at.numbers("[", "]", numbers);
  at.need(",");
  at.numbers("[", "]", rest);
  if (rest.size() != 4) at.fail("four configuration data");
  at.need(",");
  rest.clear();
  at.numbers("[", "]", rest);
  if (rest.size() != 6) at.fail("six external axes");
  at.need("]");
  if (numbers.size() != 7) at.fail("a position and a quaternion");
  return numbers;
}

const std::set<std::string>& rapidReserved() {
  static const std::set<std::string> kWords{
      "ALIAS", "AND", "BACKWARD", "CASE", "CONNECT", "CONST", "DEFAULT", "DIV", "DO", "ELSE", "ELSEIF", "ENDFOR",
      "ENDFUNC", "ENDIF", "ENDMODULE", "ENDPROC", "ENDRECORD", "ENDTEST", "ENDTRAP", "ENDWHILE", "ERROR", "EXIT",
      "FALSE", "FOR", "FROM", "FUNC", "GOTO", "IF", "INOUT", "LOCAL", "MOD", "MODULE", "NOSTEPIN", "NOT", "NOVIEW",
      "OR", "PERS", "PROC", "RAISE", "READONLY", "RECORD", "RETRY", "RETURN", "STEP", "SYSMODULE", "TEST", "THEN", "TO",
      "TRAP", "TRUE", "TRYNEXT", "UNDO", "VAR", "VIEWONLY", "WHILE", "WITH", "XOR",
      // Names in the same scope: the program's own, and installed ones.
      "MAIN", "VLINE", "P1", "P2", "NUM", "ROBTARGET", "MOVEL", "TOOL0"};
  return kWords;
}

void rapidComments(Cursor& at) {
  while (at.maybe("!")) at.restOfLine();
}

void rapidMove(Cursor& at, std::map<std::string, std::vector<double>>& points, ParsedProgram& program) {
  ParsedProgram::Move move;
  if (at.maybeWord("MoveAbsJ")) {
    move.kind = 'J';
    move.is_joints = true;
    std::vector<double> external;
    at.need("[");
    at.numbers("[", "]", move.target);
    at.need(",");
    at.numbers("[", "]", external);
    at.need("]");
    if (move.target.size() != 6 || external.size() != 6) at.fail("six joints and six external axes");
  } else {
    move.kind = at.maybeWord("MoveJ") ? 'J' : (at.needWord("MoveL"), 'L');
    const std::string point = at.word();
    if (!points.contains(point)) at.fail("a declared robtarget, not " + point);
    move.target = points[point];
  }
  at.need(",");
  if (at.word() != "vLine") at.fail("declared speed data");
  at.need(",");
  if (!at.maybeWord("fine")) {
    std::vector<double> zone;
    at.need("[");
    at.needWord("FALSE");
    at.need(",");
    do zone.push_back(at.number());
    while (at.maybe(","));
    at.need("]");
    if (zone.size() != 6 || zone[0] <= 0.0) at.fail("zone data");
    move.blend = zone[0];
  }
  at.need(",");
  at.word();
  if (at.maybe("\\")) {
    at.needWord("WObj");
    at.need(":=");
    at.word();
  }
  at.need(";");
  program.moves.push_back(move);
}

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
};

/// Elements of a small XML text in order; Wrong where tags do not close.
std::vector<Element> xmlElements(const std::string& whole, std::string* code = nullptr) {
  if (!whole.starts_with("\xEF\xBB\xBF<?xml ")) throw Wrong("no byte order mark and declaration");
  std::vector<Element> elements;
  std::vector<std::string> open;
  for (std::size_t at = whole.find("?>") + 2; at < whole.size();) {
    if (whole[at] != '<') {
      if (std::isspace(static_cast<unsigned char>(whole[at])) == 0) throw Wrong("text outside of elements");
      ++at;
      continue;
    }
    if (whole.compare(at, 9, "<![CDATA[") == 0) {
      const auto end = whole.find("]]>", at);
      if (end == std::string::npos) throw Wrong("CDATA that does not end");
      if (code) *code = whole.substr(at + 9, end - at - 9);
      at = end + 3;
      continue;
    }
    const auto end = whole.find('>', at);
    if (end == std::string::npos) throw Wrong("a tag that does not end");
    std::string tag = whole.substr(at + 1, end - at - 1);
    at = end + 1;
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) throw Wrong("</" + tag.substr(1) + "> without its begin");
      open.pop_back();
      continue;
    }
    const bool is_empty = tag.back() == '/';
    if (is_empty) tag.pop_back();
    Element element;
    std::size_t i = tag.find_first_of(" \n");
    element.name = tag.substr(0, i);
    while (i < tag.size()) {
      i = tag.find_first_not_of(" \n", i);
      if (i == std::string::npos) break;
      const auto equals = tag.find("=\"", i), close = equals == std::string::npos ? equals : tag.find('"', equals + 2);
      if (close == std::string::npos) throw Wrong("an attribute that does not end in " + tag);
      element.attributes[tag.substr(i, equals - i)] = tag.substr(equals + 2, close - equals - 2);
      i = close + 1;
    }
    if (!is_empty) open.push_back(element.name);
    elements.push_back(element);
  }
  if (!open.empty()) throw Wrong("<" + open.back() + "> does not end");
  return elements;
}

/// A data array of VAL3: its type and values.
struct Val3Data {
  std::string type;
  std::vector<std::map<std::string, std::string>> values;
};

std::map<std::string, Val3Data> val3Database(const std::string& text) {
  std::map<std::string, Val3Data> data;
  std::string current;
  std::size_t size = 0;
  for (const Element& element : xmlElements(text)) {
    if (element.name == "Data") {
      if (!current.empty() && data[current].values.size() != size) throw Wrong("another size of " + current);
      current = element.attributes.at("name");
      needName(current, 15, {});
      data[current].type = element.attributes.at("type");
      size = std::stoul(element.attributes.at("size"));
    } else if (element.name == "Value") {
      if (element.attributes.at("key") != std::to_string(data[current].values.size())) throw Wrong("keys out of order");
      data[current].values.push_back(element.attributes);
    }
  }
  return data;
}

}  // namespace

std::string parseKrl(const std::string& source, const std::string& data, ParsedProgram& program) {
  return guarded([&] {
    std::map<std::string, std::vector<double>> points;
    std::string data_name;
    Cursor dat(data);
    dat.need("&ACCESS RVP");
    dat.line();
    dat.needWord("DEFDAT");
    data_name = dat.word();
    dat.line();
    while (!dat.maybeWord("ENDDAT")) {
      dat.needWord("DECL");
      dat.needWord("E6POS");
      const std::string name = dat.word();
      needName(name, 24, krlTokens());
      dat.need("=");
      points[name] = krlRecord(dat, {"X", "Y", "Z", "A", "B", "C"});
      dat.need(",");
      if (dat.maybeWord("S")) {
        dat.number();
        dat.need(",");
        dat.needWord("T");
        dat.number();
        dat.need(",");
      }
      for (int i = 1; i <= 6; ++i) {
        if (i > 1) dat.need(",");
        dat.needWord("E" + std::to_string(i));
        dat.number();
      }
      dat.need("}");
      dat.line();
    }
    Cursor src(source);
    src.need("&ACCESS RVP");
    src.line();
    src.needWord("DEF");
    program.name = src.word();
    needName(program.name, 24, krlTokens());
    if (program.name != data_name) src.fail("the name of the data list, " + data_name);
    if (points.contains(upper(program.name))) src.fail("a name that no point has");
    src.need("(");
    src.need(")");
    src.line();
    double blend = 0.0;
    for (;;) {
      if (src.maybe(";")) {
        src.restOfLine();
      } else if (src.maybeWord("END")) {
        break;
      } else if (src.maybeWord("BAS")) {
        src.need("(");
        src.need("#INITMOV");
        src.need(",");
        src.number();
        src.need(")");
      } else if (src.maybe("$")) {
        std::string name = "$" + src.word();
        if (src.maybe(".")) name += "." + src.word();
        if (src.maybe("[")) {
          name += "[" + std::to_string(static_cast<int>(src.number())) + "]";
          src.need("]");
        }
        src.need("=");
        if (name == "$TOOL" || name == "$BASE") {
          src.restOfLine();
        } else {
          program.settings[name] = src.number();
          if (!(program.settings[name] > 0.0)) src.fail("a value over 0 for " + name);
          if (name == "$APO.CDIS") blend = program.settings[name];
        }
      } else if (src.maybeWord("WAIT")) {
        src.needWord("SEC");
        const double seconds = src.number();
        if (program.moves.empty() || !(seconds > 0.0)) src.fail("a time over 0 behind a move");
        program.moves.back().dwell = seconds;
      } else {
        ParsedProgram::Move move;
        move.kind = src.maybeWord("PTP") ? 'J' : (src.needWord("LIN"), 'L');
        if (src.isNext("{")) {
          move.is_joints = true;
          move.target = krlRecord(src, {"A1", "A2", "A3", "A4", "A5", "A6"});
          src.need("}");
        } else {
          const std::string point = src.word();
          if (!points.contains(point)) src.fail("a declared point, not " + point);
          move.target = points[point];
        }
        if (src.maybeWord("C_DIS")) move.blend = blend;
        program.moves.push_back(move);
        if (src.maybe(";")) src.restOfLine();
      }
      src.line();
    }
    src.line();
    if (!src.isAtEnd()) src.fail("the end");
  });
}

std::string parseRapid(const std::string& text, ParsedProgram& program) {
  return guarded([&] {
    std::map<std::string, std::vector<double>> points;
    Cursor at(text, true);
    at.needWord("MODULE");
    program.name = at.word();
    needName(program.name, 32, rapidReserved());
    rapidComments(at);
    while (!at.maybeWord("PROC")) {
      at.needWord("CONST");
      const bool is_speed = at.maybeWord("speeddata");
      if (!is_speed) at.needWord("robtarget");
      const std::string name = at.word();
      at.need(":=");
      std::vector<double> speed;
      if (is_speed) {
        at.numbers("[", "]", speed);
        if (speed.size() != 4 || !(speed[0] > 0.0)) at.fail("speed data");
        program.settings["speed"] = speed[0];
      } else {
        points[name] = rapidTarget(at);
        if (upper(name) == upper(program.name)) at.fail("a point with another name than the module's");
      }
      at.need(";");
    }
    at.needWord("main");
    at.need("(");
    at.need(")");
    while (!at.maybeWord("ENDPROC")) {
      rapidComments(at);
      if (at.maybe("ConfL\\Off;") || at.maybe("ConfJ\\Off;")) continue;
      if (at.maybeWord("WaitTime")) {
        const double seconds = at.number();
        if (!(seconds > 0.0) || program.moves.empty()) at.fail("a time over 0 behind a move");
        program.moves.back().dwell = seconds;
        at.need(";");
        continue;
      }
      rapidMove(at, points, program);
      rapidComments(at);
    }
    at.needWord("ENDMODULE");
    if (!at.isAtEnd()) at.fail("the end");
  });
}

std::string parseFanuc(const std::string& text, ParsedProgram& program) {
  return guarded([&] {
    Cursor at(text);
    at.needWord("/PROG");
    program.name = at.word();
    needName(program.name, 36, {"CON", "PRN", "AUX", "NUL", "COM1", "LPT1"});
    if (upper(program.name) != program.name) at.fail("an upper case name");
    at.line();
    at.need("/ATTR");
    at.line();
    while (!at.maybe("/MN")) {
      at.word();
      at.need("=");
      if (const std::string rest = at.restOfLine(); rest.empty() || rest.back() != ';')
        at.fail("a ';' at the line's end");
      at.line();
    }
    at.line();
    std::vector<std::size_t> used;
    for (int line = 1; !at.maybe("/POS"); ++line) {
      if (static_cast<int>(at.number()) != line) at.fail("line " + std::to_string(line));
      at.need(":");
      if (at.maybe("!")) {
        const std::string remark = at.restOfLine();
        if (remark.size() > 34 || remark.substr(remark.size() - 2) != " ;") at.fail("a remark of at most 32 signs");
        at.line();
        continue;
      }
      if (at.maybeWord("WAIT")) {
        const double seconds = at.number();
        if (!(seconds >= 0.01) || seconds > 327.67 || program.moves.empty()) at.fail("0.01 to 327.67 s behind a move");
        program.moves.back().dwell = seconds;
        at.need("(sec)");
      } else if (at.maybe("UFRAME_NUM=") || at.maybe("UTOOL_NUM=")) {
        at.number();
      } else {
        ParsedProgram::Move move;
        move.kind = at.maybeWord("J") ? 'J' : (at.needWord("L"), 'L');
        at.need("P[");
        used.push_back(static_cast<std::size_t>(at.number()));
        at.need("]");
        const double speed = at.number();
        if (speed != static_cast<int>(speed) || speed < 1.0 || speed > (move.kind == 'J' ? 100.0 : 4000.0))
          at.fail("a whole speed in its range");
        at.need(move.kind == 'J' ? "%" : "mm/sec");
        program.settings[move.kind == 'J' ? "joint speed" : "speed"] = speed;
        if (!at.maybeWord("FINE")) {
          at.need("CNT");
          move.blend = at.number();
          if (move.blend < 0.0 || move.blend > 100.0) at.fail("CNT0 to CNT100");
        }
        program.moves.push_back(move);
      }
      at.need(";");
      at.line();
    }
    at.line();
    std::map<std::size_t, std::vector<double>> points;
    while (!at.maybe("/END")) {
      at.need("P[");
      const auto number = static_cast<std::size_t>(at.number());
      at.need("]{");
      at.line();
      at.need("GP1:");
      at.line();
      at.need("UF");
      at.need(":");
      at.number();
      at.need(",");
      at.need("UT");
      at.need(":");
      at.number();
      at.need(",");
      at.need("CONFIG");
      at.need(":");
      at.need("'");
      if (!at.maybe("N") && !at.maybe("F")) at.fail("N or F");
      if (!at.maybe("U") && !at.maybe("D")) at.fail("U or D");
      if (!at.maybe("T") && !at.maybe("B")) at.fail("T or B");
      for (int i = 0; i < 3; ++i) {
        at.need(",");
        at.number();
      }
      at.need("',");
      at.line();
      for (const char* name : {"X", "Y", "Z", "W", "P", "R"}) {
        at.needWord(name);
        at.need("=");
        points[number].push_back(at.number());
        at.needWord(*name >= 'X' ? "mm" : "deg");
        if (*name != 'R') at.need(",");
        if (*name == 'Z' || *name == 'R') at.line();
      }
      at.need("};");
      at.line();
    }
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!points.contains(used[i])) throw Wrong("P[" + std::to_string(used[i]) + "] is not in /POS");
      program.moves[i].target = points[used[i]];
    }
  });
}

std::string parseUrScript(const std::string& text, ParsedProgram& program) {
  static const std::set<std::string> kReserved{
      "AND",  "AS",     "ASSERT", "BREAK", "CONTINUE", "DEF",   "ELIF",  "ELSE",  "END",  "FALSE",  "GLOBAL",
      "HALT", "IF",     "IN",     "JOIN",  "KILL",     "LOCAL", "NOT",   "OR",    "PASS", "RETURN", "RUN",
      "SEC",  "THREAD", "TRUE",   "WHILE", "XOR",      "MOVEL", "MOVEJ", "SLEEP", "P"};
  return guarded([&] {
    Cursor at(text);
    while (at.maybe("#")) {
      at.restOfLine();
      at.line();
    }
    at.needWord("def");
    program.name = at.word();
    needName(program.name, 60, kReserved);
    at.need("():");
    at.line();
    while (!at.maybeWord("end")) {
      if (at.maybe("#")) {
        at.restOfLine();
      } else if (at.maybeWord("set_tcp")) {
        at.restOfLine();
      } else if (at.maybeWord("sleep")) {
        at.need("(");
        const double seconds = at.number();
        at.need(")");
        if (!(seconds > 0.0) || program.moves.empty()) at.fail("a time over 0 behind a move");
        program.moves.back().dwell = seconds;
      } else {
        ParsedProgram::Move move;
        move.kind = at.maybeWord("movej") ? 'J' : (at.needWord("movel"), 'L');
        at.need("(");
        move.is_joints = at.isNext("[");
        at.numbers(move.is_joints ? "[" : "p[", "]", move.target);
        if (move.target.size() != 6) at.fail("six numbers");
        while (at.maybe(",")) {
          const std::string name = at.word();
          at.need("=");
          const double value = at.number();
          if (!(value > 0.0)) at.fail("a value over 0 for " + name);
          if (name == "r")
            move.blend = value;
          else
            program.settings[std::string(1, move.kind) + name] = value;
        }
        at.need(")");
        if (at.maybe("#")) at.restOfLine();
        program.moves.push_back(move);
      }
      at.line();
    }
    at.line();
    if (at.word() != program.name) at.fail("a call of " + program.name);
    at.need("()");
    at.line();
    if (!at.isAtEnd()) at.fail("the end");
  });
}

std::string parseVal3(const std::map<std::string, std::string>& files, ParsedProgram& program) {
  return guarded([&] {
    std::string database;
    std::set<std::string> named;
    for (const auto& [name, text] : files) {
      if (!name.ends_with(".pjx")) continue;
      const auto slash = name.find('/');
      program.name = name.substr(slash + 1, name.size() - slash - 5);
      if (name.substr(0, slash) != program.name) throw Wrong("a folder of another name than its application");
      needName(program.name, 15,
               {"BEGIN", "END", "IF", "FOR", "CALL", "START", "STOP", "NUM", "TOOL", "FRAME", "POINT", "WHILE",
                "RETURN", "DEFAULT"});
      for (const Element& element : xmlElements(text)) {
        if (!element.attributes.contains("file")) continue;
        named.insert(element.attributes.at("file"));
        if (!files.contains(program.name + "/" + element.attributes.at("file")))
          throw Wrong("a file that is not there");
        if (element.name == "Data") database = element.attributes.at("file");
      }
    }
    if (!named.contains("start.pgx") || !named.contains("stop.pgx")) throw Wrong("no programs start and stop");
    auto data = val3Database(files.at(program.name + "/" + database));
    std::string stop;
    xmlElements(files.at(program.name + "/stop.pgx"), &stop);
    std::string code;
    xmlElements(files.at(program.name + "/start.pgx"), &code);
    const auto variable = [&data](Cursor& at,
                                  const std::set<std::string>& types) -> std::map<std::string, std::string> {
      const std::string name = at.word();
      std::size_t index = 0;
      if (at.maybe("[")) {
        index = static_cast<std::size_t>(at.number());
        at.need("]");
      }
      if (!data.contains(name) || !types.contains(data[name].type) || index >= data[name].values.size())
        at.fail("declared data, not " + name);
      return data[name].values[index];
    };
    Cursor at(code);
    at.needWord("begin");
    at.line();
    while (!at.maybeWord("end")) {
      if (at.maybe("//")) {
        at.restOfLine();
      } else if (at.maybeWord("waitEndMove")) {
        at.need("()");
      } else if (at.maybeWord("delay")) {
        at.need("(");
        const double seconds = at.number();
        at.need(")");
        if (!(seconds > 0.0) || program.moves.empty()) at.fail("a time over 0 behind a move");
        program.moves.back().dwell = seconds;
      } else {
        ParsedProgram::Move move;
        move.kind = at.maybeWord("movej") ? 'J' : (at.needWord("movel"), 'L');
        at.need("(");
        const auto target = variable(
            at, move.kind == 'J' ? std::set<std::string>{"jointRx", "pointRx"} : std::set<std::string>{"pointRx"});
        move.is_joints = target.contains("j1");
        for (const char* name : {"x", "y", "z", "rx", "ry", "rz", "j1", "j2", "j3", "j4", "j5", "j6"})
          if (target.contains(name)) move.target.push_back(std::stod(target.at(name)));
        if (move.target.size() != 6) at.fail("six coordinates");
        at.need(",");
        variable(at, {"tool"});
        at.need(",");
        const auto motion = variable(at, {"mdesc"});
        at.need(")");
        program.settings[move.kind == 'J' ? "joint speed" : "lines' joint speed"] = std::stod(motion.at("vel"));
        program.settings["speed"] = std::stod(motion.at("tmax"));
        if (!(program.settings["speed"] > 0.0)) at.fail("a speed over 0");
        move.blend = motion.at("blend") == "off" ? 0.0 : std::stod(motion.at("leave"));
        program.moves.push_back(move);
      }
      at.line();
    }
  });
}

std::string parseInform(const std::string& text, ParsedProgram& program) {
  return guarded([&] {
    Cursor at(text);
    at.need("/JOB");
    at.line();
    at.need("//NAME ");
    program.name = at.word();
    needName(program.name, 32, {"NOP", "END", "MOVJ", "MOVL", "CALL", "JUMP"});
    at.line();
    at.need("//POS");
    at.line();
    at.need("///NPOS ");
    std::vector<double> counts;
    do counts.push_back(at.number());
    while (at.maybe(","));
    at.line();
    if (at.maybe("///USER ")) {
      at.number();
      at.line();
    }
    at.need("///TOOL ");
    at.number();
    at.line();
    at.need("///POSTYPE ");
    if (!at.maybeWord("BASE")) at.needWord("USER");
    at.line();
    at.need("///RECTAN");
    at.line();
    at.need("///RCONF ");
    std::vector<double> configuration;
    do configuration.push_back(at.number());
    while (at.maybe(","));
    if (configuration.size() < 8) at.fail("eight configuration data or more");
    at.line();
    std::map<std::string, std::vector<double>> points;
    while (!at.maybe("//INST")) {
      const std::string name = at.word();
      if (name.size() != 6 || name.front() != 'C') at.fail("C and five digits");
      at.need("=");
      do points[name].push_back(at.number());
      while (at.maybe(","));
      if (points[name].size() != 6) at.fail("six numbers");
      at.line();
    }
    if (counts.size() != 6 || static_cast<std::size_t>(counts[0]) != points.size())
      at.fail("as many positions as NPOS says");
    at.line();
    at.need("///DATE ");
    if (at.restOfLine().size() < 16) at.fail("a date and time");
    at.line();
    at.need("///ATTR SC,RW,RJ");
    at.line();
    at.need("////FRAME ");
    at.restOfLine();
    at.line();
    at.need("///GROUP1 RB1");
    at.line();
    at.needWord("NOP");
    at.line();
    while (!at.maybeWord("END")) {
      if (at.maybe("'")) {
        if (at.restOfLine().size() > 33) at.fail("a remark of at most 32 signs");
      } else if (at.maybeWord("TIMER")) {
        at.need("T=");
        const double seconds = at.number();
        if (seconds < 0.01 || seconds > 655.35 || program.moves.empty()) at.fail("0.01 to 655.35 s behind a move");
        program.moves.back().dwell = seconds;
      } else {
        ParsedProgram::Move move;
        move.kind = at.maybeWord("MOVJ") ? 'J' : (at.needWord("MOVL"), 'L');
        const std::string point = at.word();
        if (!points.contains(point)) at.fail("a position of //POS, not " + point);
        move.target = points[point];
        at.need(move.kind == 'J' ? "VJ=" : "V=");
        const double speed = at.number();
        if (speed <= 0.0 || speed > (move.kind == 'J' ? 100.0 : 1500.0)) at.fail("a speed in its range");
        program.settings[move.kind == 'J' ? "joint speed" : "speed"] = speed;
        if (at.maybe("CR=")) {
          move.blend = at.number();
          if (move.kind == 'J' || move.blend <= 0.0) at.fail("a corner's radius of a line");
        } else {
          at.need("PL=0");
        }
        program.moves.push_back(move);
      }
      at.line();
    }
    at.line();
    if (!at.isAtEnd()) at.fail("the end");
  });
}

}  // namespace hapticell::test
