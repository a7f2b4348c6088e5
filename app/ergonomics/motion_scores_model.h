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
  /// Starts reading a BVH, AMC (with the ASF next to it) or C3D file and scoring it with the task. `figure` is the
  /// mannequin's.
  void open(const QString& path, std::shared_ptr<const mannequin::Figure> figure, const ergonomics::WorkTask& task);
  /// Scores the motion again if it was scored for another figure or task.
  void follow(const std::shared_ptr<const mannequin::Figure>& figure, const ergonomics::WorkTask& task);
  /// Returns to the state before the first motion; ignores the result of a file that is still being read.
  void clear();
  bool isEmpty() const { return !motion_; }
  bool isBusy() const { return busy_; }
  QString name() const { return name_; }
  double seconds() const { return motion_ ? motion_->seconds : 0.0; }
  int frames() const { return motion_ ? static_cast<int>(motion_->postures.size()) : 0; }
  /// On the mannequin, relative to the origin.
  const mannequin::Posture& posture(int frame) const { return motion_->postures[static_cast<std::size_t>(frame)]; }
  /// RULA bands of body 0 to 3 (P5F to P95M), one a frame.
  const std::vector<int>& bands(std::size_t body) const { return motion_->bands[body]; }
  const std::vector<mannequin::Posture>& postures() const { return motion_->postures; }
  /// "l_shoulder, internal rotation in 12 frames": the limits of this mannequin that the recording exceeds; nothing is
  /// clamped. Empty: none.
  QString beyondLimits() const;
  /// The limit that is exceeded for the longest time.
  QString mostBeyond() const;
  /// What was detected or assumed because the file does not state it: the up axis, the marker set and so on.
  QString assumptions() const;
  /// Fraction of the time in the two higher bands.
  double shareAbove(std::size_t body) const;
  /// The phase in which RULA of the own body stays at its highest. Only valid if there is a motion.
  const ergonomics::ScorePhase& worstPhase() const { return motion_->phase; }
  /// The frame that represents the worst phase.
  int worstFrame() const { return motion_ ? static_cast<int>(motion_->phase.shown) : 0; }
  /// The worst phase with its time span; empty if there is no motion.
  std::optional<ergonomics::MotionPhase> phase() const;
  /// For the posture of the worst phase: four bodies at the same task, and better placements of the work.
  const std::vector<ergonomics::BodyAtTask>& bodiesAtPhase() const { return motion_->bodies; }
  const ergonomics::BetterPlaces& placesAtPhase() const { return motion_->places; }
  int rulaAt(int frame) const { return motion_->own[static_cast<std::size_t>(frame)]; }
  std::vector<ergonomics::ReportBlock::Strip> strips() const;

 signals:
  void changed();
  void opened();  ///< Another motion was opened; emitted after changed().
  void failed(const QString& why);

 private:
  struct Motion {
    std::vector<mannequin::Posture> postures;
    std::array<std::vector<int>, 4> bands;
    std::vector<int> own;
    std::map<std::string, int> beyond;  ///< Number of frames by limit.
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
  int question_ = 0;  ///< Number of the newest request; results of older ones are ignored.
};

}  // namespace hapticell::app
