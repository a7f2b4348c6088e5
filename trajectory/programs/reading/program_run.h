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

/// One way of an IF or SWITCH, or the body of a loop.
struct Branch {
  std::vector<Tokens> conditions;  ///< Any of them; none: otherwise.
  Block body;
};

/// A statement of a program as its language's parser gives it.
struct Statement {
  enum class Kind { kPlain, kIf, kSwitch, kWhile, kRepeat, kFor, kBreak, kReturn, kEnd };
  Kind kind = Kind::kPlain;
  std::size_t line = 0;
  Tokens tokens;  ///< A plain one's; what a SWITCH asks; a FOR's variable.
  /// Of a loop one, with its condition (none: for ever; REPEAT: until it holds). FOR: from, to, step.
  std::vector<Branch> branches;
};

struct Routine {
  std::string name;
  std::size_t line = 0;
  std::vector<std::string> parameters;
  Block body;
};

/// Runs a program as far as its files say what it does, and gives its moves to a ProgramPath.
///
/// Derived classes give the language: what a plain statement does and which ones move. Variables are of one scope for
/// the whole program, parameters of a routine are put back when it ends. Ends with an error after 500 000 statements,
/// or those allowed.
class ProgramRun {
 public:
  ProgramRun(const Dialect& dialect, ProgramPath& path);
  virtual ~ProgramRun() = default;
  ProgramRun(const ProgramRun&) = delete;
  ProgramRun& operator=(const ProgramRun&) = delete;

  enum class Flow { kNext, kBreak, kReturn, kEnd };
  Flow run(const Block& block);
  /// So many statements more, for a program that has many.
  void allowSteps(std::size_t statements) { most_steps_ += statements; }

 protected:
  virtual Flow plain(const Statement& statement) = 0;
  virtual bool isMove(const Statement& statement) const = 0;

  /// Calls a routine of the program with these arguments.
  Flow call(const Routine& routine, const std::vector<Argument>& arguments, std::size_t line);
  bool hasMoves(const Block& block, int depth = 0) const;
  Value evaluate(const Tokens& tokens) const;
  /// Assigns to "name.field[2]"; makes missing ones.
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
  std::size_t undecided_ = 0;  // conditions so far that the file did not decide
  int depth_ = 0;
};

}  // namespace hapticell::trajectory
