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

// ms between two looks at a scene in which nothing moves. Half: twice the wake-ups; twice: a contact's first picture
// comes from the loop's own wake anyway.
constexpr int kIdlePeriod = 100;

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
      station_(host),
      sound_(host.configuration().gui.sound),
      mouse_(*this),
      preparation_(new PreparationBar(&host.viewport())),
      second_(*this),
      inputs_(*this, second_),
      feed_(*this),
      forces_(*this),
      plan_(*this) {
  clock_.start();
  connect(preparation_, &PreparationBar::cancelled, this, [this] {
    if (loop_) loop_->cancelPreparation();
  });
  host_.setSoundText(sound_.state(), sound_.isOn() && sound_.hasOutput());
  connect(&sound_, &SoundPlayer::changed, this,
          [this] { host_.setSoundText(sound_.state(), sound_.isOn() && sound_.hasOutput()); });
  connect(&timer_, &QTimer::timeout, this, &VirtualDesktopController::tick);
  connect(&lister_, &DeviceLister::plugged, this, &VirtualDesktopController::reportConnectedDevice);
  followHost();
}

void VirtualDesktopController::followHost() {
  connect(&host_.documentModel(), &DocumentModel::closing, this, &VirtualDesktopController::forgetCell);
  connect(&host_.documentModel(), &DocumentModel::changed, this, [this] {
    takeEntityChoices();
    feed_.postDocument();
  });
  connect(&host_.holdChoice(), &HoldChoice::changed, this, [this] {
    const HoldChoice& choice = host_.holdChoice();
    if (loop_) loop_->post(command::SetMovedBy{movedBy()});
    second_.postSettings();
    const bool same_frame = choice.frame() == manipulation::frameOf(settings_.moved_by);
    if (same_frame && manipulation::isSameWay(choice.movedBy(), settings_.moved_by)) return;
    VirtualDesktopSettings settings = settings_;
    settings.moved_by = choice.movedBy();
    change(settings);
  });
  const auto post = [this](const auto& order) {
    if (loop_) loop_->post(order);
  };
  connect(&host_.recording(), &RecordingHub::startWanted, this, post);
  connect(&host_.recording(), &RecordingHub::stopWanted, this, [post] { post(command::StopRecording{}); });
  connect(&host_.recording(), &RecordingHub::guideWanted, this, [this] { feed_.postGuides(); });
  connect(&host_.recording(), &RecordingHub::markWanted, this, [post] { post(command::MarkFrame{}); });
  connect(&host_.viewport(), &ViewportWidget::cameraChanged, this, [this] { feed_.postCamera(); });
}

VirtualDesktopController::~VirtualDesktopController() {
  host_.viewport().setPointerTool(nullptr);
  disconnectDevice();
  delete preparation_;
  host_.setSoundText({}, false);
  station_.stop();
}

void VirtualDesktopController::connectDevice() {
  if (loop_) return;
  auto options = haptic::linkOptionsFor(station_.host().toStdString(), static_cast<std::uint16_t>(station_.port()));
  if (!options) {
    host_.messages().reportCause(Severity::kProblem, tr("The key for the haptic server cannot be used."),
                                 options.error());
    return;
  }
  options->accept_watching = true;  // Where another window has the stylus, the user is asked.
  auto link = std::make_unique<haptic::TcpLink>(*options);
  link_.set(link.get());
  // A contact that is felt is to be seen without waiting for the timer.
  const auto show = [this] {
    QMetaObject::invokeMethod(this, &VirtualDesktopController::takeSnapshot, Qt::QueuedConnection);
  };
  loop_ =
      std::make_unique<manipulation::ManipulationLoop>(std::move(link), host_.configuration(), show, host_.scenes());
  station_.beginLooking();
  forces_.connectionChanged();
  host_.recording().setLive(true);
  feed_.postDocument();
  feed_.postCamera();
  postSettings();
  mouse().hold(true);
  host_.viewport().setPointerTool(&pens_);
  second_.start();
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.start(busyPeriod());
  emit connectionChanged();
}

void VirtualDesktopController::disconnectDevice() {
  if (!loop_) return;
  inputs_.glove().rest();
  timer_.stop();
  preparation_->setShare(std::nullopt);
  host_.recording().setLive(false);
  // A recording that was going on, and where the entity was let go.
  take(loop_->finish());
  link_.set(nullptr);
  second_.forgetLink();
  loop_.reset();
  second_.drop();
  snapshot_ = {};
  forces_.reset();
  mouse().setState({});
  host_.setPreparedScene(nullptr);
  host_.setSnapshot(std::nullopt);
  host_.setDeviceText({}, true);
  emit snapshotChanged();
  emit connectionChanged();
}

int VirtualDesktopController::busyPeriod() const {
  return static_cast<int>(std::lround(1000.0 / host_.configuration().gui.rate_hz));
}

double VirtualDesktopController::guiRate() const {
  return ticks_.rate(static_cast<double>(clock_.nsecsElapsed()) * 1e-9);
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
  plan_.post();
  second_.postSettings();
  updateStrip();
}

void VirtualDesktopController::change(const VirtualDesktopSettings& settings) {
  const bool other_sets = settings.against != settings_.against;
  settings_ = settings;
  host_.holdChoice().set(settings.moved_by);
  if (other_sets) feed_.postDocument();
  postSettings();
  mouse_.update();  // The next motion of the mouse goes along the axes chosen now, not from the next snapshot on.
  emit settingsChanged();
}

void VirtualDesktopController::edit(const std::function<void(VirtualDesktopSettings&)>& edit) {
  VirtualDesktopSettings settings = settings_;
  edit(settings);
  change(settings);
}

/// The chosen entity's own choices are the document's: changed in any panel, or undone, they count here too.
void VirtualDesktopController::takeEntityChoices() {
  const workcell::Entity* entity = host_.documentModel().document().find(settings_.entity);
  if (!entity) return;
  if (entity->contact.on_contact == settings_.on_contact && entity->contact.force_class == settings_.force_class)
    return;
  VirtualDesktopSettings settings = settings_;
  settings.on_contact = entity->contact.on_contact;
  settings.force_class = entity->contact.force_class;
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
  forces_.setWanted(on);
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
  mouse().setButton(false);
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
  mouse().setButton(false);
  feed_.closeCell();
  VirtualDesktopSettings settings = settings_;
  settings.entity = 0;
  settings.moved_by = {};
  settings.against.clear();
  if (settings.axes == manipulation::AxesMode::kFrame) settings.axes = VirtualDesktopSettings().axes;
  settings.axes_frame.clear();
  change(settings);
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

void VirtualDesktopController::followConnection() {
  const bool connected = isConnected();
  if (!connected && (forcesWanted() || snapshot_.stylus.forces_on)) forces_.reportLoss();
  forces_.connectionChanged();  // Never on by a reconnection.
  loop_->post(command::SetForces{false});
  loop_->postSecond(command::SetForces{false});
  loop_->post(command::SetHandTarget{mouse().target()});
  inputs_.settleMouse();
  station_.setAnswered(connected);
  emit connectionChanged();
}

void VirtualDesktopController::tick() {
  const double now = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  ticks_.frame(now, 0.0);
  if (!isConnected() && !isWatching() && !link_.isRefused()) station_.help();  // Refused: there is one.
  if (link_.takeConnectionChange()) followConnection();
  if (link_.takeWatchingChange()) emit connectionChanged();
  second_.follow();
  // Where the server is our own its warnings come by another way.
  const std::string sentence = link_.takeSentence();
  if (!sentence.empty() && !station_.isRunning())
    host_.messages().tell(Severity::kWarning, QString::fromStdString(sentence));
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

void VirtualDesktopController::takeSnapshot() {
  manipulation::SceneSnapshot fresh;
  if (!loop_ || !loop_->latest(fresh) || !feed_.isOfCell(fresh)) return;
  sound_.play(soundCue(fresh, snapshot_));
  const bool connected = isConnected();
  const bool cut = connected && snapshot_.stylus.forces_on && !fresh.stylus.forces_on && forcesWanted();
  snapshot_ = std::move(fresh);
  if (!connected) {  // What the server said last is not so any more.
    snapshot_.server = {};
    snapshot_.stylus.forces_on = false;
    snapshot_.stylus.force_n = 0.0;
  }
  forces_.snapshotCame(cut);
  const int period = snapshot_.idle ? std::max(kIdlePeriod, busyPeriod()) : busyPeriod();
  if (timer_.interval() != period) timer_.setInterval(period);
  // The pen is drawn as the hand holds it, whatever frame of the entity it moves.
  const dquat q_WD = feed_.axes_W();
  snapshot_.stylus.X_WStylus.q = glm::normalize(q_WD * snapshot_.stylus.X_DS.q);
  mouse_.update();
  second_.updateMouse(snapshot_);
  host_.setGuiRate(guiRate());
  host_.setSnapshot(snapshot_);
}

void VirtualDesktopController::showDevice() {
  if (!device()) return host_.setDeviceText(deviceLine(), false);
  QString forces = snapshot_.stylus.forces_on ? tr(" · forces on") : tr(" · forces off");
  if (forces_.areLost()) forces = tr(" · forces lost");
  host_.setDeviceText(QString::fromStdString(device()->name) + forces, !forces_.areLost());
}

void VirtualDesktopController::reportConnectedDevice(const ListedDevice& device) {
  const QString mends = device.problem + QLatin1Char(' ') + device.fix;
  host_.messages().tell(Severity::kInformation, tr("%1 has been plugged in").arg(device.name),
                        device.usable ? tr("Choose it in the panel Virtual Desktop.") : mends);
}

/// What the first holds of a mannequin leaves the second the other hand; the trunk stands still then.
manipulation::MovedBy VirtualDesktopController::movedBy() const {
  manipulation::MovedBy moved_by = host_.holdChoice().movedBy();
  auto* hand = std::get_if<by::Hand>(&moved_by);
  if (second_.isThere() && hand) hand->locks.trunk = true;
  return moved_by;
}

void VirtualDesktopController::useServer(const QString& host, int port) {
  if (host == station_.host() && port == station_.port()) return;
  const bool was_started = isStarted();
  disconnectDevice();
  station_.use(host, port);
  if (was_started) connectDevice();
  emit connectionChanged();
}

void VirtualDesktopController::chooseDevice(const QString& profile) {
  if (profile == station_.profile()) return;
  if (isConnected() && !station_.isRunning()) {
    host_.messages().tell(
        Severity::kInformation, tr("The stylus was not changed"),
        tr("Another program started the server at %1. Choose the device there.").arg(station_.address()));
    emit connectionChanged();
    return;
  }
  const bool was_started = isStarted();
  disconnectDevice();
  station_.setProfile(profile);
  if (was_started) connectDevice();
  emit connectionChanged();
}

}  // namespace hapticell::app
