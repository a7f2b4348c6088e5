// SPDX-License-Identifier: Apache-2.0
#include "tests/trajectory/programs/writing/grammar_cursor.h"
#include "tests/trajectory/programs/writing/program_grammar.h"

namespace hapticell::test {

namespace {

/// CONST|PERS data of RAPID: [[x,y,z],[q1..q4],[c1..c4],[e1..e6]].
std::vector<double> rapidTarget(GrammarCursor& at) {
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

void rapidComments(GrammarCursor& at) {
  while (at.maybe("!")) at.restOfLine();
}

void rapidMove(GrammarCursor& at, std::map<std::string, std::vector<double>>& points, ParsedProgram& program) {
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

}  // namespace

std::string parseRapid(const std::string& text, ParsedProgram& program) {
  return guarded([&] {
    std::map<std::string, std::vector<double>> points;
    GrammarCursor at(text, true);
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

}  // namespace hapticell::test
