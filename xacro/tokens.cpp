// SPDX-License-Identifier: Apache-2.0
#include "xacro/tokens.h"

#include <cctype>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include "xacro/scope.h"

namespace hapticell::xacro {

namespace {

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}
bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

class Tokenizer {
 public:
  explicit Tokenizer(const std::string& text) : text_(text) {}

  std::vector<Token> run() {
    std::vector<Token> tokens;
    while (skipBlanks()) tokens.push_back(next());
    tokens.push_back({});
    return tokens;
  }

 private:
  const std::string& text_;
  std::size_t at_ = 0;

  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  bool skipBlanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    return at_ < text_.size();
  }

  Token next() {
    const char c = peek();
    if (isDigit(c) || (c == '.' && isDigit(peek(1)))) return number();
    if (c == '\'' || c == '"') return {Token::Kind::kConstant, "", quoted(false)};
    if (isLetter(c)) return word();
    return sign();
  }

  Token word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (isLetter(text_[at_]) || isDigit(text_[at_]))) ++at_;
    const std::string name = text_.substr(begin, at_ - begin);
    const bool prefix = name.size() == 1 && std::string_view("uUrR").find(name[0]) != std::string_view::npos;
    if ((peek() == '\'' || peek() == '"') && prefix)
      return {Token::Kind::kConstant, "", quoted(name == "r" || name == "R")};
    return {Token::Kind::kName, name, {}};
  }

  std::string quoted(bool raw) {
    const char mark = peek();
    const std::string three(3, mark);
    const bool is_long = text_.compare(at_, 3, three) == 0;
    at_ += is_long ? 3 : 1;
    std::string result;
    for (;;) {
      if (at_ >= text_.size())
        throw Fault{.found = "a text without closing quote in the expression", .expected = std::string(1, mark)};
      if (is_long ? text_.compare(at_, 3, three) == 0 : text_[at_] == mark) break;
      if (text_[at_] == '\\' && !raw && at_ + 1 < text_.size())
        result += escaped();
      else
        result += text_[at_++];
    }
    at_ += is_long ? 3 : 1;
    return result;
  }

  std::string escaped() {
    const char c = text_[at_ + 1];
    at_ += 2;
    switch (c) {
      case 'n':
        return "\n";
      case 't':
        return "\t";
      case 'r':
        return "\r";
      case '\n':
        return "";
      case '\\':
      case '\'':
      case '"':
        return std::string(1, c);
      default:
        return std::string("\\") + c;
    }
  }

  Token number() {
    const std::size_t begin = at_;
    if (peek() == '0' && std::string_view("xXoObB").find(peek(1)) != std::string_view::npos) return based();
    bool real = false;
    for (;; ++at_) {
      const char c = peek();
      const bool exponent =
          (c == 'e' || c == 'E') && (isDigit(peek(1)) || ((peek(1) == '-' || peek(1) == '+') && isDigit(peek(2))));
      if (exponent) ++at_;
      real = real || exponent || c == '.';
      if (!isDigit(c) && c != '.' && c != '_' && !exponent) break;
    }
    std::string digits;
    for (std::size_t i = begin; i < at_; ++i) {
      if (text_[i] != '_') digits += text_[i];
    }
    const std::string shown = text_.substr(begin, at_ - begin);
    if (isLetter(peek())) throw Fault{.found = Text("'%1' in the expression", shown + peek()), .expected = "a number"};
    const char *first = digits.data(), *last = first + digits.size();
    std::int64_t whole = 0;
    if (!real) {
      const auto [end, problem] = std::from_chars(first, last, whole);
      if (problem == std::errc::result_out_of_range)
        throw Fault{.found = Text("the whole number %1", shown.substr(0, 40)), .expected = "a number within 64 bits"};
      return {Token::Kind::kConstant, "", whole};
    }
    const std::optional<double> value = numberFromText(digits);  // what no double holds is 0 or infinite, as in Python
    if (!value) throw Fault{.found = Text("'%1' in the expression", shown.substr(0, 40)), .expected = "a number"};
    return {Token::Kind::kConstant, "", *value};
  }

  Token based() {
    const char kind = static_cast<char>(std::tolower(peek(1)));
    at_ += 2;
    const std::size_t begin = at_;
    while (std::isalnum(static_cast<unsigned char>(peek()))) ++at_;
    std::int64_t whole = 0;
    const char *first = text_.data() + begin, *last = text_.data() + at_;
    int base = kind == 'o' ? 8 : 2;
    if (kind == 'x') base = 16;
    const auto [end, problem] = std::from_chars(first, last, whole, base);
    if (problem != std::errc() || end != last || first == last)
      throw Fault{.found = "an invalid number in the expression", .expected = "0x1f"};
    return {Token::Kind::kConstant, "", whole};
  }

  Token sign() {
    for (const std::string_view two : {"**", "//", "<<", ">>", "<=", ">=", "==", "!="}) {
      if (text_.compare(at_, 2, two) != 0) continue;
      at_ += 2;
      return {Token::Kind::kSign, std::string(two), {}};
    }
    const char c = text_[at_];
    if (std::string_view("+-*/%()[]{},:.<>&|^~=").find(c) == std::string_view::npos)
      throw Fault{.found = Text("the character '%1' in the expression", std::string(1, c)),
                  .expected = "an expression"};
    ++at_;
    return {Token::Kind::kSign, std::string(1, c), {}};
  }
};

}  // namespace

std::vector<Token> tokensOf(const std::string& text) {
  return Tokenizer(text).run();
}

}  // namespace hapticell::xacro
