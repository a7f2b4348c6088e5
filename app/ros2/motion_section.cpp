// SPDX-License-Identifier: Apache-2.0
#include "app/ros2/motion_section.h"

#include <QComboBox>
#include <QJsonArray>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/ros2/ros2_network.h"
#include "app/style/library_text.h"
#include "app/style/live_label.h"
#include "app/style/plain_lines.h"
#include "app/style/value_field.h"
#include "geometry/system/packed_text.h"

namespace hapticell::app {

namespace {

QString oneDecimal(double value) {
  return QLocale().toString(value, 'f', 1);
}

}  // namespace

MotionSection::MotionSection(Host& host, const Ros2Network& network, QWidget* parent)
    : QWidget(parent), host_(host), network_(network) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout& section = *addSection(*column, tr("Send a motion to a real robot"));
  motion_ = new QComboBox;
  motion_->setObjectName("choiceRos2Motion");
  addRow(section, tr("Motion"), motion_);
  action_ = new QLineEdit;
  action_->setObjectName("fieldRos2Action");
  action_->setPlaceholderText("/arm_controller/follow_joint_trajectory");
  action_->setToolTip(tr("Action FollowJointTrajectory of the robot's controller, as 'ros2 action list' shows it"));
  addRow(section, tr("Action"), action_);
  speed_ = new ValueField({.unit = "mm/s", .decimals = 0, .minimum = 1.0, .maximum = 1000.0, .step = 10.0});
  speed_->setObjectName("fieldRos2Speed");
  speed_->setValue(250.0);
  speed_->setToolTip(tr("Greatest speed of the tool. A faster motion is slowed as a whole. Default: 250 mm/s"));
  addRow(section, tr("Tool speed"), speed_);
  send_ = makeButton("buttonRos2Send", tr("Check and send…"), tr("Check the motion in the cell, then ask before the robot moves"));
  stop_ = makeButton("buttonRos2Stop", tr("Stop the robot"));
  section.addWidget(sideBySide({send_, stop_}));
  line_ = makeLive(4, TextRole::kSecond, true);
  line_->setObjectName("labelRos2Motion");
  section.addWidget(line_);
  connect(send_, &QPushButton::clicked, this, &MotionSection::check);
  connect(stop_, &QPushButton::clicked, this, [this] { process_.stop(); });
  connect(action_, &QLineEdit::textChanged, this, &MotionSection::show);
  connect(&process_, &Ros2Process::said, this, &MotionSection::take);
  connect(&process_, &Ros2Process::ended, this, &MotionSection::finish);
  connect(&host_.documentModel(), &DocumentModel::changed, this, &MotionSection::show);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    process_.stop();
    says_.clear();
  });
  show();
}

void MotionSection::check() {
  const workcell::Document& document = host_.documentModel().document();
  const auto cell = copy_.write(document);
  const auto motion = copy_.writeMotion(document, motion_->currentText());
  if (!cell || !motion) {
    says_ = shownText(cell ? motion.error() : cell.error());
    return show();
  }
  const workcell::TrajectoryReference* const kept = document.state().findTrajectory(motion_->currentText().toStdString());
  job_ = network_.job("send");
  job_["workcell"] = *cell;
  job_["motion"] = *motion;
  if (kept && kept->motion) job_["entity"] = QString::fromStdString(kept->motion->entity);
  const QString action = action_->text().trimmed();
  job_["action"] = action.startsWith('/') ? action : '/' + action;
  job_["tool_speed"] = 1e-3 * speed_->value();
  job_["progress"] = true;
  says_ = tr("Checking the motion…");
  process_.start(job_);
  show();
}

void MotionSection::ask(const QJsonObject& preview) {
  auto* box = new QMessageBox(QMessageBox::Warning, tr("Move the robot"), {}, QMessageBox::Cancel, this);
  box->setObjectName("boxRos2Confirm");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setText(tr("The real robot '%1' will move for %2 s, its tool at up to %3 mm/s, and its fastest joint at up to %4 % of "
                  "its limit.")
                   .arg(preview.value("robot").toString(), oneDecimal(preview.value("duration").toDouble()))
                   .arg(qRound(1e3 * preview.value("tool_speed").toDouble()))
                   .arg(qRound(100.0 * preview.value("joint_share").toDouble())));
  QStringList notes{tr("Action: %1").arg(preview.value("action").toString())};
  if (preview.value("slowed").toDouble() > 1.0)
    notes << tr("The motion is slowed %1 times.").arg(oneDecimal(preview.value("slowed").toDouble()));
  for (const auto& pair : preview.value("touching_at_start").toArray())
    notes << tr("Not checked, because they touch at the start: %1").arg(pair.toString());
  notes << tr("Keep people out of its reach and the emergency stop at hand.");
  box->setInformativeText(notes.join('\n'));
  QPushButton* const move = box->addButton(tr("Move the robot"), QMessageBox::AcceptRole);
  move->setObjectName("buttonRos2Move");
  box->setDefaultButton(QMessageBox::Cancel);
  const QString confirmation = preview.value("confirmation").toString();
  connect(box, &QMessageBox::finished, this, [this, box, move, confirmation] {
    says_ = tr("Not sent.");
    if (box->clickedButton() == move) {
      job_["confirmation"] = confirmation;
      says_ = tr("Looking for the controller and the robot…");
      process_.start(job_);
    }
    show();
  });
  box->open();
}

void MotionSection::take(const QJsonObject& line) {
  if (!line.contains("t")) return;
  says_ = tr("The robot moves: %1 s").arg(oneDecimal(line.value("t").toDouble()));
  show();
}

void MotionSection::finish(const QJsonObject& result, const QString& sentence) {
  const QString outcome = result.value("outcome").toString();
  if (result.isEmpty()) {
    says_ = sentence;
  } else if (!result.value("sent").toBool()) {
    says_ = tr("Checked: no contact, within the limits.");
    ask(result);
  } else if (outcome == "succeeded") {
    says_ = tr("The robot finished the motion.");
  } else if (outcome == "rejected") {
    says_ = tr("The controller refused the motion.");
  } else {
    const auto reason = unpackedText(result.value("reason_text").toString().toStdString());
    const QString why = outcome == "canceled" && reason ? shownText(*reason) : plainLines(result.value("error").toString());
    says_ = tr("The robot stopped before the end of the motion: %1").arg(why);
  }
  show();
}

void MotionSection::show() {
  QStringList motions, shown;
  for (const auto& kept : host_.documentModel().document().state().trajectories) motions << QString::fromStdString(kept.name);
  for (int i = 0; i < motion_->count(); ++i) shown << motion_->itemText(i);
  const bool is_on = process_.isRunning();
  if (motions != shown && !is_on) {
    const QString chosen = motion_->currentText();
    motion_->clear();
    motion_->addItems(motions);
    motion_->setCurrentIndex(std::max(0, static_cast<int>(motions.indexOf(chosen))));
  }
  send_->setEnabled(!is_on && !motions.isEmpty() && !action_->text().trimmed().isEmpty());
  stop_->setEnabled(is_on && job_.contains("confirmation"));
  if (!says_.isEmpty()) return line_->setText(says_);
  line_->setText(motions.isEmpty() ? tr("The cell has no kept motion. Record one, or import it.")
                                   : tr("Off. No robot is moved."));
}

}  // namespace hapticell::app
