// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "mannequin/ergonomics/report/report.h"

class QLineEdit;
class QPushButton;

namespace hapticell::app {

class Host;

/// The heading of a report: a company's name and logo, chosen once and kept in the user's settings. GUI thread.
class ReportHead : public QWidget {
  Q_OBJECT
 public:
  explicit ReportHead(Host& host, QWidget* parent = nullptr);
  std::string company() const;
  /// Empty if no logo is chosen.
  const ergonomics::ReportPicture& logo() const { return logo_; }
  /// Takes a picture file (PNG, JPEG, SVG) as the logo; the settings keep a copy of it. If it cannot be read, reports
  /// that in a message, keeps the old logo and returns false.
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
