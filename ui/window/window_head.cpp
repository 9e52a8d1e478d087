// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_head.h"

#include "ui/kit/metrics.h"

#include <QHBoxLayout>
#include <QMenuBar>
#include <QToolBar>

namespace sparkout {

WindowHead::WindowHead(QWidget* parent)
    : QWidget(parent), m_menus(new QMenuBar(this)), m_tools(new QToolBar(this)) {
    m_menus->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    m_tools->setObjectName(QStringLiteral("toolBar"));
    m_tools->setMovable(false);
    m_tools->setContextMenuPolicy(Qt::PreventContextMenu);
    m_tools->setIconSize({metrics::icon, metrics::icon});
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(metrics::wide);
    line->addWidget(m_menus, 0, Qt::AlignVCenter);
    line->addWidget(m_tools, 1);
}

void WindowHead::fitNames() {
    m_tools->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_named = m_tools->sizeHint().width();
    fit();
}

void WindowHead::fit() {
    const int room = width() - m_menus->sizeHint().width() - metrics::wide;
    m_tools->setToolButtonStyle(m_named > room ? Qt::ToolButtonIconOnly
                                               : Qt::ToolButtonTextBesideIcon);
}

void WindowHead::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

/// The buttons have their final style and font, and so their width, only now.
void WindowHead::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    fitNames();
}

} // namespace sparkout
