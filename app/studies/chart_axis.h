// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

namespace hapticell::app {

class ResultTable;

/// The scale of a chart along one column of results: numbers, or words one step apart. A value.
struct ChartAxis {
  int column = -1;
  double least = 0.0, greatest = 1.0;
  std::vector<double> ticks;
  std::vector<QString> words;  ///< Not empty: the positions 0, 1, 2 ... are these.

  /// Over all rows of the table.
  static ChartAxis over(const ResultTable& table, int column);
  /// 0 to 1 along the axis; below 0: the row has no value.
  double shareOf(const ResultTable& table, std::size_t row) const;
  double share(double value) const { return (value - least) / (greatest - least); }
  /// What stands at a tick.
  QString tickText(double tick) const;
};

/// Ticks at round numbers (1, 2 or 5 times a power of ten) from `least` to `greatest`, about `count` of them.
std::vector<double> roundTicks(double least, double greatest, int count);

}  // namespace hapticell::app
