// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/line_editor.h"

#include "ui/session/document.h"
#include "ui/text/texts.h"

#include <QLineEdit>

namespace sparkout {

LineEditor::LineEditor(const std::string& path, const Field& field, Document& document,
                       QWidget* parent)
    : FieldEditor(path, field, document), m_line(new QLineEdit(parent)) {
    m_line->installEventFilter(this);
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

void LineEditor::refuse(const QString& reason) {
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
    return m_refused.isEmpty() || m_line->hasFocus() ? FieldEditor::remark()
                                                     : Remark{Mark::error, m_refused};
}

} // namespace sparkout
