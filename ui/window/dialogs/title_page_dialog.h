// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/course/institution.h"

#include <QDialog>

namespace sparkout {

class Settings;

/// Fills in what the title pages of laboratory reports have beside the work: ministry, university,
/// department, who accepts it, the town. Kept in the settings once for all works.
class TitlePageDialog : public QDialog {
    Q_OBJECT

public:
    TitlePageDialog(Settings& settings, QWidget* parent);

    void accept() override; ///< keeps it

private:
    Settings& m_settings;
    report::Institution m_page;
};

} // namespace sparkout
