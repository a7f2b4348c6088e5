// SPDX-License-Identifier: Apache-2.0
#include "tests/trajectory/programs/writing/grammar_cursor.h"
#include "tests/trajectory/programs/writing/program_grammar.h"

namespace hapticell::test {

namespace {

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
std::vector<double> krlRecord(GrammarCursor& at, const std::vector<std::string>& names) {
  std::vector<double> numbers;
  at.need("{");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) at.need(",");
    at.needWord(names[i]);
    numbers.push_back(at.number());
  }
  return numbers;
}

/// The numbers of each point of a data list, and the name of that.
std::map<std::string, std::vector<double>> krlPoints(const std::string& data, std::string& data_name) {
  std::map<std::string, std::vector<double>> points;
  GrammarCursor dat(data);
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
  return points;
}

}  // namespace

std::string parseKrl(const std::string& source, const std::string& data, ParsedProgram& program) {
  return guarded([&] {
    std::string data_name;
    auto points = krlPoints(data, data_name);
    GrammarCursor src(source);
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

}  // namespace hapticell::test
