// SPDX-License-Identifier: Apache-2.0
#include "app/ros2/description_section.h"

#include <QFileInfo>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/ros2/ros2_network.h"
#include "app/ros2/ros2_topics.h"
#include "app/style/live_label.h"

namespace hapticell::app {

namespace {

// s for the description, which its publisher keeps for who comes late. Half: a busy network is taken for none; twice: the
// user waits for a topic that nobody publishes.
constexpr double kDescriptionPatience = 5.0;

}  // namespace

DescriptionSection::DescriptionSection(Host& host, const Ros2Network& network, const Ros2Topics& topics, QWidget* parent)
    : QWidget(parent), host_(host), network_(network) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout& section = *addSection(*column, tr("Import a robot"));
  topic_ = new TopicChoice("choiceRos2Description", topics, "std_msgs::msg::dds_::String_", "/robot_description");
  topic_->setToolTip(tr("Topic on which another program publishes the robot as URDF. Default: /robot_description"));
  addRow(section, tr("Description"), topic_);
  import_ = makeButton("buttonRos2Import", tr("Import…"),
                       tr("Save the description as a URDF file, and add the robot to the cell"));
  section.addWidget(import_);
  line_ = makeLive(3, TextRole::kSecond, true);
  line_->setObjectName("labelRos2Import");
  section.addWidget(line_);
  connect(import_, &QPushButton::clicked, this, &DescriptionSection::ask);
  connect(&process_, &Ros2Process::ended, this, &DescriptionSection::finish);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    process_.stop();
    path_.clear();  // What comes is for a cell that is gone.
    says_.clear();
  });
  show();
}

void DescriptionSection::ask() {
  const std::filesystem::path& cell = host_.documentModel().document().path();
  const QString name = "robot.urdf";
  const QString start = cell.empty() ? name : QString::fromStdString((cell.parent_path() / name.toStdString()).string());
  const QString path = askToSave(this, tr("Save the robot's description"), start, tr("Robots (*.urdf)"));
  if (!path.isEmpty()) importTo(path);
}

void DescriptionSection::importTo(const QString& path) {
  if (process_.isRunning()) return;
  path_ = path;
  says_ = tr("Waiting for %1…").arg(topic_->topic());
  QJsonObject job = network_.job("listen");
  job["description"] = path;
  job["description_topic"] = topic_->topic();
  job["seconds"] = kDescriptionPatience;
  process_.start(job);
  show();
}

void DescriptionSection::finish(const QJsonObject& result, const QString& sentence) {
  if (result.isEmpty()) {
    says_ = path_.isEmpty() ? QString() : sentence;
  } else if (!path_.isEmpty()) {
    says_ = tr("%1 is being imported. The messages show what was noticed.").arg(QFileInfo(path_).fileName());
    emit received(path_);
  }
  path_.clear();
  show();
}

void DescriptionSection::show() {
  import_->setEnabled(!process_.isRunning());
  line_->setText(says_.isEmpty() ? tr("The meshes are read from the places that the description names.") : says_);
}

}  // namespace hapticell::app
