// SPDX-License-Identifier: Apache-2.0
#include "tests/trajectory/programs/writing/grammar_cursor.h"
#include "tests/trajectory/programs/writing/program_grammar.h"

namespace hapticell::test {

std::string parseInform(const std::string& text, ParsedProgram& program) {
  return guarded([&] {
    GrammarCursor at(text);
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
