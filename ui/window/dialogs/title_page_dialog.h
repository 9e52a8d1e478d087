// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/course/paper_writer.h"

#include <QDialog>

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

} // namespace sparkout
