// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <vector>

#include "mannequin/ergonomics/advice/motion_scores.h"
#include "mannequin/ergonomics/report/posture_report.h"
#include "mannequin/motion/retarget.h"

namespace hapticell::app {

/// A recorded motion on the four bodies and on the mannequin itself, scored frame by frame. GUI thread; reading and
/// scoring run in the background.
class MotionScoresModel : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  /// Begins to read a BVH, AMC (the ASF beside it) or C3D file and to score it with the task. `figure` is the
  /// mannequin's.
  void open(const QString& path, std::shared_ptr<const mannequin::Figure> figure, const ergonomics::WorkTask& task);
  /// Scores the motion again if it was scored for another figure or task.
  void follow(const std::shared_ptr<const mannequin::Figure>& figure, const ergonomics::WorkTask& task);
  /// As before the first motion; one that is being read is not taken.
  void clear();
  bool isEmpty() const { return !motion_; }
  bool isBusy() const { return busy_; }
  QString name() const { return name_; }
  double seconds() const { return motion_ ? motion_->seconds : 0.0; }
  int frames() const { return motion_ ? static_cast<int>(motion_->postures.size()) : 0; }
  /// On the mannequin, about the origin.
  const mannequin::Posture& posture(int frame) const { return motion_->postures[static_cast<std::size_t>(frame)]; }
  /// RULA bands of body 0 to 3 (P5F to P95M), one a frame.
  const std::vector<int>& bands(std::size_t body) const { return motion_->bands[body]; }
  const std::vector<mannequin::Posture>& postures() const { return motion_->postures; }
  /// "l_shoulder, internal rotation in 12 frames": limits that the recording goes beyond on this figure; nothing is
  /// clamped. Empty: none.
  QString beyondLimits() const;
  /// The one of these that lasts longest.
  QString mostBeyond() const;
  /// What was found or taken where the file does not say it: the axis that is up, the marker set ...
  QString assumptions() const;
  /// Share of the time in the two higher bands.
  double shareAbove(std::size_t body) const;
  /// Where RULA of the own body stays at its highest; only while there is a motion.
  const ergonomics::ScorePhase& worstPhase() const { return motion_->phase; }
  /// The frame that represents it.
  int worstFrame() const { return motion_ ? static_cast<int>(motion_->phase.shown) : 0; }
  /// The same with its time span; empty while there is no motion.
  std::optional<ergonomics::MotionPhase> phase() const;
  /// Of the worst phase's posture: four bodies at the same task, and where the work would be better.
  const std::vector<ergonomics::BodyAtTask>& bodiesAtPhase() const { return motion_->bodies; }
  const ergonomics::BetterPlaces& placesAtPhase() const { return motion_->places; }
  int rulaAt(int frame) const { return motion_->own[static_cast<std::size_t>(frame)]; }
  std::vector<ergonomics::ReportBlock::Strip> strips() const;

 signals:
  void changed();
  void opened();  ///< Another motion is there, after changed().
  void failed(const QString& why);

 private:
  struct Motion {
    std::vector<mannequin::Posture> postures;
    std::array<std::vector<int>, 4> bands;
    std::vector<int> own;
    std::map<std::string, int> beyond;  ///< Frames by limit.
    std::vector<Text> assumptions;
    double seconds = 0.0;
    ergonomics::ScorePhase phase;
    std::vector<ergonomics::BodyAtTask> bodies;
    ergonomics::BetterPlaces places{};
  };
  static Expected<std::shared_ptr<const Motion>> read(const std::string& path, const mannequin::Figure& figure,
                                                      const ergonomics::WorkTask& task);
  void start(bool is_new);
  std::shared_ptr<const Motion> motion_;
  QString path_;
  std::shared_ptr<const mannequin::Figure> figure_;
  ergonomics::WorkTask task_;
  QString name_;
  bool busy_ = false;
  int question_ = 0;  ///< The newest; what an older one gives is not taken.
};

}  // namespace hapticell::app
