// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/rapid_parser.h"

#include <algorithm>
#include <set>
#include <utility>

namespace hapticell::trajectory {

namespace {

using RapidEnds = std::set<std::string, std::less<>>;
// Blocks within each other, as kDeepestKrlBlock of krl_parser.cpp.
constexpr int kDeepestRapidBlock = 100;

class RapidParser {
 public:
  RapidParser(const Tokens& tokens, ProgramPath& path) : tokens_(tokens), path_(path) {}

  void parse(std::vector<Routine>& routines, std::vector<Statement>& data) {
    while (at_ < tokens_.size() && !path_.hasFailed()) {
      while (at_ < tokens_.size() && (tokens_[at_].is("local") || tokens_[at_].is("task"))) ++at_;
      if (isWord("module")) {
        // MODULE NAME (SYSMODULE, NOSTEPIN)
        at_ += 2;
        if (is("(")) skipTo(")");
      } else if (isWord("endmodule")) {
        ++at_;
      } else if (isWord("proc") || isWord("func") || isWord("trap")) {
        routines.push_back(routine());
      } else if (isWord("record")) {
        skipTo("endrecord");
      } else if (at_ < tokens_.size()) {
        data.push_back(plain());
      }
    }
  }

 private:
  bool is(const char* sign) const { return at_ < tokens_.size() && tokens_[at_].is(sign); }
  bool isWord(const char* word) const {
    return at_ < tokens_.size() && tokens_[at_].isWord() && tokens_[at_].text == word;
  }
  std::size_t line() const {
    if (tokens_.empty()) return 1;
    return tokens_[std::min(at_, tokens_.size() - 1)].line;
  }
  void skipTo(const char* word) {
    while (at_ < tokens_.size() && !is(word)) ++at_;
    if (at_ < tokens_.size()) ++at_;
  }
  bool isAt(const RapidEnds& words) const {
    return at_ < tokens_.size() && tokens_[at_].isWord() && words.contains(tokens_[at_].text);
  }

  /// Up to one of these words, which is taken.
  Tokens until(const char* word) {
    Tokens taken;
    while (at_ < tokens_.size() && !is(word) && !is(";")) taken.push_back(tokens_[at_++]);
    if (is(word)) ++at_;
    return taken;
  }

  /// A statement up to its ';'; a remark with the pose behind it belongs to it.
  Statement plain() {
    Statement statement;
    statement.line = line();
    while (at_ < tokens_.size() && !is(";") && !isBlockEnd()) statement.tokens.push_back(tokens_[at_++]);
    const std::size_t last_line = at_ < tokens_.size() ? tokens_[at_].line : statement.line;
    if (is(";")) {
      ++at_;
    } else if (statement.tokens.empty()) {
      ++at_;  // An end word that does not belong here.
    }
    if (is("@pose"))
      while (at_ < tokens_.size() && tokens_[at_].line == last_line) statement.tokens.push_back(tokens_[at_++]);
    return statement;
  }
  bool isBlockEnd() const {
    static const RapidEnds kEnds{"endproc", "endfunc",  "endtrap", "endif",
                                 "endfor",  "endwhile", "endtest", "endmodule"};
    return isAt(kEnds);
  }

  Routine routine() {
    Routine routine;
    routine.line = line();
    const std::string end = "end" + tokens_[at_++].text;
    while (at_ + 1 < tokens_.size() && !tokens_[at_ + 1].is("(") && end == "endfunc") ++at_;  // FUNC type name(
    if (at_ < tokens_.size()) routine.name = tokens_[at_++].text;
    if (is("(")) parameters(routine);
    routine.body = block({end, "error", "undo", "backward"}, 0);
    while (at_ < tokens_.size() && !isWord(end.c_str())) ++at_;  // handlers of errors
    if (at_ < tokens_.size()) ++at_;
    return routine;
  }

  /// (robtarget p, \switch fast | num x{*}, PERS tooldata t): the word before a comma or the end is the name.
  void parameters(Routine& routine) {
    std::string last;
    for (++at_; at_ < tokens_.size() && !is(")"); ++at_) {
      if (is("{")) {
        while (at_ + 1 < tokens_.size() && !is("}")) ++at_;
      } else if (is(",") || is("|")) {
        if (!last.empty()) routine.parameters.push_back(std::exchange(last, {}));
      } else if (tokens_[at_].isWord()) {
        last = tokens_[at_].text;
      }
    }
    if (!last.empty()) routine.parameters.push_back(last);
    if (at_ < tokens_.size()) ++at_;
  }

  Block block(const RapidEnds& ends, int depth) {
    Block result;
    if (depth > kDeepestRapidBlock) {
      path_.fail(line(), Text("more than 100 nested blocks"), Text("fewer"), "");
      at_ = tokens_.size();
    }
    while (at_ < tokens_.size() && !isAt(ends)) result.push_back(statement(depth));
    if (at_ >= tokens_.size()) path_.fail(line(), Text("the file ends too early"), Text("'%1'", *ends.begin()), "");
    return result;
  }

  Statement statement(int depth) {
    Statement made;
    made.line = line();
    if (isWord("if")) return ifStatement(std::move(made), depth);
    if (isWord("test")) return testStatement(std::move(made), depth);
    if (isWord("while")) {
      ++at_;
      made.kind = Statement::Kind::kWhile;
      Tokens condition = until("do");
      made.branches.push_back({{std::move(condition)}, block({"endwhile"}, depth + 1)});
      ++at_;
      return made;
    }
    if (isWord("for")) {
      ++at_;
      made.kind = Statement::Kind::kFor;
      made.tokens = until("from");
      Tokens from = until("to");
      Tokens to, step;
      while (at_ < tokens_.size() && !is("step") && !is("do") && !is(";")) to.push_back(tokens_[at_++]);
      if (is("step")) {
        ++at_;
        step = until("do");
      } else if (is("do")) {
        ++at_;
      }
      made.branches.push_back({{std::move(from), std::move(to), std::move(step)}, block({"endfor"}, depth + 1)});
      ++at_;
      return made;
    }
    if (isWord("return")) made.kind = Statement::Kind::kReturn;
    if (isWord("exit") || isWord("exitcycle")) made.kind = Statement::Kind::kEnd;
    if (at_ + 1 < tokens_.size() && tokens_[at_].isWord() && tokens_[at_ + 1].is(":")) {  // a label
      at_ += 2;
      return made;
    }
    Statement read = plain();
    read.kind = made.kind;
    return read;
  }

  Statement ifStatement(Statement made, int depth) {
    made.kind = Statement::Kind::kIf;
    ++at_;
    // IF condition statement; has no THEN: the condition ends where its expression does.
    static const ExpressionMeaning kNothing = meaningOfNothing();
    ExpressionReader condition(tokens_, at_, rapid(), kNothing);
    condition.expression();
    const std::size_t end = std::min(condition.at(), tokens_.size());
    Tokens asked(tokens_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, end)),
                 tokens_.begin() + static_cast<std::ptrdiff_t>(end));
    at_ = end;
    if (!is("then")) {
      made.branches.push_back({{std::move(asked)}, {}});
      if (at_ < tokens_.size()) made.branches.back().body.push_back(statement(depth + 1));
      return made;
    }
    ++at_;
    const RapidEnds ends{"elseif", "else", "endif"};
    made.branches.push_back({{std::move(asked)}, block(ends, depth + 1)});
    while (isWord("elseif")) {
      ++at_;
      Tokens other = until("then");
      made.branches.push_back({{std::move(other)}, block(ends, depth + 1)});
    }
    if (isWord("else")) {
      ++at_;
      made.branches.push_back({{}, block({"endif"}, depth + 1)});
    }
    ++at_;
    return made;
  }

  Statement testStatement(Statement made, int depth) {
    made.kind = Statement::Kind::kSwitch;
    ++at_;
    while (at_ < tokens_.size() && !isWord("case") && !isWord("default") && !isWord("endtest"))
      made.tokens.push_back(tokens_[at_++]);
    while (isWord("case") || isWord("default")) {
      Branch branch;
      const bool is_case = tokens_[at_++].text == "case";
      Tokens one;
      int depth_of_brackets = 0;
      for (; at_ < tokens_.size() && !(is(":") && depth_of_brackets == 0); ++at_) {
        if (is("(") || is("[")) ++depth_of_brackets;
        if (is(")") || is("]")) --depth_of_brackets;
        if (is(",") && depth_of_brackets == 0) {
          branch.conditions.push_back(std::exchange(one, {}));
        } else {
          one.push_back(tokens_[at_]);
        }
      }
      if (is_case) branch.conditions.push_back(std::move(one));
      if (at_ < tokens_.size()) ++at_;
      branch.body = block({"case", "default", "endtest"}, depth + 1);
      made.branches.push_back(std::move(branch));
    }
    ++at_;
    return made;
  }

  static ExpressionMeaning meaningOfNothing() {
    ExpressionMeaning meaning;
    meaning.find = [](const std::string&) { return nullptr; };
    meaning.variable = [](const std::string&) { return Value::unknown(""); };
    meaning.call = [](const std::string&, const std::vector<Argument>&) { return Value::unknown(""); };
    meaning.field = [](const Value&, const std::string&) { return Value::unknown(""); };
    return meaning;
  }

  const Tokens& tokens_;
  ProgramPath& path_;
  std::size_t at_ = 0;
};

}  // namespace

const Dialect& rapid() {
  static const Dialect kDialect{true, '!', false, false, true, false, 1};
  return kDialect;
}

void parseRapid(const Tokens& tokens, ProgramPath& path, std::vector<Routine>& routines, Block& data) {
  RapidParser(tokens, path).parse(routines, data);
}

}  // namespace hapticell::trajectory
