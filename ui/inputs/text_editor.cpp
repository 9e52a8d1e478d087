// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/text_editor.h"

#include "core/project/project_file.h"
#include "ui/session/document.h"

#include <QKeyEvent>
#include <QSignalBlocker>

namespace sparkout {

namespace {

constexpr int longestLine = 20'000; // in UTF-8 still below what a file may hold

/// Whether an event is undo or redo, which belong to the document and not to one field.
bool takesHistoryKey(QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) {
        return false;
    }
    const auto* key = static_cast<QKeyEvent*>(event);
    return key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo);
}

} // namespace

TextEditor::TextEditor(const std::string& path, const Field& field, Document& document,
                       QWidget* parent)
    : FieldEditor(path, field, document), m_line(new QLineEdit(parent)) {
    m_line->setMaxLength(longestLine);
    m_line->installEventFilter(this);
    connect(m_line, &QLineEdit::textEdited, this, [this](const QString& text) {
        change([this, &text](void* to) { this->field().as<std::string>(to) = text.toStdString(); });
    });
    connect(m_line, &QLineEdit::editingFinished, this, [this] { this->document().endMerge(); });
}

void TextEditor::show(bool) {
    const QString text = QString::fromStdString(field().as<std::string>(owner()));
    if (m_line->text() != text) {
        m_line->setText(text);
        m_line->setCursorPosition(0);
    }
}

bool TextEditor::eventFilter(QObject* watched, QEvent* event) {
    if (takesHistoryKey(event)) {
        event->ignore();
        return true;
    }
    return FieldEditor::eventFilter(watched, event);
}

NotesEditor::NotesEditor(const std::string& path, const Field& field, Document& document,
                         QWidget* parent)
    : FieldEditor(path, field, document), m_text(new QPlainTextEdit(parent)) {
    m_text->setTabChangesFocus(true);
    m_text->setFixedHeight(m_text->fontMetrics().lineSpacing() * 5 + 10);
    m_text->installEventFilter(this);
    connect(m_text, &QPlainTextEdit::textChanged, this, [this] {
        const std::string text = m_text->toPlainText().toStdString();
        if (text.size() <= limits::stringBytes) {
            change([this, &text](void* to) { this->field().as<std::string>(to) = text; });
        }
    });
}

void NotesEditor::show(bool) {
    const QString text = QString::fromStdString(field().as<std::string>(owner()));
    if (m_text->toPlainText() != text) {
        const QSignalBlocker quiet(m_text);
        m_text->setPlainText(text);
    }
}

bool NotesEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusOut) {
        document().endMerge();
    }
    if (takesHistoryKey(event)) {
        event->ignore();
        return true;
    }
    return FieldEditor::eventFilter(watched, event);
}

} // namespace sparkout
