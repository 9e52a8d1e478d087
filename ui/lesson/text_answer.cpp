// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/text_answer.h"

#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"

#include <QLabel>
#include <QPlainTextEdit>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {

constexpr int answerHeight = 120, longestAnswer = 20'000;

} // namespace

TextAnswer::TextAnswer(TextGoal goal, QWidget* parent)
    : AnswerField(parent)
    , m_goal(goal)
    , m_text(new QPlainTextEdit(this))
    , m_letters(new QLabel(this)) {
    m_text->setObjectName(QStringLiteral("answerText"));
    m_text->setTabChangesFocus(true);
    setTextMinimumHeight(*m_text, answerHeight);
    m_letters->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::row);
    layout->addWidget(m_text);
    layout->addWidget(m_letters);
    connect(m_text, &QPlainTextEdit::textChanged, this, [this] {
        if (m_text->toPlainText().size() > longestAnswer) { // longer than a file should contain
            const QSignalBlocker blocker(m_text);
            m_text->setPlainText(m_text->toPlainText().left(longestAnswer));
        }
        showLetters();
        emit edited();
    });
    TextAnswer::retranslate();
}

void TextAnswer::show(const Answer& answer) {
    const QSignalBlocker blocker(m_text);
    m_text->setPlainText(QString::fromStdString(answer.text));
    showLetters();
}

void TextAnswer::put(Answer& answer) const {
    answer.text = m_text->toPlainText().toStdString();
}

int TextAnswer::letters() const {
    const QString text = m_text->toPlainText();
    return static_cast<int>(
        std::count_if(text.begin(), text.end(), [](QChar each) { return !each.isSpace(); }));
}

bool TextAnswer::isWhole() const {
    return letters() >= m_goal.least_letters;
}

void TextAnswer::lock() {
    m_text->setReadOnly(true);
}

void TextAnswer::showLetters() {
    m_letters->setText(tr("%1 of at least %2 characters. Your teacher reads the answer.")
                           .arg(letters())
                           .arg(m_goal.least_letters));
}

void TextAnswer::retranslate() {
    m_text->setAccessibleName(tr("Your answer"));
    showLetters();
}

} // namespace sparkout
