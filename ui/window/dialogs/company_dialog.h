// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/paper_writer.h"
#include "ui/session/settings.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace sparkout {

class Settings;

/// Edits the data of title pages of laboratory reports: ministry, university, department, teacher,
/// town. Kept in the settings for all works.
class TitlePageDialog : public QDialog {
    Q_OBJECT

public:
    TitlePageDialog(Settings& settings, QWidget* parent);

    void accept() override; ///< saves it

private:
    Settings& m_settings;
    report::Institution m_page;
};

/// Edits the company data in the heads of documents: company, logo, names, numbers. Kept in the
/// settings for all projects.
class CompanyDialog : public QDialog {
    Q_OBJECT

public:
    CompanyDialog(Settings& settings, QWidget* parent);

    void accept() override; ///< saves it
    /// Reads the picture of a file, or shows why it cannot be used.
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
