// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/program_tokens.h"

#include <array>
#include <cctype>

#include "geometry/system/text_case.h"
#include "trajectory/motion/csv_table.h"

namespace hapticell::trajectory {

namespace {

constexpr std::string_view kPoseRemark = " HaptiCell pose ";

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
bool isWordStart(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}

class Scanner {
 public:
  Scanner(std::string_view text, const Dialect& dialect) : text_(text), dialect_(dialect) {}

  Tokens scan() {
    while (at_ < text_.size()) step();
    endLine();
    return std::move(tokens_);
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void step() {
    const char c = peek();
    if (c == '\n') {
      endLine();
      ++line_;
      ++at_;
      begins_line_ = true;
      return;
    }
    if (c == dialect_.comment || (begins_line_ && c == '&')) return skipComment();
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++at_;
      return;
    }
    begins_line_ = false;
    if (isDigit(c) || (c == '.' && isDigit(peek(1)))) return takeNumber();
    // KRL's enumeration words, #BASE.
    if (isWordStart(c) || (c == '#' && isWordStart(peek(1)))) return takeWord();
    if (c == '"') return takeText();
    takeSign();
  }

  void skipComment() {
    const std::size_t end = text_.find('\n', at_);
    const std::string_view remark = text_.substr(at_ + 1, end == std::string_view::npos ? end : end - at_ - 1);
    if (remark.starts_with(kPoseRemark)) {
      add(Token::Kind::kSign, "@pose");
      at_ += 1 + kPoseRemark.size();
      return;
    }
    at_ = end == std::string_view::npos ? text_.size() : end;
  }

  void takeNumber() {
    const std::size_t begin = at_;
    while (isDigit(peek())) ++at_;
    if (peek() == '.') ++at_;
    while (isDigit(peek())) ++at_;
    const bool has_sign = peek(1) == '+' || peek(1) == '-';
    if ((peek() == 'e' || peek() == 'E') && isDigit(peek(has_sign ? 2 : 1))) {
      at_ += has_sign ? 2 : 1;
      while (isDigit(peek())) ++at_;
    }
    const std::string_view number = text_.substr(begin, at_ - begin);
    add(Token::Kind::kNumber, std::string(number));
    tokens_.back().number = parseNumber(number).value_or(0.0);
  }

  void takeWord() {
    std::string word(1, text_[at_++]);
    while (isWordStart(peek()) || isDigit(peek())) word += text_[at_++];
    if (dialect_.ignores_case) word = lowerCase(word);
    add(Token::Kind::kWord, std::move(word));
  }

  void takeText() {
    const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
    const std::size_t stop = end == std::string_view::npos ? text_.size() : end;
    add(Token::Kind::kText, std::string(text_.substr(at_ + 1, stop - at_ - 1)));
    at_ = stop < text_.size() && text_[stop] == '"' ? stop + 1 : stop;
  }

  void takeSign() {
    static constexpr std::array<std::string_view, 6> kPairs{":=", "==", "<>", "!=", "<=", ">="};
    for (const std::string_view pair : kPairs) {
      if (text_.substr(at_, 2) != pair) continue;
      add(Token::Kind::kSign, std::string(pair));
      at_ += 2;
      return;
    }
    add(Token::Kind::kSign, std::string(1, text_[at_++]));
  }

  void endLine() {
    if (!dialect_.has_line_ends || tokens_.empty() || tokens_.back().kind == Token::Kind::kLineEnd) return;
    add(Token::Kind::kLineEnd, "");
  }

  void add(Token::Kind kind, std::string text) { tokens_.push_back({kind, std::move(text), 0.0, line_}); }

  std::string_view text_;
  const Dialect& dialect_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  bool begins_line_ = true;
  Tokens tokens_;
};

}  // namespace

Tokens tokensOf(std::string_view text, const Dialect& dialect) {
  return Scanner(text, dialect).scan();
}

}  // namespace hapticell::trajectory
