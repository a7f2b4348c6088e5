// SPDX-License-Identifier: Apache-2.0
#include "app/robot/cartesian_jog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/controls/pose_text.h"
#include "app/controls/reference_choice.h"
#include "app/kit/form.h"
#include "app/robot/robot_context.h"
#include "app/style/library_text.h"
#include "app/style/segmented.h"
#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

constexpr const char* kAxes[6]{"X", "Y", "Z", "A", "B", "C"};

/// A turns about z, B about y, C about x, as the angles of a pose do.
constexpr int kTurnAxis[3]{2, 1, 0};

constexpr int kGivenFrame = 3;  // Of the choices.

}  // namespace

CartesianJog::CartesianJog(RobotContext& context, JointMover& mover, QWidget* parent)
    : QWidget(parent), context_(context), mover_(mover) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  frame_ = new Segmented({tr("Base"), tr("Tool"), tr("World"), tr("Frame")});
  frame_->setObjectName("segmentsJogFrame");
  app::addRow(*static_cast<QVBoxLayout*>(layout()), tr("Axes"), frame_);
  frame_->setCurrent(0);
  given_ = new ReferenceChoice(context_.host(), {});
  given_->setObjectName("comboJogFrame");
  given_row_ = app::addRow(*static_cast<QVBoxLayout*>(layout()), tr("Frame"), given_);
  column->addSpacing(2);
  for (int axis = 0; axis < 6; ++axis) addRow(axis);
  const auto chosen = [this] {
    showFrames();
    showNow();
    emit frameChosen();
  };
  connect(frame_, &Segmented::chosen, this, chosen);
  connect(given_, &ReferenceChoice::referenceChanged, this, chosen);
  connect(given_, &ReferenceChoice::framesListed, this, chosen);
  showFrames();
}

/// The row is there as long as the cell has frames, so that nothing moves when one is chosen.
void CartesianJog::showFrames() {
  const bool any = given_->hasFrames();
  if (!any && frame_->current() == kGivenFrame) frame_->setCurrent(0);
  frame_->setChoiceEnabled(kGivenFrame, any, tr("No frame in this cell yet. Add one with Insert > Frame."));
  given_row_->setVisible(any);
  given_->setEnabled(frame_->current() == kGivenFrame);
}

void CartesianJog::addRow(int axis) {
  const QString name = QString::fromLatin1(kAxes[axis]);
  const bool turns = axis >= 3;
  const auto i = static_cast<std::size_t>(axis);
  auto* holder = new QWidget;
  auto* line = new QHBoxLayout(holder);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(4);
  auto* label = makeLabel(name, TextRole::kText);
  label->setFixedWidth(24);
  line->addWidget(label);
  const QString meaning = turns ? tr("about %1").arg(QChar('X' + kTurnAxis[axis - 3])) : tr("along %1").arg(name);
  line->addWidget(makeLabel(meaning, TextRole::kText, true), 1);
  fields_[i] = new ValueField({turns ? QStringLiteral("°") : QStringLiteral("mm"), 1, -1e6, 1e6, 1.0});
  fields_[i]->setObjectName(QStringLiteral("jogPose%1").arg(name));
  fields_[i]->setAccessibleName(name);
  fields_[i]->setFixedWidth(100);
  line->addWidget(fields_[i]);
  connect(fields_[i], &ValueField::edited, this, [this, axis](double value) { typed(axis, value); });
  for (const bool up : {false, true}) {
    auto* button = new HoldButton(
        up ? "plus" : "minus", up ? tr("Increase %1 by one step").arg(name) : tr("Decrease %1 by one step").arg(name));
    button->setObjectName(QStringLiteral("jog%1%2").arg(name, up ? QStringLiteral("More") : QStringLiteral("Less")));
    const auto text = [this, name] {
      const workcell::Entity* robot = context_.robot();
      return tr("Jog %1 of the TCP of %2").arg(name, robot ? QString::fromStdString(robot->name) : QString());
    };
    connectJog(button, mover_, text, [this, axis, up] {
      const double step = axis < 3 ? step_.millimetres : step_.degrees;
      jog(axis, up ? step : -step);
    });
    buttons_[i][up ? 1 : 0] = button;
    line->addWidget(button);
  }
  layout()->addWidget(holder);
}

kinematics::JogFrame CartesianJog::frame() const {
  constexpr kinematics::JogFrame kFrames[]{kinematics::JogFrame::kBase, kinematics::JogFrame::kTool,
                                           kinematics::JogFrame::kWorld, kinematics::JogFrame::kGiven};
  return kFrames[std::max(0, frame_->current())];
}

Pose CartesianJog::frame_W() const {
  switch (frame()) {
    case kinematics::JogFrame::kTool:
      return context_.tool_W();
    case kinematics::JogFrame::kBase:
      return context_.base_W();
    case kinematics::JogFrame::kGiven:
      return given_->frame_W().value_or(Pose::identity());
    case kinematics::JogFrame::kWorld:
      break;
  }
  return Pose::identity();
}

void CartesianJog::jog(int axis, double amount) {
  const workcell::Entity* robot = context_.robot();
  const kinematics::InverseModel* inverse = context_.inverse();
  if (!robot || !inverse) return;
  kinematics::JogStep step;
  step.frame = frame();
  step.R_WF = frame_W().q;
  if (axis < 3)
    step.along[axis] = amount * 0.001;
  else
    step.turn[kTurnAxis[axis - 3]] = amount * kDegree;
  const kinematics::JogRobot jogged{*robot->robot(), *inverse, robot->robot()->findLink(robot->jointed().tip_link),
                                    robot->jointed().X_LT, robot->X_WE};
  const kinematics::JogResult result = kinematics::jogTool(jogged, mover_.target(), step);
  mover_.moveTo(result.q);
  emit held(shownText(result.reason));
}

std::array<double, 6> CartesianJog::numbersNow() const {
  if (frame() == kinematics::JogFrame::kTool) return {};
  return poseNumbers(frame_W().inverse() * context_.tool_W());
}

void CartesianJog::typed(int axis, double value) {
  const workcell::Entity* robot = context_.robot();
  const kinematics::InverseModel* inverse = context_.inverse();
  if (!robot || !inverse) return;
  std::array<double, 6> numbers = numbersNow();
  numbers[static_cast<std::size_t>(axis)] = value;
  const Pose X_FT = poseFromNumbers(numbers);
  const auto solution = inverse->solve(context_.base_W().inverse() * frame_W() * X_FT, robot->joints());
  if (solution.status == kinematics::InverseStatus::kSolved) {
    mover_.step(tr("Move the TCP of %1").arg(QString::fromStdString(robot->name)), solution.q);
    emit held({});
  } else {
    emit held(solution.status == kinematics::InverseStatus::kLimit ? tr("A joint limit prevents this pose")
                                                                   : tr("This pose is out of reach"));
  }
  showNow();
}

void CartesianJog::showNow() {
  const bool free = context_.isFree() && context_.inverse();
  const auto numbers = numbersNow();
  for (std::size_t i = 0; i < 6; ++i) {
    fields_[i]->setEnabled(free);
    for (HoldButton* button : buttons_[i]) button->setEnabled(free);
    if (!fields_[i]->hasFocus()) fields_[i]->setValue(numbers[i]);
  }
}

}  // namespace hapticell::app
