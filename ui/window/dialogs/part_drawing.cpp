// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/part_drawing.h"

#include "core/project/part.h"
#include "core/quality/verdict.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/results/verdict_table.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>
#include <QToolTip>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

struct PieceTimeText {
    Q_DECLARE_TR_FUNCTIONS(PieceTimeText)
};

constexpr int timeTextDigits = 4;

QString shownTime(double value) {
    return printedNumber(value, timeTextDigits);
}

/// A short sum of seconds; the time itself is in minutes.
QString auxiliaryLine(const SetupTimes& times, std::size_t surfaces, const PieceTime& piece) {
    if (times.auxiliary_min) {
        return PieceTimeText::tr("T_a = %1 min, as given").arg(shownTime(piece.auxiliary_min));
    }
    return PieceTimeText::tr("T_a = n·(approach + retreat + gauging) + (n − 1)·positioning + "
                             "handling = %1·(%2 + %3 + %4) + %5·%6 + %7 s = %8 min")
        .arg(surfaces)
        .arg(shownTime(times.approach_s), shownTime(times.retreat_s), shownTime(times.gauging_s))
        .arg(surfaces - 1)
        .arg(shownTime(times.positioning_s), shownTime(times.handling_s),
             shownTime(piece.auxiliary_min));
}

struct StatusText {
    Q_DECLARE_TR_FUNCTIONS(StatusText)
};

} // namespace

QString pieceTimeText(const SetupTimes& times, std::size_t surfaces,
                      std::optional<double> cycles_min) {
    QStringList lines;
    const bool isMainKnown = times.main_min || cycles_min;
    const PieceTime piece = pieceTime(times, surfaces, cycles_min.value_or(0));
    if (times.main_min) {
        lines += PieceTimeText::tr("T_o = %1 min, as given").arg(shownTime(piece.main_min));
    } else if (cycles_min) {
        lines += PieceTimeText::tr("T_o = sum of the cycles = %1 min").arg(shownTime(*cycles_min));
    } else {
        lines += PieceTimeText::tr("T_o: not known, not every cycle ends at size");
    }
    if (!piece.isPieceEntered) {
        lines += PieceTimeText::tr("T_a is not entered, so no piece time is stated");
        return lines.join(u'\n');
    }
    lines += auxiliaryLine(times, surfaces, piece);
    if (times.piece_min) {
        lines += PieceTimeText::tr("T_1 = %1 min, as given").arg(shownTime(piece.piece_min));
    } else if (isMainKnown) {
        lines += PieceTimeText::tr("T_1 = (T_o + T_a)·(1 + service/100) = (%1 + %2)·(1 + %3/100) "
                                   "= %4 min")
                     .arg(shownTime(piece.main_min), shownTime(piece.auxiliary_min),
                          shownTime(times.service_percent), shownTime(piece.piece_min));
    }
    if (times.piece_min || isMainKnown) {
        lines += PieceTimeText::tr("T_1 + T_p/N = %1 + %2/%3 = %4 min")
                     .arg(shownTime(piece.piece_min), shownTime(times.preparation_min))
                     .arg(times.batch_size)
                     .arg(shownTime(piece.calculation_min));
    }
    return lines.join(u'\n');
}

QString statusText(const SurfaceStatus& status) {
    switch (status.state) {
    case SurfaceStatus::State::notRun: return StatusText::tr("not run");
    case SurfaceStatus::State::refused: return StatusText::tr("inputs refused");
    case SurfaceStatus::State::ran: break;
    }
    return JudgementText::headline(status.judgement);
}

QString worstText(const SurfaceStatus& status) {
    const std::optional<ConstraintResult>& worst = status.judgement.worst;
    if (!status.ran() || !worst) {
        return {};
    }
    const char* const unit = requirementOf(worst->kind).unit;
    const QString margin = Names::margin(*worst);
    return QStringLiteral("%1 %2").arg(
        Names::constraintBrief(worst->kind),
        *unit && !Names::isRange(worst->kind) && marginKnown(*worst) != MarginKnown::no
            ? QStringLiteral("%1\u00a0%2").arg(margin, unitText(unit))
            : margin);
}

QPixmap statusPixmap(const SurfaceStatus& status, int size, qreal ratio) {
    if (status.ran()) {
        return judgedPixmap(status.judgement.state, size, ratio, status.areStocksComing);
    }
    QPixmap pixmap(QSize(size, size) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette palette = QGuiApplication::palette();
    const QRectF box(2, 2, size - 4, size - 4);
    if (status.state == SurfaceStatus::State::refused) {
        painter.setPen(QPen(tone(Tone::error, palette), 2));
        painter.drawLine(box.topLeft(), box.bottomRight());
        painter.drawLine(box.topRight(), box.bottomLeft());
    } else {
        painter.setPen(QPen(palette.color(QPalette::PlaceholderText), 1));
        painter.drawEllipse(box);
    }
    return pixmap;
}

namespace {

constexpr double mostTakenOfStep = 0.5; ///< of a step that counts as free
constexpr double bushWall = 1.5; ///< ratio of diameter to bore for a bush without a given body

double commonLength_mm(const PartOutline::Step& a, const PartOutline::Step& b) {
    return std::min(a.to_mm(), b.to_mm()) - std::max(a.from_mm, b.from_mm);
}

} // namespace

PartOutline PartOutline::of(const SetupState& state) {
    PartOutline outline;
    double end_mm = 0, widest_mm = 0;
    for (const SurfaceStatePtr& surface : state.surfaces) {
        const Part& part = *surface->project.part;
        Ground ground;
        ground.from_mm = part.shaft.segments.empty() ? 0 : part.shaft.ground_from_mm;
        ground.length_mm = part.length_mm;
        ground.diameter_mm = part.diameter_mm;
        ground.isInternal = part.surface == Surface::internal;
        end_mm = std::max(end_mm, ground.to_mm());
        widest_mm = std::max(widest_mm, ground.diameter_mm * (ground.isInternal ? bushWall : 1));
        outline.surfaces.push_back(ground);
    }
    double at_mm = 0;
    for (const ShaftSegment& segment : state.inFront().project.part->shaft.segments) {
        outline.steps.push_back({at_mm, segment.length_mm, segment.diameter_mm});
        at_mm += segment.length_mm;
        outline.diameter_mm = std::max(outline.diameter_mm, segment.diameter_mm);
    }
    outline.hasSteps = !outline.steps.empty();
    if (!outline.hasSteps) {
        outline.steps.push_back({0, end_mm, widest_mm});
        at_mm = end_mm;
    }
    outline.diameter_mm = std::max(outline.diameter_mm, widest_mm);
    outline.length_mm = std::max(at_mm, end_mm);
    return outline;
}

std::optional<std::size_t> PartOutline::stepAt(double x_mm) const {
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (x_mm >= steps[i].from_mm && x_mm <= steps[i].to_mm()) {
            return i;
        }
    }
    return std::nullopt;
}

std::optional<std::size_t> PartOutline::surfaceAt(double x_mm) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const Ground& ground = surfaces[i];
        if (x_mm >= ground.from_mm && x_mm <= ground.to_mm()
            && (!found || ground.length_mm < surfaces[*found].length_mm)) {
            found = i;
        }
    }
    return found;
}

bool PartOutline::isFree(std::size_t step) const {
    return std::ranges::none_of(surfaces, [&](const Ground& ground) {
        return commonLength_mm(ground, steps[step]) > mostTakenOfStep * steps[step].length_mm;
    });
}

std::optional<std::size_t> PartOutline::firstFreeStep() const {
    for (std::size_t i = 0; hasSteps && i < steps.size(); ++i) {
        if (isFree(i)) {
            return i;
        }
    }
    return std::nullopt;
}

namespace {

constexpr int usualDrawingWidth = 200, leastDrawingWidth = 120, usualDrawingHeight = 46;
constexpr double thinLine = 1, boldLine = 3;

} // namespace

PartDrawing::PartDrawing(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

void PartDrawing::setOutline(PartOutline outline) {
    m_outline = std::move(outline);
    update();
}

void PartDrawing::setPresent(std::optional<std::size_t> surface) {
    m_present = surface;
    update();
}

void PartDrawing::setChosenStep(std::optional<std::size_t> step) {
    m_step = step;
    update();
}

void PartDrawing::setTips(QStringList tips) {
    m_tips = std::move(tips);
}

QSize PartDrawing::sizeHint() const {
    return {atFontSize(usualDrawingWidth), atFontSize(usualDrawingHeight)};
}

QSize PartDrawing::minimumSizeHint() const {
    return {leastDrawingWidth, atFontSize(usualDrawingHeight)};
}

/// The same along the part and across it; the numbers are above.
double PartDrawing::scale() const {
    const double width = std::max(1, this->width() - 2 * metrics::tight);
    const double height = std::max(1, this->height() - fontMetrics().height() - metrics::tight);
    return std::min(width / std::max(m_outline.length_mm, 1e-9),
                    height / std::max(m_outline.diameter_mm, 1e-9));
}

double PartDrawing::xOf(double place_mm) const {
    const double drawn = scale() * m_outline.length_mm;
    return (width() - drawn) / 2 + scale() * place_mm;
}

double PartDrawing::placeAt(double x) const {
    return (x - xOf(0)) / scale();
}

QRectF PartDrawing::box(const PartOutline::Step& step) const {
    const double axis =
        fontMetrics().height() + (height() - fontMetrics().height() - metrics::hair) / 2.0;
    const double across = scale() * step.diameter_mm;
    return {xOf(step.from_mm), axis - across / 2, scale() * step.length_mm, across};
}

void PartDrawing::drawBody(QPainter& painter) const {
    QColor line = palette().color(QPalette::WindowText);
    painter.setPen(QPen(line, thinLine));
    for (std::size_t i = 0; i < m_outline.steps.size(); ++i) {
        QColor fill = palette().color(QPalette::Highlight);
        fill.setAlphaF(0.35F);
        painter.setBrush(m_step == i ? QBrush(fill) : QBrush(palette().color(QPalette::Base)));
        painter.drawRect(box(m_outline.steps[i]));
    }
    line.setAlphaF(0.6F);
    painter.setPen(QPen(line, thinLine, Qt::DashDotLine));
    const double axis = box(m_outline.steps.front()).center().y();
    painter.drawLine(QPointF(xOf(0) - metrics::tight, axis),
                     QPointF(xOf(m_outline.length_mm) + metrics::tight, axis));
}

void PartDrawing::drawSurface(QPainter& painter, std::size_t surface) const {
    const QRectF place = box(m_outline.surfaces[surface]);
    if (m_present == surface) {
        QColor fill = palette().color(QPalette::Highlight);
        fill.setAlphaF(0.45F);
        painter.fillRect(place, fill);
    }
    painter.setPen(
        QPen(palette().color(m_present == surface ? QPalette::Highlight : QPalette::WindowText),
             boldLine, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(place.topLeft(), place.topRight());
    painter.drawLine(place.bottomLeft(), place.bottomRight());
}

/// Leaves out numbers that do not fit; the list beside the drawing has them all.
void PartDrawing::drawNumbers(QPainter& painter) const {
    const double body = scale() * m_outline.diameter_mm;
    const double axis = box(m_outline.steps.front()).center().y();
    const double top = std::max(0.0, axis - body / 2 - fontMetrics().height() - metrics::hair);
    std::vector<QRectF> taken;
    const auto draw = [&](std::size_t surface) {
        const QString number = QString::number(surface + 1);
        const QRectF place = box(m_outline.surfaces[surface]);
        const double width = fontMetrics().horizontalAdvance(number) + metrics::hair;
        const QRectF label(place.center().x() - width / 2, top, width, fontMetrics().height());
        if (std::ranges::any_of(taken,
                                [&](const QRectF& other) { return other.intersects(label); })) {
            return;
        }
        taken.push_back(label);
        QFont font = this->font();
        font.setBold(m_present == surface);
        painter.setFont(font);
        painter.drawText(label, Qt::AlignCenter | Qt::TextDontClip, number);
    };
    painter.setPen(palette().color(QPalette::WindowText));
    if (m_present) {
        draw(*m_present);
    }
    for (std::size_t i = 0; i < m_outline.surfaces.size(); ++i) {
        if (m_present != i) {
            draw(i);
        }
    }
}

void PartDrawing::paintEvent(QPaintEvent*) {
    if (m_outline.steps.empty()) {
        return;
    }
    QPainter painter(this);
    drawBody(painter);
    for (std::size_t i = 0; i < m_outline.surfaces.size(); ++i) {
        drawSurface(painter, i);
    }
    drawNumbers(painter);
}

void PartDrawing::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        QWidget::mousePressEvent(event);
        return;
    }
    const double place_mm = placeAt(event->position().x());
    if (const auto step = m_outline.stepAt(place_mm)) {
        emit stepClicked(*step);
    }
    if (const auto surface = m_outline.surfaceAt(place_mm)) {
        emit surfaceClicked(*surface);
    }
}

void PartDrawing::mouseDoubleClickEvent(QMouseEvent* event) {
    const auto step = m_outline.stepAt(placeAt(event->position().x()));
    if (event->button() == Qt::LeftButton && m_outline.hasSteps && step
        && m_outline.isFree(*step)) {
        emit freeStepEntered(*step);
    } else {
        mousePressEvent(event);
    }
}

bool PartDrawing::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto surface = m_outline.surfaceAt(placeAt(help->pos().x()));
        const QString tip = surface ? m_tips.value(static_cast<qsizetype>(*surface)) : QString();
        tip.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), tip, this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace sparkout
