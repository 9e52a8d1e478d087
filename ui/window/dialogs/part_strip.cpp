// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/part_strip.h"

#include "core/project/part.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/session/document.h"
#include "ui/session/part_runs.h"
#include "ui/session/surface_edits.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/window/dialogs/part_drawing.h"

#include <QContextMenuEvent>
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QTabBar>
#include <QToolButton>

#include <algorithm>
#include <vector>

namespace sparkout {

namespace {

constexpr int leastOnTab = 6; ///< least letters of a name; below, a tab has only its number

/// The greatest width of texts with which all fit; short ones leave their surplus to the others.
int widestOf(std::vector<int> widths, int room) {
    std::ranges::sort(widths);
    auto left = static_cast<int>(widths.size());
    for (const int width : widths) {
        if (width > room / left) {
            return room / left;
        }
        room -= width;
        --left;
    }
    return widths.empty() ? 0 : widths.back();
}

} // namespace

PartStrip::PartStrip(Document& document, const PartRuns& runs, QWidget* parent)
    : QFrame(parent)
    , m_document(document)
    , m_runs(runs)
    , m_drawing(new PartDrawing(this))
    , m_tabs(new QTabBar(this))
    , m_whole(new QToolButton(this))
    , m_menu(new QToolButton(this)) {
    setObjectName(QStringLiteral("partStrip"));
    setHelpTopic(*this, QStringLiteral("surfaces"));
    m_tabs->setObjectName(QStringLiteral("surfaces"));
    m_tabs->setExpanding(false);
    m_tabs->setDrawBase(false);
    m_tabs->setElideMode(Qt::ElideNone);
    m_tabs->setUsesScrollButtons(true);
    m_tabs->setIconSize({metrics::iconSmall, metrics::iconSmall});
    m_tabs->setFocusPolicy(Qt::TabFocus);
    m_tabs->installEventFilter(this);
    m_whole->setObjectName(QStringLiteral("wholePart"));
    m_whole->setAutoRaise(true);
    m_whole->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_menu->setObjectName(QStringLiteral("surfaceMenu"));
    m_menu->setIcon(themeIcon(u"part"));
    m_menu->setAutoRaise(true);
    m_menu->setPopupMode(QToolButton::InstantPopup);
    m_menu->setMenu(new QMenu(m_menu));
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(metrics::tight, 0, metrics::tight, 0);
    line->setSpacing(metrics::gap);
    line->addWidget(m_drawing);
    line->addWidget(m_tabs, 1, Qt::AlignBottom);
    line->addWidget(m_whole);
    line->addWidget(m_menu);
    connect(m_tabs, &QTabBar::currentChanged, this, [this](int tab) {
        if (!m_following && tab >= 0) {
            emit surfaceWanted(static_cast<std::size_t>(tab));
        }
    });
    connect(m_drawing, &PartDrawing::surfaceClicked, this, &PartStrip::surfaceWanted);
    connect(m_drawing, &PartDrawing::freeStepEntered, this, &PartStrip::surfaceOnStepWanted);
    connect(m_whole, &QToolButton::clicked, this, &PartStrip::wholePartWanted);
    connect(&document, &Document::changed, this, &PartStrip::follow);
    connect(&runs, &PartRuns::changed, this, &PartStrip::showStatuses);
    retranslate();
}

void PartStrip::setActions(const QList<QAction*>& actions) {
    m_menu->menu()->addActions(actions);
}

void PartStrip::tellResults(bool tells) {
    if (m_tells != tells) {
        m_tells = tells;
        m_whole->setVisible(tells);
        showStatuses();
    }
}

void PartStrip::follow() {
    const int count = static_cast<int>(m_document.surfaceCount());
    setVisible(count > 1);
    m_following = true;
    while (m_tabs->count() > count) {
        m_tabs->removeTab(m_tabs->count() - 1);
    }
    while (m_tabs->count() < count) {
        m_tabs->addTab(QString());
    }
    m_tabs->setCurrentIndex(static_cast<int>(m_document.surface()));
    m_following = false;
    m_drawing->setOutline(PartOutline::of(m_document.state()));
    m_drawing->setPresent(m_document.surface());
    showStatuses();
}

QString PartStrip::tip(std::size_t surface) const {
    const Part& part = *m_document.state().surfaces[surface]->project.part;
    const SurfaceStatus& status = m_runs.statuses()[surface];
    QStringList lines{tr("%1. %2")
                          .arg(surface + 1)
                          .arg(printableText(SurfaceEdits::nameOf(m_document.state(), surface)))};
    lines += tr("⌀%1 × %2 mm, from %3 mm")
                 .arg(printedNumber(part.diameter_mm), printedNumber(part.length_mm),
                      printedNumber(part.shaft.ground_from_mm));
    if (!m_tells) {
        return lines.join(u'\n');
    }
    lines += statusText(status);
    if (const QString worst = worstText(status); !worst.isEmpty()) {
        lines += worst;
    }
    return lines.join(u'\n');
}

void PartStrip::showStatuses() {
    const std::size_t count = m_document.surfaceCount();
    if (m_runs.statuses().size() != count || m_tabs->count() != static_cast<int>(count)) {
        return; // the other one follows in a moment
    }
    QStringList tips;
    std::size_t holding = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const SurfaceStatus& status = m_runs.statuses()[i];
        const int tab = static_cast<int>(i);
        const QString name = printableText(SurfaceEdits::nameOf(m_document.state(), i));
        m_tabs->setTabIcon(
            tab, m_tells ? QIcon(statusPixmap(status, metrics::iconSmall, devicePixelRatioF()))
                         : QIcon());
        m_tabs->setAccessibleTabName(
            tab, m_tells ? tr("Surface %1: %2, %3").arg(i + 1).arg(name, statusText(status))
                         : tr("Surface %1: %2").arg(i + 1).arg(name));
        tips += tip(i);
        m_tabs->setTabToolTip(tab, tips.back());
        holding += status.holds();
    }
    m_drawing->setTips(tips);
    const auto time = m_runs.time();
    m_whole->setText(
        time
            ? tr("%1 of %2 · %3").arg(holding).arg(count).arg(Names::timeOfMinutes(time->piece_min))
            : tr("%1 of %2").arg(holding).arg(count));
    m_whole->setAccessibleName(tr("The whole part: %1").arg(m_whole->text()));
    nameTabs();
}

void PartStrip::nameTabs() {
    QStringList names;
    std::vector<int> widths;
    const QFontMetrics metrics = m_tabs->fontMetrics();
    constexpr int besideText = 2 * metrics::margin + metrics::iconSmall + metrics::gap;
    for (int tab = 0; tab < m_tabs->count(); ++tab) {
        const QString name =
            printableText(SurfaceEdits::nameOf(m_document.state(), static_cast<std::size_t>(tab)));
        names += QStringLiteral("%1 %2").arg(tab + 1).arg(name);
        widths.push_back(metrics.horizontalAdvance(names.back()));
    }
    const int room = width() - m_drawing->minimumSizeHint().width() - m_whole->sizeHint().width()
                     - m_menu->sizeHint().width() - 5 * metrics::gap - m_tabs->count() * besideText;
    const int widest = widestOf(widths, room);
    const int least = metrics.horizontalAdvance(QStringLiteral("00 ") + QString(leastOnTab, u'n'));
    for (int tab = 0; tab < m_tabs->count(); ++tab) {
        const int own = widths[static_cast<std::size_t>(tab)];
        QString text = own <= widest    ? names[tab]
                       : widest < least ? QString::number(tab + 1)
                                        : metrics.elidedText(names[tab], Qt::ElideRight, widest);
        text.replace(u'&', QStringLiteral("&&"));
        if (m_tabs->tabText(tab) != text) {
            m_tabs->setTabText(tab, text);
        }
    }
}

void PartStrip::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    if (m_tabs->count() == static_cast<int>(m_document.surfaceCount())) {
        nameTabs();
    }
}

void PartStrip::retranslate() {
    m_drawing->setAccessibleName(tr("The part with its surfaces"));
    m_tabs->setAccessibleName(tr("Surfaces of the part in the order of grinding"));
    m_whole->setToolTip(tr("Number of fit surfaces, and piece time; a click shows times and "
                           "verdicts of all surfaces"));
    m_menu->setToolTip(tr("Add, move and remove surfaces"));
    m_menu->setAccessibleName(m_menu->toolTip());
    follow();
}

void PartStrip::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        showStatuses();
        m_drawing->updateGeometry();
    }
    QFrame::changeEvent(event);
}

/// Shows the menu of a tab's surface.
bool PartStrip::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_tabs && event->type() == QEvent::ContextMenu) {
        const auto* asked = static_cast<QContextMenuEvent*>(event);
        const int tab =
            asked->reason() == QContextMenuEvent::Mouse ? m_tabs->tabAt(asked->pos()) : -1;
        if (tab >= 0) {
            emit surfaceWanted(static_cast<std::size_t>(tab));
        }
        m_menu->menu()->popup(asked->globalPos());
        return true;
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace sparkout
