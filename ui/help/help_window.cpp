// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_window.h"

#include "ui/help/help_book.h"
#include "ui/kit/keyboard.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QScreen>
#include <QScrollBar>
#include <QSplitter>
#include <QTextBrowser>
#include <QTextDocument>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {

constexpr int leastTyped = 2; ///< letters worth marking

QUrl urlOf(const QString& topic) {
    return QUrl(QStringLiteral("help:") + topic);
}

constexpr QSize helpSize(900, 640);
constexpr QSize helpFrame(40, 80);
constexpr int contentsWidth = 250;
constexpr int topicRole = Qt::UserRole;
constexpr int searchPause_ms = 200; ///< after typing a search

QTreeWidgetItem* contentsItem(QTreeWidget& list, const QString& topic) {
    for (int i = 0; i < list.topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = list.topLevelItem(i);
        for (int j = 0; j < group->childCount(); ++j) {
            if (group->child(j)->data(0, topicRole) == topic) {
                return group->child(j);
            }
        }
    }
    return nullptr;
}

} // namespace

/// Shows pages of a help book, in the colours and the font of the window.
class HelpBrowser : public QTextBrowser {
public:
    explicit HelpBrowser(QWidget* parent = nullptr);

    void setBook(const HelpBook* book) { m_book = book; } ///< must outlive its use here
    void openTopic(const QString& topic); ///< "feeds#mouse"; an unknown page shows the first
    [[nodiscard]] QString topic() const;  ///< the current one
    void renew();                         ///< reloads the page after a change of book, look or font
    void mark(const QString& words);      ///< every occurrence of each word

protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] QString styleSheetNow() const;

    const HelpBook* m_book = nullptr;
    QString m_words;
};

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
    return QStringLiteral(
               "a { color: %1; } h1 { font-size: x-large; margin-bottom: 8px; } h2 { font-size: "
               "large; margin-top: 16px; margin-bottom: 4px; } h3 { font-size: medium; margin-top: "
               "12px; margin-bottom: 2px; } p { margin-top: 4px; margin-bottom: 4px; } p.formula { "
               "margin-left: 24px; background-color: %3; } p.key { color: %2; font-size: small; } "
               "td, th { padding: 2px 10px 2px 0px; } pre { background-color: %3; } ")
        .arg(link, quiet, ground);
}

void HelpBrowser::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (m_book && (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)) {
        renew();
    }
}

HelpWindow::HelpWindow(std::function<QString()> shortcuts, QWidget* parent)
    : QWidget(parent, Qt::Window)
    , m_shortcuts(std::move(shortcuts))
    , m_back(new QToolButton(this))
    , m_forward(new QToolButton(this))
    , m_search(new QLineEdit(this))
    , m_list(new QTreeWidget(this))
    , m_browser(new HelpBrowser(this)) {
    setObjectName(QStringLiteral("help"));
    setWindowIcon(QIcon(QStringLiteral(":/icons/sparkout.svg")));
    setAttribute(Qt::WA_QuitOnClose, false); // the program ends with its own window
    build();
    connectParts();
    renew();
    resize(helpSize.boundedTo(screen()->availableSize() - helpFrame));
}

HelpWindow::~HelpWindow() = default;

void HelpWindow::build() {
    m_back->setObjectName(QStringLiteral("helpBack"));
    m_back->setIcon(themeIcon(u"back"));
    m_back->setShortcut(Qt::ALT | Qt::Key_Left);
    m_forward->setObjectName(QStringLiteral("helpForward"));
    m_forward->setIcon(themeIcon(u"forward"));
    m_forward->setShortcut(Qt::ALT | Qt::Key_Right);
    for (QToolButton* button : {m_back, m_forward}) {
        button->setIconSize({metrics::icon, metrics::icon});
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
    }
    m_search->setObjectName(QStringLiteral("helpSearch"));
    m_search->setClearButtonEnabled(true);
    m_list->setObjectName(QStringLiteral("helpContents"));
    m_list->setHeaderHidden(true);
    m_list->setTextElideMode(Qt::ElideRight);
    m_browser->setObjectName(QStringLiteral("helpPage"));
    auto* bar = new QHBoxLayout;
    bar->setSpacing(metrics::tight);
    bar->setContentsMargins(metrics::gap, metrics::tight, metrics::gap, metrics::tight);
    bar->addWidget(m_back);
    bar->addWidget(m_forward);
    bar->addWidget(m_search, 1);
    auto* parts = new QSplitter(this);
    parts->setChildrenCollapsible(false);
    parts->addWidget(m_list);
    parts->addWidget(m_browser);
    parts->setStretchFactor(1, 1);
    parts->setSizes({contentsWidth, helpSize.width() - contentsWidth});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(bar);
    layout->addWidget(parts, 1);
}

void HelpWindow::connectParts() {
    connect(m_back, &QToolButton::clicked, m_browser, &HelpBrowser::backward);
    connect(m_forward, &QToolButton::clicked, m_browser, &HelpBrowser::forward);
    connect(m_browser, &HelpBrowser::backwardAvailable, m_back, &QToolButton::setEnabled);
    connect(m_browser, &HelpBrowser::forwardAvailable, m_forward, &QToolButton::setEnabled);
    connect(m_browser, &HelpBrowser::sourceChanged, this, [this](const QUrl& url) {
        m_page = url.path(); // the browser's own source is not up to date here
        showPlace();
    });
    m_back->setEnabled(false);
    m_forward->setEnabled(false);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &HelpWindow::openListed);
    auto* find = new QAction(this);
    find->setShortcut(QKeySequence::Find);
    addAction(find);
    connect(find, &QAction::triggered, m_search, [this] {
        m_search->setFocus(Qt::ShortcutFocusReason);
        m_search->selectAll();
    });
    auto* pause = new QTimer(this);
    pause->setSingleShot(true);
    pause->setInterval(searchPause_ms);
    connect(m_search, &QLineEdit::textChanged, pause, qOverload<>(&QTimer::start));
    connect(pause, &QTimer::timeout, this, &HelpWindow::fillList);
    connect(m_search, &QLineEdit::returnPressed, this, [this, pause] {
        if (pause->isActive()) {
            pause->stop();
            fillList();
        }
        QTreeWidgetItem* first = m_list->topLevelItem(0);
        if (first && !m_search->text().trimmed().isEmpty()) {
            m_list->setCurrentItem(first);
            m_list->setFocus(Qt::TabFocusReason);
        }
    });
    m_renewal.setSingleShot(true);
    m_renewal.setInterval(0);
    connect(&m_renewal, &QTimer::timeout, this, &HelpWindow::renew);
}

void HelpWindow::renew() {
    auto before = std::exchange(m_book, std::make_unique<HelpBook>(m_shortcuts()));
    m_browser->setBook(m_book.get());
    m_back->setToolTip(tr("Back"));
    m_forward->setToolTip(tr("Forward"));
    for (QToolButton* button : {m_back, m_forward}) {
        button->setAccessibleName(button->toolTip());
        button->setToolTip(QStringLiteral("%1 (%2)").arg(
            button->toolTip(), button->shortcut().toString(QKeySequence::NativeText)));
    }
    m_search->setPlaceholderText(tr("Search the help (Ctrl+F)"));
    m_search->setAccessibleName(tr("Search the help"));
    m_list->setAccessibleName(tr("Contents"));
    m_browser->setAccessibleName(tr("Page of the help"));
    if (before) {
        m_browser->renew();
    }
    fillList();
    showPlace();
}

void HelpWindow::fillList() {
    const QScopedValueRollback showing(m_showing, true);
    m_list->clear();
    const QString words = m_search->text().trimmed();
    m_list->setRootIsDecorated(words.isEmpty());
    if (!words.isEmpty()) {
        for (const HelpBook::Hit& hit : m_book->search(words)) {
            const QString title =
                hit.section->title == hit.page->title
                    ? hit.page->title
                    : QStringLiteral("%1 — %2").arg(hit.section->title, hit.page->title);
            auto* item = new QTreeWidgetItem(m_list, {title});
            item->setData(0, topicRole, hit.topic());
            item->setToolTip(0, title);
        }
        if (m_list->topLevelItemCount() == 0) {
            auto* none = new QTreeWidgetItem(m_list, {tr("No page has all these words.")});
            none->setFlags(Qt::NoItemFlags);
        }
        return;
    }
    QTreeWidgetItem* group = nullptr;
    for (const HelpPage& page : m_book->pages()) {
        if (!group || group->text(0) != page.group) {
            group = new QTreeWidgetItem(m_list, {page.group});
            group->setFlags(Qt::ItemIsEnabled);
        }
        auto* item = new QTreeWidgetItem(group, {page.title});
        item->setData(0, topicRole, page.id);
        item->setToolTip(0, page.title);
    }
    m_list->expandAll();
    showPlace();
}

void HelpWindow::openListed() {
    const QTreeWidgetItem* item = m_list->currentItem();
    if (m_showing || !item || !item->data(0, topicRole).isValid()) {
        return;
    }
    const QScopedValueRollback showing(m_showing, true);
    m_browser->openTopic(item->data(0, topicRole).toString());
    m_browser->mark(m_search->text());
}

void HelpWindow::openTopic(const QString& topic) {
    m_browser->openTopic(topic);
}

QString HelpWindow::topic() const {
    return m_browser->topic();
}

void HelpWindow::showFront() {
    setWindowState(windowState() & ~Qt::WindowMinimized);
    show();
    raise();
    activateWindow();
    m_browser->setFocus(Qt::OtherFocusReason);
}

void HelpWindow::showPlace() {
    const HelpPage* page = m_book->find(m_page);
    setWindowTitle(page ? tr("%1 — Sparkout help").arg(page->title) : tr("Sparkout help"));
    if (page && m_search->text().trimmed().isEmpty()) {
        const QScopedValueRollback showing(m_showing, true);
        m_list->setCurrentItem(contentsItem(*m_list, page->id));
    }
}

void HelpWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        m_renewal.start();
    }
    QWidget::changeEvent(event);
}

void HelpWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        if (m_search->hasFocus() && !m_search->text().isEmpty()) {
            m_search->clear();
        } else {
            close();
        }
        return;
    }
    QWidget::keyPressEvent(event);
}

} // namespace sparkout
