// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/export_file.h"
#include "ui/report/study_book.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QPushButton;

namespace sparkout {

class Document;
struct Studies;

/// A batch, sweep or search that a view shows.
struct StudyOffer {
    Study study;
    QString obstacle = {}; ///< why it does not belong to the current inputs; may be empty
};

/// Asks for the contents and the format of an export, and shows what does not fit before a file is
/// chosen.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    ExportDialog(OutcomePtr outcome, ExportFormat format, QWidget* parent,
                 std::vector<StudyOffer> studies = {});

    [[nodiscard]] ExportChoice choice() const; ///< without parts: a study is chosen
    [[nodiscard]] const Study* study() const;  ///< null: parts of the result are chosen

private:
    void offerContents();
    void judge();
    [[nodiscard]] const StudyOffer* offered() const;
    [[nodiscard]] QString note(const ExportChoice& choice) const;
    [[nodiscard]] ExportFormat format() const;

    OutcomePtr m_outcome;
    std::vector<StudyOffer> m_studies; ///< after the last entries of m_content
    QComboBox* m_format;
    QComboBox* m_content;
    std::vector<std::vector<ResultPart>> m_contents; ///< by entry of m_content
    QLabel* m_note;
    QPushButton* m_go = nullptr;
};

/// The computed batch, sweep and search, marked if they are running, or do not belong to `now`.
[[nodiscard]] std::vector<StudyOffer> studiesOffered(Studies& studies, const Project& now,
                                                     const Document& document);

} // namespace sparkout
