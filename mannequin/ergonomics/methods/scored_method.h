// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hapticell::ergonomics {

/// One sub-score that a method asks for.
struct SubScore {
  std::string_view name;  ///< As in files and reports, e.g. "upper_arm".
  int least = 1;
  int greatest = 1;
  /// Required: a posture is not scored without it. Others (modifiers, loads) are taken as `least` if they are not
  /// given, and the score is then marked as partial.
  bool required = true;
};

/// A cell that was looked up.
struct TableEntry {
  std::string_view table;  ///< "A", "B", "C".
  int row = 0;             ///< As printed in the method's table (from 1), the first of its row headings.
  int row_part = 0;        ///< The second row heading (lower arm in RULA's table A); 0 without one.
  int column = 0;
  int column_part = 0;
  int value = 0;
};

/// The result of a method for complete sub-scores.
struct Evaluation {
  int score = 0;
  int level = 0;  ///< The method's action level (ScoredMethod::levelName says what it means).
  std::vector<TableEntry> entries{};
  struct Sum {
    std::string_view name;
    int value = 0;
  };
  std::vector<Sum> sums{};  ///< Scores between the tables, e.g. "score_a".
};

/// A method that turns whole-numbered sub-scores into a score: RULA, REBA, OWAS. Objects hold no state; any thread.
class ScoredMethod {
 public:
  virtual ~ScoredMethod() = default;
  virtual std::string_view name() const = 0;
  /// The publication that the tables are from.
  virtual std::string_view source() const = 0;
  virtual std::span<const SubScore> subScores() const = 0;
  /// `values`: one for each of subScores(), each within its range (a broken contract otherwise).
  virtual int score(std::span<const int> values) const = 0;
  virtual Evaluation evaluate(std::span<const int> values) const = 0;
  virtual int levelOf(int score) const = 0;
  virtual std::string_view levelName(int level) const = 0;
  /// True if a lower sub-score never raises the score. (OWAS numbers its postures without such an order.)
  virtual bool isOrdered() const { return true; }
};

/// One sub-score whose change would lower the score.
struct Driver {
  std::string_view sub_score;
  int from = 0;
  int to = 0;     ///< The change that lowers the score most; of equal ones the nearest to `from`.
  int score = 0;  ///< With that change alone.
};

/// The smallest change of sub-scores that reaches a lower action level.
struct NextLevel {
  struct Change {
    std::string_view sub_score;
    int from = 0;
    int to = 0;
  };
  std::vector<Change> changes{};
  int score = 0;
  int level = 0;
};

/// A score with its reasons.
struct Assessment {
  std::optional<int> score;  ///< Empty if a required sub-score is missing and matters.
  std::optional<int> level;
  int least_score = 0;     ///< Over all values that missing sub-scores could have.
  int greatest_score = 0;  ///< Equal to least_score if nothing is missing.
  std::vector<std::string_view> missing{};
  std::vector<int> values{};  ///< The sub-scores used; 0 for a required one that is missing.
  std::optional<Evaluation> evaluation{};
  std::vector<Driver> drivers{};  ///< Largest decrease first.
  std::optional<NextLevel> next_level{};

  bool isPartial() const { return !missing.empty(); }
};

/// Scores `values` (one for each of method.subScores(), empty if unknown) and finds what drives the score.
/// @pre each given value lies within its range.
Assessment assess(const ScoredMethod& method, std::span<const std::optional<int>> values);

}  // namespace hapticell::ergonomics
