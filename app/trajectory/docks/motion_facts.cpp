// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/motion_facts.h"

#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/kit/form.h"
#include "app/style/theme.h"
#include "app/trajectory/motions/motion_list.h"

namespace hapticell::app {
namespace {

QLabel* motionLine(const char* name, int lines) {
  auto* label = makeLive(lines, TextRole::kSecond, true);
  label->setObjectName(name);
  return label;
}

}  // namespace

MotionFacts::MotionFacts(MotionList& list, QVBoxLayout& section, QObject* parent) : QObject(parent), list_(list) {
  name_ = new QLineEdit;
  name_->setObjectName("editMotionName");
  addRow(section, tr("Name"), name_);
  facts_ = motionLine("labelMotionFacts", 2);
  section.addWidget(facts_);
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    const Motion* motion = list_.current();
    if (motion && !name_->text().trimmed().isEmpty()) list_.rename(motion->name, name_->text());
    show();
  });
}

void MotionFacts::addResult(QVBoxLayout& section) {
  line_ = motionLine("labelMotionResult", 3);
  section.addWidget(line_);
  busy_ = makeLabel({}, TextRole::kSecond, true);
  busy_->setObjectName("labelMotionBusy");
  progress_ = new QProgressBar;
  progress_->setTextVisible(false);
  progress_->setFixedHeight(6);
  cancel_ = new QPushButton(tr("Cancel"));
  cancel_->setObjectName("buttonCancelMotionWork");
  for (QWidget* widget :
       {static_cast<QWidget*>(busy_), static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_)}) {
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
    section.addWidget(widget);
  }
  connect(cancel_, &QPushButton::clicked, this, [this] { list_.work().cancel(); });
  connect(&list_.work(), &BackgroundWork::progressed, this, &MotionFacts::showProgress);
  showProgress();
}

void MotionFacts::show() {
  const Motion* motion = list_.current();
  name_->setEnabled(motion != nullptr);
  if (!name_->hasFocus()) name_->setText(motion ? QString::fromStdString(motion->name) : QString());
  if (!motion) {
    facts_->setText(tr("No motion yet. Record one, or import a file."));
  } else if (!motion->trajectory) {
    facts_->setText(motion->problem.isEmpty() ? tr("loading…") : motion->problem);
  } else {
    const auto& trajectory = *motion->trajectory;
    QStringList words{tr("frames: %1").arg(trajectory.size()), tr("%1 s").arg(trajectory.duration(), 0, 'f', 2)};
    if (!trajectory.entity.empty()) words << tr("of %1").arg(QString::fromStdString(trajectory.entity));
    if (!trajectory.moved.empty()) words << tr("by %1").arg(QString::fromStdString(trajectory.moved));
    if (trajectory.hasJoints()) words << tr("joints: %1").arg(trajectory.joint_names.size());
    if (!trajectory.touches.empty()) words << tr("contacts felt: %1").arg(trajectory.touches.size());
    facts_->setText(words.join(QStringLiteral(" · ")) +
                    (motion->problem.isEmpty() ? QString() : QStringLiteral("\n") + motion->problem));
  }
}

void MotionFacts::showLine(const QString& line, bool careful) {
  line_->setText(line);
  line_->setForegroundRole(careful ? QPalette::WindowText : kQuietText);
  line_->setPalette({});
}

void MotionFacts::markMissed() {
  QPalette red = line_->palette();
  red.setColor(QPalette::WindowText, themeOf(line_->palette()).contact);
  line_->setPalette(red);
}

void MotionFacts::showProgress() {
  BackgroundWork& work = list_.work();
  const bool busy = work.isBusy();
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, cancel_, busy_}) widget->setVisible(busy);
  if (!busy) return;
  const auto progress = work.progress();
  busy_->setText(QStringLiteral("%1 · %2 %").arg(work.name()).arg(std::lround(100.0 * progress.share)));
  progress_->setValue(static_cast<int>(100.0 * progress.share));
}

}  // namespace hapticell::app
