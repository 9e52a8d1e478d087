// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/view_plot.h"

#include "ui/chart/plot_cursors.h"
#include "ui/chart/plot_tools.h"
#include "ui/kit/font_size.h"
#include "ui/kit/theme.h"

#include <QApplication>
#include <QEvent>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace sparkout::style {

bool isDark(const QPalette& palette) {
    return sparkout::isDark(palette);
}

QColor dimmed(QColor colour, bool dim) {
    if (dim) {
        colour.setAlphaF(colour.alphaF() * 0.35F);
    }
    return colour;
}

QColor thinned(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

QColor filling(QColor colour, int alpha, const QPalette& palette) {
    const bool isContrast = coloursFor(palette).theme == Theme::contrast;
    return thinned(colour, isContrast ? 8 * alpha / 5 : alpha); // more would hide the curves
}

void setUpAxis(QCPAxis& axis) {
    axis.setLayer(QStringLiteral("axes"));
    axis.grid()->setLayer(QStringLiteral("grid"));
    axis.setNumberFormat(QStringLiteral("g"));
    axis.setNumberPrecision(6);
    axis.setSubTicks(false);
    axis.setTicker(QSharedPointer<NumberTicker>::create());
}

void setLogarithmic(QCPAxis& axis, bool on) {
    axis.setScaleType(on ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    axis.setTicker(on ? QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog)
                      : QSharedPointer<QCPAxisTicker>(new NumberTicker));
}

void applyPalette(QCPAxis& axis, const QPalette& palette) {
    const QColor text = palette.color(QPalette::Text);
    const QColor line = thinned(text, 150);
    axis.setBasePen(line);
    axis.setTickPen(line);
    axis.setSubTickPen(line);
    axis.setTickLabelColor(text);
    axis.setLabelColor(text);
    const QColor grid = thinned(text, 35);
    axis.grid()->setPen(QPen(grid, 0));
    axis.grid()->setSubGridVisible(false);
    axis.grid()->setZeroLinePen(QPen(line, 0));
}

QList<QCPAxis*> axesOf(const QCPAxisRect& rect) {
    return rect.axes(QCPAxis::atLeft | QCPAxis::atRight | QCPAxis::atTop | QCPAxis::atBottom);
}

void applyPalette(QCustomPlot& plot, const QPalette& palette) {
    plot.setBackground(palette.brush(QPalette::Base));
    for (QCPAxisRect* rect : plot.axisRects()) {
        for (QCPAxis* axis : axesOf(*rect)) {
            applyPalette(*axis, palette);
        }
    }
}

int ticksWithRoom(int height, const QFont& font) {
    constexpr int least = 2, usual = 5;
    constexpr double lines = 1.4; // height of a tick label with spacing, in lines
    return std::clamp(static_cast<int>(height / (lines * QFontMetrics(font).height())), least,
                      usual);
}

bool fitValueAxes(QCPAxisRect& rect, const QFont& font) {
    constexpr double least = 0.6; // least share of the usual size
    constexpr int air = 6;        // space beyond the plot, before a neighbour's label
    bool changed = false;
    const auto fit = [&](QCPAxis& axis, int room) {
        int need = 1;
        for (const QString& line : axis.label().split(u'\n')) {
            need = std::max(need, QFontMetrics(font).horizontalAdvance(line));
        }
        const double times = double(room) / need;
        const QFont own = times < 1 ? enlarged(font, std::max(times, least)) : font;
        if (axis.labelFont() != own) {
            axis.setLabelFont(own);
            changed = true;
        }
    };
    const QRect all = rect.outerRect(); // a label is centred on its axis
    const int centre = rect.center().x();
    for (QCPAxis* axis : rect.axes(QCPAxis::atBottom)) {
        fit(*axis, 2 * std::min(centre - all.left(), all.right() - centre) - air);
    }
    for (QCPAxis* axis : rect.axes(QCPAxis::atLeft | QCPAxis::atRight)) {
        fit(*axis, rect.height() + air);
        const int count = ticksWithRoom(rect.height(), font);
        changed = changed || axis->ticker()->tickCount() != count;
        axis->ticker()->setTickCount(count);
    }
    return changed;
}

void setSafeRange(QCPAxis& axis, double low, double high) {
    if (!std::isfinite(low) || !std::isfinite(high) || low > high) {
        return;
    }
    const double least = std::max({std::abs(low), std::abs(high), 1e-6}) * 1e-9;
    if (high - low < least) {
        low -= least;
        high += least;
    }
    axis.setRange(low, high);
}

void setRoomyRange(QCPAxis& axis, double low, double high, double room, double leastRoom) {
    const double least = std::max({std::abs(low), std::abs(high), 1e-3}) * leastRoom;
    const double beside = std::max(room * (high - low), least);
    setSafeRange(axis, low - beside, high + beside);
}

} // namespace sparkout::style

namespace sparkout {

void PlotHistory::restart(State state) {
    m_states.assign(1, std::move(state));
    m_at = 0;
    m_gesture = 0;
}

void PlotHistory::visit(State state, int gesture) {
    if (state == m_states[m_at]) {
        return;
    }
    m_states.resize(m_at + 1);
    if (gesture > 0 && gesture == m_gesture) {
        m_states[m_at] = std::move(state);
        return;
    }
    m_gesture = gesture;
    m_states.push_back(std::move(state));
    if (m_states.size() > mostStates) {
        m_states.erase(m_states.begin());
    }
    m_at = m_states.size() - 1;
}

void PlotHistory::amend(State state) {
    m_states[m_at] = std::move(state);
    m_gesture = 0;
}

const PlotHistory::State& PlotHistory::back() {
    m_gesture = 0;
    return m_states[--m_at];
}

const PlotHistory::State& PlotHistory::forward() {
    m_gesture = 0;
    return m_states[++m_at];
}

namespace {

QLocale plainNumbers() {
    QLocale numbers;
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    return numbers;
}

} // namespace

ViewPlot::ViewPlot(QWidget* parent) : QCustomPlot(parent) {
    setNotAntialiasedElements(QCP::aeFills | QCP::aeGrid | QCP::aeAxes);
    setAutoAddPlottableToLegend(false);
    plotLayout()->clear();
    addLayer(QStringLiteral("bands"), layer(QStringLiteral("background")), QCustomPlot::limAbove);
    setLocale(plainNumbers());
}

void ViewPlot::built() {
    restyle();
    retranslate();
    setBuilt();
}

void ViewPlot::setDimmed(bool dim) {
    if (m_dim != dim) {
        m_dim = dim;
        if (m_built) {
            restyle();
            emit contentChanged();
            replot(rpQueuedReplot);
        }
    }
}

void ViewPlot::retranslate() {
    setLocale(plainNumbers());
    setTexts();
    if (m_tools) {
        m_tools->retranslate();
    }
}

void ViewPlot::restyle() {
    style::applyPalette(*this, palette());
    for (const QCPAxisRect* rect : axisRects()) {
        for (QCPAxis* axis : style::axesOf(*rect)) {
            axis->setTickLabelFont(font());
            axis->setLabelFont(font());
        }
    }
}

QColor ViewPlot::toned(style::Drawn what) const {
    return style::dimmed(style::colour(what, palette()), m_dim);
}

QColor ViewPlot::toned(Tone tone) const {
    return style::dimmed(sparkout::tone(tone, palette()), m_dim);
}

QColor ViewPlot::ink() const {
    return style::dimmed(palette().color(QPalette::Text), m_dim);
}

// --- parts --------------------------------------------------------------------------------------

QCPAxisRect* ViewPlot::addRect(int row, int column, QCPLayoutGrid* into) {
    auto* const rect = new QCPAxisRect(this, true);
    (into ? into : plotLayout())->addElement(row, column, rect);
    for (QCPAxis* axis : style::axesOf(*rect)) {
        style::setUpAxis(*axis);
    }
    return rect;
}

QCPAxisRect* ViewPlot::addCell(int row) {
    QCPAxisRect* const rect = addRect(row);
    for (const auto side : {QCPAxis::atTop, QCPAxis::atRight}) {
        rect->axis(side)->setVisible(true);
        rect->axis(side)->setTicks(false);
    }
    return rect;
}

void ViewPlot::tie(const std::vector<QCPAxisRect*>& rects, QCPAxis::AxisType side) {
    for (const QCPAxisRect* rect : rects) {
        for (const QCPAxisRect* other : rects) {
            if (rect != other) { // terminates, since setting an equal range has no effect
                connect(rect->axis(side), QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged),
                        other->axis(side), qOverload<const QCPRange&>(&QCPAxis::setRange));
            }
        }
    }
}

void ViewPlot::anchor(std::initializer_list<QCPItemPosition*> points, QCPAxisRect& rect) {
    for (QCPItemPosition* point : points) {
        point->setAxisRect(&rect);
        point->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    }
}

QCPItemStraightLine* ViewPlot::addRule(QCPAxisRect& rect, double at, bool upright) {
    auto* const rule = new QCPItemStraightLine(this);
    anchor({rule->point1, rule->point2}, rect);
    rule->point1->setCoords(upright ? at : 0, upright ? 0 : at);
    rule->point2->setCoords(upright ? at : 1, upright ? 1 : at);
    rule->setClipAxisRect(&rect);
    return rule;
}

QCPGraph* ViewPlot::addLine(const QCPAxisRect& rect) {
    return addGraph(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
}

QCPCurve* ViewPlot::addCurve(const QCPAxisRect& rect) {
    return new QCPCurve(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
}

// --- tools --------------------------------------------------------------------------------------

PlotTools& ViewPlot::addTools(PlotSubject subject, Settings* settings) {
    subject.legend = [this] { return legendEntries(); };
    subject.table = [this] { return table(); };
    PlotNavigation::Hooks& hooks = subject.navigation;
    if (!hooks.fit) {
        hooks.fit = [this] { fit(); };
    }
    hooks.state = [this] { return visibleRange(); };
    hooks.setState = [this](const PlotHistory::State& state) { setVisibleRange(state); };
    hooks.axes = [this](QCPAxisRect& rect) { return movedAxes(rect); };
    m_tools = new PlotTools(*this, std::move(subject));
    m_tools->setSettings(settings);
    return *m_tools;
}

PlotCursors& ViewPlot::addCursors() {
    m_cursors = new PlotCursors(*this, cursorSubject());
    m_tools->addTool(m_cursors->toggle);
    return *m_cursors;
}

CursorSubject ViewPlot::cursorSubject() {
    return {[this] { return axisRects().last()->axis(QCPAxis::atBottom)->label(); },
            [this] { return readSpan(); },
            [this] { return readCurves(); },
            {},
            {}};
}

PlotHistory::State ViewPlot::visibleRange() const {
    return PlotNavigation::rangesOf(*this);
}

void ViewPlot::setVisibleRange(const PlotHistory::State& range) {
    PlotNavigation::setRanges(*this, range);
}

QList<QCPAxis*> ViewPlot::movedAxes(QCPAxisRect& rect) const {
    return {rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft)};
}

// --- legend and mouse ---------------------------------------------------------------------------

void ViewPlot::toggleCurve(int key) {
    m_choice.toggle(key);
    followChoice();
}

void ViewPlot::showOnly(int key) {
    m_choice.only(key, besides(key));
    followChoice();
}

void ViewPlot::followChoice() {
    showChoice();
    emit contentChanged();
    replot(rpQueuedReplot);
}

LegendEntry ViewPlot::lineEntry(int key, const QPen& pen, const QString& text) const {
    LegendEntry entry{pen.color(), pen.style(), text, key, shows(key)};
    entry.weight = pen.widthF();
    if (pen.style() == Qt::CustomDashLine) {
        entry.pen = Qt::SolidLine;
        entry.dash = pen.dashPattern();
    }
    return entry;
}

LegendEntry ViewPlot::areaEntry(int key, const QColor& colour, const QString& text) const {
    return {colour, Qt::NoPen, text, key, shows(key)};
}

void ViewPlot::onMouse(QMouseEvent* event) {
    emit pointed(valuesAt(event->position()));
}

void ViewPlot::onClick(std::function<void(const QPointF& at)> clicked) {
    auto pressed = std::make_shared<QPointF>();
    connect(this, &QCustomPlot::mousePress, this,
            [pressed](QMouseEvent* event) { *pressed = event->position(); });
    connect(this, &QCustomPlot::mouseRelease, this,
            [pressed, clicked = std::move(clicked)](QMouseEvent* event) {
                const QPointF moved = event->position() - *pressed;
                if (event->button() == Qt::LeftButton
                    && moved.manhattanLength() < QApplication::startDragDistance()) {
                    clicked(event->position());
                }
            });
}

void ViewPlot::pointAway() {
    emit pointed({});
}

void ViewPlot::mouseMoveEvent(QMouseEvent* event) {
    QCustomPlot::mouseMoveEvent(event);
    onMouse(event);
}

void ViewPlot::leaveEvent(QEvent* event) {
    QCustomPlot::leaveEvent(event);
    pointAway();
}

// --- look ---------------------------------------------------------------------------------------

void ViewPlot::takeLook(bool) {
    restyle();
}

// Here, since a parent receives a new palette before its children.
void ViewPlot::changeEvent(QEvent* event) {
    QCustomPlot::changeEvent(event);
    const bool font = event->type() == QEvent::FontChange;
    if (m_built && (font || event->type() == QEvent::PaletteChange)) {
        takeLook(font);
        emit contentChanged();
        replot(rpQueuedReplot);
    }
}

} // namespace sparkout
