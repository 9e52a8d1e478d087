// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/order_answer.h"

#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/lesson/lesson_text.h"

#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QToolButton>

#include <algorithm>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

constexpr int orderedPlaceRole = Qt::UserRole;

std::size_t orderedPlaceCount(const Project& project) {
    std::size_t count = 0;
    while (hasPlace(project, placeName(project, count)) && count < 1000) {
        ++count;
    }
    return count;
}

} // namespace

OrderAnswer::OrderAnswer(OrderPrediction goal, const Project& project, QWidget* parent)
    : AnswerField(parent)
    , m_goal(std::move(goal))
    , m_project(project)
    , m_note(new QLabel(this))
    , m_list(new QListWidget(this))
    , m_up(new QToolButton(this))
    , m_down(new QToolButton(this))
    , m_resultLabel(new QLabel(this))
    , m_result(new QListWidget(this)) {
    m_note->setWordWrap(true);
    m_resultLabel->setWordWrap(true);
    m_list->setObjectName(QStringLiteral("predictedOrder"));
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setDefaultDropAction(Qt::MoveAction);
    m_list->installEventFilter(this);
    m_result->setObjectName(QStringLiteral("resultOrder"));
    m_result->setSelectionMode(QAbstractItemView::NoSelection);
    m_up->setIcon(themeIcon(u"up"));
    m_down->setIcon(themeIcon(u"down"));
    for (QToolButton* button : {m_up, m_down}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
    }
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(metrics::row);
    grid->addWidget(m_note, 0, 0, 1, 2);
    grid->addWidget(m_list, 1, 0, 2, 1);
    grid->addWidget(m_up, 1, 1, Qt::AlignBottom);
    grid->addWidget(m_down, 2, 1, Qt::AlignTop);
    grid->addWidget(m_resultLabel, 0, 2);
    grid->addWidget(m_result, 1, 2, 2, 1);
    grid->setColumnStretch(0, 1);
    m_resultLabel->hide();
    m_result->hide();
    connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
    connect(m_list->model(), &QAbstractItemModel::rowsMoved, this, &AnswerField::edited);
    std::vector<std::size_t> order(orderedPlaceCount(m_project));
    std::iota(order.begin(), order.end(), std::size_t{0});
    fill(order);
    OrderAnswer::retranslate();
}

void OrderAnswer::fill(const std::vector<std::size_t>& order) {
    const QSignalBlocker blocker(m_list->model());
    m_list->clear();
    for (const std::size_t place : order) {
        auto* item = new QListWidgetItem(LessonText::place(m_project, place), m_list);
        item->setData(orderedPlaceRole, static_cast<int>(place));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
    }
    m_list->setCurrentRow(0);
    m_list->reset(); // its model emitted no signals
    m_list->setCurrentRow(0);
    fitHeight();
}

void OrderAnswer::fitHeight() {
    constexpr int most = 8;
    for (QListWidget* list : {m_list, m_result}) {
        const int rows = std::clamp(list->count(), 1, most);
        const int height = std::max(list->sizeHintForRow(0), list->fontMetrics().height());
        list->setFixedHeight(rows * height + 2 * list->frameWidth() + metrics::hair);
    }
}

void OrderAnswer::move(int by) {
    const int from = m_list->currentRow();
    const int to = from + by;
    if (from < 0 || to < 0 || to >= m_list->count() || !m_up->isEnabled()) {
        return;
    }
    QListWidgetItem* const item = m_list->takeItem(from);
    m_list->insertItem(to, item);
    m_list->setCurrentRow(to);
    emit edited();
}

bool OrderAnswer::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_list && event->type() == QEvent::KeyPress) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if ((key.modifiers() & Qt::ControlModifier)
            && (key.key() == Qt::Key_Up || key.key() == Qt::Key_Down)) {
            move(key.key() == Qt::Key_Up ? -1 : 1);
            return true;
        }
    }
    if (watched == m_list && event->type() == QEvent::FontChange) {
        fitHeight();
    }
    return AnswerField::eventFilter(watched, event);
}

void OrderAnswer::show(const Answer& answer) {
    if (answer.order && answer.order->size() == static_cast<std::size_t>(m_list->count())) {
        std::vector<std::size_t> order;
        for (const double place : *answer.order) {
            order.push_back(static_cast<std::size_t>(place));
        }
        fill(order);
    }
}

void OrderAnswer::put(Answer& answer) const {
    std::vector<double> order;
    for (int i = 0; i < m_list->count(); ++i) {
        order.push_back(m_list->item(i)->data(orderedPlaceRole).toInt());
    }
    answer.order = std::move(order);
}

bool OrderAnswer::isWhole() const {
    return m_list->count() > 0;
}

void OrderAnswer::lock() {
    m_list->setDragDropMode(QAbstractItemView::NoDragDrop);
    m_up->setEnabled(false);
    m_down->setEnabled(false);
    m_up->hide();
    m_down->hide();
}

void OrderAnswer::showResult(const GoalResult& result) {
    m_found = result.order;
    m_result->clear();
    for (const std::size_t place : m_found) {
        auto* item = new QListWidgetItem(LessonText::place(m_project, place), m_result);
        item->setFlags(Qt::ItemIsEnabled);
    }
    m_resultLabel->setVisible(!m_found.empty());
    m_result->setVisible(!m_found.empty());
    static_cast<QGridLayout*>(layout())->setColumnStretch(2, m_found.empty() ? 0 : 1);
    fitHeight();
    retranslate();
}

void OrderAnswer::retranslate() {
    const bool isDone = !m_found.empty();
    m_note->setText(isDone ? tr("Your prediction, the largest first")
                           : tr("The largest first: drag them, or move them by the buttons."));
    m_list->setAccessibleName(tr("Your prediction, the largest first"));
    m_result->setAccessibleName(tr("Result of the run, the largest first"));
    m_resultLabel->setText(tr("Result of the run, the largest first"));
    const auto name = [](QToolButton& button, const QString& text, const QString& keys) {
        button.setAccessibleName(text);
        button.setToolTip(QStringLiteral("%1 (%2)").arg(text, keys));
    };
    name(*m_up, tr("Move up"), tr("Ctrl+Up"));
    name(*m_down, tr("Move down"), tr("Ctrl+Down"));
    for (QListWidget* list : {m_list, m_result}) {
        for (int i = 0; i < list->count(); ++i) {
            const std::size_t place =
                list == m_list
                    ? static_cast<std::size_t>(list->item(i)->data(orderedPlaceRole).toInt())
                    : m_found[static_cast<std::size_t>(i)];
            list->item(i)->setText(LessonText::place(m_project, place));
        }
    }
}

} // namespace sparkout
