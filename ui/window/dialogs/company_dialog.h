// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/company.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace sparkout {

class Settings;

/// Fills in what the heads of documents have beside the project: company, logo, names, numbers.
/// Kept in the settings once for all projects.
class CompanyDialog : public QDialog {
    Q_OBJECT

public:
    CompanyDialog(Settings& settings, QWidget* parent);

    void accept() override; ///< keeps it
    /// Takes the picture of a file, or says why it cannot.
    void takeLogo(const QString& path);

private:
    void chooseLogo();
    void showLogo(const QString& fault);

    Settings& m_settings;
    Company m_company;
    QLabel* m_logo;
    QLabel* m_fault;
    QPushButton* m_remove;
};

} // namespace sparkout
