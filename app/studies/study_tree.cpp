// SPDX-License-Identifier: Apache-2.0
#include "app/studies/study_tree.h"

#include <QHeaderView>

#include "app/studies/study_fields.h"

namespace hapticell::app {

using studies::StudyPlace;
using studies::StudyValue;

namespace {

constexpr const char* kTables[] = {"vary", "ask", "require", "objective"};

QString groupName(int group) {
  switch (group) {
    case 0:
      return StudyTree::tr("What varies");
    case 1:
      return StudyTree::tr("What is asked");
    case 2:
      return StudyTree::tr("Requirements");
    default:
      return StudyTree::tr("Objectives");
  }
}

QString number(const StudyDraft& draft, const StudyPlace& place, const char* key) {
  return QString::fromStdString(draft.text().written(place, key));
}

QString rangeWords(const StudyDraft& draft, const StudyPlace& place) {
  const auto says = [&](const char* key) { return !draft.text().written(place, key).empty(); };
  if (says("library")) return StudyTree::tr("all library robots");
  if (says("values")) {
    const StudyValue value = draft.text().value(place, "values");
    if (const auto* numbers = std::get_if<std::vector<double>>(&value))
      return StudyTree::tr("%n value(s)", nullptr, static_cast<int>(numbers->size()));
    if (const auto* words = std::get_if<std::vector<std::string>>(&value))
      return StudyTree::tr("%n value(s)", nullptr, static_cast<int>(words->size()));
  }
  if (says("sigma")) return StudyTree::tr("normal, sigma %1").arg(number(draft, place, "sigma"));
  if (!says("from")) return {};
  return StudyTree::tr("%1 to %2").arg(number(draft, place, "from"), number(draft, place, "to"));
}

}  // namespace

StudyTree::StudyTree(StudyDraft& draft, QWidget* parent) : QTreeWidget(parent), draft_(draft) {
  setObjectName("treeStudy");
  setAccessibleName(tr("Content of the study"));
  setHeaderHidden(true);
  setColumnCount(1);
  setRootIsDecorated(false);
  setIndentation(14);
  setTextElideMode(Qt::ElideRight);
  connect(&draft_, &StudyDraft::changed, this, &StudyTree::refresh);
  connect(this, &QTreeWidget::itemSelectionChanged, this, &StudyTree::placeChosen);
  refresh();
}

QString StudyTree::summary(const StudyDraft& draft, const StudyPlace& place) {
  const auto word = [&](const char* key) { return QString::fromStdString(draft.text().word(place, key)); };
  if (place.table == "require") {
    QString text = word("value");
    if (const QString least = number(draft, place, "at_least"); !least.isEmpty()) text += QStringLiteral(" ≥ ") + least;
    if (const QString most = number(draft, place, "at_most"); !most.isEmpty()) text += QStringLiteral(" ≤ ") + most;
    return text;
  }
  if (place.table == "objective")
    return word("goal") == QLatin1String("greatest") ? tr("large %1").arg(word("value")) : tr("small %1").arg(word("value"));
  const StudyKind* kind = studyKind(place.table, draft.text().word(place, "what"));
  QString text = QString::fromStdString(draft.nameOf(place)) + QStringLiteral(": ") +
                 (kind != nullptr ? studyFieldLabel(kind->label) : word("what"));
  if (!word("entity").isEmpty()) text += QStringLiteral(", ") + word("entity");
  if (!word("axis").isEmpty()) text += QStringLiteral(", ") + word("axis");
  if (place.table == "vary") {
    if (const QString range = rangeWords(draft, place); !range.isEmpty()) text += QStringLiteral(", ") + range;
  }
  return text;
}

void StudyTree::refresh() {
  const auto before = chosen();
  const QSignalBlocker quiet(this);
  clear();
  for (int group = 0; group < 4; ++group) {
    auto* head = new QTreeWidgetItem(this, {groupName(group)});
    head->setFlags(Qt::ItemIsEnabled);
    QFont font = head->font(0);
    font.setWeight(QFont::DemiBold);
    head->setFont(0, font);
    for (std::size_t i = 0; i < draft_.text().count(kTables[group]); ++i) {
      const QString text = summary(draft_, {kTables[group], i});
      auto* item = new QTreeWidgetItem(head, {text});
      item->setToolTip(0, text);
    }
    head->setExpanded(true);
  }
  if (before) choose(*before);
}

std::optional<StudyPlace> StudyTree::chosen() const {
  const QList<QTreeWidgetItem*> items = selectedItems();
  if (items.isEmpty() || items.front()->parent() == nullptr) return std::nullopt;
  QTreeWidgetItem* head = items.front()->parent();
  return StudyPlace{kTables[indexOfTopLevelItem(head)], static_cast<std::size_t>(head->indexOfChild(items.front()))};
}

void StudyTree::choose(const StudyPlace& place) {
  for (int group = 0; group < topLevelItemCount(); ++group) {
    if (place.table != kTables[group]) continue;
    QTreeWidgetItem* item = topLevelItem(group)->child(static_cast<int>(place.index));
    if (item != nullptr) setCurrentItem(item);
  }
}

}  // namespace hapticell::app
