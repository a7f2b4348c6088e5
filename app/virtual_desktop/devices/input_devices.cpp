// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/input_devices.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptic/devices/device_choice.h"
#include "haptic/devices/device_node.h"
#include "mannequin/motion/glove_file.h"

namespace hapticell::app {
namespace {

// A second at full deflection, about a window's width. By trial. Half: slow; twice: hard to stop.
constexpr double kPanPixels = 900.0;
// A second at full deflection: 3.75 rad (kRadiansPerPixel of camera.cpp). By trial. Half: slow; twice: hard to stop.
constexpr double kTurnPixels = 500.0;
// Of the distance's logarithm a second: 3.3 times. By trial. Half: slow; twice: hard to stop.
constexpr double kZoom = 1.2;
// m/s of the simulated hand at full deflection. By trial. Half: slow; twice: it presses hard on contacts.
constexpr double kHandSpeed = 0.12;
// rad/s, 69 degrees. By trial. Half: slow; twice: hard to stop.
constexpr double kHandTurn = 1.2;
// s: a window that stood still does not leap. Half: slow windows move slower; twice: leaps of 24 mm.
constexpr double kLongest = 0.1;

/// Gentle about the middle, full at the end; the sign stays.
double curve(double deflection) {
  return deflection * std::abs(deflection);
}

}  // namespace

Camera movedByMouse(const Camera& from, const double (&motion)[6], double seconds, const ViewSize& size) {
  const double s = std::clamp(seconds, 0.0, kLongest);
  Camera camera = from;
  camera.pan({kPanPixels * s * curve(motion[0]), -kPanPixels * s * curve(motion[2])}, camera.target_W, size);
  camera.orbit({kTurnPixels * s * curve(motion[5]), kTurnPixels * s * curve(motion[3])}, camera.target_W);
  camera.zoom(std::exp(kZoom * s * curve(motion[1])), camera.target_W);
  return camera;
}

Twist handMotion(const double (&motion)[6], double seconds) {
  const double s = std::clamp(seconds, 0.0, kLongest);
  Twist twist;
  for (int i = 0; i < 3; ++i) {
    twist.linear[i] = kHandSpeed * s * curve(motion[i]);
    twist.angular[i] = kHandTurn * s * curve(motion[3 + i]);
  }
  return twist;
}

QString GloveCalibrator::instruction(int pose) {
  switch (pose) {
    case 0:
      return QObject::tr("Hold the hand flat, fingers straight and together, the thumb beside the palm.");
    case 1:
      return QObject::tr("Make a fist, every finger joint bent by a right angle.");
    case 2:
      return QObject::tr("Hold the hand flat and spread the fingers, the thumb far out.");
    case 3:
      return QObject::tr("Hold the hand flat and lay the thumb across under the palm.");
    default:
      return {};
  }
}

void GloveCalibrator::take(const mannequin::GloveReadings& readings) {
  if (next() >= kPoses) return;
  taken_.push_back(readings);
  if (next() < kPoses) return;
  mannequin::GloveCalibrationPoses poses{taken_[0], taken_[1], taken_[2], taken_[3]};
  std::size_t bad = 0;
  result_ = mannequin::calibrateGlove(poses, &bad);
  if (!result_) bad_sensor_ = static_cast<int>(bad);
}

InputDevices::InputDevices(const config::Configuration& configuration, QObject* parent)
    : QObject(parent), configuration_(configuration) {}

InputDevices::~InputDevices() = default;

std::unique_ptr<haptic::InputReader> InputDevices::open(const QString& device) {
  if (device.isEmpty()) return nullptr;
  const haptic::DeviceName name = haptic::parseDeviceName(device.toStdString());
  const auto driver = haptic::findDriver(name.driver, configuration_.drivers);
  if (!driver) {
    news_.push_back(driver.error().text());
    return nullptr;
  }
  return std::make_unique<haptic::InputReader>(**driver, name.id);
}

void InputDevices::chooseGlove(const QString& device) {
  if (device == glove_name_) return;
  glove_.reset();
  glove_name_ = device;
  glove_ = open(device);
  readCalibration();
  emit changed();
}

void InputDevices::chooseMouse(const QString& device) {
  if (device == mouse_name_) return;
  mouse_.reset();
  mouse_name_ = device;
  mouse_ = open(device);
  emit changed();
}

void InputDevices::setMouseMoves(MouseMoves moves) {
  if (moves == moves_) return;
  moves_ = moves;
  emit changed();
}

std::optional<driver::State> InputDevices::mouseState() {
  if (!mouse_) return std::nullopt;
  const haptic::InputReader::Snapshot now = mouse_->latest();
  return now.open && now.measurements > 0 ? std::optional(now.state) : std::nullopt;
}

std::optional<mannequin::GloveReadings> InputDevices::gloveReadings() const {
  if (!glove_) return std::nullopt;
  const haptic::InputReader::Snapshot now = glove_->latest();
  if (!now.open || now.measurements == 0) return std::nullopt;
  return mannequin::gloveReadings(
      std::span(now.state.sensors).first(std::min<std::size_t>(now.capabilities.sensors, 32)));
}

std::optional<mannequin::GloveReadings> InputDevices::gloveAngles() const {
  const auto readings = gloveReadings();
  return readings ? std::optional(mannequin::gloveAngles(calibration_, *readings)) : std::nullopt;
}

bool InputDevices::isRightGlove() const {
  return !glove_ || QString::fromUtf8(glove_->latest().capabilities.name).contains(QStringLiteral("left")) == false;
}

void InputDevices::vibrateGlove(const std::array<double, 6>& strength) {
  if (!glove_) return;
  double each[6];
  for (std::size_t i = 0; i < 6; ++i) each[i] = std::clamp(strength[i], 0.0, 1.0);
  glove_->vibrate(each);
}

QString InputDevices::gloveLine() const {
  if (!glove_) return {};
  const haptic::InputReader::Snapshot now = glove_->latest();
  if (!now.open) return now.problem.empty() ? tr("Searching") : QString::fromStdString(now.problem);
  const QString name = QString::fromUtf8(now.capabilities.name);
  return calibrated_ ? name : tr("%1, not calibrated for you").arg(name);
}

QString InputDevices::mouseLine() const {
  if (!mouse_) return {};
  const haptic::InputReader::Snapshot now = mouse_->latest();
  if (now.open) return QString::fromUtf8(now.capabilities.name);
  return now.problem.empty() ? tr("Searching") : QString::fromStdString(now.problem);
}

std::string InputDevices::calibrationFile() const {
  return driver::userDeviceFolder() + "/glove.json";
}

void InputDevices::readCalibration() {
  const auto own = mannequin::readGloveCalibration(calibrationFile());
  calibrated_ = own.has_value();
  calibration_ = own ? *own : mannequin::roughGloveCalibration();
}

Expected<void> InputDevices::keepCalibration(const mannequin::GloveCalibration& calibration) {
  const auto written = mannequin::writeGloveCalibration(calibration, calibrationFile());
  if (!written) return written;
  calibration_ = calibration;
  calibrated_ = true;
  emit changed();
  return {};
}

std::vector<Text> InputDevices::takeNews() {
  std::vector<Text> all = std::exchange(news_, {});
  for (haptic::InputReader* reader : {glove_.get(), mouse_.get()}) {
    if (!reader) continue;
    for (std::string& sentence : reader->takeNews()) all.emplace_back(std::move(sentence));
  }
  return all;
}

}  // namespace hapticell::app
