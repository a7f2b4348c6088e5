// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace hapticell::test {

/// What is wrong with a program, as parsers of grammars throw it.
struct Wrong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A cursor over a text; what is asked for and not there is Wrong. Blanks before it are skipped, lines' ends where
/// `skips_lines` says so.
class GrammarCursor {
 public:
  explicit GrammarCursor(std::string text, bool skips_lines = false)
      : text_(std::move(text)), skips_lines_(skips_lines) {}

  bool isAtEnd() { return blanks(), at_ >= text_.size(); }
  bool isNext(const std::string& what) { return blanks(), text_.compare(at_, what.size(), what) == 0; }
  bool maybe(const std::string& what);
  void need(const std::string& what);
  /// A word that is not the begin of a longer one.
  bool maybeWord(const std::string& what);
  void needWord(const std::string& what);
  std::string word();
  double number();
  /// "[a,b,c]" of numbers, all in one list.
  void numbers(const std::string& open, const std::string& close, std::vector<double>& into);
  std::string restOfLine();
  void line();  ///< To the next, of which nothing may be left.
  [[noreturn]] void fail(const std::string& expected);

 private:
  bool isDigit() const { return at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9'; }
  bool isWordSign(std::size_t at) const;
  void blanks();

  std::string text_;
  bool skips_lines_;
  std::size_t at_ = 0;
};

std::string upper(std::string text);
/// Wrong for a name that is too long, begins with no letter, or is one of `reserved` (upper case).
void needName(const std::string& name, std::size_t longest, const std::set<std::string>& reserved);

/// "" or what was wrong in `parse`.
template <class Parse>
std::string guarded(Parse&& parse) {
  try {
    parse();
  } catch (const Wrong& wrong) {
    return wrong.what();
  } catch (const std::exception& other) {
    return std::string("a number out of range: ") + other.what();
  }
  return {};
}

}  // namespace hapticell::test
