// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/rows_editor.h"

#include "ui/session/document.h"
#include "ui/session/number_text.h"
#include "ui/session/texts.h"

#include <QLineEdit>
#include <QLocale>

namespace sparkout {

RowsEditor::RowsEditor(const std::string& path, const Field& field, Document& document,
                       QWidget* parent)
    : FieldEditor(path, field, document), m_line(new QLineEdit(parent)) {
    m_line->installEventFilter(this);
    connect(m_line, &QLineEdit::textEdited, this, &RowsEditor::take);
    connect(m_line, &QLineEdit::editingFinished, this, [this] {
        this->document().endMerge();
        emit remarkChanged();
    });
}

QWidget* RowsEditor::widget() const {
    return m_line;
}

const NumberRows& RowsEditor::stored() const {
    return field().as<NumberRows>(owner());
}

QString RowsEditor::text(const NumberRows& rows) const {
    QStringList lines;
    for (std::size_t i = 0; rows && i < rows->size(); ++i) {
        QStringList numbers;
        for (const double value : (*rows)[i]) {
            numbers += showNumber(value, QLocale());
        }
        lines += numbers.join(u' ');
    }
    return lines.join(QStringLiteral("; "));
}

std::optional<NumberRows> RowsEditor::rowsOf(const QString& text) const {
    if (text.trimmed().isEmpty()) {
        return NumberRows();
    }
    std::vector<std::vector<double>> rows;
    for (const QString& line : text.split(u';', Qt::SkipEmptyParts)) {
        std::vector<double> row;
        for (const QString& number : line.simplified().split(u' ', Qt::SkipEmptyParts)) {
            const std::optional<double> value = parseNumber(number);
            if (!value) {
                return std::nullopt;
            }
            row.push_back(*value);
        }
        if (row.size() != field().count) {
            return std::nullopt;
        }
        rows.push_back(std::move(row));
    }
    return NumberRows(std::move(rows));
}

void RowsEditor::take() {
    const std::optional<NumberRows> rows = rowsOf(m_line->text());
    const auto set = [this, &rows](void* to) { field().as<NumberRows>(to) = *rows; };
    if (!rows) {
        refuse(tr("rows of %n number(s), a semicolon between them, as in 0 50; 200 80", nullptr,
                  static_cast<int>(field().count)));
    } else if (!fits(set)) {
        refuse(tr("the forces must rise from row to row, the stiffnesses lie above 0"));
    } else {
        refuse({});
        change(set);
    }
}

void RowsEditor::refuse(const QString& reason) {
    m_kept = stored();
    m_refused = reason;
    emit remarkChanged();
}

void RowsEditor::show(bool replaced) {
    if (!m_refused.isEmpty() && !replaced && stored() == m_kept) {
        return; // the refused text stays in sight
    }
    refuse({});
    const std::optional<NumberRows> shown = rowsOf(m_line->text());
    if (replaced || !shown || *shown != stored()) { // else as it was typed
        m_line->setText(text(stored()));
    }
}

void RowsEditor::retranslate() {
    m_line->setPlaceholderText(inputText(field().nullMeaning));
    if (m_refused.isEmpty()) {
        m_line->setText(text(stored()));
    } else {
        take();
    }
}

Remark RowsEditor::remark() const {
    return m_refused.isEmpty() || m_line->hasFocus() ? FieldEditor::remark()
                                                     : Remark{Mark::error, m_refused};
}

} // namespace sparkout
