// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/text_editor.h"

#include "core/format/project_file.h"
#include "ui/kit/font_size.h"
#include "ui/session/document.h"

#include <QEvent>
#include <QLocale>
#include <QSignalBlocker>

namespace sparkout {

namespace {

constexpr int longestLine = 20'000; // in UTF-8 still below the limit of a file

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

NotesEditor::NotesEditor(const std::string& path, const Field& field, Document& document,
                         QWidget* parent)
    : FieldEditor(path, field, document), m_text(new QPlainTextEdit(parent)) {
    m_text->setTabChangesFocus(true);
    setTextLines(*m_text, 5, 10);
    m_text->installEventFilter(this);
    connect(m_text, &QPlainTextEdit::textChanged, this, &NotesEditor::take);
}

QString NotesEditor::stored() const {
    return QString::fromStdString(field().as<std::string>(owner()));
}

void NotesEditor::take() {
    const std::string text = m_text->toPlainText().toStdString();
    if (text.size() > limits::stringBytes) {
        m_kept = stored();
        refuse(tooLong(text.size()));
        return;
    }
    refuse({});
    change([this, &text](void* to) { field().as<std::string>(to) = text; });
}

QString NotesEditor::tooLong(std::size_t bytes) {
    const auto kilobytes = [](double size) { return QLocale().toString(size / 1024, 'f', 1); };
    return tr("the text takes %1 KB; at most %2 KB are kept")
        .arg(kilobytes(double(bytes)), kilobytes(double(limits::stringBytes)));
}

void NotesEditor::refuse(const QString& reason) {
    if (reason != m_refused) {
        m_refused = reason;
        emit remarkChanged();
    }
}

Remark NotesEditor::remark() const {
    return m_refused.isEmpty() ? FieldEditor::remark() : Remark{Mark::error, m_refused};
}

void NotesEditor::dropRefusal() {
    m_kept.clear();
    refuse({});
    show(true);
}

void NotesEditor::show(bool replaced) {
    const QString text = stored();
    if (!m_refused.isEmpty() && !replaced && text == m_kept) {
        return; // the refused text stays in sight
    }
    refuse({});
    if (m_text->toPlainText() != text) {
        const QSignalBlocker quiet(m_text);
        m_text->setPlainText(text);
    }
}

void NotesEditor::retranslate() {
    if (!m_refused.isEmpty()) {
        m_refused = tooLong(std::size_t(m_text->toPlainText().toUtf8().size()));
    }
}

bool NotesEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusOut) {
        document().endMerge();
    }
    return FieldEditor::eventFilter(watched, event);
}

} // namespace sparkout
