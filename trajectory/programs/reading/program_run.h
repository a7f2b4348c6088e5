// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "trajectory/programs/reading/program_expression.h"
#include "trajectory/programs/reading/program_path.h"

namespace hapticell::trajectory {

struct Statement;
using Block = std::vector<Statement>;

/// One branch of an IF or SWITCH, or the body of a loop.
struct Branch {
  std::vector<Tokens> conditions;  ///< Any of them must hold; empty: the default branch.
  Block body;
};

/// A statement of a program as the parser of its language gives it.
struct Statement {
  enum class Kind { kPlain, kIf, kSwitch, kWhile, kRepeat, kFor, kBreak, kReturn, kEnd };
  Kind kind = Kind::kPlain;
  std::size_t line = 0;
  Tokens tokens;  ///< Of a plain statement; the operand of a SWITCH; the variable of a FOR.
  /// Of a loop: one branch with its condition (empty: endless; REPEAT: until it holds). FOR: from, to, step.
  std::vector<Branch> branches;
};

struct Routine {
  std::string name;
  std::size_t line = 0;
  std::vector<std::string> parameters;
  Block body;
};

/// Runs a program as far as its files define it, and gives its moves to a ProgramPath.
///
/// Derived classes define the language: what a plain statement does and which ones move. All variables have one scope
/// for the whole program; parameters of a routine are restored when it ends. Ends with an error after 500 000
/// statements, or those allowed.
class ProgramRun {
 public:
  ProgramRun(const Dialect& dialect, ProgramPath& path);
  virtual ~ProgramRun() = default;
  ProgramRun(const ProgramRun&) = delete;
  ProgramRun& operator=(const ProgramRun&) = delete;

  enum class Flow { kNext, kBreak, kReturn, kEnd };
  Flow run(const Block& block);
  /// Allows this many more statements, for a long program.
  void allowSteps(std::size_t statements) { most_steps_ += statements; }

 protected:
  virtual Flow plain(const Statement& statement) = 0;
  virtual bool isMove(const Statement& statement) const = 0;

  /// Calls a routine of the program with these arguments.
  Flow call(const Routine& routine, const std::vector<Argument>& arguments, std::size_t line);
  bool hasMoves(const Block& block, int depth = 0) const;
  Value evaluate(const Tokens& tokens) const;
  /// Assigns to "name.field[2]"; creates missing parts.
  void assign(const std::string& name, const std::vector<AccessStep>& steps, Value value);
  const Value* find(const std::string& name) const;
  /// The tokens of a statement unchanged, for messages.
  static std::string textOf(const Tokens& tokens);

  const Dialect dialect_;
  ProgramPath& path_;
  ExpressionMeaning meaning_;
  std::map<std::string, Value> variables_;
  std::map<std::string, Routine> routines_;

 private:
  Flow step(const Statement& statement);
  Flow runIf(const Statement& statement);
  Flow runSwitch(const Statement& statement);
  Flow runLoop(const Statement& statement);
  Flow runFor(const Statement& statement);
  Flow runForever(const Statement& statement, const Text& what);
  static bool hasEnd(const Block& block);
  bool countStep(std::size_t line);
  bool isUndecided(const Statement& statement, const Value& condition);

  std::size_t steps_ = 0, most_steps_ = 500'000;
  std::size_t undecided_ = 0;  // conditions so far that the file does not determine
  int depth_ = 0;
};

}  // namespace hapticell::trajectory
