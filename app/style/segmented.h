// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

class QAbstractButton;
class QButtonGroup;

namespace hapticell::app {

/// A few choices side by side in one frame: one of them, or any number. The arrow keys move within it; Tab enters and
/// leaves it.
class Segmented : public QWidget {
  Q_OBJECT
 public:
  enum class Kind { kOne, kMany };  ///< kMany: each is switched separately; chosen() says which one was.
  explicit Segmented(const QStringList& choices, QWidget* parent = nullptr, Kind kind = Kind::kOne);

  int current() const;                       ///< Index, or -1 while nothing is chosen.
  void setCurrent(int index);                ///< Does not emit chosen(). Out of range: nothing is chosen.
  void setChoiceEnabled(int index, bool on, const QString& why = {});
  QAbstractButton* button(int index) const;  ///< Null when out of range.
  QSize sizeHint() const override;

 signals:
  void chosen(int index);                    ///< The user chose another one.

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QButtonGroup* group_;
};

}  // namespace hapticell::app
