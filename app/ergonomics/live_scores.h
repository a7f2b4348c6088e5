// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

#include "mannequin/ergonomics/advice/advice_words.h"
#include "mannequin/ergonomics/scores/force_table.h"

namespace hapticell::app {

class MannequinContext;

/// The scores of the mannequin's present posture, at every frame in which it moves: all methods, both sides, four
/// bodies at the same task; and, when it stops moving, suggestions to lower the score. GUI thread; long computations
/// run in the background.
class LiveScores : public QObject {
  Q_OBJECT
 public:
  explicit LiveScores(MannequinContext& context, QObject* parent = nullptr);

  /// Drops all scores, for another document.
  void clear();
  /// Checks whether anything moved, and scores it; call it at each frame.
  void look();
  bool isEmpty() const { return !scores_.has_value(); }
  const ergonomics::PostureScores& scores() const { return *scores_; }
  const mannequin::Posture& posture() const { return posture_; }
  const std::shared_ptr<const mannequin::Figure>& figure() const { return figure_; }
  /// The document's task for this mannequin; an empty task if it has none.
  const ergonomics::WorkTask& task() const { return task_; }
  bool hasTask() const { return has_task_; }
  /// The user's own limits for the force of the hands, from the file that was chosen last; empty without such a file.
  const ergonomics::ForceTable& ownLimits() const { return own_limits_; }
  /// Reads a table and remembers its file for the next start; an empty name forgets it. If the file cannot be read,
  /// nothing changes.
  Expected<void> chooseOwnLimits(const QString& file);
  const std::vector<ergonomics::BodyAtTask>& bodies() const { return bodies_; }
  /// Index in bodies() of the body with the mannequin's own size; -1: none.
  int ownBody() const;

  /// Suggestions for the posture at rest.
  struct Advice {
    std::array<ergonomics::MethodAdvice, ergonomics::kPostureMethods.size()> methods;
    ergonomics::BetterPlaces better;
    std::optional<ergonomics::LiftingAdvice> lift;  ///< If the task is a lift that the equation applies to.
    std::vector<double> rises;                      ///< m
    std::vector<std::vector<int>> by_height;        ///< RULA of each body; 0: out of reach.
    std::optional<double> best_rise;                ///< Lowest worst score, nearest to now.
    double target_height = 0.0;                     ///< m, present height of the active hands.
  };
  const std::optional<Advice>& advice() const { return advice_; }
  /// "Nearest: upper arm 97° to 45° gives RULA 4. Lowering the work by 70 mm gives RULA 4."
  QString adviceText(ergonomics::PostureMethod method) const;
  /// The main drivers of the lifting index and how to lower it; empty where there is no lift.
  QString liftAdviceText() const;

 signals:
  void changed();
  void adviceChanged();

 private:
  void score();
  void advise();
  QString placeText(ergonomics::PostureMethod method) const;
  MannequinContext& context_;
  std::shared_ptr<const mannequin::Figure> figure_;
  mannequin::Posture posture_;
  ergonomics::WorkTask task_;
  bool has_task_ = false;
  ergonomics::ForceTable own_limits_;
  std::optional<ergonomics::PostureScores> scores_;
  std::vector<ergonomics::BodyAtTask> bodies_;
  std::vector<mannequin::NamedFigure> figures_;
  std::optional<Advice> advice_;
  QTimer rests_;
  QElapsedTimer since_bodies_;
  std::uint64_t question_ = 0;
  bool asking_ = false, bodies_late_ = false;
};

/// The language of the scores: the system's if it is French.
ergonomics::Language shownLanguage();
QString shown(const std::string& text);

}  // namespace hapticell::app
