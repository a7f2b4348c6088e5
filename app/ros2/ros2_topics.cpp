// SPDX-License-Identifier: Apache-2.0
#include "app/ros2/ros2_topics.h"

#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "app/kit/form.h"
#include "app/ros2/ros2_network.h"
#include "app/style/live_label.h"
#include "app/style/plain_lines.h"

namespace hapticell::app {

namespace {

/// "sensor_msgs::msg::dds_::JointState_" is sensor_msgs/JointState for people.
QString shownType(QString type) {
  if (type.endsWith('_')) type.chop(1);
  return type.replace("::msg::dds_::", "/").replace("::action::dds_::", "/").replace("::srv::dds_::", "/");
}

/// "/tf", and below it "tf2_msgs/TFMessage, 1 → 2".
QString linesOf(const QJsonArray& topics) {
  QStringList lines;
  for (const auto& value : topics) {
    const QJsonObject topic = value.toObject();
    lines << QStringLiteral("%1\n    %2, %3 → %4")
                 .arg(plainLines(topic.value("name").toString()), plainLines(shownType(topic.value("type").toString())))
                 .arg(topic.value("publishers").toInt())
                 .arg(topic.value("subscribers").toInt());
  }
  return lines.join('\n');
}

}  // namespace

Ros2Topics::Ros2Topics(const Ros2Network& network, QWidget* parent) : QWidget(parent), network_(network) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout& section = *addSection(*column, tr("Topics of other programs (publishers → subscribers)"));
  list_ = new QPlainTextEdit;
  list_->setObjectName("textRos2Topics");
  list_->setReadOnly(true);
  list_->setFixedHeight(110);
  list_->setTabChangesFocus(true);
  list_->setAccessibleName(tr("Topics of other programs"));
  section.addWidget(list_);
  find_ = makeButton("buttonRos2Topics", tr("Find topics"), tr("Look for programs of ROS 2 in the network for three seconds"));
  section.addWidget(find_);
  line_ = makeLive(2, TextRole::kSecond, true);
  line_->setObjectName("labelRos2Topics");
  section.addWidget(line_);
  connect(find_, &QPushButton::clicked, this, &Ros2Topics::find);
  connect(&process_, &Ros2Process::said, this, [this](const QJsonObject& line) { take(line.value("topics").toArray()); });
  connect(&process_, &Ros2Process::ended, this, [this](const QJsonObject&, const QString& sentence) {
    problem_ = sentence;
    show();
  });
  show();
}

void Ros2Topics::find() {
  problem_.clear();
  asked_ = true;
  topics_ = {};
  list_->clear();
  QJsonObject job = network_.job("topics");
  job["progress"] = true;
  process_.start(job);
  show();
}

void Ros2Topics::take(const QJsonArray& topics) {
  if (topics == topics_) return;
  topics_ = topics;
  list_->setPlainText(linesOf(topics_));
  show();
  emit changed();
}

QStringList Ros2Topics::publishedOf(const QString& type) const {
  QStringList names;
  for (const auto& value : topics_) {
    const QJsonObject topic = value.toObject();
    if (topic.value("type").toString() == type && topic.value("publishers").toInt() > 0)
      names << plainLines(topic.value("name").toString());
  }
  return names;
}

void Ros2Topics::show() {
  find_->setEnabled(!process_.isRunning());
  if (process_.isRunning()) return line_->setText(tr("Looking for programs of ROS 2…"));
  if (!problem_.isEmpty()) return line_->setText(problem_);
  if (!topics_.isEmpty()) return line_->setText(tr("Topics: %1").arg(topics_.size()));
  line_->setText(asked_ ? tr("No topics were found. Check the domain and the network.")
                        : tr("Press 'Find topics' to see what other programs publish."));
}

TopicChoice::TopicChoice(const char* name, const Ros2Topics& topics, QString type, const QString& usual, QWidget* parent)
    : QComboBox(parent), topics_(topics), type_(std::move(type)), usual_(usual) {
  setObjectName(name);
  setEditable(true);
  setInsertPolicy(QComboBox::NoInsert);
  setMinimumContentsLength(12);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  addItem(usual_);
  connect(&topics_, &Ros2Topics::changed, this, &TopicChoice::offer);
}

QString TopicChoice::topic() const {
  const QString typed = currentText().trimmed();
  if (typed.isEmpty()) return usual_;
  return typed.startsWith('/') ? typed : '/' + typed;
}

/// The found ones; what is typed stays.
void TopicChoice::offer() {
  const QString typed = currentText();
  const QSignalBlocker quiet(this);
  QStringList names = topics_.publishedOf(type_);
  if (!names.contains(usual_)) names.prepend(usual_);
  clear();
  addItems(names);
  setCurrentIndex(static_cast<int>(names.indexOf(typed)));
  setEditText(typed);
}

}  // namespace hapticell::app
