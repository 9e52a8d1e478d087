// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/text_editor.h"

#include "core/format/project_file.h"

#include <QEvent>
#include <QLocale>
#include <QSignalBlocker>
#include <QTextCursor>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr int longestLine = 20'000; // in UTF-8 still below the limit of a file

} // namespace

TextEditor::TextEditor(const std::string& path, const Field& field, FormModel& model,
                       QWidget* parent)
    : FieldEditor(path, field, model), m_line(new QLineEdit(parent)) {
    m_line->setMaxLength(std::isfinite(field.hard.high) ? static_cast<int>(field.hard.high)
                                                        : longestLine);
    m_line->installEventFilter(this);
    connect(m_line, &QLineEdit::textEdited, this, [this](const QString& text) {
        change([this, &text](void* to) { this->field().as<std::string>(to) = text.toStdString(); });
    });
    connect(m_line, &QLineEdit::editingFinished, this, [this] { this->model().endMerge(); });
}

void TextEditor::show(bool) {
    const QString text = QString::fromStdString(field().as<std::string>(owner()));
    if (m_line->text() != text) {
        m_line->setText(text);
        m_line->setCursorPosition(0);
    }
}

NotesEditor::NotesEditor(const std::string& path, const Field& field, FormModel& model,
                         QWidget* parent)
    : FieldEditor(path, field, model), m_text(new QPlainTextEdit(parent)) {
    m_text->setTabChangesFocus(true);
    m_text->installEventFilter(this);
    connect(m_text, &QPlainTextEdit::textChanged, this, &NotesEditor::take);
}

QString NotesEditor::stored() const {
    return QString::fromStdString(field().as<std::string>(owner()));
}

/// With the spaces that do not break, which toPlainText() makes plain ones.
QString NotesEditor::typed() const {
    return m_text->document()
        ->toRawText()
        .replace(QChar::ParagraphSeparator, u'\n')
        .replace(QChar::LineSeparator, u'\n');
}

void NotesEditor::take() {
    const std::string text = typed().toStdString();
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
    if (typed() != text) {
        const QSignalBlocker quiet(m_text);
        QTextCursor cursor = m_text->textCursor();
        const int place = cursor.position();
        m_text->setPlainText(text);
        cursor.setPosition(std::min(place, m_text->document()->characterCount() - 1));
        m_text->setTextCursor(cursor);
    }
}

void NotesEditor::retranslate() {
    if (!m_refused.isEmpty()) {
        m_refused = tooLong(std::size_t(typed().toUtf8().size()));
    }
}

bool NotesEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusOut) {
        model().endMerge();
    }
    return FieldEditor::eventFilter(watched, event);
}

} // namespace sparkout
