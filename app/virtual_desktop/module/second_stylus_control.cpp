// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/second_stylus_control.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/style/library_text.h"
#include "app/viewport/scene/pen_look.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {
namespace {

namespace command = manipulation::command;

/// One of this machine's that nobody listens on now; 0 where none is to be had.
int freePort() {
  const int probe = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  const bool bound = probe >= 0 && bind(probe, any, length) == 0 && getsockname(probe, any, &length) == 0;
  if (probe >= 0) close(probe);
  return bound ? ntohs(address.sin_port) : 0;
}

}  // namespace

SecondStylusControl::SecondStylusControl(VirtualDesktopController& owner)
    : owner_(owner), mouse_([this](const haptic::HandTarget& target) {
        if (owner_.loop()) owner_.loop()->postSecond(command::SetHandTarget{target});
      }) {
  connect(&server_, &ServerProcess::warned, this,
          [this](const QString& sentence) { owner_.host().messages().tell(Severity::kWarning, sentence); });
  connect(&server_, &ServerProcess::ended, this, [this](const QString& sentence) {
    owner_.host().messages().tell(Severity::kProblem, sentence,
                                  tr("The second stylus was disconnected. Choose it again to start it."));
    profile_.clear();
    drop();
    emit owner_.connectionChanged();
  });
}

void SecondStylusControl::choose(const QString& device) {
  if (device == profile_) return;
  profile_ = device;
  drop();
  if (owner_.isStarted()) start();
  owner_.postSettings();
  emit owner_.connectionChanged();
}

void SecondStylusControl::drop() {
  if (owner_.loop() && link_) owner_.loop()->setSecondStylus(nullptr);
  link_ = nullptr;
  device_.reset();
  server_.stop();
  mouse_.setState({});
}

/// Needs the loop.
void SecondStylusControl::start() {
  if (profile_.isEmpty() || !owner_.loop()) return;
  const int port = freePort();
  server_.start(profile_, port);
  haptic::TcpLinkOptions options;
  options.port = static_cast<std::uint16_t>(port);
  options.program = "HaptiCell, second stylus";
  auto link = std::make_unique<haptic::TcpLink>(options);
  link_ = link.get();
  owner_.loop()->setSecondStylus(std::move(link));
  owner_.postCamera();  // Its place in the view is not the first one's.
  mouse_.hold(true);
}

void SecondStylusControl::postSettings() {
  if (!owner_.loop() || !link_) return;
  manipulation::MovedBy moved_by = owner_.movedBy();
  auto* hand = std::get_if<by::Hand>(&moved_by);
  owner_.loop()->postSecond(command::ChooseEntity{hand ? owner_.settings().entity : 0});
  if (hand) {
    hand->side = mannequin::other(hand->side);
  } else {
    moved_by = {};
  }
  owner_.loop()->postSecond(command::SetMovedBy{moved_by});
  owner_.loop()->postSecond(command::SetAxes{{owner_.settings().axes, owner_.settings().axes_frame}});
  owner_.loop()->postSecond(command::SetScale{{owner_.settings().scale, 1.0}});
}

QString SecondStylusControl::line() const {
  if (profile_.isEmpty()) return {};
  if (!link_) return tr("Connects with the first stylus");
  if (link_->linkState() != haptic::LinkState::kConnected) return shownText(link_->problem());
  if (owner_.snapshot().second && owner_.snapshot().second->device_fault)
    return tr("Not responding: its force is zero");
  if (!owner_.host().holdChoice().is<by::Hand>())
    return tr("Connected as stylus 2; holds the part that its tip touches");
  return tr("Connected as stylus 2; holds the other hand, trunk fixed");
}

/// As for the first: a connection begins without forces, and the simulated hand is told where it is.
void SecondStylusControl::follow() {
  if (!link_) return;
  const bool connected = link_->linkState() == haptic::LinkState::kConnected;
  if (connected && !device_) {
    device_ = link_->device();
    postSettings();
    // Never on by a connection: the user switches them on for both.
    owner_.loop()->postSecond(command::SetForces{false});
    if (owner_.forcesWanted()) {
      owner_.setForces(false);
      owner_.host().messages().tell(Severity::kInformation, tr("Forces are off: a second stylus was connected"));
    }
    owner_.loop()->postSecond(command::SetHandTarget{mouse_.target()});
    emit owner_.connectionChanged();
  } else if (!connected && device_) {
    device_.reset();
    owner_.loop()->postSecond(command::SetForces{false});
    emit owner_.connectionChanged();
  }
}

void SecondStylusControl::updateMouse(manipulation::SceneSnapshot& snapshot) {
  MouseStylus::State state;
  if (snapshot.second && device_) {
    manipulation::StylusState& second = *snapshot.second;
    const dquat q_WD = owner_.axes_W();
    second.X_WStylus.q = glm::normalize(q_WD * second.X_DS.q);
    const ViewportWidget& viewport = owner_.host().viewport();
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    state.usable = device_->simulated;
    state.holding_entity = second.held != 0;
    state.q_WD = q_WD;
    state.scale = second.motion_scale;
    state.p_WTip = second.X_WStylus.p;
    state.d_WPen = second.X_WStylus.rotate(stylusDirection_S());
    state.pen_length = penPixels(size) * viewport.camera().metresPerPixel(state.p_WTip, size);
    state.workspace_min = device_->workspace_min;
    state.workspace_max = device_->workspace_max;
  }
  mouse_.setState(state);
}

}  // namespace hapticell::app
