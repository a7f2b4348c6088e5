// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/krl_parser.h"

#include <algorithm>
#include <set>

namespace hapticell::trajectory {

namespace {

using KrlEnds = std::set<std::string, std::less<>>;
// Blocks within each other: guards the stack; programs have a few. Half: still enough; twice: twice the stack.
constexpr int kDeepestKrlBlock = 100;

/// Lines of a module into routines and data.
class KrlParser {
 public:
  KrlParser(const Tokens& tokens, ProgramPath& path) : path_(path) {
    Tokens line;
    for (const Token& token : tokens) {
      if (token.kind != Token::Kind::kLineEnd) {
        line.push_back(token);
      } else if (!line.empty()) {
        lines_.push_back(std::move(line));
        line.clear();
      }
    }
  }

  void parse(std::vector<Routine>& routines, Block& data) {
    while (at_ < lines_.size()) {
      const std::size_t first = lines_[at_].front().is("global") && lines_[at_].size() > 1 ? 1 : 0;
      const Token& word = lines_[at_][first];
      if (word.is("def") || word.is("deffct")) {
        routines.push_back(routine(first));
      } else if (word.is("defdat") || word.is("enddat") || word.is("end") || word.is("endfct")) {
        ++at_;
      } else {
        Statement statement = plainLine();
        data.push_back(std::move(statement));
      }
    }
  }

 private:
  Routine routine(std::size_t first) {
    const Tokens& head = lines_[at_++];
    Routine routine;
    std::size_t bracket = first + 1;
    while (bracket < head.size() && !head[bracket].is("(")) ++bracket;
    routine.line = head.front().line;
    if (bracket > 0 && head[bracket - 1].isWord()) routine.name = head[bracket - 1].text;
    for (std::size_t i = bracket + 1; i < head.size(); ++i)
      if (head[i].isWord() && !head[i - 1].is(":")) routine.parameters.push_back(head[i].text);
    routine.body = block({"end", "endfct"}, 0);
    if (at_ < lines_.size()) ++at_;
    return routine;
  }

  Statement plainLine() {
    Statement statement;
    statement.line = lines_[at_].front().line;
    statement.tokens = lines_[at_++];
    return statement;
  }

  bool isAt(const KrlEnds& words) const { return at_ < lines_.size() && words.contains(lines_[at_].front().text); }

  /// Up to a line that begins with one of `ends`, which stays.
  Block block(const KrlEnds& ends, int depth) {
    Block result;
    if (depth > kDeepestKrlBlock) {
      path_.fail(lines_[std::min(at_, lines_.size() - 1)].front().line, Text("more than 100 nested blocks"),
                 Text("fewer"), "");
      at_ = lines_.size();
    }
    while (at_ < lines_.size() && !isAt(ends)) result.push_back(statement(depth));
    if (at_ >= lines_.size() && !path_.hasFailed() && !lines_.empty()) {
      path_.fail(lines_.back().front().line, Text("the file ends too early"), Text("'%1'", *ends.begin()), "");
    }
    return result;
  }

  static Tokens without(const Tokens& tokens, std::size_t first, const char* last) {
    Tokens result;
    for (std::size_t i = first; i < tokens.size() && !tokens[i].is(last); ++i) result.push_back(tokens[i]);
    return result;
  }

  Statement statement(int depth) {
    const Tokens line = lines_[at_];
    Statement made;
    made.line = line.front().line;
    const std::string& word = line.front().text;
    if (word == "if") return ifStatement(std::move(made), depth);
    if (word == "switch") return switchStatement(std::move(made), depth);
    if (word == "loop") return loop(std::move(made), Statement::Kind::kWhile, {}, "endloop", depth);
    if (word == "while")
      return loop(std::move(made), Statement::Kind::kWhile, {without(line, 1, "")}, "endwhile", depth);
    if (word == "for" && line.size() > 2 && line[2].is("=")) return forStatement(std::move(made), depth);
    if (word == "repeat") {
      ++at_;
      made.kind = Statement::Kind::kRepeat;
      Block body = block({"until"}, depth + 1);
      const Tokens until = at_ < lines_.size() ? without(lines_[at_++], 1, "") : Tokens{};
      made.branches.push_back({{until}, std::move(body)});
      return made;
    }
    if (word == "exit") made.kind = Statement::Kind::kBreak;
    if (word == "return") made.kind = Statement::Kind::kReturn;
    if (word == "halt") return ++at_, Statement{Statement::Kind::kPlain, made.line, line, {}};
    if (made.kind != Statement::Kind::kPlain) return ++at_, made;
    return plainLine();
  }

  Statement loop(Statement made, Statement::Kind kind, std::vector<Tokens> conditions, const char* end, int depth) {
    ++at_;
    made.kind = kind;
    Block body = block({end}, depth + 1);
    if (at_ < lines_.size()) ++at_;
    made.branches.push_back({std::move(conditions), std::move(body)});
    return made;
  }

  Statement ifStatement(Statement made, int depth) {
    made.kind = Statement::Kind::kIf;
    Tokens condition = without(lines_[at_++], 1, "then");
    made.branches.push_back({{std::move(condition)}, block({"else", "endif"}, depth + 1)});
    if (isAt({"else"})) {
      ++at_;
      made.branches.push_back({{}, block({"endif"}, depth + 1)});
    }
    if (at_ < lines_.size()) ++at_;
    return made;
  }

  Statement switchStatement(Statement made, int depth) {
    made.kind = Statement::Kind::kSwitch;
    made.tokens = without(lines_[at_++], 1, "");
    while (isAt({"case", "default"})) {
      const Tokens head = lines_[at_++];
      Branch branch;
      Tokens one;
      for (std::size_t i = 1; head.front().is("case") && i <= head.size(); ++i) {
        if (i < head.size() && !head[i].is(",")) {
          one.push_back(head[i]);
        } else if (!one.empty()) {
          branch.conditions.push_back(std::move(one));
          one.clear();
        }
      }
      branch.body = block({"case", "default", "endswitch"}, depth + 1);
      made.branches.push_back(std::move(branch));
    }
    if (at_ < lines_.size()) ++at_;
    return made;
  }

  Statement forStatement(Statement made, int depth) {
    const Tokens line = lines_[at_];
    made.tokens = {line[1]};
    const Tokens rest(line.begin() + 3, line.end());
    const auto place = [&](const char* word) {
      return static_cast<std::size_t>(
          std::find_if(rest.begin(), rest.end(), [&](const Token& t) { return t.is(word); }) - rest.begin());
    };
    const std::size_t to = place("to"), step = place("step");
    std::vector<Tokens> parts{without(rest, 0, "to"), to < rest.size() ? without(rest, to + 1, "step") : Tokens{},
                              step < rest.size() ? without(rest, step + 1, "") : Tokens{}};
    return loop(std::move(made), Statement::Kind::kFor, std::move(parts), "endfor", depth);
  }

  ProgramPath& path_;
  std::vector<Tokens> lines_;
  std::size_t at_ = 0;
};

}  // namespace

const Dialect& krl() {
  static const Dialect kDialect{true, ';', true, true, false, false, 1};
  return kDialect;
}

void parseKrl(const Tokens& tokens, ProgramPath& path, std::vector<Routine>& routines, Block& data) {
  KrlParser(tokens, path).parse(routines, data);
}

}  // namespace hapticell::trajectory
