// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/line_editor.h"

#include "ui/fields/number_field.h"
#include "ui/text/texts.h"

namespace sparkout {

LineEditor::LineEditor(const std::string& path, const Field& field, FormModel& model,
                       QWidget* parent)
    : FieldEditor(path, field, model), m_line(new CellsLineEdit(parent)) {
    m_line->installEventFilter(this);
    m_line->setTakesCells([this](const PastedCells& cells) { takeCells(cells); });
    connect(&model, &FormModel::saved, this, &LineEditor::forgetPaste);
    connect(m_line, &QLineEdit::textEdited, this, &LineEditor::take);
    connect(m_line, &QLineEdit::editingFinished, this, [this] {
        this->model().endMerge();
        emit remarkChanged();
    });
}

QWidget* LineEditor::widget() const {
    return m_line;
}

void LineEditor::take() {
    forgetPaste();
    refuse(accept(m_line->text()));
}

void LineEditor::takeCells(const PastedCells& cells) {
    const CellsText meant = textOf(cells);
    model().endMerge();
    m_notPasted = meant.fault.isEmpty() ? accept(meant.text) : meant.fault;
    model().endMerge();
    if (m_notPasted.isEmpty()) {
        m_line->setText(meant.text);
        refuse({});
    } else {
        emit remarkChanged();
    }
}

void LineEditor::forgetPaste() {
    if (!m_notPasted.isEmpty()) {
        m_notPasted.clear();
        emit remarkChanged();
    }
}

void LineEditor::refuse(const QString& reason) {
    m_kept = storedText();
    m_refused = reason;
    emit remarkChanged();
}

void LineEditor::show(bool replaced) {
    forgetPaste();
    if (!m_refused.isEmpty() && !replaced && storedText() == m_kept) {
        return; // the refused text stays in sight
    }
    refuse({});
    if (replaced || !isStored(m_line->text())) { // otherwise as typed
        m_line->setText(storedText());
    }
}

void LineEditor::retranslate() {
    forgetPaste();
    m_line->setPlaceholderText(inputText(field().nullMeaning));
    if (m_refused.isEmpty()) {
        m_line->setText(storedText());
    } else {
        take();
    }
}

Remark LineEditor::remark() const {
    if (!m_notPasted.isEmpty()) {
        return {Mark::error, m_notPasted};
    }
    const bool typing = m_line->hasFocus();
    return m_refused.isEmpty() || typing ? FieldEditor::remark() : Remark{Mark::error, m_refused};
}

} // namespace sparkout
