// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/edit/text_preview.h"

#include "ui/lesson/edit/lesson_draft.h"
#include "ui/lesson/lesson_text.h"

#include <QComboBox>
#include <QLocale>
#include <QScrollBar>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {

constexpr int leastLines = 7; ///< visible

} // namespace

TextPreview::TextPreview(LessonDraft& draft, TextOf text, QWidget* parent)
    : QWidget(parent)
    , m_draft(draft)
    , m_text(std::move(text))
    , m_language(new QComboBox(this))
    , m_shown(new QTextBrowser(this)) {
    m_language->setObjectName(QStringLiteral("previewLanguage"));
    m_language->setAccessibleName(tr("Language of the preview"));
    m_language->addItems({QStringLiteral("Русский"), QStringLiteral("English")});
    m_language->setCurrentIndex(QLocale().language() == QLocale::Russian ? 0 : 1);
    m_shown->setObjectName(QStringLiteral("lessonPreview"));
    m_shown->setAccessibleName(tr("As the student reads it"));
    m_shown->setOpenLinks(false);
    m_shown->setMinimumHeight(leastLines * fontMetrics().lineSpacing());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_language, 0, Qt::AlignLeft);
    layout->addWidget(m_shown, 1);
    connect(m_language, &QComboBox::activated, this, &TextPreview::show);
    connect(&m_draft, &LessonDraft::changed, this, &TextPreview::show);
    show();
}

void TextPreview::show() {
    Bilingual text = m_text(m_draft.lesson());
    (m_language->currentIndex() == 0 ? text.en : text.ru).clear();
    const int scrolled = m_shown->verticalScrollBar()->value();
    m_shown->setHtml(LessonText::markup(text));
    m_shown->verticalScrollBar()->setValue(scrolled);
}

} // namespace sparkout
