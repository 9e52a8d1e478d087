// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/field_editor.h"

#include <QObject>

class QGridLayout;
class QLabel;

namespace sparkout {

/// "Diameter d" as rich text: the symbol in italics, with its index below the line.
[[nodiscard]] QString labelMarkup(const Field& field);
/// Meaning, limits and source of a field, for its tooltip.
[[nodiscard]] QString hintMarkup(const Field& field);

/// One row of a form: label with symbol, field, unit, and below them the reason of a mark.
class FormRow : public QObject {
    Q_OBJECT

public:
    FormRow(std::unique_ptr<FieldEditor> editor, QGridLayout& grid, QWidget* parent);

    [[nodiscard]] FieldEditor& editor() const { return *m_editor; }
    void show(const Project& project, bool replaced);
    void setIssues(const Issues& issues);
    void retranslate();

private:
    void addTo(QGridLayout& grid);
    void showRemark();
    [[nodiscard]] bool meaningIsLong() const; ///< of an empty field, for the field itself
    [[nodiscard]] QString emptyCaption() const;

    std::unique_ptr<FieldEditor> m_editor;
    QLabel* m_label;
    QLabel* m_unit;
    QLabel* m_reason;
    bool m_relevant = true;
};

} // namespace sparkout
