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

/// The camera after a motion of the 3D mouse: turns and pans as if the cap were the scene. `motion` as in
/// driver::State, `seconds` since the last call, at most 0.1.
Camera movedByMouse(const Camera& from, const double (&motion)[6], double seconds, const ViewSize& size);

/// Motion of a held entity by a 3D mouse within `seconds`, along the hand's axes D: metres and radians.
Twist handMotion(const double (&motion)[6], double seconds);

/// The four poses of a glove's calibration, one after another: the request to the user, and the result.
class GloveCalibrator {
 public:
  static constexpr int kPoses = 4;
  /// Index of the pose to hold now, 0 to 3; kPoses when all are taken.
  int next() const { return static_cast<int>(taken_.size()); }
  static QString instruction(int pose);
  /// Takes the pose that the user holds; after the last, computes the calibration, or names a sensor without motion.
  void take(const mannequin::GloveReadings& readings);
  const std::optional<mannequin::GloveCalibration>& result() const { return result_; }
  int badSensor() const { return bad_sensor_; }

 private:
  std::vector<mannequin::GloveReadings> taken_;
  std::optional<mannequin::GloveCalibration> result_;
  int bad_sensor_ = -1;
};

/// The glove and the 3D mouse used with the stylus, read in this process (their drivers contain no vendor's code). GUI
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

  /// The newest state of the mouse, if it answers.
  std::optional<driver::State> mouseState();
  /// The mouse's buttons that were pressed since the last call, even if released again.
  std::uint32_t takeMousePresses() { return mouse_ ? mouse_->takePressed() : 0u; }
  /// The readings of all 22 sensors of the glove, if it answers.
  std::optional<mannequin::GloveReadings> gloveReadings() const;
  /// Joint angles of the hand, rad, by the user's calibration (or a rough default).
  std::optional<mannequin::GloveReadings> gloveAngles() const;
  bool isRightGlove() const;
  /// While the user shows the poses of a calibration, the glove controls nothing.
  void setCalibrating(bool calibrating) { calibrating_ = calibrating; }
  bool isCalibrating() const { return calibrating_; }
  /// Thumb to little finger and palm, 0 to 1 each.
  void vibrateGlove(const std::array<double, 6>& strength);
  /// One line about the glove or the mouse.
  QString gloveLine() const;
  QString mouseLine() const;
  bool isGloveCalibrated() const { return calibrated_; }
  /// Stores the user's calibration and uses it.
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
