// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/mannequin_panel.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/mannequin/body_size.h"
#include "app/mannequin/carried_part.h"
#include "app/mannequin/figure_drag.h"
#include "app/mannequin/figure_sketch.h"
#include "app/mannequin/hand_gizmo.h"
#include "app/mannequin/joint_list.h"
#include "app/mannequin/mannequin_context.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/mannequin/reach_lines.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/style/theme.h"
#include "app/style/units.h"
#include "geometry/shapes/vector.h"
#include "mannequin/shape/hand_shape.h"

namespace hapticell::app {
namespace {

using manipulation::isSameWay;
using manipulation::MovedBy;
using mannequin::Side;

std::array<MovedBy, 5> waysOfHolding() {
  return {by::Whole{}, by::Hand{Side::kLeft}, by::Hand{Side::kRight}, by::BothHands{}, by::Head{}};
}

QString bodyText(const mannequin::Figure& figure) {
  const QString text = figure.sex == mannequin::Sex::kMale ? MannequinPanel::tr("Man, %1, %2 kg")
                                                           : MannequinPanel::tr("Woman, %1, %2 kg");
  return text.arg(lengthText(figure.body[mannequin::Dimension::kStature], 0)).arg(std::lround(figure.totalMass()));
}

/// Bodies of what is held, for the sketch.
std::vector<std::size_t> bodiesOf(const MovedBy& held) {
  using S = mannequin::Segment;
  std::vector<std::size_t> bodies;
  const auto add = [&](S first, S last) {
    for (std::size_t i = mannequin::indexOf(first); i <= mannequin::indexOf(last); ++i) bodies.push_back(i);
  };
  const bool both = std::holds_alternative<by::BothHands>(held);
  if (std::holds_alternative<by::Whole>(held)) add(S::kPelvis, S::kRightToes);
  if (both || isSameWay(held, by::Hand{Side::kLeft})) add(S::kLeftUpperArm, S::kLeftHand);
  if (both || isSameWay(held, by::Hand{Side::kRight})) add(S::kRightUpperArm, S::kRightHand);
  if (std::holds_alternative<by::Head>(held)) add(S::kLowerNeck, S::kHead);
  return bodies;
}

}  // namespace

MannequinPanel::MannequinPanel(MannequinContext& context, FigureDrag& drag, QWidget* parent)
    : QWidget(parent), context_(context), drag_(drag) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addEmptyState(*column);
  content_ = new QWidget;
  column->addWidget(content_);
  column->addStretch(1);
  auto* inside = new QVBoxLayout(content_);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->setSpacing(0);
  addHolding(*inside);
  QVBoxLayout* size = addSection(*inside, tr("Size, ANSUR II"));
  size_ = new BodySize(context_);
  size->addWidget(size_);
  addHands(*inside);
  addReach(*inside);
  addPostures(*inside);
  drawings_ = addSection(*inside, tr("Shown in the scene"));
  QVBoxLayout* joints = addSection(*inside, tr("Joints, with their limits"));
  joints_ = new JointList(context_);
  joints->addWidget(joints_);
  connect(&context_, &MannequinContext::mannequinChanged, this, &MannequinPanel::showMannequin);
  connect(&context_, &MannequinContext::documentChanged, this, &MannequinPanel::showNow);
  connect(&context_.host().holdChoice(), &HoldChoice::changed, this, &MannequinPanel::showNow);
  connect(&drag_, &FigureDrag::moved, reach_, &ReachLines::show);
  connect(&drag_, &FigureDrag::ended, this, &MannequinPanel::showNow);
  showMannequin();
}

void MannequinPanel::addEmptyState(QVBoxLayout& column) {
  empty_ = new QWidget;
  auto* rows = new QVBoxLayout(empty_);
  rows->setContentsMargins(24, 48, 24, 24);
  rows->setSpacing(8);
  auto* picture = new QLabel;
  picture->setPixmap(icon("mannequin").pixmap(48, 48));
  picture->setAlignment(Qt::AlignCenter);
  rows->addWidget(picture);
  auto* title = makeLabel(tr("No mannequin in the cell"), TextRole::kPanelState);
  title->setAlignment(Qt::AlignCenter);
  rows->addWidget(title);
  auto* how = makeLabel(tr("Add a mannequin of any size with Ctrl+Shift+M. It stands on the floor, and its hands "
                           "follow the stylus or the mouse."),
                        TextRole::kText, true);
  how->setWordWrap(true);
  how->setAlignment(Qt::AlignCenter);
  rows->addWidget(how);
  auto* add = new QPushButton(tr("Add mannequin"));
  add->setObjectName("buttonAddMannequin");
  add->setProperty("main", true);
  connect(add, &QPushButton::clicked, this, &MannequinPanel::addWanted);
  rows->addSpacing(8);
  rows->addWidget(add, 0, Qt::AlignHCenter);
  column.addWidget(empty_);
}

void MannequinPanel::addHolding(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  name_ = makeLabel({}, TextRole::kPanelState);
  name_->setObjectName("labelMannequin");
  body_ = makeLabel({}, TextRole::kSecond, true);
  body_->setObjectName("labelBody");
  section->addWidget(name_);
  section->addWidget(body_);
  auto* line = new QHBoxLayout;
  line->setSpacing(12);
  sketch_ = new FigureSketch;
  line->addWidget(sketch_, 1);
  auto* choices = new QVBoxLayout;
  choices->setSpacing(4);
  choices->addWidget(makeLabel(tr("Held by the stylus"), TextRole::kSecond, true));
  const std::array<QString, 5> words{tr("Whole mannequin"), tr("Left hand"), tr("Right hand"), tr("Both hands"),
                                     tr("Head, gaze")};
  const std::array<const char*, 5> icons{"mannequin", "hand", "hand", "hands", "eye"};
  for (std::size_t i = 0; i < holds_.size(); ++i) {
    auto* button = holds_[i] = new QPushButton;
    button->setObjectName(QStringLiteral("hold%1").arg(i));
    button->setText(words[i]);
    button->setIcon(icon(QLatin1String(icons[i])));
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setMinimumHeight(26);
    connect(button, &QPushButton::clicked, this, [this, i] { hold(waysOfHolding()[i]); });
    choices->addWidget(button);
  }
  choices->addSpacing(4);
  choices->addWidget(makeLabel(tr("Locked"), TextRole::kSecond, true));
  const std::array<QString, 4> locks{tr("Trunk"), tr("Pelvis"), tr("Feet"), tr("On a seat")};
  for (std::size_t i = 0; i < locks_.size(); ++i) {
    auto* lock = locks_[i] = new QCheckBox(locks[i]);
    lock->setObjectName(QStringLiteral("lock%1").arg(i));
    lock->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);  // The space next to its text is not part of it.
    connect(lock, &QCheckBox::clicked, this, [this, i](bool on) { setLock(static_cast<int>(i), on); });
    choices->addWidget(lock);
  }
  locks_[2]->setToolTip(tr("Off: the mannequin can step so that the hand reaches"));
  locks_[3]->setToolTip(tr("The pelvis stays on the seat, which carries the body"));
  line->addLayout(choices);
  section->addLayout(line);
}

void MannequinPanel::addHands(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  grasp_ = new Segmented({tr("Power"), tr("Pinch"), tr("Flat"), tr("Point")});
  grasp_->setObjectName("segmentsGrasp");
  addRow(*section, tr("Grasp"), grasp_);
  curl_ = new QSlider(Qt::Horizontal);
  curl_->setObjectName("sliderCurl");
  curl_->setRange(0, 90);
  addRow(*section, tr("Finger curl"), curl_);
  two_hands_ = new Segmented({tr("Separate"), tr("Hold one part")});
  two_hands_->setObjectName("segmentsTwoHands");
  addRow(*section, tr("Two hands"), two_hands_);
  part_ = new CarriedPart(context_, *section, this);
  connect(grasp_, &Segmented::chosen, this, &MannequinPanel::setGrasp);
  connect(curl_, &QSlider::sliderMoved, this, &MannequinPanel::setCurl);
  connect(curl_, &QSlider::sliderPressed, this,
          [this] { context_.host().documentModel().beginStep(tr("Curl fingers")); });
  connect(curl_, &QSlider::sliderReleased, this, [this] { context_.host().documentModel().endStep(); });
  connect(two_hands_, &Segmented::chosen, this, [this](int i) {
    by::BothHands hands = context_.host().holdChoice().hands();
    hands.apart = i == 0;
    context_.host().holdChoice().setHands(hands);
  });
  connect(part_, &CarriedPart::carryWanted, this, &MannequinPanel::carry);
}

void MannequinPanel::addReach(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  reach_ = new ReachLines(context_, drag_, *section, this);
}

void MannequinPanel::addPostures(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  postures_ = new QPushButton(tr("Postures…"));
  postures_->setObjectName("buttonPostures");
  mirror_ = new QPushButton(tr("Mirror"));
  mirror_->setObjectName("buttonMirror");
  swap_ = new QPushButton(tr("Swap hands"));
  swap_->setObjectName("buttonSwapHands");
  auto* line = new QHBoxLayout;  // Each as wide as its words: three of the widest are wider than the dock.
  line->setSpacing(6);
  for (QPushButton* button : {postures_, mirror_, swap_}) line->addWidget(button, 1);
  section->addLayout(line);
  connect(postures_, &QPushButton::clicked, this, [this] { openPostureMenu(); });
  const auto change = [this](const QString& text, auto&& edit) {
    const workcell::Entity* entity = context_.entity();
    if (!entity || !context_.isFree()) return;
    context_.host().documentModel().executeAll(text, {postureCommand(*entity, edit(postureOf(*entity)))});
  };
  connect(mirror_, &QPushButton::clicked, this, [this, change] {
    change(tr("Mirror %1").arg(name_->text()), [](const mannequin::Posture& p) { return mannequin::mirror(p); });
  });
  connect(swap_, &QPushButton::clicked, this, [this, change] {
    change(tr("Swap hands of %1").arg(name_->text()),
           [](const mannequin::Posture& p) { return mannequin::swapHands(p); });
  });
}

void MannequinPanel::hold(const MovedBy& way) {
  context_.host().holdChoice().set(way);
  showHolding();
}

void MannequinPanel::setLock(int which, bool on) {
  by::BothHands hands = context_.host().holdChoice().hands();
  bool stand = !hands.may_step;
  bool* const flags[4]{&hands.locks.trunk, &hands.locks.pelvis, &stand, &hands.locks.seat};
  *flags[which] = on;
  hands.may_step = !stand;
  context_.host().holdChoice().setHands(hands);
}

std::vector<Side> MannequinPanel::chosenHands() const {
  const HoldChoice& choice = context_.host().holdChoice();
  if (choice.is<by::BothHands>()) return {Side::kLeft, Side::kRight};
  const auto* hand = std::get_if<by::Hand>(&choice.movedBy());
  return {hand ? hand->side : Side::kRight};
}

void MannequinPanel::setGrasp(int index) {
  static constexpr std::array<const char*, 4> kGrasps{"power", "pinch", "flat", "pointing"};
  const workcell::Entity* entity = context_.entity();
  if (!entity || !context_.isFree()) return;
  mannequin::Posture posture = postureOf(*entity);
  for (const Side side : chosenHands()) mannequin::setGrasp(posture, side, kGrasps[static_cast<std::size_t>(index)]);
  context_.host().documentModel().executeAll(tr("Grasp of %1").arg(name_->text()), {postureCommand(*entity, posture)});
}

void MannequinPanel::setCurl(int degrees) {
  const workcell::Entity* entity = context_.entity();
  if (!entity || !context_.isFree()) return;
  mannequin::Posture posture = postureOf(*entity);
  for (const Side side : chosenHands())
    posture[mannequin::armDof(side, mannequin::Dof::kLeftFingersCurl)] = degrees / 57.295779513082323;
  context_.host().documentModel().execute(postureCommand(*entity, posture));
}

void MannequinPanel::carry() {
  const workcell::Entity* entity = context_.entity();
  const workcell::Entity* part = context_.host().documentModel().document().find(part_->chosen());
  if (!entity || !part) return;
  DocumentModel& document = context_.host().documentModel();
  if (part->attachment.to == entity->name) {
    document.execute(workcell::Detach{part->id});
  } else {
    document.execute(workcell::Attach{part->id, entity->id, handLink(chosenHands().front())});
  }
  showHands();
}

void MannequinPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  showNow();
}

void MannequinPanel::showMannequin() {
  const workcell::Entity* entity = context_.entity();
  empty_->setVisible(!entity);
  content_->setVisible(entity != nullptr);
  if (!entity) return;
  name_->setText(QString::fromStdString(entity->name));
  body_->setText(bodyText(*entity->figure()));
  sketch_->setFigure(entity->figure());
  showNow();
}

void MannequinPanel::showNow() {
  if (!context_.entity() || !isVisible()) return;
  sketch_->setPosture(context_.posture());
  showHolding();
  showHands();
  reach_->show();
  size_->showNow();
  joints_->showNow();
  for (QPushButton* button : {postures_, mirror_, swap_}) button->setEnabled(context_.isFree());
}

void MannequinPanel::showHolding() {
  const HoldChoice& choice = context_.host().holdChoice();
  const workcell::Entity* entity = context_.entity();
  const MovedBy held = entity ? choice.movedByFor(*entity) : choice.movedBy();
  const auto ways = waysOfHolding();
  for (std::size_t i = 0; i < holds_.size(); ++i) holds_[i]->setChecked(isSameWay(held, ways[i]));
  const by::BothHands& hands = choice.hands();
  const std::array<bool, 4> on{hands.locks.trunk, hands.locks.pelvis, !hands.may_step, hands.locks.seat};
  for (std::size_t i = 0; i < locks_.size(); ++i) locks_[i]->setChecked(on[i]);
  two_hands_->setCurrent(hands.apart ? 0 : 1);
  sketch_->setHeld(bodiesOf(held));
}

void MannequinPanel::showHands() {
  const workcell::Entity* entity = context_.entity();
  if (!entity) return;
  part_->show();
  if (!curl_->isSliderDown()) {
    const double curl = context_.posture()[mannequin::armDof(chosenHands().front(), mannequin::Dof::kLeftFingersCurl)];
    curl_->setValue(static_cast<int>(std::lround(curl / kDegree)));
  }
}

}  // namespace hapticell::app
