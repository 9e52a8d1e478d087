// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/notice_bar.h"

#include "ui/session/program_log.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

NoticeBar::NoticeBar(QWidget* parent) : QWidget(parent), m_rows(new QVBoxLayout(this)) {
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setSpacing(1);
    setVisible(false);
}

void NoticeBar::add(Notice notice) {
    ProgramLog::note(notice.text());
    const auto same = std::find_if(m_notices.begin(), m_notices.end(),
                                   [&](const Notice& one) { return one.key == notice.key; });
    if (same != m_notices.end()) {
        *same = std::move(notice);
    } else {
        m_notices.push_back(std::move(notice));
    }
    build();
}

void NoticeBar::remove(const QString& key) {
    if (std::erase_if(m_notices, [&](const Notice& one) { return one.key == key; }) != 0) {
        build();
    }
}

bool NoticeBar::holds(const QString& key) const {
    return std::any_of(m_notices.begin(), m_notices.end(),
                       [&](const Notice& one) { return one.key == key; });
}

QString NoticeBar::textOf(const QString& key) const {
    for (const Notice& notice : m_notices) {
        if (notice.key == key) {
            return notice.text();
        }
    }
    return {};
}

QWidget* NoticeBar::above(QWidget* content) {
    auto* both = new QWidget;
    auto* layout = new QVBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(this);
    layout->addWidget(content, 1);
    return both;
}

void NoticeBar::build() {
    while (QLayoutItem* item = m_rows->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // one of its buttons may be clicked at this moment
        delete item;
    }
    for (const Notice& notice : m_notices) {
        m_rows->addWidget(makeRow(notice));
    }
    setVisible(!m_notices.empty());
}

QWidget* NoticeBar::makeRow(const Notice& notice) {
    auto* row = new QFrame(this);
    row->setObjectName(QStringLiteral("notice ") + notice.key);
    row->setFrameShape(QFrame::StyledPanel);
    row->setAutoFillBackground(true);
    row->setBackgroundRole(QPalette::AlternateBase);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(8, 3, 4, 3);
    auto* icon = new QLabel(row);
    const int size = style()->pixelMetric(QStyle::PM_SmallIconSize);
    icon->setPixmap(markIcon(notice.mark).pixmap(size, size));
    icon->setVisible(notice.mark != Mark::none);
    auto* text = new QLabel(notice.text(), row);
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text->setAccessibleName(tr("Notice"));
    layout->addWidget(icon);
    layout->addWidget(text, 1);
    const auto addButton = [&](const QString& name, const std::function<void()>& act) {
        auto* button = new QPushButton(name, row);
        button->setAutoDefault(false);
        // A queued call: the action may delete the row with this button.
        connect(
            button, &QPushButton::clicked, this,
            [this, key = notice.key, act] {
                remove(key);
                if (act) {
                    act();
                }
            },
            Qt::QueuedConnection);
        layout->addWidget(button);
    };
    for (const Notice::Button& button : notice.buttons) {
        addButton(button.text(), button.act);
    }
    addButton(tr("Close"), {});
    return row;
}

void NoticeBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        build();
    }
    QWidget::changeEvent(event);
}

} // namespace sparkout
