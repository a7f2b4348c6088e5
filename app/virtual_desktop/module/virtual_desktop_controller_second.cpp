// SPDX-License-Identifier: Apache-2.0
// A second stylus: its own haptic server on a free port, its link, what it holds.
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "app/host/document_model.h"
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

void VirtualDesktopController::chooseSecond(const QString& device) {
  if (device == second_profile_) return;
  second_profile_ = device;
  dropSecond();
  if (isStarted()) startSecond();
  postSettings();
  emit connectionChanged();
}

void VirtualDesktopController::dropSecond() {
  if (loop_ && second_link_) loop_->setSecondStylus(nullptr);
  second_link_ = nullptr;
  second_device_.reset();
  second_server_.stop();
  second_mouse_.setState({});
}

/// Needs the loop.
void VirtualDesktopController::startSecond() {
  if (second_profile_.isEmpty() || !loop_) return;
  const int port = freePort();
  second_server_.start(second_profile_, port);
  haptic::TcpLinkOptions options;
  options.port = static_cast<std::uint16_t>(port);
  options.program = "HaptiCell, second stylus";
  auto link = std::make_unique<haptic::TcpLink>(options);
  second_link_ = link.get();
  loop_->setSecondStylus(std::move(link));
  postCamera();  // Its place in the view is not the first one's.
  second_mouse_.hold(true);
}

/// What the first holds of a mannequin leaves the second the other hand; the trunk stands still then.
manipulation::MovedBy VirtualDesktopController::movedBy() const {
  manipulation::MovedBy moved_by = host_.holdChoice().movedBy();
  auto* hand = std::get_if<by::Hand>(&moved_by);
  if (second_link_ && hand) hand->locks.trunk = true;
  return moved_by;
}

void VirtualDesktopController::postSecondSettings() {
  if (!loop_ || !second_link_) return;
  manipulation::MovedBy moved_by = movedBy();
  auto* hand = std::get_if<by::Hand>(&moved_by);
  loop_->postSecond(command::ChooseEntity{hand ? settings_.entity : 0});
  if (hand) {
    hand->side = mannequin::other(hand->side);
  } else {
    moved_by = {};
  }
  loop_->postSecond(command::SetMovedBy{moved_by});
  loop_->postSecond(command::SetAxes{{settings_.axes, settings_.axes_frame}});
  loop_->postSecond(command::SetScale{{settings_.scale, 1.0}});
}

QString VirtualDesktopController::secondLine() const {
  if (second_profile_.isEmpty()) return {};
  if (!second_link_) return tr("Comes with the first one");
  if (second_link_->linkState() != haptic::LinkState::kConnected) return shownText(second_link_->problem());
  if (snapshot_.second && snapshot_.second->device_fault) return tr("It does not answer: its force is zero");
  if (!host_.holdChoice().is<by::Hand>()) return tr("Connected, pen 2 in the scene; it holds what its tip touches");
  return tr("Connected, pen 2 in the scene; it holds the other hand, the trunk stands still");
}

/// As for the first: a connection begins without forces, and the simulated hand is told where it is.
void VirtualDesktopController::followSecond() {
  if (!second_link_) return;
  const bool connected = second_link_->linkState() == haptic::LinkState::kConnected;
  if (connected && !second_device_) {
    second_device_ = second_link_->device();
    postSecondSettings();
    // Never on by a connection: the user switches them on for both.
    loop_->postSecond(command::SetForces{false});
    if (forces_wanted_) {
      setForces(false);
      host_.messages().tell(Severity::kInformation, tr("Forces are off: a second stylus has come"));
    }
    loop_->postSecond(command::SetHandTarget{second_mouse_.target()});
    emit connectionChanged();
  } else if (!connected && second_device_) {
    second_device_.reset();
    loop_->postSecond(command::SetForces{false});
    emit connectionChanged();
  }
}

void VirtualDesktopController::updateSecondMouse() {
  MouseStylus::State state;
  if (snapshot_.second && second_device_) {
    manipulation::SecondStylusState& second = *snapshot_.second;
    const dquat q_WD = axes_W();
    second.X_WStylus.q = glm::normalize(q_WD * second.X_DS.q);
    const ViewportWidget& viewport = host_.viewport();
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    state.usable = second_device_->simulated;
    state.holding_entity = second.held != 0;
    state.q_WD = q_WD;
    state.scale = second.motion_scale;
    state.p_WTip = second.X_WStylus.p;
    state.d_WPen = second.X_WStylus.rotate(stylusDirection_S());
    state.pen_length = penPixels(size) * viewport.camera().metresPerPixel(state.p_WTip, size);
    state.workspace_min = second_device_->workspace_min;
    state.workspace_max = second_device_->workspace_max;
  }
  second_mouse_.setState(state);
}

}  // namespace hapticell::app
