// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/program_run.h"

#include <algorithm>
#include <cmath>

namespace hapticell::trajectory {

namespace {

// Routines within each other: guards the stack; programs have a few. Half: still enough; twice: twice the stack.
constexpr int kDeepestCall = 50;
// Items of an array: guards memory against an index that is wrong. Half, twice: larger arrays are not kept, or more
// memory.
constexpr double kLongestList = 200'000;

}  // namespace

ProgramRun::ProgramRun(const Dialect& dialect, ProgramPath& path) : dialect_(dialect), path_(path) {
  meaning_.find = [this](const std::string& name) { return find(name); };
  meaning_.variable = [](const std::string& name) {
    return Value::unknown(Text("'%1', which the file does not define", name));
  };
  meaning_.call = [](const std::string& name, const std::vector<Argument>&) {
    return Value::unknown(Text("the result of '%1'", name));
  };
  meaning_.field = [](const Value&, const std::string& field) { return Value::unknown(Text("the field '%1'", field)); };
}

const Value* ProgramRun::find(const std::string& name) const {
  const auto found = variables_.find(name);
  return found == variables_.end() ? nullptr : &found->second;
}

Value ProgramRun::evaluate(const Tokens& tokens) const {
  return ExpressionReader(tokens, 0, dialect_, meaning_).expression();
}

std::string ProgramRun::textOf(const Tokens& tokens) {
  std::string text;
  for (const Token& token : tokens) {
    if (token.kind == Token::Kind::kLineEnd || token.is("@pose") || text.size() > 60) break;
    const bool is_apart = !text.empty() && token.isWord() && std::isalnum(static_cast<unsigned char>(text.back())) != 0;
    text += (is_apart ? " " : "") + token.text;
  }
  return text;
}

void ProgramRun::assign(const std::string& name, const std::vector<AccessStep>& steps, Value value) {
  Value* place = &variables_[name];
  for (const AccessStep& step : steps) {
    if (!step.field.empty()) {
      if (place->kind != Value::Kind::kRecord) *place = {Value::Kind::kRecord, 0.0, {}, {}, {}};
      const auto found = std::find(place->fields.begin(), place->fields.end(), step.field);
      const auto i = static_cast<std::size_t>(found - place->fields.begin());
      if (found == place->fields.end()) {
        place->fields.push_back(step.field);
        place->items.push_back(Value::unknown(Text("'%1.%2'", name, step.field)));
      }
      place = &place->items[i];
      continue;
    }
    const double index = step.index - static_cast<double>(dialect_.first_index);
    if (!step.is_known || !(index >= 0.0) || !(index < kLongestList)) return;
    if (place->kind != Value::Kind::kList) *place = Value::list("", std::vector<Value>{});
    const auto i = static_cast<std::size_t>(index);
    if (place->items.size() <= i)
      place->items.resize(i + 1, Value::unknown(Text("an undefined element of '%1'", name)));
    place = &place->items[i];
  }
  *place = std::move(value);
}

bool ProgramRun::hasMoves(const Block& block, int depth) const {
  if (depth > kDeepestCall) return true;
  return std::any_of(block.begin(), block.end(), [&](const Statement& statement) {
    if (statement.kind == Statement::Kind::kPlain) {
      if (isMove(statement)) return true;
      const auto routine = statement.tokens.empty() ? routines_.end() : routines_.find(statement.tokens.front().text);
      return routine != routines_.end() && hasMoves(routine->second.body, depth + 5);
    }
    return std::any_of(statement.branches.begin(), statement.branches.end(),
                       [&](const Branch& branch) { return hasMoves(branch.body, depth + 1); });
  });
}

ProgramRun::Flow ProgramRun::run(const Block& block) {
  for (const Statement& statement : block) {
    if (!countStep(statement.line)) return Flow::kEnd;
    if (const Flow flow = step(statement); flow != Flow::kNext) return flow;
  }
  return Flow::kNext;
}

ProgramRun::Flow ProgramRun::step(const Statement& statement) {
  switch (statement.kind) {
    case Statement::Kind::kPlain:
      return plain(statement);
    case Statement::Kind::kIf:
      return runIf(statement);
    case Statement::Kind::kSwitch:
      return runSwitch(statement);
    case Statement::Kind::kWhile:
    case Statement::Kind::kRepeat:
      return runLoop(statement);
    case Statement::Kind::kFor:
      return runFor(statement);
    case Statement::Kind::kBreak:
      return Flow::kBreak;
    case Statement::Kind::kReturn:
      return Flow::kReturn;
    case Statement::Kind::kEnd:
      return Flow::kEnd;
  }
  return Flow::kNext;
}

/// A condition that the file does not decide: nothing moves in its branches, or it is an error.
bool ProgramRun::isUndecided(const Statement& statement, const Value& condition) {
  if (condition.isKnown()) return false;
  ++undecided_;
  const bool moves = std::any_of(statement.branches.begin(), statement.branches.end(),
                                 [&](const Branch& branch) { return hasMoves(branch.body); });
  if (moves) {
    path_.fail(statement.line, Text("moves that depend on %1", condition.whyUnknown()),
               Text("a condition with values that the file defines"),
               Text("In a copy of the program, delete the branch that you do not need."));
  } else {
    path_.skip(statement.line);
  }
  return true;
}

ProgramRun::Flow ProgramRun::runIf(const Statement& statement) {
  for (const Branch& branch : statement.branches) {
    if (branch.conditions.empty()) return run(branch.body);
    const Value condition = evaluate(branch.conditions.front());
    if (isUndecided(statement, condition)) return Flow::kNext;
    if (condition.isNumber() && condition.number != 0.0) return run(branch.body);
  }
  return Flow::kNext;
}

ProgramRun::Flow ProgramRun::runSwitch(const Statement& statement) {
  const Value asked = evaluate(statement.tokens);
  if (isUndecided(statement, asked)) return Flow::kNext;
  for (const Branch& branch : statement.branches) {
    bool is_chosen = branch.conditions.empty();
    for (const Tokens& tokens : branch.conditions) {
      const Value equal = binary("==", asked, evaluate(tokens));
      if (isUndecided(statement, equal)) return Flow::kNext;
      is_chosen = is_chosen || equal.number != 0.0;
    }
    if (is_chosen) return run(branch.body);
  }
  return Flow::kNext;
}

bool ProgramRun::hasEnd(const Block& block) {
  return std::any_of(block.begin(), block.end(), [](const Statement& statement) {
    using Kind = Statement::Kind;
    if (statement.kind == Kind::kBreak || statement.kind == Kind::kReturn || statement.kind == Kind::kEnd) return true;
    return std::any_of(statement.branches.begin(), statement.branches.end(),
                       [](const Branch& branch) { return hasEnd(branch.body); });
  });
}

/// A loop without end: to its EXIT where the file decides that, else once.
ProgramRun::Flow ProgramRun::runForever(const Statement& statement, const Text& what) {
  const Block& body = statement.branches.front().body;
  const bool has_end = hasEnd(body);
  for (;;) {
    const std::size_t undecided = undecided_;
    const Flow flow = run(body);
    if (flow == Flow::kBreak) return Flow::kNext;
    if (flow != Flow::kNext) return flow;
    if (has_end && undecided == undecided_) {
      if (countStep(statement.line)) continue;
      return Flow::kEnd;
    }
    if (hasMoves(body)) path_.noteLine(statement.line, Text("%1; the moves in it are read once.", what));
    return Flow::kNext;
  }
}

bool ProgramRun::countStep(std::size_t line) {
  if (path_.hasFailed()) return false;
  if (++steps_ > most_steps_) path_.fail(line, Text("statements that run endlessly"), Text("a program that ends"), "");
  return !path_.hasFailed();
}

ProgramRun::Flow ProgramRun::runLoop(const Statement& statement) {
  const Branch& branch = statement.branches.front();
  const bool is_repeat = statement.kind == Statement::Kind::kRepeat;
  const auto isAlways = [](Tokens condition) {
    std::erase_if(condition, [](const Token& token) { return token.is("(") || token.is(")"); });
    return condition.size() == 1 && (condition[0].number != 0.0 || condition[0].is("true") || condition[0].is("True"));
  };
  if (branch.conditions.empty() || (!is_repeat && isAlways(branch.conditions.front())))
    return runForever(statement, Text("an endless loop"));
  for (bool is_first = true;; is_first = false) {
    if (!countStep(statement.line)) return Flow::kEnd;
    if (!is_repeat || !is_first) {
      const Value condition = evaluate(branch.conditions.front());
      if (!condition.isKnown()) {
        if (is_first) return runForever(statement, Text("a loop that depends on %1", condition.whyUnknown()));
        if (hasMoves(branch.body))
          path_.noteLine(statement.line, Text("the end of the loop depends on %1; the moves up to here are read.",
                                              condition.whyUnknown()));
        return Flow::kNext;
      }
      if ((condition.number != 0.0) == is_repeat) return Flow::kNext;
    }
    const Flow flow = run(branch.body);
    if (flow == Flow::kBreak) return Flow::kNext;
    if (flow != Flow::kNext) return flow;
  }
}

ProgramRun::Flow ProgramRun::runFor(const Statement& statement) {
  const Branch& branch = statement.branches.front();
  if (branch.conditions.size() != 3 || statement.tokens.empty()) return Flow::kNext;
  const Value from = evaluate(branch.conditions[0]), to = evaluate(branch.conditions[1]);
  const Value step = branch.conditions[2].empty() ? Value::of(1.0) : evaluate(branch.conditions[2]);
  for (const Value* value : {&from, &to, &step})
    if (isUndecided(statement, *value)) return Flow::kNext;
  if (!from.isNumber() || !to.isNumber() || !step.isNumber() || step.number == 0.0) {
    path_.fail(statement.line, Text("a FOR with limits that are not numbers"), Text("numbers"), "");
    return Flow::kEnd;
  }
  const double count = std::floor((to.number - from.number) / step.number + 1e-9);
  for (double i = 0; i <= count; ++i) {
    if (!countStep(statement.line)) return Flow::kEnd;
    variables_[statement.tokens.front().text] = Value::of(from.number + i * step.number);
    const Flow flow = run(branch.body);
    if (flow == Flow::kBreak) return Flow::kNext;
    if (flow != Flow::kNext) return flow;
  }
  return Flow::kNext;
}

ProgramRun::Flow ProgramRun::call(const Routine& routine, const std::vector<Argument>& arguments, std::size_t line) {
  if (depth_ >= kDeepestCall) {
    path_.fail(line, Text("routines that call each other endlessly"), Text("at most 50 nested calls"), "");
    return Flow::kEnd;
  }
  std::map<std::string, Value> before;
  std::vector<std::string> added;
  std::size_t positional = 0;
  for (const std::string& parameter : routine.parameters) {
    if (const Value* old = find(parameter)) before[parameter] = *old;
    Value value = Value::unknown(Text("the parameter '%1'", parameter));
    const auto named =
        std::find_if(arguments.begin(), arguments.end(), [&](const Argument& a) { return a.name == parameter; });
    if (named != arguments.end()) {
      value = named->value;
    } else {
      while (positional < arguments.size() && !arguments[positional].name.empty()) ++positional;
      if (positional < arguments.size()) value = arguments[positional++].value;
    }
    variables_[parameter] = std::move(value);
    added.push_back(parameter);
  }
  ++depth_;
  const Flow flow = run(routine.body);
  --depth_;
  for (const std::string& parameter : added) variables_.erase(parameter);
  for (auto& [name, value] : before) variables_[name] = std::move(value);
  return flow == Flow::kEnd ? Flow::kEnd : Flow::kNext;
}

}  // namespace hapticell::trajectory
