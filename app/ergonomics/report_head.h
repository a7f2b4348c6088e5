// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "mannequin/ergonomics/report/report.h"

class QLineEdit;
class QPushButton;

namespace hapticell::app {

class Host;

/// Whose report it is: a company's name and logo, chosen once and kept with the user's settings. GUI thread.
class ReportHead : public QWidget {
  Q_OBJECT
 public:
  explicit ReportHead(Host& host, QWidget* parent = nullptr);
  std::string company() const;
  /// Empty: none is chosen.
  const ergonomics::ReportPicture& logo() const { return logo_; }
  /// Takes a picture's file (PNG, JPEG, SVG) as the logo; the settings keep a copy of it. One that cannot be read is
  /// said in a message, and the logo stays as it was: false.
  bool takeLogo(const QString& file);
  void dropLogo();

 signals:
  void changed();

 private:
  void showLogo();
  Host& host_;
  QLineEdit* name_;
  QPushButton* choose_;
  ergonomics::ReportPicture logo_;
};

}  // namespace hapticell::app
