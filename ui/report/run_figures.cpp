// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/run_figures.h"

#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/gauge.h"
#include "core/project/part.h"
#include "core/quality/limit_series.h"
#include "core/simulation/feed_series.h"
#include "ui/kit/theme.h"
#include "ui/report/cell_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/views/cycle/feeds_plot.h"
#include "ui/views/part/profiles_plot.h"
#include "ui/views/part/profiles_text.h"
#include "ui/views/requirements/constraints_plot.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QPicture>

#include <algorithm>
#include <cmath>
#include <qcustomplot.h>

namespace sparkout::report {

namespace {

constexpr int plotFontPixels = 12;
constexpr int legendGap = 6;

QSize draw(QPicture& picture, QCustomPlot& plot, const LegendEntries& legend) {
    const auto rects = legendRects(legend, QFontMetrics(plot.font()), plot.width());
    const int top = legend.empty() ? 0 : legendHeight(rects) + legendGap;
    QCPPainter painter(&picture);
    painter.setModes(QCPPainter::pmNoCaching | QCPPainter::pmNonCosmetic
                     | QCPPainter::pmVectorized);
    painter.setFont(plot.font());
    for (std::size_t i = 0; i < legend.size(); ++i) {
        drawLegendEntry(painter, legend[i], rects[i], plot.palette().color(QPalette::Text));
    }
    painter.translate(0, top);
    plot.toPainter(&painter, plot.width(), plot.height());
    painter.end();
    return {plot.width(), plot.height() + top};
}

} // namespace

void setUpForPaper(QCustomPlot& plot, int height) {
    plot.setPalette(paletteOf(Theme::light));
    QFont font = plot.font();
    font.setPixelSize(plotFontPixels); // the same on every device
    plot.setFont(font);
    plot.resize(figureWidth, height);
}

Figure plotFigure(QCustomPlot& plot, const LegendEntries& legend, const QString& caption,
                  const QString& description) {
    plot.replot();
    QPicture picture;
    const QSize size = draw(picture, plot, legend);
    return {caption, description, size,
            [picture, dots = double(plot.logicalDpiX())](QPainter& painter) {
                // A picture is enlarged by the device's resolution.
                painter.scale(dots / painter.device()->logicalDpiX(),
                              dots / painter.device()->logicalDpiY());
                painter.drawPicture(0, 0, picture);
            }};
}

namespace {

constexpr int feedsHeight = 420, profilesHeight = 400, limitsHeight = 380;

struct RunFigures {
    Q_DECLARE_TR_FUNCTIONS(RunFigures)
};

} // namespace

std::optional<Figure> feedsFigure(const OutcomePtr& outcome) {
    return feedsFigure(outcome, 0, outcome->feeds.end_s, {},
                       RunFigures::tr("Feeds by stage over the whole cycle"));
}

std::optional<Figure> feedsFigure(const OutcomePtr& outcome, double from_s, double to_s,
                                  std::optional<double> moment_s, const QString& caption) {
    if (outcome->trajectory.passes.empty()) {
        return {};
    }
    const Project& project = outcome->result.project;
    const auto count = static_cast<int>(outcome->feeds.columns.size());
    FeedsPlot plot;
    setUpForPaper(plot, feedsHeight);
    plot.setRun(outcome,
                shownSections(count, project.operation->travels ? 0 : gaugeSection(project)));
    plot.restyle();
    plot.setMoment(moment_s);
    plot.showTimes(from_s, to_s);
    return plotFigure(plot, plot.legendEntries(), caption, caption);
}

Figure profilesFigure(const OutcomePtr& outcome) {
    const SimulationResult& result = outcome->result;
    const std::vector<int> shown =
        shownSections(static_cast<int>(result.sections.size()), gaugeProfile(result));
    ProfilesPlot plot;
    setUpForPaper(plot, profilesHeight);
    plot.setHidden({ProfileLine::blank});
    plot.setSeries(makeProfileSeries(result, outcome->trajectory), shown);
    plot.restyle();
    plot.fit();
    using enum ProfileLine;
    return plotFigure(plot, plot.entriesOf({profile, target, leastSquares, field}),
                      RunFigures::tr("Cross-sections at the end of the cycle"),
                      ProfilesText::summary(plot.series(), plot.shown()));
}

std::optional<Figure> limitsFigure(const OutcomePtr& outcome, const Place& at) {
    const int group = limitGroupAt(outcome->limits, at);
    if (group < 0) {
        return {};
    }
    ConstraintsPlot plot;
    setUpForPaper(plot, limitsHeight);
    plot.setRun(outcome, group);
    plot.restyle();
    plot.fit();
    if (plot.limits().cuts()->cuts.empty()) {
        return {};
    }
    const QString caption = RunFigures::tr("%1: actual feed over the stock left, under its limits")
                                .arg(Names::zoneFull(at.zone, at.section));
    return plotFigure(plot, plot.legendEntries(), caption, caption);
}

namespace {

constexpr QSizeF sketchSize(820, 236);
constexpr double left = 80, right = 740, axis = 106, mostHalf = 46, leastHalf = 14;
constexpr double zoneLine = 34, lengthLine = 206, wholeLine = 230;
constexpr double arrow = 7, centre = 26, wallWidth = 10;
constexpr double supportName = axis + mostHalf + 22; ///< below the body
constexpr int fontPixels = 12;
constexpr double betweenNames = 8; ///< distance between the names of a row
constexpr QColor ink(0, 0, 0), faint(110, 110, 110), paperWhite(255, 255, 255),
    bodyGrey(225, 230, 236), ground(190, 205, 222);

struct Sketch {
    Q_DECLARE_TR_FUNCTIONS(PartSketch)
public:
    static QString length(double value_mm) { return tr("%1 mm").arg(printedNumber(value_mm, 6)); }
    static QString description(const Outcome& outcome);
    static QString headstock() { return tr("headstock"); }
    static QString tailstock() { return tr("tailstock"); }
    static QString gauge() { return tr("gauge"); }
    static QString caption() { return tr("Sketch of the part, not to scale across"); }
};

struct Stretch {
    double from_mm, to_mm; ///< along the ground length
    QString name;
};

std::vector<Stretch> stretches(const Outcome& outcome) {
    const auto ends = groundStretches(outcome.result.project);
    const auto& sections = outcome.result.sections;
    std::vector<Stretch> all;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const Zone zone = sections[i].zone;
        all.push_back({ends[i].from_mm, ends[i].to_mm,
                       zone == Zone::section ? QString::number(i + 1) : Names::zone(zone)});
    }
    return all;
}

double gaugePlace(const Outcome& outcome) {
    const Project& project = outcome.result.project;
    const auto section = static_cast<std::size_t>(gaugeSection(project));
    return project.gauge->position_mm ? *project.gauge->position_mm
                                      : outcome.result.sections.at(section).position_mm;
}

QString Sketch::description(const Outcome& outcome) {
    const Part& part = *outcome.result.project.part;
    QStringList parts{tr("ground diameter %1").arg(length(part.diameter_mm)),
                      tr("ground length %1").arg(length(part.length_mm))};
    for (const Stretch& s : stretches(outcome)) {
        parts << tr("%1: %2 to %3", "zone or section, from, to")
                     .arg(s.name, length(s.from_mm), length(s.to_mm));
    }
    if (outcome.result.project.gauge->control == Control::gauge) {
        parts << tr("gauge at %1").arg(length(gaugePlace(outcome)));
    }
    return parts.join(QStringLiteral("; "));
}

/// Draws along x to scale, across not.
class Drawing {
public:
    Drawing(QPainter& painter, const Outcome& outcome);
    void paint();

private:
    [[nodiscard]] double x(double along_mm) const { ///< from the headstock end of the part
        return left + (right - left) * along_mm / m_whole_mm;
    }
    [[nodiscard]] double half(double diameter_mm) const {
        return std::max(leastHalf, mostHalf * diameter_mm / m_largest_mm);
    }
    [[nodiscard]] double widthOf(const QString& text) const {
        return QFontMetricsF(m_painter.font()).horizontalAdvance(text);
    }
    /// Returns where it ends.
    double text(const QPointF& middle, const QString& text);
    /// Places a text as near to its position as two names in the same row allow.
    void textBetween(double from, double to, const QPointF& middle, const QString& text);
    void dimension(double from, double to, double y, const QString& name);
    void drawBody();
    void drawBore();
    void drawSupports();
    void drawStretches();
    void drawGauge();
    void drawDimensions();

    QPainter& m_painter;
    const Outcome& m_outcome;
    const Part& m_part;
    double m_from_mm = 0; ///< beginning of the ground length
    double m_whole_mm;
    double m_largest_mm;
    double m_headstockTo = 0, m_tailstockFrom = sketchSize.width(); ///< their names
};

Drawing::Drawing(QPainter& painter, const Outcome& outcome)
    : m_painter(painter)
    , m_outcome(outcome)
    , m_part(*outcome.result.project.part)
    , m_whole_mm(m_part.length_mm)
    , m_largest_mm(m_part.diameter_mm) {
    if (!m_part.shaft.segments.empty() && m_part.surface == Surface::external) {
        double sum = 0;
        for (const ShaftSegment& s : m_part.shaft.segments) {
            sum += s.length_mm;
            m_largest_mm = std::max(m_largest_mm, s.diameter_mm);
        }
        m_from_mm = m_part.shaft.ground_from_mm;
        m_whole_mm = std::max(sum, m_from_mm + m_part.length_mm);
    }
}

double Drawing::text(const QPointF& middle, const QString& text) {
    const double width = widthOf(text);
    const double from = std::clamp(middle.x() - width / 2, 2.0, sketchSize.width() - width - 2);
    m_painter.setPen(ink);
    m_painter.drawText(QPointF(from, middle.y()), text);
    return from + width;
}

void Drawing::textBetween(double from, double to, const QPointF& middle, const QString& text) {
    const double half = widthOf(text) / 2 + betweenNames;
    const double at = std::max(from + half, std::min(middle.x(), to - half));
    this->text({at, middle.y()}, text);
}

void Drawing::dimension(double from, double to, double y, const QString& name) {
    m_painter.setPen(QPen(faint, 0.8));
    m_painter.drawLine(QPointF(from, y), QPointF(to, y));
    for (const auto& [tip, side] : {std::pair(from, 1.0), std::pair(to, -1.0)}) {
        m_painter.drawLine(QPointF(tip, y), QPointF(tip + side * arrow, y - arrow / 2.5));
        m_painter.drawLine(QPointF(tip, y), QPointF(tip + side * arrow, y + arrow / 2.5));
    }
    text({(from + to) / 2, y - 4}, name);
}

void Drawing::drawBody() {
    m_painter.setPen(QPen(ink, 1.2));
    double at = 0;
    for (const ShaftSegment& s : m_part.shaft.segments) {
        m_painter.setBrush(bodyGrey);
        const double h = half(s.diameter_mm);
        m_painter.drawRect(
            QRectF(QPointF(x(at), axis - h), QPointF(x(at + s.length_mm), axis + h)));
        at += s.length_mm;
    }
    m_painter.setBrush(ground);
    const double h = half(m_part.diameter_mm);
    m_painter.drawRect(QRectF(QPointF(x(m_from_mm), axis - h),
                              QPointF(x(m_from_mm + m_part.length_mm), axis + h)));
}

/// A bore in section: its outer form is not an input.
void Drawing::drawBore() {
    const double inner = mostHalf - 14;
    for (const double side : {-1.0, 1.0}) {
        const QRectF wall =
            QRectF(QPointF(left, axis + side * inner), QPointF(right, axis + side * mostHalf))
                .normalized();
        m_painter.fillRect(wall, bodyGrey);
        m_painter.setPen(QPen(faint, 0.6));
        for (double at = wall.left(); at + wall.height() < wall.right(); at += 10) {
            m_painter.drawLine(QPointF(at, wall.bottom()), QPointF(at + wall.height(), wall.top()));
        }
        m_painter.setPen(QPen(ink, 1.6));
        m_painter.drawLine(QPointF(left, axis + side * inner), QPointF(right, axis + side * inner));
    }
}

void Drawing::drawSupports() {
    const bool bore = m_part.surface == Surface::internal;
    const bool chuck = bore || m_part.shaft.mounting == Mounting::chuck;
    m_painter.setPen(QPen(ink, 1));
    m_painter.setBrush(paperWhite);
    if (chuck) {
        m_painter.drawRect(QRectF(left - centre, axis - mostHalf - 8, centre, 2 * mostHalf + 16));
    } else {
        m_painter.drawPolygon(QPolygonF{QPointF(left, axis), QPointF(left - centre, axis - 10),
                                        QPointF(left - centre, axis + 10)});
        m_painter.drawPolygon(QPolygonF{QPointF(right, axis), QPointF(right + centre, axis - 10),
                                        QPointF(right + centre, axis + 10)});
        m_tailstockFrom =
            text({right + centre, supportName}, Sketch::tailstock()) - widthOf(Sketch::tailstock());
    }
    if (bore && m_part.blind_bore) {
        m_painter.setBrush(bodyGrey);
        m_painter.drawRect(QRectF(left - wallWidth, axis - mostHalf, wallWidth, 2 * mostHalf));
    }
    m_headstockTo = text({left - centre, supportName}, Sketch::headstock());
    for (const SteadyRest& rest : m_part.shaft.steady_rests) {
        const double at = x(rest.position_mm);
        m_painter.setPen(QPen(ink, 1));
        m_painter.setBrush(paperWhite);
        m_painter.drawPolygon(QPolygonF{QPointF(at, axis + mostHalf),
                                        QPointF(at - 8, axis + mostHalf + 14),
                                        QPointF(at + 8, axis + mostHalf + 14)});
    }
}

void Drawing::drawStretches() {
    const std::vector<Stretch> all = stretches(m_outcome);
    double nameEnd = 0; // names that do not fit are left out
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double from = x(m_from_mm + all[i].from_mm);
        const double to = x(m_from_mm + all[i].to_mm);
        m_painter.setPen(QPen(faint, 0.8, Qt::DashLine));
        for (const double at : {from, to}) { // below the names, which may be wider than a section
            m_painter.drawLine(QPointF(at, zoneLine + 18), QPointF(at, axis + mostHalf));
        }
        const double middle = (from + to) / 2;
        if (middle - widthOf(all[i].name) / 2 > nameEnd + betweenNames / 2) {
            nameEnd = text({middle, zoneLine + 14}, all[i].name);
        }
    }
}

void Drawing::drawGauge() {
    if (m_outcome.result.project.gauge->control != Control::gauge) {
        return;
    }
    const double at = x(m_from_mm + gaugePlace(m_outcome));
    const double bottom = axis + mostHalf + 4;
    m_painter.setPen(QPen(ink, 1.6));
    m_painter.drawLine(QPointF(at, bottom), QPointF(at, bottom + 10));
    m_painter.setBrush(ink);
    m_painter.drawPolygon(QPolygonF{QPointF(at, bottom - 4), QPointF(at - 4, bottom + 4),
                                    QPointF(at + 4, bottom + 4)});
    textBetween(m_headstockTo, m_tailstockFrom, {at, bottom + 22}, Sketch::gauge());
}

void Drawing::drawDimensions() {
    const double from = x(m_from_mm);
    const double to = x(m_from_mm + m_part.length_mm);
    dimension(from, to, lengthLine, Sketch::length(m_part.length_mm));
    if (m_whole_mm > m_part.length_mm) {
        dimension(left, right, wholeLine, Sketch::length(m_whole_mm));
    }
    text({(from + to) / 2, zoneLine - 12}, // with its deviations as on a drawing
         drawnSize(m_part));
}

void Drawing::paint() {
    QFont font;
    font.setPixelSize(fontPixels);
    m_painter.setFont(font);
    m_part.surface == Surface::internal ? drawBore() : drawBody();
    m_painter.setPen(QPen(faint, 0.8, Qt::DashDotLine));
    m_painter.drawLine(QPointF(left - centre, axis), QPointF(right + centre, axis));
    drawSupports();
    drawStretches();
    drawGauge();
    drawDimensions();
}

} // namespace

Figure partSketch(const OutcomePtr& outcome) {
    return {Sketch::caption(), Sketch::description(*outcome), sketchSize,
            [outcome](QPainter& painter) { Drawing(painter, *outcome).paint(); }};
}

} // namespace sparkout::report
