// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/line_editor.h"

#include "ui/fields/cells_line_edit.h"
#include "ui/session/document.h"
#include "ui/text/texts.h"

namespace sparkout {

LineEditor::LineEditor(const std::string& path, const Field& field, Document& document,
                       QWidget* parent)
    : FieldEditor(path, field, document), m_line(new CellsLineEdit(parent)) {
    m_line->installEventFilter(this);
    m_line->setTakesCells([this](const PastedCells& cells) { takeCells(cells); });
    connect(m_line, &QLineEdit::textEdited, this, &LineEditor::take);
    connect(m_line, &QLineEdit::editingFinished, this, [this] {
        this->document().endMerge();
        emit remarkChanged();
    });
}

QWidget* LineEditor::widget() const {
    return m_line;
}

void LineEditor::take() {
    refuse(accept(m_line->text()));
}

void LineEditor::takeCells(const PastedCells& cells) {
    const CellsText meant = textOf(cells);
    document().endMerge();
    const QString reason = meant.fault.isEmpty() ? accept(meant.text) : meant.fault;
    document().endMerge();
    if (reason.isEmpty()) {
        m_line->setText(meant.text);
    }
    refuse(reason, Shown::atOnce);
}

void LineEditor::refuse(const QString& reason, Shown shown) {
    m_shown = shown;
    m_kept = storedText();
    m_refused = reason;
    emit remarkChanged();
}

void LineEditor::show(bool replaced) {
    if (!m_refused.isEmpty() && !replaced && storedText() == m_kept) {
        return; // the refused text stays in sight
    }
    refuse({});
    if (replaced || !isStored(m_line->text())) { // else as it was typed
        m_line->setText(storedText());
    }
}

void LineEditor::retranslate() {
    m_line->setPlaceholderText(inputText(field().nullMeaning));
    if (m_refused.isEmpty()) {
        m_line->setText(storedText());
    } else {
        take();
    }
}

Remark LineEditor::remark() const {
    const bool typing = m_shown == Shown::onLeaving && m_line->hasFocus();
    return m_refused.isEmpty() || typing ? FieldEditor::remark() : Remark{Mark::error, m_refused};
}

} // namespace sparkout
