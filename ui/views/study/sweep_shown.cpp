// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/sweep_shown.h"

#include "core/project/sweep.h"
#include "core/quality/constraints.h"
#include "ui/chart/plot_view.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

constexpr int mostNamed = 3; ///< requirements named at a point
constexpr int sweepDigits = 4;

QString withUnit(const QString& text, const std::string& unit, const QString& between) {
    return unit.empty() ? text : text + between + unitText(unit.c_str());
}

QString amount(double value, const std::string& unit) {
    return withUnit(Names::significant(value, sweepDigits), unit, QStringLiteral("\u00a0"));
}

} // namespace

/// The page, list item and input of a path, without the levels between them.
QString SweepText::input(const std::string& path) {
    const QStringList words = locationText(path).split(QStringLiteral(" › "));
    QStringList kept;
    for (const QString& word : words) {
        if (&word == &words.front() || &word == &words.back() || word.back().isDigit()) {
            kept << word;
        }
    }
    if (path.starts_with("/cycle/stages/")) {
        kept.removeFirst();
    }
    return kept.join(QStringLiteral(" › "));
}

QString SweepText::inputBrief(const std::string& path) {
    const QStringList words = locationText(path).split(QStringLiteral(" › "));
    const bool stage = path.starts_with("/cycle/stages/") && words.size() > 1;
    const bool part = path.starts_with("/machine/") && words.size() > 2;
    return stage || part ? words.mid(words.size() - 2).join(QStringLiteral(" › ")) : words.last();
}

QString SweepText::inputAxis(const SweptInput& input) {
    return withUnit(inputBrief(input.axis.input), input.unit, QStringLiteral(", "));
}

QString SweepText::inputValue(double value, const SweptInput& input) {
    return withUnit(printedNumber(ShownScale::at(input.axis.input).shown(value)), input.unit,
                    QStringLiteral(" "));
}

QString SweepText::name(const SweepQuantity& quantity) {
    if (const Requirement* const row = requirementNamed(quantity.name)) {
        return Names::constraint(row->kind);
    }
    return quantity.name == "time"                ? tr("Machining time")
           : quantity.name == "least_margin"      ? tr("Minimum margin of all requirements")
           : quantity.name == "diameter"          ? tr("Mean diameter")
           : quantity.name == "peak_normal_force" ? tr("Maximum normal force")
                                                  : tr("Maximum power");
}

QString SweepText::where(const SweepQuantity& quantity) {
    return quantity.section < 0 ? tr("whole part") : Names::zone(quantity.zone, quantity.section);
}

QString SweepText::entry(const SweepResult& sweep, const SweepEntry& entry) {
    const SweepQuantity& first = sweep.quantities[entry.quantities.front()];
    return entry.key == first.name || first.section < 0
               ? name(first)
               : QStringLiteral("%1, %2").arg(name(first), Names::within(where(first)));
}

QString SweepText::axis(const SweepResult& sweep, const SweepEntry& entry, bool margins) {
    const QString of = SweepText::entry(sweep, entry);
    return withUnit(margins ? tr("Margin: %1").arg(of) : of,
                    sweep.quantities[entry.quantities.front()].unit, QStringLiteral(", "));
}

QString SweepText::column(const SweepQuantity& quantity) {
    const QString of = quantity.section < 0
                           ? name(quantity)
                           : QStringLiteral("%1, %2").arg(name(quantity), where(quantity));
    return withUnit(of, quantity.unit, QStringLiteral(", "));
}

QString SweepText::status(const SweepPoint& point) {
    switch (point.status) {
    case SweepStatus::pending: return tr("not run");
    case SweepStatus::refused: return tr("refused");
    case SweepStatus::notReached: return tr("does not reach size");
    case SweepStatus::done: break;
    }
    return point.good ? tr("fit") : tr("unfit");
}

QString SweepText::progress(qint64 done, qint64 points, double left_s) {
    return RunBar::withTimeLeft(tr("%1 of %2 points").arg(done).arg(points), left_s);
}

QString SweepText::run(const SweepResult& sweep) {
    const auto count = [&sweep](SweepStatus status) {
        return static_cast<int>(std::ranges::count(sweep.points, status, &SweepPoint::status));
    };
    const int good = static_cast<int>(std::ranges::count(sweep.points, true, &SweepPoint::good));
    const int all = static_cast<int>(sweep.points.size());
    QStringList texts;
    if (sweep.stopped) {
        texts
            << tr("Stopped after %1 of %2 points.").arg(all - count(SweepStatus::pending)).arg(all);
    }
    texts << tr("%1 of %2 points meet the drawing.").arg(good).arg(all);
    if (const int refused = count(SweepStatus::refused)) {
        texts << tr("Refused: %1.").arg(refused);
    }
    if (const int stuck = count(SweepStatus::notReached)) {
        texts << tr("Size not reached: %1.").arg(stuck);
    }
    return texts.join(u' ');
}

QString SweepText::inputs(const SweepResult& sweep, std::size_t point) {
    QStringList texts;
    const std::vector<double> values = sweep.valuesAt(point);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const SweptInput& input = sweep.inputs[i];
        texts << inputBrief(input.axis.input) + u' ' + inputValue(values[i], input);
    }
    return texts.join(QStringLiteral(", "));
}

/// Whether the drawing is met, and what violates it.
QString SweepText::verdict(const SweepResult& sweep, const SweepPoint& point) {
    if (point.good) {
        return tr("all requirements are met");
    }
    QStringList failing;
    for (std::size_t q = 0; q < sweep.quantities.size(); ++q) {
        const SweepQuantity& quantity = sweep.quantities[q];
        if (requirementNamed(quantity.name) && point.values[q].margin < 0) {
            failing << (quantity.section < 0 ? name(quantity)
                                             : name(quantity) + u' ' + where(quantity));
        }
    }
    const bool more = failing.size() > mostNamed;
    return tr("not met: %1")
        .arg(failing.mid(0, mostNamed).join(QStringLiteral(", "))
             + (more ? QStringLiteral(" …") : QString()));
}

QString SweepText::point(const SweepResult& sweep, std::size_t point, const SweepEntry& entry) {
    const SweepPoint& at = sweep.points[point];
    const QString inputs = SweepText::inputs(sweep, point);
    switch (at.status) {
    case SweepStatus::pending: return tr("%1: not run").arg(inputs);
    case SweepStatus::refused:
        return tr("%1: refused. %2").arg(inputs, Names::refusal(at.issues, 1));
    case SweepStatus::notReached: return tr("%1: %2").arg(inputs, Names::status(at.run));
    case SweepStatus::done: break;
    }
    QStringList texts;
    for (const std::size_t q : entry.quantities) {
        const SweepValue& value = at.values[q];
        const SweepQuantity& quantity = sweep.quantities[q];
        if (std::isnan(value.value) || quantity.name == "time") {
            continue;
        }
        QString text = (entry.quantities.size() > 1 ? where(quantity) + u' ' : QString())
                       + amount(value.value, quantity.unit);
        if (!std::isnan(value.margin) && quantity.name != "least_margin") {
            text += tr(" (margin %1)").arg(Names::significant(value.margin, 3));
        }
        texts << text;
    }
    QString shown = texts.join(QStringLiteral(", "));
    shown = shown.isEmpty() ? QString() : SweepText::entry(sweep, entry) + u' ' + shown + u';';
    for (std::size_t q = 0; q < sweep.quantities.size(); ++q) {
        if (sweep.quantities[q].name == "time") {
            shown += tr(" time %1;").arg(amount(at.values[q].value, "s"));
        }
    }
    return QStringLiteral("%1: %2 %3").arg(inputs, shown.trimmed(), verdict(sweep, at));
}

namespace {

constexpr double fewDecades = 1.2, manyDecades = 4; ///< with ticks at 1, 2, 5, 10
constexpr double mostDecades = 300;

} // namespace

QVector<double> SweepTicker::createTickVector(double step, const QCPRange& range) {
    if (!m_scale.ratios || range.size() > mostDecades) {
        return QCPAxisTicker::createTickVector(step, range);
    }
    QVector<double> ticks;
    if (range.size() < fewDecades) {
        const QCPRange values(m_scale.valueAt(range.lower), m_scale.valueAt(range.upper));
        for (const double value : QCPAxisTicker::createTickVector(getTickStep(values), values)) {
            if (value > 0) {
                ticks << m_scale.at(value);
            }
        }
        return ticks;
    }
    for (double decade = std::floor(range.lower); decade <= range.upper; ++decade) {
        ticks << decade;
        if (range.size() < manyDecades) {
            ticks << decade + std::log10(2) << decade + std::log10(5);
        }
    }
    return ticks;
}

QString SweepTicker::getTickLabel(double tick, const QLocale& locale, QChar format, int precision) {
    return NumberTicker::getTickLabel(m_scale.shown.shown(m_scale.valueAt(tick)), locale, format,
                                      precision);
}

SweepScale SweepShown::scaleOf(std::size_t input) const {
    const SweepAxis& axis = result->inputs[input].axis;
    return {axis.spacing == SweepSpacing::logarithmic, ShownScale::at(axis.input)};
}

std::vector<double> SweepShown::placesOf(std::size_t input) const {
    const SweepScale scale = scaleOf(input);
    std::vector<double> places;
    for (const double value : result->inputs[input].values) {
        places.push_back(scale.at(value));
    }
    return places;
}

double SweepShown::placeOf(std::size_t point, std::size_t input) const {
    return scaleOf(input).at(result->valuesAt(point)[input]);
}

std::optional<double> SweepShown::presentPlace(std::size_t input) const {
    if (input >= present.size() || !present[input]) {
        return std::nullopt;
    }
    const double place = scaleOf(input).at(*present[input]);
    return std::isfinite(place) ? std::optional(place) : std::nullopt;
}

double SweepShown::shownAt(std::size_t point, std::size_t quantity) const {
    const SweepPoint& at = result->points[point];
    if (at.values.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return margins ? at.values[quantity].margin : at.values[quantity].value;
}

std::size_t SweepShown::pointNear(double across, double up) const {
    const auto nearest = [this](std::size_t input, double at) {
        const std::vector<double> places = placesOf(input);
        const auto away = [at](double place) { return std::abs(place - at); };
        return static_cast<std::size_t>(std::ranges::min_element(places, {}, away)
                                        - places.begin());
    };
    return result->index(nearest(0, across), isMap() ? nearest(1, up) : 0);
}

QString SweepShown::textOf(std::size_t point) const {
    return SweepText::point(*result, point, entry);
}

std::vector<ChartSeries>
SweepShown::statusMarks(double size, const std::function<double(std::size_t)>& height) const {
    ChartSeries refused{.key = refusedKey,
                        .name = tr("refused (×)"),
                        .kind = ChartSeries::Kind::points,
                        .colour = style::Drawn::refused,
                        .mark = ChartSeries::Mark::cross,
                        .markSize = size,
                        .sight = InSight::never};
    ChartSeries notReached = refused;
    notReached.key = notReachedKey;
    notReached.name = tr("does not reach size (▲)");
    notReached.colour = style::Drawn::sizeNotReached;
    notReached.mark = ChartSeries::Mark::triangle;
    for (std::size_t i = 0; i < result->points.size(); ++i) {
        const SweepStatus status = result->points[i].status;
        if (status == SweepStatus::refused || status == SweepStatus::notReached) {
            (status == SweepStatus::refused ? refused : notReached)
                .points.push_back({placeOf(i, 0), height(i)});
        }
    }
    std::vector<ChartSeries> marks;
    for (ChartSeries* of : {&refused, &notReached}) {
        if (!of->points.empty()) {
            marks.push_back(std::move(*of));
        }
    }
    return marks;
}

ChartTable SweepShown::table() const {
    ChartTable table{tableOf(*result, entry.quantities)};
    for (std::size_t i = 0; i < result->points.size(); ++i) {
        if (result->points[i].status != SweepStatus::pending) {
            const double across = placeOf(i, 0);
            ChartTable::Place& place = table.places.emplace_back();
            place.across = {across, across};
            if (isMap()) {
                place.up = {placeOf(i, 1), placeOf(i, 1)};
            }
        }
    }
    return table;
}

CsvTable SweepShown::tableOf(const SweepResult& sweep, const std::vector<std::size_t>& quantities) {
    CsvTable table;
    for (const SweptInput& input : sweep.inputs) {
        table.header << SweepText::inputAxis(input);
    }
    table.header << tr("State");
    for (const std::size_t q : quantities) {
        const QString name = SweepText::column(sweep.quantities[q]);
        table.header << name << tr("%1: lower limit").arg(name) << tr("%1: upper limit").arg(name)
                     << tr("%1: margin").arg(name);
    }
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
        const SweepPoint& point = sweep.points[i];
        if (point.status == SweepStatus::pending) {
            continue;
        }
        const std::vector<double> values = sweep.valuesAt(i);
        std::vector<CsvCell> row;
        for (std::size_t of = 0; of < values.size(); ++of) {
            row.emplace_back(ShownScale::at(sweep.inputs[of].axis.input).shown(values[of]));
        }
        row.emplace_back(SweepText::status(point));
        for (const std::size_t q : quantities) {
            const SweepValue value = point.values.empty() ? SweepValue{} : point.values[q];
            row.insert(row.end(), {value.value, value.low, value.high, value.margin});
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace sparkout
