// SPDX-License-Identifier: Apache-2.0
// Number fields: units, ends, the wheel, the click, and what is painted.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QToolTip>

#include "app/settings/configuration_fields.h"
#include "app/style/units.h"
#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

/// Counts the paints of what it watches.
class PaintCount : public QObject {
 public:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++paints;
    return false;
  }
  int paints = 0;
};

TEST(ValueFields, AClickChoosesTheWholeNumberAndTheNextPlacesTheCursor) {
  QWidget window;
  ValueField field({"mm", 1, -100.0, 100.0, 1.0});
  QLineEdit other;
  QHBoxLayout row(&window);
  row.addWidget(&other);
  row.addWidget(&field);
  field.setValue(12.5);
  window.show();
  window.activateWindow();
  other.setFocus();
  ASSERT_TRUE(CellPage::until([&] { return other.hasFocus(); }, 20000));
  auto* edit = field.findChild<QLineEdit*>();
  QTest::mouseClick(window.windowHandle(), Qt::LeftButton, {}, edit->mapTo(&window, edit->rect().center()));
  CellPage::settle();
  EXPECT_TRUE(field.hasFocus());
  EXPECT_EQ(edit->selectedText(), edit->text());
  QTest::mouseClick(window.windowHandle(), Qt::LeftButton, {}, edit->mapTo(&window, edit->rect().center()));
  CellPage::settle();
  EXPECT_TRUE(edit->selectedText().isEmpty());
}

TEST(ValueField, SpeedsAreShownInTheUnitOfLength) {
  ValueField field({QStringLiteral("mm/s"), 0, 1.0, 5000.0, 10.0});
  field.setValue(254.0);
  EXPECT_EQ(field.text(), "254");
  Units inches;
  inches.length = Units::Length::kInch;
  setUnitsNow(inches);
  field.unitsChanged();
  EXPECT_EQ(field.text(), "10");
  field.show();
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, "900");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_NEAR(field.value(), 5000.0, 1e-6);
  EXPECT_TRUE(QTest::qWaitFor([] { return QToolTip::text() == "At most 197 in/s. You typed 900 in/s."; }, 2000))
      << QToolTip::text().toStdString();
  setUnitsNow({});
}

TEST(ValueField, ANumberBeyondAnEndBecomesThatEndAndSaysSo) {
  for (const auto& [typed, end, said] : {std::tuple{"200", 170.0, "At most 170.0°. You typed 200.0°."},
                                         std::tuple{"-200", -170.0, "At least -170.0°. You typed -200.0°."},
                                         std::tuple{"4 rad", 170.0, "At most 170.0°. You typed 229.2°."}}) {
    ValueField field({QStringLiteral("°"), 1, -170.0, 170.0});
    field.setValue(10.0);
    field.show();
    std::vector<double> edited;
    QObject::connect(&field, &ValueField::edited, [&](double value) { edited.push_back(value); });
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, typed);
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_EQ(edited, std::vector<double>{end}) << typed;
    EXPECT_TRUE(QTest::qWaitFor([said = said] { return QToolTip::text() == QString::fromUtf8(said); }, 2000))
        << QToolTip::text().toStdString();
  }
}

TEST(ValueField, TheNumberThatItShowsAlreadyIsNotPaintedAnew) {
  CellPage page;
  ValueField field({QStringLiteral("mm")});
  field.show();
  field.setValue(990.0);
  CellPage::settle();
  PaintCount count;
  field.installEventFilter(&count);
  field.setValue(990.0 + 3e-8);  // As a pose that was worked out anew has it.
  CellPage::settle();
  EXPECT_EQ(count.paints, 0);
  field.setValue(991.0);
  ASSERT_TRUE(CellPage::until([&] { return count.paints > 0; }, 30000));
  EXPECT_EQ(field.text(), "991.0");
}

TEST(ValueFields, GiveTheirUnitAwayBeforeANumberIsCut) {
  ValueField field({"mm", 1, -1e6, 1e6, 1.0});
  field.resize(64, 26);
  field.show();
  for (const double value : {1.0, 1512.0, -123456.7}) {
    field.setValue(value);
    const QLineEdit* line = field.findChild<QLineEdit*>();
    const int room = line->width() - line->textMargins().right();
    EXPECT_LE(line->fontMetrics().horizontalAdvance(line->text()), room) << value;
  }
}

TEST(Wheel, GivesNoFieldTheFocus) {
  CellPage page;
  int fields = 0;
  for (const QWidget* widget : page.window().findChildren<QWidget*>()) {
    const bool is_field = qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
                          qobject_cast<const QAbstractSlider*>(widget);
    if (!is_field || !widget->testAttribute(Qt::WA_WState_Polished)) continue;
    ++fields;
    EXPECT_NE(widget->focusPolicy(), Qt::WheelFocus) << widget->objectName().toStdString();
  }
  EXPECT_GT(fields, 5);
}

}  // namespace
}  // namespace hapticell::app
