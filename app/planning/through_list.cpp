// SPDX-License-Identifier: Apache-2.0
#include "app/planning/through_list.h"

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/kit/form.h"
#include "app/style/icon.h"

namespace hapticell::app {

namespace {

/// Rows that are seen at once. Half: most lists are scrolled; twice: the dock is long while nothing is in it.
constexpr int kRowsShown = 3;

QPushButton* namedButton(const QString& words, const char* name) {
  auto* button = new QPushButton(words);
  button->setObjectName(QString::fromLatin1(name));
  return button;
}

}  // namespace

ThroughList::ThroughList(Host& host, QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  choice_ = new ReferenceChoice(host, {});
  choice_->setObjectName("choicePlanThrough");
  addRow(*column, tr("Through"), choice_);
  list_ = new QListWidget;
  list_->setObjectName("listPlanThrough");
  list_->setAccessibleName(tr("Frames that the path passes, in this order"));
  list_->setFixedHeight(kRowsShown * (list_->fontMetrics().height() + 8) + 2 * list_->frameWidth());
  empty_ = makeLabel({}, TextRole::kSecond);
  empty_->setObjectName("labelPlanThroughEmpty");
  empty_->setWordWrap(true);
  empty_->setAlignment(Qt::AlignCenter);
  auto* over = new QVBoxLayout(list_);
  over->setContentsMargins(6, 0, 6, 0);
  over->addWidget(empty_);
  column->addWidget(list_);
  add_ = namedButton(tr("Add"), "buttonPlanThroughAdd");
  remove_ = namedButton(tr("Remove"), "buttonPlanThroughRemove");
  up_ = namedButton(tr("Up"), "buttonPlanThroughUp");
  down_ = namedButton(tr("Down"), "buttonPlanThroughDown");
  column->addWidget(sideBySide({add_, remove_}));
  column->addWidget(sideBySide({up_, down_}));
  connect(add_, &QPushButton::clicked, this, &ThroughList::add);
  connect(remove_, &QPushButton::clicked, this, &ThroughList::remove);
  connect(up_, &QPushButton::clicked, this, [this] { move(-1); });
  connect(down_, &QPushButton::clicked, this, [this] { move(1); });
  connect(list_, &QListWidget::currentRowChanged, this, &ThroughList::refresh);
  connect(choice_, &ReferenceChoice::framesListed, this, &ThroughList::refresh);
  refresh();
}

Expected<std::vector<Pose>> ThroughList::poses() const {
  std::vector<Pose> poses;
  for (const Reference& frame : frames_) {
    const auto X_WF = choice_->frame_W(frame);
    if (!X_WF)
      return makeError({.place = "through",
                        .found = Text("the frame '%1' no longer exists", frame.name.toStdString()),
                        .expected = "frames of the cell; remove it from the list"});
    poses.push_back(*X_WF);
  }
  return poses;
}

void ThroughList::clear() {
  frames_.clear();
  list_->clear();
  refresh();
}

void ThroughList::add() {
  const auto frame = choice_->chosen();
  if (!frame) return;
  frames_.push_back(*frame);
  list_->addItem(new QListWidgetItem(icon("frame"), frame->name));
  list_->setCurrentRow(list_->count() - 1);
  refresh();
}

void ThroughList::remove() {
  const int row = list_->currentRow();
  if (row < 0) return;
  frames_.erase(frames_.begin() + row);
  delete list_->takeItem(row);
  refresh();
}

void ThroughList::move(int by) {
  const int row = list_->currentRow(), to = row + by;
  if (row < 0 || to < 0 || to >= list_->count()) return;
  std::swap(frames_[static_cast<std::size_t>(row)], frames_[static_cast<std::size_t>(to)]);
  list_->insertItem(to, list_->takeItem(row));
  list_->setCurrentRow(to);
  refresh();
}

void ThroughList::refresh() {
  const int row = list_->currentRow();
  empty_->setVisible(list_->count() == 0);
  empty_->setText(choice_->hasFrames() ? tr("No frame: the path goes to its goal by any way.")
                                       : tr("The cell has no frames that the path could pass."));
  add_->setEnabled(choice_->hasFrames());
  remove_->setEnabled(row >= 0);
  up_->setEnabled(row > 0);
  down_->setEnabled(row >= 0 && row + 1 < list_->count());
}

}  // namespace hapticell::app
