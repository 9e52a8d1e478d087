// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/bar_plot.h"

#include "ui/chart/plot_tools.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <utility>

namespace sparkout {

/// The chart as a layer of the plot, with a frame around the selected bar.
class BarPlot::Layer : public QCPLayerable {
public:
    explicit Layer(BarPlot& plot) : QCPLayerable(&plot, QStringLiteral("main")), m_plot(plot) {}

protected:
    void applyDefaultAntialiasingHint(QCPPainter* painter) const override {
        applyAntialiasingHint(painter, false, QCP::aeOther);
    }
    void draw(QCPPainter* painter) override {
        const bool onScreen = !painter->modes().testFlag(QCPPainter::pmNoCaching);
        if (onScreen && m_plot.visibleRegion().isEmpty()) {
            m_plot.m_stale = true; // Qt Charts is slow
            return;
        }
        m_plot.m_drawing.paint(*painter, m_plot.viewport().size());
        const auto& parts = m_plot.m_drawing.parts();
        const auto chosen = static_cast<std::size_t>(m_plot.m_chosen);
        if (m_plot.m_chosen >= 0 && chosen < parts.size() && onScreen && m_plot.hasFocus()) {
            painter->setPen(QPen(m_plot.palette().color(QPalette::Highlight), 2));
            painter->setBrush(Qt::NoBrush);
            parts[chosen].slice.isEmpty()
                ? painter->drawRect(parts[chosen].rect.adjusted(-2, -2, 2, 2))
                : painter->drawPath(parts[chosen].slice);
        }
    }

private:
    BarPlot& m_plot;
};

BarPlot::BarPlot(QWidget* parent) : ViewPlot(parent) {
    new Layer(*this);
    built();
}

BarPlot::~BarPlot() = default;

void BarPlot::setChart(BarChart chart) {
    m_drawing.setChart(std::move(chart));
    m_chosen = m_pressed = -1;
    showChoice();
    emit contentChanged();
}

bool BarPlot::shows(std::size_t series) const {
    return ViewPlot::shows(static_cast<int>(series));
}

PlotTools& BarPlot::addTools(PlotSubject subject, Settings* settings) {
    PlotTools& tools = ViewPlot::addTools(std::move(subject), settings);
    for (QAction* action : {tools.fit, tools.back, tools.forward}) {
        action->setVisible(false);
    }
    return tools;
}

// --- displayed chart ----------------------------------------------------------------------------

void BarPlot::showChoice() {
    std::vector<bool> shown;
    for (std::size_t i = 0; i < chart().series.size(); ++i) {
        shown.push_back(shows(i));
    }
    m_drawing.setShown(std::move(shown));
}

LegendEntries BarPlot::legendEntries() const {
    return chart().legend(palette(), isDimmed(), [this](std::size_t i) { return shows(i); });
}

/// Lines and bands cannot be chosen.
LegendEntries BarPlot::besides(int) const {
    LegendEntries entries = legendEntries();
    std::erase_if(entries, [](const LegendEntry& entry) { return entry.key < 0; });
    return entries;
}

CsvTable BarPlot::table() const {
    return chart().table([this](std::size_t i) { return shows(i); });
}

void BarPlot::restyle() {
    ViewPlot::restyle();
    m_drawing.setLook({palette(), font(), isDimmed()});
}

// --- mouse and keyboard -------------------------------------------------------------------------

QString BarPlot::describedAt(int part) const {
    if (part < 0 || part >= static_cast<int>(m_drawing.parts().size())) {
        return {};
    }
    return described(m_drawing.parts()[static_cast<std::size_t>(part)]);
}

QString BarPlot::described(const BarPart& part) const {
    return chart().described(part.series, part.category);
}

QString BarPlot::valuesAt(const QPointF& at) const {
    return describedAt(m_drawing.partAt(at));
}

void BarPlot::onMouse(QMouseEvent* event) {
    ViewPlot::onMouse(event);
    const int part = m_drawing.partAt(event->position());
    part >= 0 && m_leads ? setCursor(Qt::PointingHandCursor) : unsetCursor();
    setToolTip(describedAt(part));
}

void BarPlot::pointAway() {
    setToolTip({});
    ViewPlot::pointAway();
}

void BarPlot::paintEvent(QPaintEvent* event) {
    if (std::exchange(m_stale, false)) {
        replot(rpQueuedReplot);
    }
    ViewPlot::paintEvent(event);
}

/// Leaves the wheel to the scrolling page.
void BarPlot::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

void BarPlot::mousePressEvent(QMouseEvent* event) {
    ViewPlot::mousePressEvent(event);
    m_pressed = event->button() == Qt::LeftButton ? m_drawing.partAt(event->position()) : -1;
}

void BarPlot::mouseReleaseEvent(QMouseEvent* event) {
    ViewPlot::mouseReleaseEvent(event);
    const int pressed = std::exchange(m_pressed, -1);
    if (pressed >= 0 && m_drawing.partAt(event->position()) == pressed) {
        enter(pressed);
    }
}

void BarPlot::enter(int part) {
    if (part >= 0 && part < static_cast<int>(m_drawing.parts().size())) {
        const BarPart of = m_drawing.parts()[static_cast<std::size_t>(part)];
        emit entered(of.series, of.category);
    }
}

void BarPlot::choose(int part) {
    m_chosen = part;
    const QString text = describedAt(part);
    emit pointed(text);
    setAccessibleDescription(text);
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
    replot(rpQueuedReplot);
}

bool BarPlot::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const bool isPlain = static_cast<QKeyEvent*>(event)->modifiers() == Qt::NoModifier;
        if (isPlain && (key == Qt::Key_Space || (key >= Qt::Key_Left && key <= Qt::Key_Down))) {
            event->accept(); // keys of the bars, not of the window
            return true;
        }
    }
    return ViewPlot::event(event);
}

void BarPlot::keyPressEvent(QKeyEvent* event) {
    const int parts = static_cast<int>(m_drawing.parts().size());
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Up: choose(std::max(m_chosen - 1, std::min(0, parts - 1))); return;
    case Qt::Key_Right:
    case Qt::Key_Down: choose(std::min(m_chosen + 1, parts - 1)); return;
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter: enter(m_chosen); return;
    default: ViewPlot::keyPressEvent(event);
    }
}

void BarPlot::focusInEvent(QFocusEvent* event) {
    ViewPlot::focusInEvent(event);
    const bool byKey =
        event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
    if (byKey && m_chosen < 0 && !m_drawing.parts().empty()) {
        choose(0);
    } else {
        replot(rpQueuedReplot);
    }
}

void BarPlot::focusOutEvent(QFocusEvent* event) {
    ViewPlot::focusOutEvent(event);
    replot(rpQueuedReplot);
}

} // namespace sparkout
