// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/device_watch.h"

#include <algorithm>

#include "app/style/library_text.h"

namespace hapticell::app {
namespace {

// ms between two looks, 30 a second, as the meter moves. Half: twice the work; twice: jerks.
constexpr int kPeriod = 33;
// Samples kept: one each 0.1 s, a minute. Half, twice: half a minute, or two.
constexpr std::size_t kMostSamples = 600;
// s until forces must have come on: the engage gate and a driver's start. Half: slow drivers fail; twice: one waits for
// dead ones.
constexpr double kPatience = 6.0;
// s for a server to see that its client has let go. Half: refused without reason; twice: one waits.
constexpr double kRefusedPatience = 2.5;
// s; the server lets a weight change by 5 N/s at most: 1 N in this. Half: a slow window takes longer; twice: a leap is
// cut by the server.
constexpr double kLongestStep = 0.2;
// s: up, full, down: a push is felt as slow (0.5 N/s) and its end is soft. Half: twice as quick; twice: eight seconds
// of waiting.
constexpr double kRamp = 2.0, kHold = 1.0, kFall = 1.0;

}  // namespace

void RangeTest::take(const dvec3& p_D, std::uint32_t buttons) {
  min_ = any_ ? glm::min(min_, p_D) : p_D;
  max_ = any_ ? glm::max(max_, p_D) : p_D;
  any_ = true;
  now_ = buttons;
  pressed_ |= buttons;
}

dvec3 RangeTest::covered(const dvec3& workspace_min, const dvec3& workspace_max) const {
  const dvec3 size = workspace_max - workspace_min;
  dvec3 part(0.0);
  for (int i = 0; i < 3; ++i) {
    const double reached = std::min(max_[i], workspace_max[i]) - std::max(min_[i], workspace_min[i]);
    if (any_ && size[i] > 0.0) part[i] = std::clamp(reached / size[i], 0.0, 1.0);
  }
  return part;
}

double testPush(double seconds, double peak_n) {
  if (!(seconds > 0.0) || seconds >= kRamp + kHold + kFall) return 0.0;
  if (seconds < kRamp) return peak_n * seconds / kRamp;
  if (seconds < kRamp + kHold) return peak_n;
  return peak_n * (1.0 - (seconds - kRamp - kHold) / kFall);
}

DeviceWatch::DeviceWatch(QObject* parent) : QObject(parent) {
  timer_.setInterval(kPeriod);
  connect(&timer_, &QTimer::timeout, this, &DeviceWatch::tick);
}

DeviceWatch::~DeviceWatch() {
  stop();
}

void DeviceWatch::start(const std::string& host, int port) {
  if (link_) return;
  host_ = host;
  port_ = port;
  history_.clear();
  connectAs(haptic::ClientKind::kWatcher);
  timer_.start();
}

void DeviceWatch::stop() {
  if (testing_) endForceTest(tr("The test was stopped."));
  timer_.stop();
  link_.reset();
  device_.reset();
  state_ = {};
}

bool DeviceWatch::isConnected() const {
  return link_ && link_->linkState() == haptic::LinkState::kConnected;
}

void DeviceWatch::connectAs(haptic::ClientKind kind) {
  // A key that cannot be used is told where the stylus is connected; here the link says that it has none.
  auto options = haptic::linkOptionsFor(host_, static_cast<std::uint16_t>(port_)).value_or(haptic::TcpLinkOptions());
  options.host = host_;
  options.port = static_cast<std::uint16_t>(port_);
  options.kind = kind;
  options.program = "HaptiCell's device check";
  link_ = std::make_unique<haptic::TcpLink>(options);
}

void DeviceWatch::tick() {
  device_ = isConnected() ? link_->device() : std::nullopt;
  if (const auto newest = link_->latestState()) {
    state_ = *newest;
    if (!state_.device_fault) range_.take(state_.X_DS.p, state_.buttons);
  }
  if (const auto figures = link_->latestStatistics()) {
    statistics_ = *figures;
    history_.push_back({figures->rate_hz, figures->late_p99_ms, figures->late_max_ms});
    if (history_.size() > kMostSamples) history_.pop_front();
  }
  if (testing_) stepForceTest();
  emit changed();
}

void DeviceWatch::startForceTest() {
  if (testing_ || !link_) return;
  connectAs(haptic::ClientKind::kController);
  testing_ = true;
  step_.start();
  waited_s_ = 0.0;
  pushing_s_ = -1.0;
  progress_ = pushed_n_ = 0.0;
}

void DeviceWatch::stopForceTest() {
  if (testing_) endForceTest(tr("The test was stopped."));
}

void DeviceWatch::endForceTest(const QString& sentence) {
  if (isConnected()) link_->sendControl({});
  testing_ = false;
  emit forceTestEnded(sentence, pushed_n_);
  connectAs(haptic::ClientKind::kWatcher);
}

void DeviceWatch::stepForceTest() {
  // A window that stood still goes on where it was, and does not leap.
  const double step = std::min(kLongestStep, 1e-9 * static_cast<double>(step_.nsecsElapsed()));
  step_.restart();
  if (state_.device_fault && isConnected())
    return endForceTest(tr("The device reports a fault. No force was applied."));
  // Who controlled it has just let go: the server may need a moment to see that.
  if (link_->linkState() == haptic::LinkState::kRefused && waited_s_ > kRefusedPatience)
    return endForceTest(shownText(link_->problem()));
  haptic::HapticControl control;
  control.forces_enabled = true;
  const bool open = isConnected() && state_.forces_on && state_.force_ramp > 0.999;
  if (pushing_s_ < 0.0) {
    waited_s_ += step;
    if (waited_s_ > kPatience) return endForceTest(tr("Forces did not switch on. The device is not ready."));
    if (open) pushing_s_ = 0.0;
  } else {
    pushing_s_ += step;
    progress_ = std::min(1.0, pushing_s_ / kTestSeconds);
    pushed_n_ = std::max(pushed_n_, glm::length(state_.force_D));
    const double peak = device_ ? std::min(kTestPush, 0.5 * device_->continuous_force) : 0.0;
    control.load.weight_D = {0.0, 0.0, -testPush(pushing_s_, peak)};
    if (pushing_s_ >= kTestSeconds) return endForceTest({});
  }
  if (isConnected()) link_->sendControl(control);
}

}  // namespace hapticell::app
