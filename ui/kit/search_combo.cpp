// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/search_combo.h"

#include "ui/kit/metrics.h"

#include <QApplication>
#include <QFrame>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QScreen>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {

constexpr int shownEntries = 14;

QString folded(const QString& text) {
    return text.toCaseFolded().replace(u'ё', u'е');
}

/// Accepts the entries that contain every word.
class WordFilter : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setWords(const QString& text) {
        m_words = folded(text).split(u' ', Qt::SkipEmptyParts);
        invalidateFilter();
    }

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
        const QModelIndex entry = sourceModel()->index(row, 0, parent);
        const QString text =
            folded(entry.data().toString() + u'\n' + entry.data(SearchCombo::wordsRole).toString());
        return std::all_of(m_words.begin(), m_words.end(),
                           [&text](const QString& word) { return text.contains(word); });
    }

private:
    QStringList m_words;
};

} // namespace

SearchCombo::SearchCombo(QWidget* parent)
    : QComboBox(parent)
    , m_found(new WordFilter(this))
    , m_popup(new QFrame(this, Qt::Popup))
    , m_search(new QLineEdit(m_popup))
    , m_list(new QListView(m_popup))
    , m_nothing(new QLabel(m_popup)) {
    m_found->setSourceModel(model());
    m_list->setModel(m_found);
    m_list->setUniformItemSizes(true);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setMouseTracking(true);
    m_popup->setFrameShape(QFrame::StyledPanel);
    m_popup->setFocusProxy(m_search);
    m_search->setObjectName(QStringLiteral("search"));
    m_search->setClearButtonEnabled(true);
    m_search->setAccessibleName(tr("Search the list"));
    m_search->installEventFilter(this);
    auto* layout = new QVBoxLayout(m_popup);
    layout->setContentsMargins(metrics::hair, metrics::hair, metrics::hair, metrics::hair);
    layout->setSpacing(metrics::hair);
    layout->addWidget(m_search);
    layout->addWidget(m_list);
    layout->addWidget(m_nothing);
    connect(m_search, &QLineEdit::textChanged, this, &SearchCombo::search);
    connect(m_list, &QListView::clicked, this, &SearchCombo::choose);
    connect(m_list, &QListView::entered, m_list, &QListView::setCurrentIndex);
}

void SearchCombo::showPopup() {
    open({});
}

void SearchCombo::changeEvent(QEvent* event) {
    QComboBox::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        m_search->setAccessibleName(tr("Search the list"));
    }
}

void SearchCombo::hidePopup() {
    m_popup->hide();
    QComboBox::hidePopup();
}

void SearchCombo::open(const QString& text) {
    m_search->setPlaceholderText(tr("Type to search"));
    m_search->setAccessibleName(tr("Search the list"));
    m_list->setAccessibleName(accessibleName());
    m_nothing->setText(tr("Nothing found"));
    m_search->setText(text);
    search(text);
    place();
    m_popup->show();
    m_search->setFocus(Qt::PopupFocusReason);
}

/// Places the list below the box, or above it if there is more room, as wide as its entries.
void SearchCombo::place() {
    const int rows = std::min(count(), shownEntries);
    const int width = std::max(this->width(), m_list->sizeHintForColumn(0)
                                                  + m_list->verticalScrollBar()->sizeHint().width()
                                                  + 4 * metrics::tight);
    m_list->setFixedHeight(rows * std::max(m_list->sizeHintForRow(0), fontMetrics().height())
                           + 2 * m_list->frameWidth());
    m_nothing->setFixedHeight(m_list->height());
    m_nothing->setAlignment(Qt::AlignTop);
    m_popup->setFixedSize(width, m_search->sizeHint().height() + m_list->height()
                                     + 4 * metrics::hair + 2 * m_popup->frameWidth());
    const QRect room = screen()->availableGeometry();
    QPoint at = mapToGlobal(rect().bottomLeft());
    if (at.y() + m_popup->height() > room.bottom()) {
        at.setY(std::max(room.top(), mapToGlobal(rect().topLeft()).y() - m_popup->height()));
    }
    at.setX(
        std::clamp(at.x(), room.left(), std::max(room.left(), room.right() - m_popup->width())));
    m_popup->move(at);
}

void SearchCombo::search(const QString& text) {
    static_cast<WordFilter*>(m_found)->setWords(text);
    const QModelIndex now = m_found->mapFromSource(model()->index(currentIndex(), 0));
    m_list->setCurrentIndex(text.trimmed().isEmpty() && now.isValid() ? now : m_found->index(0, 0));
    m_list->scrollTo(m_list->currentIndex());
    m_list->setVisible(m_found->rowCount() > 0);
    m_nothing->setVisible(m_found->rowCount() == 0);
}

void SearchCombo::keyPressEvent(QKeyEvent* event) {
    const QString text = event->text();
    const bool command =
        event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    if (!command && !text.isEmpty() && text.front().isPrint() && !text.front().isSpace()) {
        open(text);
        m_search->setCursorPosition(int(text.size()));
        event->accept();
        return;
    }
    QComboBox::keyPressEvent(event);
}

bool SearchCombo::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_search && event->type() == QEvent::KeyPress) {
        return takeKey(*static_cast<QKeyEvent*>(event));
    }
    return QComboBox::eventFilter(watched, event);
}

bool SearchCombo::takeKey(QKeyEvent& key) {
    switch (key.key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown: QApplication::sendEvent(m_list, &key); return true;
    case Qt::Key_Return:
    case Qt::Key_Enter: choose(m_list->currentIndex()); return true;
    case Qt::Key_Tab:
    case Qt::Key_Escape: hidePopup(); return true;
    default: return false;
    }
}

void SearchCombo::choose(const QModelIndex& found) {
    if (!found.isValid()) {
        return;
    }
    const int row = m_found->mapToSource(found).row();
    hidePopup();
    setCurrentIndex(row);
    emit activated(row);
    emit textActivated(itemText(row));
}

} // namespace sparkout
