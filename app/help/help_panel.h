// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>

class QLineEdit;
class QTextBrowser;
class QTreeWidget;
class QTreeWidgetItem;

namespace hapticell::app {

/// The manual: contents, a search in all pages, and the page, with *Back* and *Forward*. GUI thread.
class HelpPanel : public QWidget {
  Q_OBJECT
 public:
  /// Markdown that is added to a page each time it is shown ("keys"); empty for most.
  using Addition = std::function<QString(const QString& page)>;
  HelpPanel(const QString& language, Addition addition, QWidget* parent = nullptr);
  /// Shows a page by its name; an unknown name shows the scene's page.
  void showPage(const QString& name);
  /// The name of the shown page.
  QString page() const;
  /// Fills the page again and keeps the reading position.
  void refresh();

 private:
  QWidget* makeBar();
  void makeContents();
  void search();
  void openFirst();
  void shown(const QString& name);
  void markWords();
  QTreeWidgetItem* rowOf(const QString& name) const;
  QString language_;
  Addition addition_;
  QLineEdit* typed_;
  QTreeWidget* contents_;
  QTextBrowser* browser_;
};

}  // namespace hapticell::app
