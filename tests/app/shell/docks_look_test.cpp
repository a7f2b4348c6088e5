// SPDX-License-Identifier: Apache-2.0
// Every dock on the smallest screen that is supported (1366 x 768): nothing is cut off, nothing lies over another.
//
// HAPTICELL_LOOK_FOLDER=folder saves a picture of each dock, HAPTICELL_LOOK_THEME=light and
// HAPTICELL_LOOK_SIZE=1920x1080 choose how; HAPTICELL_LOOK_LANGUAGE=fr is French.
#include <QCheckBox>
#include <QComboBox>
#include <QFontInfo>
#include <QHeaderView>
#include <QLayout>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QStyleOption>
#include <QToolButton>

#include "app/controls/joint_row.h"
#include "app/host/language.h"
#include "app/style/fonts.h"
#include "app/style/live_label.h"
#include "app/style/proxy_style.h"
#include "app/style/theme.h"
#include "geometry/shapes/shapes.h"
#include "tests/app/pages/mannequin_page.h"

namespace hapticell::app {
namespace {

QString placeOf(const QWidget& widget) {
  QString place = widget.objectName();
  if (place.isEmpty() || place.startsWith("qt_")) place = QString::fromLatin1(widget.metaObject()->className());
  if (const QWidget* parent = widget.parentWidget(); parent && !qobject_cast<const QDockWidget*>(&widget))
    if (!parent->objectName().isEmpty() && !parent->objectName().startsWith("qt_"))
      place = parent->objectName() + '/' + place;
  return place;
}

/// A row by what stands in it.
QString wordsOf(const QWidget& row) {
  QStringList words{placeOf(row)};
  for (const QLabel* label : row.findChildren<QLabel*>()) words << label->text();
  for (const QAbstractButton* button : row.findChildren<QAbstractButton*>()) words << button->text();
  return words.join(' ').left(120);
}

/// What a demanding eye finds in a dock, as sentences.
class Look {
 public:
  explicit Look(const QWidget& dock) : dock_(dock) {}
  QStringList findings() {
    for (const QWidget* widget : dock_.findChildren<QWidget*>()) {
      if (!widget->isVisibleTo(&dock_) || widget->width() <= 1) continue;
      if (const auto* label = qobject_cast<const QLabel*>(widget)) look(*label);
      if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) look(*button);
      if (const auto* combo = qobject_cast<const QComboBox*>(widget)) look(*combo);
      if (const auto* header = qobject_cast<const QHeaderView*>(widget)) look(*header);
      if (widget->layout()) lookForOverlap(*widget);
      if (const auto* scroll = qobject_cast<const QScrollArea*>(widget)) lookForCut(*scroll);
    }
    return findings_;
  }

 private:
  void tell(const QWidget& widget, const QString& what) {
    findings_ << QStringLiteral("%1, %2: %3").arg(dock_.objectName(), placeOf(widget), what);
  }
  void need(const QWidget& widget, const QString& text, int room) {
    const int wide = widget.fontMetrics().horizontalAdvance(text);
    if (wide > room + 1) tell(widget, QStringLiteral("\"%1\" needs %2 px of %3").arg(text).arg(wide).arg(room));
  }
  void look(const QLabel& label) {
    if (const auto* live = dynamic_cast<const LiveLabel*>(&label)) {
      if (!live->isWhole()) tell(label, QStringLiteral("\"%1\" needs more lines").arg(live->text()));
      return;
    }
    if (label.wordWrap() || Qt::mightBeRichText(label.text()) || label.text().isEmpty()) return;
    const QString brief = label.property("short").toString();
    for (const QString& line : (brief.isEmpty() ? label.text() : brief).split('\n'))
      need(label, line, label.contentsRect().width());
  }
  /// What the switch takes of the room.
  static int markOf(const QAbstractButton& box) {
    QStyleOptionButton option;
    option.initFrom(&box);
    return box.style()->subElementRect(QStyle::SE_CheckBoxContents, &option, &box).left();
  }
  /// The headings of a table.
  void look(const QHeaderView& header) {
    if (header.orientation() != Qt::Horizontal || !header.model()) return;
    for (int i = 0; i < header.count(); ++i) {
      const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
      if (text.isEmpty() || header.isSectionHidden(i)) continue;
      constexpr int kHeaderEdges = 8;
      need(header, text, header.sectionSize(i) - kHeaderEdges);
    }
  }
  void look(const QAbstractButton& button) {
    QString text = button.text();
    text.remove('&');
    if (text.isEmpty()) return;
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    if (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly) return;
    const bool beside = !button.icon().isNull() && !(tool && tool->toolButtonStyle() == Qt::ToolButtonTextUnderIcon);
    int mark = beside ? button.iconSize().width() + 4 : 0;
    if (qobject_cast<const QCheckBox*>(&button)) mark = markOf(button);
    need(button, text, button.width() - mark);
  }
  void look(const QComboBox& combo) {
    if (combo.isEditable() || combo.currentIndex() < 0) return;
    need(combo, combo.currentText(), combo.width() - 26);
  }
  /// A panel that cannot be scrolled sideways and has no room.
  void lookForCut(const QScrollArea& scroll) {
    if (!scroll.widget() || scroll.horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) return;
    const int room = scroll.viewport()->width(), needed = scroll.widget()->width();
    if (needed <= room) return;
    // The innermost row that cannot be narrower.
    const QWidget* widest = nullptr;
    int furthest = room - 60;
    for (const QWidget* row : scroll.widget()->findChildren<QWidget*>()) {
      if (!row->isVisibleTo(&dock_) || !row->layout()) continue;
      const int least = row->layout()->totalMinimumSize().width();
      if (least > furthest || (widest && widest->isAncestorOf(row) && least == furthest))
        widest = row, furthest = least;
    }
    tell(scroll, QStringLiteral("needs %1 px of %2, by %3").arg(needed).arg(room).arg(widest ? wordsOf(*widest) : "?"));
  }
  void lookForOverlap(const QWidget& holder) {
    QList<const QWidget*> laid;
    for (const QWidget* child : holder.findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
      if (child->isVisibleTo(&dock_) && holder.layout()->indexOf(const_cast<QWidget*>(child)) >= 0) laid << child;
    for (int i = 0; i < laid.size(); ++i)
      for (int k = i + 1; k < laid.size(); ++k) {
        const QRect both = laid[i]->geometry() & laid[k]->geometry();
        if (both.width() > 1 && both.height() > 1) tell(*laid[i], "lies over " + placeOf(*laid[k]));
      }
  }
  const QWidget& dock_;
  QStringList findings_;
};

QSize sizeWanted() {
  const QStringList sides = qEnvironmentVariable("HAPTICELL_LOOK_SIZE", "1366x768").split('x');
  return sides.size() == 2 ? QSize(sides[0].toInt(), sides[1].toInt()) : QSize(1366, 768);
}

class LookPage : public MannequinPage {
 public:
  LookPage() {
    window().setTheme(qEnvironmentVariable("HAPTICELL_LOOK_THEME") != "light");
    window().resize(sizeWanted());
    workcell::Entity bench;
    bench.name = "Bench";
    bench.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(geometry::makeBox({0.8, 0.6, 0.05}))};
    bench.X_WE.p = {0.6, 0.0, 0.9};
    add(bench);
    EXPECT_TRUE(addMannequin());
    addRobot("hc6");
    window().viewport().fitAll(false);
    // Texts and places are what is looked at: without pictures the window need not be drawn hundreds of times.
    if (!qEnvironmentVariableIsSet("HAPTICELL_LOOK_FOLDER")) window().setUpdatesEnabled(false);
    trigger("actionMeasure");
    trigger("actionManual");
    trigger("actionSettings");
  }
  void bring(QDockWidget& dock) {
    dock.show();
    dock.raise();
    settle();
  }
  void save(QDockWidget& dock) {
    const QString folder = qEnvironmentVariable("HAPTICELL_LOOK_FOLDER");
    if (!folder.isEmpty()) window().grab().save(folder + '/' + dock.objectName() + ".png");
  }
};

TEST(Docks, ShowAllOfTheirWordsAndLieBesideEachOther) {
  const QString language = qEnvironmentVariable("HAPTICELL_LOOK_LANGUAGE");
  if (!language.isEmpty() && !installLanguage(language)) GTEST_SKIP() << "built without Qt's Linguist tools";
  if (!QFontInfo(textFont(TextRole::kText)).family().startsWith("Roboto"))
    GTEST_SKIP() << "without the font Roboto widths are others";
  LookPage page;
  EXPECT_LE(page.window().width(), sizeWanted().width()) << "the window does not fit the screen";
  QStringList findings;
  for (const workcell::EntityId chosen :
       {page.document().document().findByName("Bench")->id, page.document().document().findByName("Operator")->id,
        page.window().selection().current()}) {
    page.window().selection().set(chosen);
    page.settle();
    for (QDockWidget* dock : page.window().findChildren<QDockWidget*>()) {
      page.bring(*dock);
      page.save(*dock);
      findings << Look(*dock).findings();
      if (dock->objectName() == "dockSettings") {
        auto* pages = dock->findChild<QListWidget*>("listSettings");
        for (int row = 1; row < pages->count(); ++row) {
          pages->setCurrentRow(row);
          page.settle();
          for (const QString& one : Look(*dock).findings()) findings << pages->item(row)->text() + ": " + one;
        }
        pages->setCurrentRow(0);
        dock->hide();
      }
      if (qEnvironmentVariableIsSet("HAPTICELL_LOOK_FOLDER"))
        std::printf("%s: at least %d px\n", qPrintable(dock->objectName()), dock->widget()->minimumSizeHint().width());
    }
  }
  findings.removeDuplicates();
  EXPECT_TRUE(findings.isEmpty()) << findings.join('\n').toStdString();
}

TEST(ChoiceList, IsAsWideAsTheWordsInItAndNoNarrowerThanItsField) {
  QComboBox box;
  box.addItems({"a", "Some words that the field has no room for"});
  QStyleOptionComboBox option;
  for (const int width : {60, 900}) {
    option.rect = QRect(0, 0, width, 26);
    const QRect list = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxListBoxPopup, &box);
    EXPECT_GE(list.width(), box.fontMetrics().horizontalAdvance(box.itemText(1)));
    EXPECT_GE(list.width(), width);
  }
}

TEST(ScrollBar, HandleIsNoLongerThanABarWithoutRoom) {
  const ProxyStyle style;
  QStyleOptionSlider bar;
  bar.rect = QRect(0, 0, 10, 20);
  bar.orientation = Qt::Vertical;
  bar.maximum = 400;
  bar.pageStep = 20;
  for (const int position : {0, 150, 400}) {
    bar.sliderPosition = position;
    const QRect handle = style.subControlRect(QStyle::CC_ScrollBar, &bar, QStyle::SC_ScrollBarSlider, nullptr);
    EXPECT_TRUE(bar.rect.contains(handle)) << handle.top() << " to " << handle.bottom();
  }
}

}  // namespace
}  // namespace hapticell::app
