// SPDX-License-Identifier: Apache-2.0
#include "app/panels/cell/history_panel.h"

#include <QPainter>
#include <QStyledItemDelegate>

#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

class StepDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {200, kFieldHeight}; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Theme& theme = themeOf(option.palette);
    const bool current = index.data(HistoryModel::kCurrentRole).toBool();
    const bool undone = index.data(HistoryModel::kUndoneRole).toBool();
    const QRect r = option.rect;
    painter->save();
    if (current) {
      painter->fillRect(r, theme.selected_row);
      painter->fillRect(QRect(r.left(), r.top(), 2, r.height()), theme.selection);
    } else if (option.state.testFlag(QStyle::State_MouseOver)) {
      painter->fillRect(r, theme.header);
    }
    const char* const done = index.row() == 0 ? "open" : "check";
    icon(undone ? "redo" : done, undone ? theme.text3 : theme.text2)
        .paint(painter, QRect(r.left() + 12, r.center().y() - 7, 16, 16));
    painter->setFont(textFont(TextRole::kText));
    painter->setPen(undone ? theme.text3 : theme.text1);
    painter->drawText(r.adjusted(38, 0, -12, 0), Qt::AlignVCenter, index.data().toString());
    painter->setPen(theme.text3);
    painter->setFont(textFont(TextRole::kSecond));
    if (current || undone)
      painter->drawText(r.adjusted(38, 0, -16, 0), Qt::AlignVCenter | Qt::AlignRight,
                        current ? tr("now") : tr("undone"));
    painter->restore();
  }
};

}  // namespace

HistoryModel::HistoryModel(DocumentModel& document, QObject* parent) : QAbstractListModel(parent), document_(document) {
  read();
  connect(&document_, &DocumentModel::changed, this, &HistoryModel::read);
}

void HistoryModel::read() {
  beginResetModel();
  texts_ = {tr("Start")};
  for (const auto& text : document_.document().undoTexts()) texts_ << QString::fromStdString(text);
  current_ = static_cast<int>(texts_.size()) - 1;
  for (const auto& text : document_.document().redoTexts()) texts_ << QString::fromStdString(text);
  endResetModel();
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(texts_.size());
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= texts_.size()) return {};
  switch (role) {
    case Qt::DisplayRole:
      return texts_[index.row()];
    case kUndoneRole:
      return index.row() > current_;
    case kCurrentRole:
      return index.row() == current_;
    case Qt::AccessibleTextRole:
      return index.row() > current_ ? tr("%1, undone").arg(texts_[index.row()]) : texts_[index.row()];
    default:
      return {};
  }
}

HistoryPanel::HistoryPanel(DocumentModel& document, QWidget* parent) : QListView(parent), model_(document) {
  setObjectName("listHistory");
  setAccessibleName(tr("History"));
  setFrameShape(QFrame::NoFrame);
  setMouseTracking(true);
  setUniformItemSizes(true);
  setItemDelegate(new StepDelegate(this));
  setModel(&model_);
  viewport()->setBackgroundRole(QPalette::Window);
  const auto go = [&document](const QModelIndex& index) { document.goTo(index.row()); };
  // Queued: going there resets the model that is just telling of the click.
  connect(this, &QListView::clicked, this, go, Qt::QueuedConnection);
  connect(this, &QListView::activated, this, go, Qt::QueuedConnection);
  connect(&model_, &QAbstractItemModel::modelReset, this, [this] { scrollTo(model_.index(model_.current(), 0)); });
}

}  // namespace hapticell::app
