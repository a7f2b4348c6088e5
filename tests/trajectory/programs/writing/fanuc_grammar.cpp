// SPDX-License-Identifier: Apache-2.0
#include "tests/trajectory/programs/writing/grammar_cursor.h"
#include "tests/trajectory/programs/writing/program_grammar.h"

namespace hapticell::test {

namespace {

/// The numbers of each position of /POS.
std::map<std::size_t, std::vector<double>> fanucPositions(GrammarCursor& at) {
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
  return points;
}

}  // namespace

std::string parseFanuc(const std::string& text, ParsedProgram& program) {
  return guarded([&] {
    GrammarCursor at(text);
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
    const std::map<std::size_t, std::vector<double>> points = fanucPositions(at);
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!points.contains(used[i])) throw Wrong("P[" + std::to_string(used[i]) + "] is not in /POS");
      program.moves[i].target = points.at(used[i]);
    }
  });
}

}  // namespace hapticell::test
