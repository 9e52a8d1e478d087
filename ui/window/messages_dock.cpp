// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/messages_dock.h"

#include "ui/inputs/messages_panel.h"

#include <QDockWidget>
#include <QGuiApplication>
#include <QStatusBar>
#include <QToolButton>

#include <algorithm>

namespace sparkout {

namespace {
constexpr int dragged_ms = 200; ///< interval of checking for the end of a drag
} // namespace

MessagesDock::MessagesDock(QDockWidget& dock, MessagesPanel& panel, QStatusBar& bar)
    : QObject(&dock), m_dock(dock), m_panel(panel), m_button(new QToolButton(&bar)) {
    m_button->setObjectName(QStringLiteral("messagesButton"));
    m_button->setAutoRaise(true);
    m_button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar.addPermanentWidget(m_button);
    connect(m_button, &QToolButton::clicked, this,
            [this] { m_dock.setVisible(!m_dock.isVisible()); });
    m_later.setSingleShot(true);
    connect(&m_later, &QTimer::timeout, this, &MessagesDock::follow);
    connect(&m_panel, &MessagesPanel::messagesChanged, this, [this] {
        retranslate();
        m_later.start(0);
    });
}

/// The views do not resize while a slider is dragged.
void MessagesDock::follow() {
    if (QGuiApplication::mouseButtons() != Qt::NoButton) {
        m_later.start(dragged_ms);
        return;
    }
    const QStringList paths = m_panel.paths();
    const bool isNew =
        std::ranges::any_of(paths, [this](const QString& path) { return !m_seen.contains(path); });
    if (isNew || (paths.isEmpty() && !m_seen.isEmpty())) {
        m_dock.setVisible(isNew);
    }
    m_seen = paths;
}

void MessagesDock::showOrHide() {
    m_later.stop();
    m_seen = m_panel.paths();
    m_dock.setVisible(!m_seen.isEmpty());
}

void MessagesDock::retranslate() {
    const auto count = static_cast<int>(m_panel.paths().size());
    m_button->setText(count == 0 ? tr("No messages") : tr("%n message(s)", nullptr, count));
    m_button->setIcon(markIcon(m_panel.worst()));
    m_button->setToolTip(tr("Show or hide the messages"));
    m_button->setAccessibleName(m_button->text());
}

} // namespace sparkout
