// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/passport_prediction.h"

#include "core/batch/scenario_source.h"
#include "core/judgement/judgement.h"
#include "core/project/batch.h"
#include "ui/charts/verdict_table.h"
#include "ui/report/parts/cell_text.h"
#include "ui/report/parts/run_figures.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/views/batch/batch_figures.h"
#include "ui/views/batch/batch_text.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace sparkout::report {

namespace {

constexpr int factorDigits = 6;

QString limitsText(const Characteristic& of) {
    if (of.low && of.high) {
        return printedNumber(*of.low) + u'…' + printedNumber(*of.high);
    }
    return of.high  ? QStringLiteral("≤ ") + printedNumber(*of.high)
           : of.low ? QStringLiteral("≥ ") + printedNumber(*of.low)
                    : cell({});
}

/// The values of the nominal part, measured like those of the batch.
std::vector<QString> nominalTexts(const Outcome& outcome,
                                  const std::vector<Characteristic>& characteristics) {
    PartOutcome part;
    measure(outcome.result, characteristics, part);
    std::vector<QString> texts;
    for (std::size_t i = 0; i < characteristics.size(); ++i) {
        const bool measured = i < part.values.size() && std::isfinite(part.values[i]);
        texts.push_back(measured ? BatchText::value(part.values[i], characteristics[i]) : cell({}));
    }
    return texts;
}

QString percentText(double order) {
    return printedNumber(100 * order, 6) + QStringLiteral("\u00a0%");
}

/// The requirements of one part, the worst of each kind.
Table worstRequirements(const Outcome& outcome) {
    Outcome worst;
    worst.result = outcome.result;
    worst.constraints = worstByKind(outcome.constraints);
    return PassportPrediction::requirements(worst);
}

bool isSetting(const ConstraintResult& constraint) {
    return requirementOf(constraint.kind).scope == ConstraintScope::setting;
}

} // namespace

Table PassportPrediction::nominal(const Outcome& outcome) {
    const std::vector<Characteristic> all = characteristicsOf(outcome.result.project);
    const std::vector<QString> texts = nominalTexts(outcome, all);
    Table table;
    table.head = {tr("Characteristic"), tr("Unit"), tr("Limits"), tr("Nominal part")};
    table.texts = {true, true};
    for (std::size_t i = 0; i < all.size(); ++i) {
        table.rows.push_back(
            {BatchText::full(all[i]), unitText(all[i].unit), limitsText(all[i]), texts[i]});
    }
    return table;
}

Table PassportPrediction::values(const Subject& subject) {
    const BatchSummary& summary = subject.batch->summary;
    const std::vector<QString> texts =
        nominalTexts(*subject.outcome, characteristicsOf(subject.outcome->result.project));
    Table table;
    table.head = {tr("Characteristic"), tr("Unit"), tr("Limits"), tr("Nominal part"), tr("Min."),
                  tr("Mean"),           tr("Max."), tr("s"),      tr("Mean, 95 %")};
    table.texts = {true, true};
    for (std::size_t i = 0; i < summary.characteristics.size(); ++i) {
        const CharacteristicSummary& of = summary.characteristics[i];
        QStringList row{BatchText::full(of.characteristic), unitText(of.characteristic.unit),
                        limitsText(of.characteristic), texts[i]};
        for (const char* figure :
             {"min", "mean", "max", "standard_deviation", "mean_interval_95"}) {
            row << figureText({&of, summary.isSample, summary.drifts}, figure);
        }
        table.rows.push_back(row);
    }
    if (table.rows.empty()) { // no part reached size
        table.rows.push_back(QStringList(table.head.size(), cell({})));
    }
    return table;
}

Table PassportPrediction::capability(const BatchSummary& summary) {
    Table table;
    table.head = {tr("Characteristic"), tr("Pp"), tr("Ppk"), tr("Out of tolerance"),
                  BatchText::normalityName(summary)};
    table.texts = {true};
    for (const CharacteristicSummary& of : summary.characteristics) {
        QStringList row{BatchText::full(of.characteristic)};
        for (const char* figure : {"pp", "ppk", "outside", "normality_probability"}) {
            row << figureText({&of, summary.isSample, summary.drifts}, figure);
        }
        table.rows.push_back(row);
    }
    return table;
}

Table PassportPrediction::percentiles(const BatchSummary& summary) {
    Table table;
    table.head = {tr("Characteristic")};
    table.texts = {true};
    for (const Percentile& percentile : summary.characteristics.front().percentiles) {
        table.head << percentText(percentile.order);
    }
    for (const CharacteristicSummary& of : summary.characteristics) {
        QStringList row{BatchText::full(of.characteristic)};
        for (const Percentile& percentile : of.percentiles) {
            row << BatchText::percentile(percentile, of);
        }
        while (row.size() < table.head.size()) {
            row << cell({}); // no part has such a value
        }
        table.rows.push_back(row);
    }
    return table;
}

std::vector<Block> PassportPrediction::worst(const Subject& subject) {
    const BatchSummary& summary = subject.batch->summary;
    const ScenarioSource source(subject.batch->result.project);
    const std::vector<double> values = source.values(summary.worstPart);
    std::vector<Block> blocks{Paragraph{
        tr("Of the %n part(s) number %1 has the minimum margin. %2.", nullptr,
           static_cast<int>(summary.parts))
            .arg(Names::part(summary.worstPart),
                 summary.bad.count == 0 ? tr("It meets all requirements")
                                        : JudgementText::headline(judge(
                                            subject.worst->result, subject.worst->constraints)))}};
    if (!values.empty()) {
        Facts facts;
        for (std::size_t f = 0; f < values.size(); ++f) {
            const GivenFactor& factor = source.factors()[f];
            const char* unit =
                tableOf<Factors>().fields[static_cast<std::size_t>(factor.kind)].unit;
            const QString value = Names::significant(values[f], factorDigits);
            facts.facts.emplace_back(BatchText::factor(factor),
                                     *unit ? withUnit(value, unit) : value);
        }
        blocks.push_back(std::move(facts));
    }
    if (!subject.worst->constraints.empty()) {
        blocks.push_back(worstRequirements(*subject.worst));
    }
    return blocks;
}

Table PassportPrediction::requirements(const Outcome& outcome) {
    Table table;
    table.head = {
        tr("Zone or section"), tr("Requirement"),        tr("Unit"),   tr("Value"), tr("Limit"),
        tr("Margin"),          tr("Where in the cycle"), tr("Verdict")};
    table.texts = {true, true, true, false, false, false, true, true};
    for (const ConstraintResult& c : outcome.constraints) {
        if (!isSetting(c)) {
            const RequirementCells cells(c);
            table.rows.push_back(
                {Names::where(c), Names::constraint(c.kind), requirementUnit(c.kind), cells.value(),
                 Names::limit(c), cells.margin(),
                 c.at ? Names::moment(*c.at, outcome.result.project.operation) : tr("at the end"),
                 cells.verdict()});
        }
    }
    return table;
}

Table PassportPrediction::settings(const Outcome& outcome) {
    Table table;
    table.head = {tr("Stage or cycle"), tr("Requirement"), tr("Unit"),   tr("Value"),
                  tr("Limit"),          tr("Margin"),      tr("Verdict")};
    table.texts = {true, true, true, false, false, false, true};
    for (const ConstraintResult& c : outcome.constraints) {
        if (isSetting(c)) {
            table.rows.push_back({Names::where(c), Names::constraint(c.kind),
                                  requirementUnit(c.kind), Names::value(c), Names::limit(c),
                                  Names::margin(c), lightName(c)});
        }
    }
    return table;
}

namespace {

constexpr std::size_t mostCharted = 24; ///< rows
constexpr double customaryPpk = 1.33;
// Colours on paper.
constexpr QColor chartInk(0, 0, 0), chartMark(40, 40, 40), chartGrid(190, 190, 190),
    chartGood(20, 90, 160), chartPoor(190, 60, 20);

} // namespace

CapabilityChart::CapabilityChart(std::vector<CharacteristicSummary> rows)
    : m_rows(std::move(rows)) {
    for (const CharacteristicSummary& of : m_rows) {
        m_lowest = of.ppk->interval.low < 0 ? -1 : m_lowest;
    }
    for (const double end : {2.0, 3.0, 5.0, 10.0}) {
        m_highest = end;
        if (end >= 1.2 * m_rows.front().ppk->interval.high) {
            break;
        }
    }
}

QSizeF CapabilityChart::size() const {
    return {double(figureWidth), top + rowHeight * double(m_rows.size()) + bottom};
}

void CapabilityChart::paint(QPainter& painter) const {
    QFont font;
    font.setPixelSize(fontPixels);
    painter.setFont(font);
    paintScale(painter);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        paintRow(painter, m_rows[i], top + rowHeight * (double(i) + 0.5));
    }
}

double CapabilityChart::x(double ppk) const {
    return left
           + (right - left) * (std::clamp(ppk, m_lowest, m_highest) - m_lowest)
                 / (m_highest - m_lowest);
}

void CapabilityChart::paintScale(QPainter& painter) const {
    const double end = top + rowHeight * double(m_rows.size());
    std::vector<QRectF> taken; // the marks' numbers have priority over the others
    for (const double value : {1.0, customaryPpk, 0.0, 10.0, 5.0, 3.0, 2.0, -1.0}) {
        if (value < m_lowest || value > m_highest) {
            continue;
        }
        const bool mark = value == customaryPpk || value == 1;
        painter.setPen(QPen(mark ? chartMark : chartGrid, 1, mark ? Qt::DashLine : Qt::SolidLine));
        painter.drawLine(QPointF(x(value), top), QPointF(x(value), end));
        const QString name = printedNumber(value);
        const double width = QFontMetricsF(painter.font()).horizontalAdvance(name);
        constexpr double reach = 3; // the two marks are close: keep their numbers apart
        const double from = value == 1              ? x(value) + reach - width
                            : value == customaryPpk ? x(value) - reach
                                                    : x(value) - width / 2;
        const QRectF box(from - reach, end, width + 2 * reach, bottom);
        const auto meets = [&box](const QRectF& other) { return box.intersects(other); };
        if (mark || std::ranges::none_of(taken, meets)) {
            painter.setPen(chartInk);
            painter.drawText(QPointF(from, end + 16), name);
            taken.push_back(box);
        }
    }
}

void CapabilityChart::paintRow(QPainter& painter, const CharacteristicSummary& of, double y) const {
    const Estimate& ppk = *of.ppk;
    const QFontMetricsF metrics(painter.font());
    const double base = y + metrics.ascent() / 2 - 1;
    painter.setPen(chartInk);
    painter.drawText(QPointF(2, base), metrics.elidedText(BatchText::full(of.characteristic),
                                                          Qt::ElideRight, left - 12));
    painter.drawText(QPointF(right + 10, base), BatchText::capability(of.ppk));
    const QColor colour = ppk.value < 1 ? chartPoor : chartGood;
    painter.setPen(QPen(colour, 2));
    painter.drawLine(QPointF(x(ppk.interval.low), y), QPointF(x(ppk.interval.high), y));
    painter.setBrush(colour);
    if (ppk.value <= m_highest) {
        painter.drawEllipse(QPointF(x(ppk.value), y), 4, 4);
    } else { // outside the scale
        painter.drawPolygon(
            QPolygonF{QPointF(right - 7, y - 5), QPointF(right + 1, y), QPointF(right - 7, y + 5)});
    }
}

std::optional<Figure> CapabilityChart::figure(const BatchSummary& summary) {
    std::vector<CharacteristicSummary> rows;
    for (const CharacteristicSummary& of : summary.characteristics) {
        if (of.ppk) {
            rows.push_back(of);
        }
    }
    if (rows.empty()) {
        return {};
    }
    std::ranges::stable_sort(rows, {}, [](const auto& of) { return of.ppk->value; });
    rows.resize(std::min(rows.size(), mostCharted));
    QStringList values;
    for (const CharacteristicSummary& of : rows) {
        values << QStringLiteral("%1: %2").arg(BatchText::full(of.characteristic),
                                               BatchText::capability(of.ppk));
    }
    const CapabilityChart chart(std::move(rows));
    return Figure{tr("Ppk with its 95 % bounds, the smallest first; dashed: 1 and %1")
                      .arg(printedNumber(customaryPpk)),
                  values.join(QStringLiteral("; ")), chart.size(),
                  [chart](QPainter& painter) { chart.paint(painter); }};
}

} // namespace sparkout::report
