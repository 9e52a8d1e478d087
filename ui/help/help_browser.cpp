// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_browser.h"

#include "ui/help/help_book.h"
#include "ui/help/help_words.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"

#include <QEvent>
#include <QScrollBar>
#include <QTextDocument>

namespace sparkout {

namespace {

constexpr int leastTyped = 2; ///< letters worth marking

QUrl urlOf(const QString& topic) {
    return QUrl(QStringLiteral("help:") + topic);
}

} // namespace

HelpBrowser::HelpBrowser(QWidget* parent) : QTextBrowser(parent) {
    setOpenExternalLinks(false);
    document()->setDocumentMargin(metrics::wide);
    document()->setDefaultStyleSheet(styleSheetNow());
}

void HelpBrowser::openTopic(const QString& topic) {
    m_words.clear();
    setExtraSelections({});
    setSource(urlOf(topic), QTextDocument::HtmlResource);
}

QString HelpBrowser::topic() const {
    return source().path() + (source().hasFragment() ? u'#' + source().fragment() : QString());
}

QVariant HelpBrowser::loadResource(int type, const QUrl& name) {
    if (type != QTextDocument::HtmlResource || !m_book || m_book->pages().empty()) {
        return QVariant(QString()); // the pages have only text
    }
    const HelpPage* page = m_book->find(name.path());
    return page ? page->html : m_book->pages().front().html;
}

void HelpBrowser::renew() {
    const int at = verticalScrollBar()->value();
    document()->setDefaultStyleSheet(styleSheetNow());
    reload();
    verticalScrollBar()->setValue(at);
    mark(m_words);
}

void HelpBrowser::mark(const QString& words) {
    m_words = words;
    QList<ExtraSelection> selections;
    if (words.trimmed().size() >= leastTyped) {
        for (const auto& [at, length] : HelpWords(words).placesIn(document()->toRawText())) {
            ExtraSelection selection;
            selection.cursor = QTextCursor(document());
            selection.cursor.setPosition(int(at));
            selection.cursor.setPosition(int(at + length), QTextCursor::KeepAnchor);
            selection.format.setBackground(palette().brush(QPalette::Highlight));
            selection.format.setForeground(palette().brush(QPalette::HighlightedText));
            selections += selection;
        }
    }
    setExtraSelections(selections);
}

QString HelpBrowser::styleSheetNow() const {
    const QString link = palette().color(QPalette::Link).name();
    const QString quiet = palette().color(QPalette::PlaceholderText).name();
    const QString ground = palette().color(QPalette::AlternateBase).name();
    return QStringLiteral("a { color: %1; } "
                          "h1 { font-size: x-large; margin-bottom: 8px; } "
                          "h2 { font-size: large; margin-top: 16px; margin-bottom: 4px; } "
                          "h3 { font-size: medium; margin-top: 12px; margin-bottom: 2px; } "
                          "p { margin-top: 4px; margin-bottom: 4px; } "
                          "p.formula { margin-left: 24px; background-color: %3; } "
                          "p.key { color: %2; font-size: small; } "
                          "td, th { padding: 2px 10px 2px 0px; } "
                          "pre { background-color: %3; } ")
        .arg(link, quiet, ground);
}

void HelpBrowser::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (m_book && (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)) {
        renew();
    }
}

} // namespace sparkout
