// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/export_file.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QPushButton;

namespace sparkout {

/// Asks what of a result is exported and as what; what would not fit is said here, before a place
/// is chosen.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    ExportDialog(OutcomePtr outcome, ExportFormat format, QWidget* parent);

    [[nodiscard]] ExportChoice choice() const;

private:
    void offerContents();
    void judge();
    [[nodiscard]] QString note(const ExportChoice& choice) const;
    [[nodiscard]] ExportFormat format() const;

    OutcomePtr m_outcome;
    QComboBox* m_format;
    QComboBox* m_content;
    std::vector<std::vector<ResultPart>> m_contents; ///< behind the entries of m_content
    QLabel* m_note;
    QPushButton* m_go = nullptr;
};

} // namespace sparkout
