// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace hapticell::test {

/// What a grammar found in a program: numbers as they are written, in the language's units.
struct ParsedProgram {
  struct Move {
    char kind = 'L';             ///< 'J' or 'L'.
    bool is_joints = false;      ///< A move to joints.
    std::vector<double> target;  ///< Six numbers, or seven with a quaternion.
    double blend = 0.0;
    double dwell = 0.0;  ///< Waited there.
  };
  std::string name;
  std::vector<Move> moves;
  std::map<std::string, double> settings;  ///< "$VEL.CP", "$VEL_AXIS[1]", "speed" ...
};

/// Small parsers of the subsets that are written, after the published syntax: KRL after the grammar of KUKA's System
/// Software (as in ANTLR's krl.g4), RAPID after ABB's "RAPID Kernel" (EBNF), FANUC's ASCII form, UR's script manual,
/// Staubli's VAL3 reference manual, Yaskawa's INFORM manual. They know nothing of what wrote the text. Each gives "" or
/// what is wrong.
std::string parseKrl(const std::string& source, const std::string& data, ParsedProgram& program);
std::string parseRapid(const std::string& text, ParsedProgram& program);
std::string parseFanuc(const std::string& text, ParsedProgram& program);
std::string parseUrScript(const std::string& text, ParsedProgram& program);
std::string parseVal3(const std::map<std::string, std::string>& files, ParsedProgram& program);
std::string parseInform(const std::string& text, ParsedProgram& program);

}  // namespace hapticell::test
