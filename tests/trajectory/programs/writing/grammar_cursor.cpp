// SPDX-License-Identifier: Apache-2.0
#include "tests/trajectory/programs/writing/grammar_cursor.h"

#include <algorithm>
#include <cctype>

namespace hapticell::test {

bool GrammarCursor::maybe(const std::string& what) {
  if (!isNext(what)) return false;
  at_ += what.size();
  return true;
}

void GrammarCursor::need(const std::string& what) {
  if (!maybe(what)) fail("'" + what + "'");
}

bool GrammarCursor::maybeWord(const std::string& what) {
  if (!isNext(what) || isWordSign(at_ + what.size())) return false;
  at_ += what.size();
  return true;
}

void GrammarCursor::needWord(const std::string& what) {
  if (!maybeWord(what)) fail("the word '" + what + "'");
}

std::string GrammarCursor::word() {
  blanks();
  std::string result;
  while (isWordSign(at_)) result += text_[at_++];
  if (result.empty() || std::isdigit(static_cast<unsigned char>(result.front())) != 0) fail("a word");
  return result;
}

double GrammarCursor::number() {
  blanks();
  const std::size_t begin = at_;
  if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
  std::size_t digits = 0;
  while (isDigit()) ++at_, ++digits;
  if (at_ < text_.size() && text_[at_] == '.') ++at_;
  while (isDigit()) ++at_, ++digits;
  if (digits > 0 && at_ < text_.size() && (text_[at_] == 'E' || text_[at_] == 'e')) {
    ++at_;
    if (text_[at_] == '-' || text_[at_] == '+') ++at_;
    while (isDigit()) ++at_;
  }
  if (digits == 0) fail("a number");
  return std::stod(text_.substr(begin, at_ - begin));
}

void GrammarCursor::numbers(const std::string& open, const std::string& close, std::vector<double>& into) {
  need(open);
  do into.push_back(number());
  while (maybe(","));
  need(close);
}

std::string GrammarCursor::restOfLine() {
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  std::string rest = text_.substr(at_, end - at_);
  at_ = end;
  return rest;
}

void GrammarCursor::line() {
  blanks();
  maybe("\r");
  if (at_ < text_.size() && text_[at_] != '\n') fail("the line's end");
  if (at_ < text_.size()) ++at_;
}

void GrammarCursor::fail(const std::string& expected) {
  const auto number =
      1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size())), '\n');
  throw Wrong("line " + std::to_string(number) + ": '" + text_.substr(std::min(at_, text_.size()), 30) +
              "' instead of " + expected);
}

bool GrammarCursor::isWordSign(std::size_t at) const {
  return at < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at])) != 0 || text_[at] == '_') &&
         static_cast<unsigned char>(text_[at]) < 128;
}

void GrammarCursor::blanks() {
  while (at_ < text_.size() &&
         (text_[at_] == ' ' || text_[at_] == '\t' || (skips_lines_ && (text_[at_] == '\n' || text_[at_] == '\r'))))
    ++at_;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

void needName(const std::string& name, std::size_t longest, const std::set<std::string>& reserved) {
  if (name.size() > longest) throw Wrong("the name " + name + " is too long");
  if (std::isalpha(static_cast<unsigned char>(name.front())) == 0)
    throw Wrong("the name " + name + " begins with no letter");
  if (reserved.contains(upper(name))) throw Wrong("the name " + name + " is reserved");
}

}  // namespace hapticell::test
