// SPDX-License-Identifier: Apache-2.0
#include "tests/trajectory/programs/writing/grammar_cursor.h"
#include "tests/trajectory/programs/writing/program_grammar.h"

namespace hapticell::test {

std::string parseUrScript(const std::string& text, ParsedProgram& program) {
  static const std::set<std::string> kReserved{
      "AND",  "AS",     "ASSERT", "BREAK", "CONTINUE", "DEF",   "ELIF",  "ELSE",  "END",  "FALSE",  "GLOBAL",
      "HALT", "IF",     "IN",     "JOIN",  "KILL",     "LOCAL", "NOT",   "OR",    "PASS", "RETURN", "RUN",
      "SEC",  "THREAD", "TRUE",   "WHILE", "XOR",      "MOVEL", "MOVEJ", "SLEEP", "P"};
  return guarded([&] {
    GrammarCursor at(text);
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

}  // namespace hapticell::test
