// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "trajectory/programs/reading/fanuc_file.h"

namespace hapticell::trajectory {

/// The number in brackets after `opening`, from `from` on: "P[3:NAME]" after "P[" is 3. Nothing where no whole number
/// of 0 to a million stands there.
std::optional<int> fanucBracketed(const std::string& text, const std::string& opening, std::size_t from = 0);

/// "PR[2:NAME]" is 2 and 0, "PR[2,3:NAME]" 2 and 3; nothing for any other text.
std::optional<std::pair<int, int>> fanucRegisterIn(const std::string& text);

/// Without blanks and without the names in brackets: "R[1:UP-DOWN] = 2" is "R[1]=2".
std::string fanucWithoutBlanks(std::string text);

/// The numeric registers R[] and the position registers PR[] while a FANUC program runs: what the file does not tell is
/// unknown, not zero. Texts are upper case, as in FanucLine. One thread.
class FanucRegisters {
 public:
  /// `positions`: those of /POS; they must outlive this.
  explicit FanucRegisters(const std::map<int, FanucPosition>& positions) : positions_(positions) {}

  /// "R[1]", "PR[1,3]", a number, or "R[1]+2" (without blanks; * and / before + and -, each from left to right);
  /// nothing where the file does not say, and for a division by zero.
  std::optional<double> number(const std::string& text) const;
  /// Whether "R[1]<>2 AND R[2]=1" holds; nothing where the file does not say.
  std::optional<bool> holds(std::string text) const;
  std::optional<double> value(int r) const;
  /// Null: the program does not set it, or the file does not say to what.
  const FanucPosition* position(int pr) const;

  void set(int r, double value) { numbers_[r] = value; }
  /// "R[1]=R[2]+1" without blanks: false where no register is assigned. A value that is not known makes it unknown.
  bool assign(const std::string& text);
  /// "PR[1]=P[2]", "PR[1]=LPOS", "PR[1,3]=PR[1,3]-R[21]", without blanks: false where no register is assigned; what is
  /// not understood makes it unknown. `here`: LPOS, if it is known.
  bool assignPosition(const std::string& text, const std::optional<FanucPosition>& here);

 private:
  void assignWhole(int to, const std::string& right, const std::optional<FanucPosition>& here);

  const std::map<int, FanucPosition>& positions_;
  std::map<int, double> numbers_;
  std::map<int, FanucPosition> held_;
};

}  // namespace hapticell::trajectory
