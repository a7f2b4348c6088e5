// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/recording_hub.h"
#include "app/host/selection.h"
#include "app/style/library_text.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/virtual_desktop/widgets/preparation_bar.h"

namespace hapticell::app {
namespace {

namespace command = manipulation::command;

constexpr int kLeastPress = 90;   // Milliseconds that a press of the stylus's button lasts at least.
constexpr int kInputPeriod = 16;  // Milliseconds between two looks at glove and 3-D mouse.

/// "Fine".
QString scaleName(manipulation::ScaleLevel level) {
  switch (level) {
    case manipulation::ScaleLevel::kRough:
      return QObject::tr("Rough");
    case manipulation::ScaleLevel::kMedium:
      return QObject::tr("Medium");
    case manipulation::ScaleLevel::kFine:
      return QObject::tr("Fine");
    case manipulation::ScaleLevel::kScreen:
      return QObject::tr("Screen");
    case manipulation::ScaleLevel::kNumber:
      break;
  }
  return {};
}

}  // namespace

VirtualDesktopController::VirtualDesktopController(Host& host, QObject* parent)
    : QObject(parent),
      host_(host),
      sound_(host.configuration().gui.sound),
      mouse_([this](const haptic::HandTarget& target) { postHand(target); }),
      preparation_(new PreparationBar(&host.viewport())),
      inputs_(host_.configuration()),
      second_mouse_([this](const haptic::HandTarget& target) {
        if (loop_) loop_->postSecond(command::SetHandTarget{target});
      }) {
  clock_.start();
  connect(preparation_, &PreparationBar::cancelled, this, [this] {
    if (loop_) loop_->cancelPreparation();
  });
  profile_ = QString::fromStdString(host_.configuration().haptic.device);
  server_host_ = QString::fromStdString(host_.configuration().server.host);
  server_port_ = host_.configuration().server.port;
  host_.setSoundText(sound_.state(), sound_.isOn() && sound_.hasOutput());
  connect(&sound_, &SoundPlayer::changed, this,
          [this] { host_.setSoundText(sound_.state(), sound_.isOn() && sound_.hasOutput()); });
  connect(&timer_, &QTimer::timeout, this, &VirtualDesktopController::tick);
  input_clock_.start();
  input_timer_.setInterval(kInputPeriod);
  connect(&input_timer_, &QTimer::timeout, this, &VirtualDesktopController::takeInputs);
  connect(&inputs_, &InputDevices::changed, this, [this] {
    const bool any = !inputs_.glove().isEmpty() || !inputs_.mouse().isEmpty();
    any ? input_timer_.start() : input_timer_.stop();
    if (inputs_.glove().isEmpty()) endGlove();
    settleMouse();
    takeInputs();
    emit connectionChanged();
  });
  connect(&host_.documentModel(), &DocumentModel::closing, this, &VirtualDesktopController::forgetCell);
  connect(&host_.documentModel(), &DocumentModel::changed, this, [this] {
    takeEntityChoices();
    postDocument();
  });
  connect(&host_.holdChoice(), &HoldChoice::changed, this, [this] {
    const HoldChoice& choice = host_.holdChoice();
    if (loop_) loop_->post(command::SetMovedBy{movedBy()});
    postSecondSettings();
    const bool same_frame = choice.frame() == manipulation::frameOf(settings_.moved_by);
    if (same_frame && manipulation::isSameWay(choice.movedBy(), settings_.moved_by)) return;
    VirtualDesktopSettings settings = settings_;
    settings.moved_by = choice.movedBy();
    change(settings);
  });
  connect(&lister_, &DeviceLister::plugged, this, &VirtualDesktopController::tellOfPlugged);
  const auto post = [this](const auto& order) {
    if (loop_) loop_->post(order);
  };
  connect(&host_.recording(), &RecordingHub::startWanted, this, post);
  connect(&host_.recording(), &RecordingHub::stopWanted, this, [post] { post(command::StopRecording{}); });
  connect(&host_.recording(), &RecordingHub::guideWanted, this, &VirtualDesktopController::postGuides);
  connect(&host_.recording(), &RecordingHub::markWanted, this, [post] { post(command::MarkFrame{}); });
  connect(&host_.viewport(), &ViewportWidget::cameraChanged, this, &VirtualDesktopController::postCamera);
  connect(&server_, &ServerProcess::warned, this,
          [this](const QString& sentence) { host_.messages().tell(Severity::kWarning, sentence); });
  connect(&second_server_, &ServerProcess::warned, this,
          [this](const QString& sentence) { host_.messages().tell(Severity::kWarning, sentence); });
  connect(&second_server_, &ServerProcess::ended, this, [this](const QString& sentence) {
    host_.messages().tell(Severity::kProblem, sentence, tr("The second stylus is gone. Choose it again to start it."));
    second_profile_.clear();
    dropSecond();
    emit connectionChanged();
  });
  connect(&server_, &ServerProcess::ended, this, [this](const QString& sentence) {
    // One that has worked is started again; one that cannot start is not tried for ever.
    const bool worked = std::exchange(server_worked_, false);
    if (worked) server_tried_ = false;
    host_.messages().tell(Severity::kProblem, sentence,
                          worked ? tr("Forces are off. The server is started again; Ctrl+Space then turns them on.")
                                 : tr("Forces are off. Connect again to start it anew."));
  });
}

VirtualDesktopController::~VirtualDesktopController() {
  host_.viewport().setPointerTool(nullptr);
  disconnectDevice();
  delete preparation_;
  host_.setSoundText({}, false);
  server_.stop();
}

void VirtualDesktopController::connectDevice() {
  if (loop_) return;
  auto options = haptic::linkOptionsFor(server_host_.toStdString(), static_cast<std::uint16_t>(server_port_));
  if (!options) {
    host_.messages().tell(Severity::kProblem, tr("The key for the haptic server cannot be used."),
                          QString::fromStdString(options.error().message()));
    return;
  }
  options->accept_watching = true;  // Where another window has the stylus, the user is asked.
  auto link = std::make_unique<haptic::TcpLink>(*options);
  link_ = link.get();
  // A contact that is felt is to be seen without waiting for the timer.
  loop_ = std::make_unique<manipulation::ManipulationLoop>(std::move(link), host_.configuration(), [this] {
    QMetaObject::invokeMethod(this, &VirtualDesktopController::takeSnapshot, Qt::QueuedConnection);
  });
  connecting_.start();
  server_tried_ = false;
  forces_wanted_ = false;
  host_.recording().setLive(true);
  postDocument();
  postCamera();
  postSettings();
  mouse_.hold(true);
  host_.viewport().setPointerTool(&pens_);
  startSecond();
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.start(busyPeriod());
  emit connectionChanged();
}

void VirtualDesktopController::disconnectDevice() {
  if (!loop_) return;
  restGlove();
  timer_.stop();
  preparation_->setShare(std::nullopt);
  host_.recording().setLive(false);
  // A recording that was going on, and where the entity was let go.
  take(loop_->finish());
  link_ = second_link_ = nullptr;
  loop_.reset();
  dropSecond();
  snapshot_ = {};
  device_.reset();
  forces_wanted_ = forces_lost_ = was_connected_ = was_watching_ = false;
  mouse_.setState({});
  host_.setPreparedScene(nullptr);
  host_.setSnapshot(std::nullopt);
  host_.setDeviceText({}, true);
  emit snapshotChanged();
  emit connectionChanged();
}

bool VirtualDesktopController::isConnected() const {
  return link_ && link_->linkState() == haptic::LinkState::kConnected &&
         link_->grantedKind() == haptic::ClientKind::kController;
}

bool VirtualDesktopController::isWatching() const {
  return link_ && link_->linkState() == haptic::LinkState::kConnected &&
         link_->grantedKind() == haptic::ClientKind::kWatcher;
}

void VirtualDesktopController::takeStylus() {
  if (isWatching()) link_->takeOver();
}

void VirtualDesktopController::postHand(const haptic::HandTarget& target) {
  if (!loop_) return;
  const bool pressed = (target.buttons & 1u) != 0;
  if (pressed && !pressed_.isValid()) pressed_.start();
  haptic::HandTarget sent = target;
  // Newest wins on the way: a press must last, or its release overtakes it where the window is slow.
  if (!pressed && pressed_.isValid() && pressed_.elapsed() < kLeastPress) {
    sent.buttons |= 1u;
    QTimer::singleShot(kLeastPress, this, [this] { postHand(mouse_.target()); });
  } else if (!pressed) {
    pressed_.invalidate();
  }
  loop_->post(command::SetHandTarget{sent});
}

int VirtualDesktopController::busyPeriod() const {
  return static_cast<int>(std::lround(1000.0 / host_.configuration().gui.rate_hz));
}

double VirtualDesktopController::guiRate() const {
  return ticks_.rate(static_cast<double>(clock_.nsecsElapsed()) * 1e-9);
}

void VirtualDesktopController::postDocument() {
  if (!loop_) return;
  const workcell::Document& document = host_.documentModel().document();
  workcell::PairPolicy pairs = document.state().pairPolicy();
  if (document.state().findPairSet(settings_.against))
    for (workcell::PairSet& set : pairs.sets) set.enabled = set.name == settings_.against;
  loop_->post(command::SetDocument{document.snapshotEntities(), std::move(pairs)});
  postGuides();
}

void VirtualDesktopController::postGuides() {
  if (!loop_) return;
  std::vector<workcell::Guide> guides = host_.documentModel().document().state().guides;
  if (const auto& training = host_.recording().guide()) guides.push_back(*training);
  loop_->post(command::SetGuides{std::move(guides)});
}

void VirtualDesktopController::postSettings() {
  if (!loop_) return;
  loop_->post(command::ChooseEntity{settings_.entity});
  loop_->post(command::SetMovedBy{movedBy()});
  loop_->post(command::SetAxes{{settings_.axes, settings_.axes_frame}});
  loop_->post(command::SetScale{{settings_.scale, 1.0}});
  loop_->post(command::SetOnContact{settings_.on_contact});
  loop_->post(command::SetForceClass{settings_.force_class});
  const FreeAxes& free = settings_.free;
  loop_->post(command::SetFilter{free.translates(), free.rotates(), free.moves, free.turns});
  postSecondSettings();
  updateStrip();
}

void VirtualDesktopController::change(const VirtualDesktopSettings& settings) {
  const bool other_sets = settings.against != settings_.against;
  settings_ = settings;
  host_.holdChoice().set(settings.moved_by);
  if (other_sets) postDocument();
  postSettings();
  updateMouse();  // The next motion of the mouse goes along the axes chosen now, not from the next snapshot on.
  emit settingsChanged();
}

/// The chosen entity's own choices are the document's: changed in any panel, or undone, they count here too.
void VirtualDesktopController::takeEntityChoices() {
  const workcell::Entity* entity = host_.documentModel().document().find(settings_.entity);
  if (!entity) return;
  if (entity->on_contact == settings_.on_contact && entity->force_class == settings_.force_class) return;
  VirtualDesktopSettings settings = settings_;
  settings.on_contact = entity->on_contact;
  settings.force_class = entity->force_class;
  change(settings);
}

/// `set` writes the choice into the command and into the settings alike.
template <typename Set>
void VirtualDesktopController::choose(const Set& set) {
  workcell::SetProperties wanted;
  wanted.id = settings_.entity;
  set(wanted);
  if (settings_.entity != 0 && host_.documentModel().execute(wanted)) return;
  VirtualDesktopSettings settings = settings_;
  set(settings);
  change(settings);
}

void VirtualDesktopController::setOnContact(workcell::OnContact on_contact) {
  choose([on_contact](auto& choices) { choices.on_contact = on_contact; });
}

void VirtualDesktopController::setForceClass(workcell::ForceClass force_class) {
  choose([force_class](auto& choices) { choices.force_class = force_class; });
}

void VirtualDesktopController::updateStrip() {
  StripContext strip;
  strip.on_contact = settings_.on_contact;
  strip.scale_name = scaleName(settings_.scale).toStdString();
  strip.free_axes = freeAxesText(settings_.free);
  strip.near_miss_distance = host_.configuration().manipulation.near_miss;
  host_.viewport().setStrip(strip);
}

void VirtualDesktopController::setForces(bool on) {
  if (on && !isConnected()) return;
  forces_wanted_ = on;
  forces_cut_ = forces_lost_ = false;
  if (loop_) {
    loop_->post(command::SetForces{on});
    loop_->postSecond(command::SetForces{on});
  }
  emit settingsChanged();
}

void VirtualDesktopController::setClutch(bool on) {
  if (loop_) loop_->post(command::SetClutch{on});
}

void VirtualDesktopController::letGo() {
  mouse_.setButton(false);
  if (loop_) loop_->post(command::Release{});
}

void VirtualDesktopController::handleMoved(const manipulation::result::Moved& moved) {
  DocumentModel& document = host_.documentModel();
  if (!document.document().find(moved.entity)) return;  // Of a cell that is closed, or removed meanwhile.
  const workcell::SetConfiguration own{moved.entity, moved.X_WE, moved.joints};
  std::vector<workcell::Command> commands;
  for (const auto& axis : moved.axes)
    commands.push_back(workcell::SetConfiguration{axis.entity, axis.X_WE, axis.joints});
  commands.push_back(own);
  document.executeAll(QString::fromStdString(workcell::commandText(own, document.document().state())), commands);
}

/// What was chosen of the cell's own things; how the hand moves stays.
void VirtualDesktopController::forgetCell() {
  mouse_.setButton(false);
  for (const auto& entity : host_.documentModel().document().state().entities)
    closed_ids_ = std::max(closed_ids_, entity->id);
  VirtualDesktopSettings settings = settings_;
  settings.entity = 0;
  settings.moved_by = {};
  settings.against.clear();
  if (settings.axes == manipulation::AxesMode::kFrame) settings.axes = VirtualDesktopSettings().axes;
  settings.axes_frame.clear();
  change(settings);
}

/// The loop may still be at the cell before.
bool VirtualDesktopController::isOfCell(const manipulation::SceneSnapshot& snapshot) const {
  const auto isOld = [this](workcell::EntityId id) { return id != 0 && id <= closed_ids_; };
  return !isOld(snapshot.held) && std::none_of(snapshot.pairs.begin(), snapshot.pairs.end(), [&](const auto& pair) {
    return isOld(pair.moved) || isOld(pair.other);
  });
}

void VirtualDesktopController::take(const std::vector<manipulation::Result>& results) {
  for (const manipulation::Result& result : results) {
    if (const auto* moved = std::get_if<manipulation::result::Moved>(&result)) handleMoved(*moved);
    if (const auto* grabbed = std::get_if<manipulation::result::Grabbed>(&result))
      host_.selection().set(grabbed->entity);
    if (const auto* notice = std::get_if<manipulation::result::Notice>(&result))
      host_.messages().tell(Severity::kInformation, shownText(notice->sentence));
    if (const auto* recorded = std::get_if<manipulation::result::Recorded>(&result))
      host_.recording().deliver(recorded->trajectories);
  }
}

void VirtualDesktopController::tick() {
  const double now = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  ticks_.frame(now, 0.0);
  helpServer();
  const bool connected = isConnected();
  if (connected != was_connected_) {
    was_connected_ = connected;
    device_ = connected ? link_->device() : std::nullopt;
    if (!connected && (forces_wanted_ || snapshot_.forces_on)) tellOfLoss();
    forces_wanted_ = forces_cut_ = false;  // Never on by a reconnection.
    loop_->post(command::SetForces{false});
    loop_->postSecond(command::SetForces{false});
    loop_->post(command::SetHandTarget{mouse_.target()});
    settleMouse();
    if (connected) server_worked_ = server_.isRunning();
    if (!connected) connecting_.restart(), server_tried_ = server_.isRunning();
    emit connectionChanged();
  }
  if (isWatching() != was_watching_) {
    was_watching_ = !was_watching_;
    emit connectionChanged();
  }
  followSecond();
  tellOfDevice();
  take(loop_->takeResults());
  host_.setPreparedScene(loop_->scene());
  preparation_->setShare(loop_->preparation());
  takeSnapshot();
  showDevice();
  // Also without a snapshot: a loop that stands still is to be told of.
  if (!told_.isValid() || told_.elapsed() >= 100) {
    told_.start();
    emit snapshotChanged();
  }
}

}  // namespace hapticell::app
