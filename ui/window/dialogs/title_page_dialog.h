// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <vector>

class QLineEdit;

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
    std::vector<QLineEdit*> m_edits; ///< in the order of report::institutionFields()
};

} // namespace sparkout
