// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/viewport/scene/camera.h"
#include "config/configuration.h"
#include "haptic/devices/input_reader.h"
#include "mannequin/motion/glove_mapping.h"
#include "mannequin/posture/posture.h"

namespace hapticell::app {

/// Turns and shifts the view by a 3-D mouse: the cap is the scene. `motion` as driver::State has it, `seconds` since
/// the last call, at most 0.1.
Camera movedByMouse(const Camera& from, const double (&motion)[6], double seconds, const ViewSize& size);

/// What a 3-D mouse moves what is held by within `seconds`, in the hand's axes D: metres and radians.
Twist handMotion(const double (&motion)[6], double seconds);

/// The four poses of a glove's calibration, one after another; what the user is asked for, and what came of it.
class GloveCalibrator {
 public:
  static constexpr int kPoses = 4;
  /// Pose to hold now, 0 .. 3; kPoses when all are taken.
  int next() const { return static_cast<int>(taken_.size()); }
  static QString instruction(int pose);
  /// Takes the pose that is held; after the last the calibration, or which sensor did not move.
  void take(const mannequin::GloveReadings& readings);
  const std::optional<mannequin::GloveCalibration>& result() const { return result_; }
  int badSensor() const { return bad_sensor_; }

 private:
  std::vector<mannequin::GloveReadings> taken_;
  std::optional<mannequin::GloveCalibration> result_;
  int bad_sensor_ = -1;
};

/// The glove and the 3-D mouse beside the stylus, read in this process (their drivers hold nothing of a vendor). GUI
/// thread; never waits.
class InputDevices : public QObject {
  Q_OBJECT
 public:
  enum class MouseMoves { kView, kEntity };

  explicit InputDevices(const config::Configuration& configuration, QObject* parent = nullptr);
  ~InputDevices() override;

  /// A device as the listing names it ("cyberglove:/dev/ttyUSB0"); empty: none.
  void chooseGlove(const QString& device);
  void chooseMouse(const QString& device);
  const QString& glove() const { return glove_name_; }
  const QString& mouse() const { return mouse_name_; }
  void setMouseMoves(MouseMoves moves);
  MouseMoves mouseMoves() const { return moves_; }

  /// The mouse's newest state, where it answers.
  std::optional<driver::State> mouseState();
  /// The mouse's buttons that went down since the last call, also those that are up again.
  std::uint32_t takeMousePresses() { return mouse_ ? mouse_->takePressed() : 0u; }
  /// The glove's readings of all 22 sensors, where it answers.
  std::optional<mannequin::GloveReadings> gloveReadings() const;
  /// Joint angles of the hand, rad, by the user's calibration (without one, by a rough default).
  std::optional<mannequin::GloveReadings> gloveAngles() const;
  bool isRightGlove() const;
  /// While the user shows the poses of a calibration the glove poses nothing.
  void setCalibrating(bool calibrating) { calibrating_ = calibrating; }
  bool isCalibrating() const { return calibrating_; }
  /// Thumb to little finger and palm, 0 .. 1 each.
  void vibrateGlove(const std::array<double, 6>& strength);
  /// One line about the glove or the mouse.
  QString gloveLine() const;
  QString mouseLine() const;
  bool isGloveCalibrated() const { return calibrated_; }
  /// Keeps a user's calibration and uses it.
  Expected<void> keepCalibration(const mannequin::GloveCalibration& calibration);

  /// What happened since the last call, in sentences.
  std::vector<Text> takeNews();

 signals:
  void changed();

 private:
  std::unique_ptr<haptic::InputReader> open(const QString& device);
  std::string calibrationFile() const;
  void readCalibration();

  const config::Configuration& configuration_;
  std::unique_ptr<haptic::InputReader> glove_, mouse_;
  QString glove_name_, mouse_name_;
  MouseMoves moves_ = MouseMoves::kView;
  mannequin::GloveCalibration calibration_;
  bool calibrated_ = false, calibrating_ = false;
  std::vector<Text> news_;
};

}  // namespace hapticell::app
