// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "xacro/expression.h"
#include "xacro/tokens.h"

namespace hapticell::xacro {

namespace {

using Kind = Expression::Kind;

constexpr std::size_t kLongest = std::size_t{64} << 10;
constexpr int kDeepestSource = 100;  // Of parentheses and the like: the parser recurses.
constexpr int kDeepestTree = 300;    // Of the tree: the evaluator recurses; a + b + c … is a level a sign.

const std::set<std::string> kKeywords = {"False",  "None",   "True",    "and",      "as",       "assert", "async",
                                         "await",  "break",  "class",   "continue", "def",      "del",    "elif",
                                         "else",   "except", "finally", "for",      "from",     "global", "if",
                                         "import", "in",     "is",      "lambda",   "nonlocal", "not",    "or",
                                         "pass",   "raise",  "return",  "try",      "while",    "with",   "yield"};

/// Signs of two operands by how tightly they bind, loosest first.
constexpr std::array<std::array<const char*, 4>, 6> kBinary = {
    {{"|"}, {"^"}, {"&"}, {"<<", ">>"}, {"+", "-"}, {"*", "/", "//", "%"}}};

class Parser {
 public:
  explicit Parser(const std::string& text) : tokens_(tokensOf(text)) {}

  ExpressionPointer run() {
    ExpressionPointer whole = items();
    if (now().kind != Token::Kind::kEnd) fail(Text("the end of the expression"));
    return whole;
  }

 private:
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int level_ = 0;

  struct Level {
    int& level;
    explicit Level(int& of) : level(of) {
      if (++level > kDeepestSource)
        throw Fault{.found = "an expression nested deeper than 100 levels", .expected = "a simpler one"};
    }
    ~Level() { --level; }
  };

  const Token& now() const { return tokens_[at_]; }
  bool isSign(const char* sign) const { return now().kind == Token::Kind::kSign && now().text == sign; }
  bool isWord(const char* word) const { return now().kind == Token::Kind::kName && now().text == word; }
  bool takeSign(const char* sign) {
    if (!isSign(sign)) return false;
    ++at_;
    return true;
  }
  bool takeWord(const char* word) {
    if (!isWord(word)) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail(const Text& expected) const {
    if (now().kind == Token::Kind::kEnd) throw Fault{.found = "the expression ends too early", .expected = expected};
    if (now().kind == Token::Kind::kConstant) throw Fault{.found = "a value in the expression", .expected = expected};
    throw Fault{.found = Text("'%1' in the expression", now().text), .expected = expected};
  }
  void need(const char* sign) {
    if (!takeSign(sign)) fail(std::string("'") + sign + "'");
  }

  ExpressionPointer make(Expression node) const {
    const auto deepen = [&node](const ExpressionPointer& part) {
      if (part) node.depth = std::max(node.depth, part->depth + 1);
    };
    for (const ExpressionPointer& part : node.parts) deepen(part);
    for (const Expression::Clause& clause : node.clauses) {
      deepen(clause.source);
      for (const ExpressionPointer& condition : clause.conditions) deepen(condition);
    }
    if (node.depth > kDeepestTree)
      throw Fault{.found = "an expression of more than 300 nested steps", .expected = "a simpler one"};
    return std::make_shared<const Expression>(std::move(node));
  }
  ExpressionPointer make(Kind kind, std::vector<ExpressionPointer> parts, std::string name = {}) const {
    Expression node;
    node.kind = kind;
    node.name = std::move(name);
    node.parts = std::move(parts);
    return make(std::move(node));
  }
  ExpressionPointer constant(Value value) const {
    Expression node;
    node.value = std::move(value);
    return make(std::move(node));
  }

  bool endsItems() const {
    return now().kind == Token::Kind::kEnd || isSign(")") || isSign("]") || isSign("}") || isSign(":");
  }

  /// One expression, or several with commas: a tuple.
  ExpressionPointer items() {
    ExpressionPointer first = single();
    if (!isSign(",")) return first;
    std::vector<ExpressionPointer> parts = {std::move(first)};
    while (takeSign(",") && !endsItems()) parts.push_back(single());
    return make(Kind::kTuple, std::move(parts));
  }

  ExpressionPointer single() {
    const Level level(level_);
    if (takeWord("lambda")) return lambda();
    ExpressionPointer value = either();
    if (!takeWord("if")) return value;
    ExpressionPointer condition = either();
    if (!takeWord("else")) fail("else");
    ExpressionPointer otherwise = single();
    return make(Kind::kChoice, {std::move(condition), std::move(value), std::move(otherwise)});
  }

  ExpressionPointer lambda() {
    Expression node;
    node.kind = Kind::kLambda;
    while (!isSign(":")) {
      node.names.push_back(identifier());
      if (!isSign(":")) need(",");
    }
    need(":");
    node.parts.push_back(single());
    return make(std::move(node));
  }

  std::string identifier() {
    if (now().kind != Token::Kind::kName || !isIdentifier(now().text)) fail(Text("a name"));
    return tokens_[at_++].text;
  }

  ExpressionPointer either() {
    std::vector<ExpressionPointer> parts = {both()};
    while (takeWord("or")) parts.push_back(both());
    return parts.size() == 1 ? parts[0] : make(Kind::kOr, std::move(parts));
  }

  ExpressionPointer both() {
    std::vector<ExpressionPointer> parts = {negation()};
    while (takeWord("and")) parts.push_back(negation());
    return parts.size() == 1 ? parts[0] : make(Kind::kAnd, std::move(parts));
  }

  ExpressionPointer negation() {
    const Level level(level_);
    if (takeWord("not")) return make(Kind::kUnary, {negation()}, "not");
    return comparison();
  }

  std::string comparisonSign() {
    for (const char* sign : {"<", ">", "<=", ">=", "==", "!="}) {
      if (takeSign(sign)) return sign;
    }
    if (takeWord("in")) return "in";
    if (takeWord("is")) return takeWord("not") ? "is not" : "is";
    if (isWord("not") && tokens_[at_ + 1].kind == Token::Kind::kName && tokens_[at_ + 1].text == "in") {
      at_ += 2;
      return "not in";
    }
    return {};
  }

  ExpressionPointer comparison() {
    Expression node;
    node.kind = Kind::kCompare;
    node.parts.push_back(binary(0));
    for (std::string sign = comparisonSign(); !sign.empty(); sign = comparisonSign()) {
      node.names.push_back(sign);
      node.parts.push_back(binary(0));
    }
    return node.names.empty() ? node.parts[0] : make(std::move(node));
  }

  ExpressionPointer binary(std::size_t tightness) {
    if (tightness == kBinary.size()) return unary();
    ExpressionPointer left = binary(tightness + 1);
    for (bool found = true; found;) {
      found = false;
      for (const char* sign : kBinary[tightness]) {
        if (!sign || !takeSign(sign)) continue;
        left = make(Kind::kBinary, {left, binary(tightness + 1)}, sign);
        found = true;
        break;
      }
    }
    return left;
  }

  ExpressionPointer unary() {
    const Level level(level_);
    for (const char* sign : {"-", "+", "~"}) {
      if (takeSign(sign)) return make(Kind::kUnary, {unary()}, sign);
    }
    ExpressionPointer base = postfix();
    if (!takeSign("**")) return base;
    return make(Kind::kBinary, {std::move(base), unary()}, "**");
  }

  ExpressionPointer postfix() {
    ExpressionPointer value = atom();
    for (;;) {
      if (takeSign(".")) {
        if (now().kind != Token::Kind::kName) fail(Text("a name"));
        const std::string name = tokens_[at_++].text;
        value = make(Kind::kAttribute, {std::move(value)}, name);
      } else if (takeSign("(")) {
        value = call(std::move(value));
      } else if (takeSign("[")) {
        value = index(std::move(value));
      } else {
        return value;
      }
    }
  }

  ExpressionPointer call(ExpressionPointer function) {
    Expression node;
    node.kind = Kind::kCall;
    node.parts.push_back(std::move(function));
    while (!isSign(")")) {
      const bool named = now().kind == Token::Kind::kName && tokens_[at_ + 1].kind == Token::Kind::kSign &&
                         tokens_[at_ + 1].text == "=";
      if (named) {
        node.names.push_back(identifier());
        need("=");
      } else if (!node.names.empty()) {
        fail(Text("named arguments after the others"));
      }
      ExpressionPointer argument = single();
      if (isWord("for")) argument = comprehension(std::move(argument), nullptr);
      node.parts.push_back(std::move(argument));
      if (!isSign(")")) need(",");
    }
    need(")");
    return make(std::move(node));
  }

  ExpressionPointer index(ExpressionPointer of) {
    std::vector<ExpressionPointer> parts = {std::move(of), nullptr, nullptr, nullptr};
    bool slice = false;
    for (std::size_t i = 1; i < parts.size(); ++i) {
      if (!isSign(":") && !isSign("]")) parts[i] = i == 1 ? items() : single();
      if (!takeSign(":")) break;
      slice = true;
    }
    need("]");
    if (slice) return make(Kind::kSlice, std::move(parts));
    if (!parts[1]) fail(Text("an index"));
    parts.resize(2);
    return make(Kind::kIndex, std::move(parts));
  }

  ExpressionPointer comprehension(ExpressionPointer made, ExpressionPointer value) {
    Expression node;
    node.kind = Kind::kComprehension;
    node.dict = value != nullptr;
    node.parts.push_back(std::move(made));
    if (value) node.parts.push_back(std::move(value));
    while (takeWord("for")) {
      Expression::Clause clause;
      const bool closed = takeSign("(");
      do clause.names.push_back(identifier());
      while (takeSign(","));
      if (closed) need(")");
      if (!takeWord("in")) fail("in");
      clause.source = either();
      while (takeWord("if")) clause.conditions.push_back(either());
      node.clauses.push_back(std::move(clause));
    }
    return make(std::move(node));
  }

  ExpressionPointer atom() {
    const Token token = now();
    if (token.kind == Token::Kind::kConstant) return literal();
    if (token.kind == Token::Kind::kName) return name();
    if (takeSign("(")) return parentheses();
    if (takeSign("[")) return list();
    if (takeSign("{")) return dict();
    fail(Text("a value"));
  }

  ExpressionPointer literal() {
    Value value = tokens_[at_++].value;
    while (value.text() && now().kind == Token::Kind::kConstant && now().value.text())
      value = *value.text() + *tokens_[at_++].value.text();
    return constant(std::move(value));
  }

  ExpressionPointer name() {
    if (takeWord("True")) return constant(true);
    if (takeWord("False")) return constant(false);
    if (takeWord("None")) return constant({});
    if (kKeywords.count(now().text)) fail(Text("a value"));
    return make(Kind::kName, {}, tokens_[at_++].text);
  }

  ExpressionPointer parentheses() {
    const Level level(level_);
    if (takeSign(")")) return make(Kind::kTuple, {});
    ExpressionPointer inside = items();
    if (isWord("for")) inside = comprehension(std::move(inside), nullptr);
    need(")");
    return inside;
  }

  ExpressionPointer list() {
    const Level level(level_);
    std::vector<ExpressionPointer> parts;
    while (!isSign("]")) {
      parts.push_back(single());
      if (parts.size() == 1 && isWord("for")) {
        ExpressionPointer made = comprehension(std::move(parts[0]), nullptr);
        need("]");
        return made;
      }
      if (!isSign("]")) need(",");
    }
    need("]");
    return make(Kind::kList, std::move(parts));
  }

  ExpressionPointer dict() {
    const Level level(level_);
    std::vector<ExpressionPointer> parts;
    while (!isSign("}")) {
      parts.push_back(single());
      need(":");
      parts.push_back(single());
      if (parts.size() == 2 && isWord("for")) {
        ExpressionPointer made = comprehension(std::move(parts[0]), std::move(parts[1]));
        need("}");
        return made;
      }
      if (!isSign("}")) need(",");
    }
    need("}");
    return make(Kind::kDict, std::move(parts));
  }
};

}  // namespace

ExpressionPointer parseExpression(const std::string& text) {
  if (text.size() > kLongest) throw Fault{.found = "an expression of more than 64 kB", .expected = "a shorter one"};
  return Parser(text).run();
}

bool isIdentifier(const std::string& name) {
  if (name.empty() || (name[0] >= '0' && name[0] <= '9') || kKeywords.count(name)) return false;
  return std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) || c == '_' || c >= 0x80; });
}

}  // namespace hapticell::xacro
