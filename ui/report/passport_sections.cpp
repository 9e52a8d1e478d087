// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/passport_sections.h"

#include "core/batch/judgement.h"
#include "core/batch/scenario_source.h"
#include "core/project/batch.h"
#include "core/project/member.h"
#include "core/study/batch_edits.h"
#include "core/version.h"
#include "ui/report/cell_text.h"
#include "ui/report/run_figures.h"
#include "ui/results/verdict_table.h"
#include "ui/text/field_text.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/views/study/batch_text.h"

#include <QFileInfo>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace sparkout::report {

namespace {

constexpr std::int64_t mostDrawn = 4096; ///< parts whose factors are looked through

QString factorUnit(FactorKind kind) {
    return cell(unitText(tableOf<Factors>().fields[static_cast<std::size_t>(kind)].unit));
}

QString rangeText(double low, double high) {
    return printedNumber(low) + u'…' + printedNumber(high);
}

/// Smallest and largest value of each factor over the parts.
std::vector<std::pair<double, double>> drawnRanges(const ScenarioSource& source) {
    std::vector<std::pair<double, double>> ranges;
    for (std::int64_t part = 0; part < std::min(source.parts(), mostDrawn); ++part) {
        const std::vector<double> values = source.values(part);
        for (std::size_t f = 0; f < values.size(); ++f) {
            if (part == 0) {
                ranges.emplace_back(values[f], values[f]);
            } else {
                ranges[f].first = std::min(ranges[f].first, values[f]);
                ranges[f].second = std::max(ranges[f].second, values[f]);
            }
        }
    }
    return ranges;
}

Table correlations(const std::vector<GivenFactor>& factors,
                   const std::vector<std::vector<double>>& matrix) {
    Table table;
    table.head = {PassportInputs::tr("Correlation")};
    table.texts = {true};
    for (std::size_t i = 0; i < matrix.size(); ++i) { // those of zones are independent
        table.head << BatchText::factor(factors[i]);
        QStringList row{BatchText::factor(factors[i])};
        for (std::size_t j = 0; j < matrix.size(); ++j) {
            row << printedNumber(matrix.at(i).at(j));
        }
        table.rows.push_back(row);
    }
    return table;
}

/// A form of a factor's distribution that is not the given one.
bool isOtherForm(const Leaf& leaf, bool isNumber) {
    if (leaf.owner == nullptr || isNumber || !leaf.path.starts_with("/batch/factors/")) {
        return false;
    }
    const bool isList = leaf.field->kind == sparkout::Kind::optionalNumberList;
    return isList ? !leaf.field->as<std::optional<std::vector<double>>>(leaf.owner)
                  : leaf.field->kind == sparkout::Kind::optionalInteger;
}

/// Typed values stay unchanged; a wheel worn by other surfaces has all the digits of a double.
QString inNineDigits(double value) {
    constexpr qsizetype typed = 12;
    const QString exact = printedNumber(value);
    return exact.size() > typed ? printedNumber(value, 9) : exact;
}

} // namespace

Facts PassportInputs::drawing(const Project& project) {
    Facts facts{{inputFact(project, "/part/upper_deviation_um"),
                 inputFact(project, "/part/lower_deviation_um")}};
    for (const char* path :
         {"/part/target_diameter_mm", "/part/tolerance/radial_runout_um",
          "/part/tolerance/roundness_um", "/part/tolerance/cylindricity_um",
          "/part/tolerance/total_runout_um", "/part/tolerance/waviness_um",
          "/part/tolerance/roughness_ra_um", "/machine/wheel_drive_kw", "/machine/work_drive_kw"}) {
        const ConstMember member = findMember(project, path);
        auto [name, value] = inputFact(project, path);
        const bool given = numberIn(*member.field, member.owner).has_value();
        facts.facts.emplace_back(name, given ? value : inputText(member.field->nullMeaning));
    }
    return facts;
}

QString PassportInputs::law(const GivenFactor& factor) {
    const Factor& law = factor.law;
    switch (formOf(law)) {
    case FactorForm::constant: return tr("constant %1").arg(printedNumber(law.uniform->front()));
    case FactorForm::uniform:
        return tr("uniform, %1").arg(rangeText(law.uniform->front(), law.uniform->back()));
    case FactorForm::normal: {
        const QString normal =
            tr("normal, mean %1, standard deviation %2")
                .arg(printedNumber(law.normal->front()), printedNumber(law.normal->back()));
        return law.within ? tr("%1, truncated to %2", "normal distribution")
                                .arg(normal, rangeText(law.within->front(), law.within->back()))
                          : normal;
    }
    case FactorForm::triangular:
        return tr("triangular, %1, most frequent %2")
            .arg(rangeText(law.triangular->front(), law.triangular->back()),
                 printedNumber(law.triangular->at(1)));
    case FactorForm::measured:
        return tr("as measured, %n value(s), %1", nullptr, static_cast<int>(law.measured->size()))
            .arg(rangeText(*std::ranges::min_element(*law.measured),
                           *std::ranges::max_element(*law.measured)));
    case FactorForm::grows: {
        const QString grows =
            tr("grows part by part from %1 to %2")
                .arg(printedNumber(law.grows->front()), printedNumber(law.grows->back()));
        if (law.parts_between_dressings && factor.kind == FactorKind::gaugeAge) {
            return tr("%1, %n part(s) between settings of the gauge", nullptr,
                      *law.parts_between_dressings)
                .arg(grows);
        }
        return law.parts_between_dressings
                   ? tr("%1, %n part(s) between dressings", nullptr, *law.parts_between_dressings)
                         .arg(grows)
                   : tr("%1 over the whole batch").arg(grows);
    }
    }
    return cell({});
}

std::vector<Block> PassportInputs::scenarios(const Subject& subject) {
    if (!subject.batch) {
        return {
            Paragraph{
                tr("This project describes no batch, so the passport covers only the nominal part: "
                   "it gives no scatter, no capability and no share out of tolerance.")},
            Paragraph{tr(
                "A batch is added on the page Batch of the inputs, where each factor that scatters "
                "gets its distribution, or with “Add a typical batch” in the view Batch.")}};
    }
    const BatchOutcome& outcome = *subject.batch;
    const Batch& batch = *outcome.result.project.batch;
    const ScenarioSource source(outcome.result.project);
    const std::vector<GivenFactor>& factors = source.factors();
    const bool drawn = outcome.summary.isSample && !factors.empty();
    std::vector<Block> blocks;
    blocks.push_back(Facts{
        {{tr("Parts run"), QString::number(outcome.summary.parts)},
         {tr("Scenarios"),
          choiceText(choicesOf<Scenarios>()[static_cast<std::size_t>(batch.scenarios)].label)},
         {tr("Seed"), drawn ? QString::number(batch.seed) : tr("none is drawn")},
         {tr("Correlation of the factors"),
          batch.correlation ? tr("as in the table below") : tr("independent")}}});
    if (factors.empty()) {
        blocks.push_back(Paragraph{BatchText::run(outcome)});
        return blocks;
    }
    Table table;
    table.head = {tr("Factor"), tr("Unit"), tr("Distribution"), tr("Minimum tried"),
                  tr("Maximum tried")};
    table.texts = {true, true, true};
    const auto ranges = drawnRanges(source);
    for (std::size_t f = 0; f < factors.size(); ++f) {
        table.rows.push_back({BatchText::factor(factors[f]), factorUnit(factors[f].kind),
                              law(factors[f]), Names::significant(ranges[f].first),
                              Names::significant(ranges[f].second)});
    }
    blocks.push_back(std::move(table));
    if (source.parts() > mostDrawn) {
        blocks.push_back(Paragraph{
            tr("Minimum and maximum tried: of the first %n parts.", nullptr, int(mostDrawn))});
    }
    if (batch.correlation) {
        blocks.push_back(correlations(factors, *batch.correlation));
    }
    return blocks;
}

Table PassportInputs::inputs(const Project& project) {
    constexpr std::array<std::string_view, 7> left{
        "/title", "/author",   "/notes", "/optimisation",
        "/sweep", "/measured", "/runs"}; // no part of what is computed
    Table table;
    table.head = {tr("Input"), tr("Value"), tr("Unit")};
    table.texts = {true, true, true};
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        const Field& field = *leaf.field;
        const bool isRead = !field.relevant || field.relevant(project, leaf.owner);
        if (!isRead || std::ranges::any_of(left, [&leaf](std::string_view path) {
                return leaf.path.starts_with(path);
            })) {
            continue;
        }
        const std::optional<double> number = singleNumberIn(field, leaf.owner);
        if (isOtherForm(leaf, number.has_value())) {
            continue;
        }
        const QString value = number ? inNineDigits(*number)
                              : field.kind == sparkout::Kind::text
                                  ? oneLine(field.as<std::string>(leaf.owner))
                                  : fieldText(field, leaf.owner);
        table.rows.push_back({locationText(leaf.path), cell(value), cell(unitText(field.unit))});
    }
    return table;
}

std::vector<Block> PassportInputs::recomputing(const Subject& subject) {
    const Project& project = subject.outcome->result.project;
    const QString file = manyLines(QFileInfo(subject.file).fileName()).simplified();
    const QString surface = subject.surfaceOption.isEmpty()
                                ? QString()
                                : QStringLiteral(" --surface ") + subject.surfaceOption;
    const QString command = QStringLiteral("sparkout --report passport \"%1\"%2 -o passport.pdf")
                                .arg(file.isEmpty() ? QStringLiteral("FILE") : file, surface);
    Facts facts{{{tr("Program"), QStringLiteral("Sparkout %1").arg(QString::fromUtf8(version))},
                 {tr("Version of the engine"),
                  QString::fromStdString(subject.outcome->result.engineVersion)}}};
    if (subject.batch) {
        facts.facts.emplace_back(tr("Extent of the run"), BatchText::run(*subject.batch));
    }
    facts.facts.emplace_back(tr("Command to recompute it"), command);
    const QString how =
        project.batch ? tr(
            "The same inputs and the same seed give the same numbers, with any number of threads. "
            "All that the computation reads is in the appendix, each number with all its digits.")
                      : tr("The same inputs give the same numbers. All that the computation reads "
                           "is in the appendix, each number with all its digits.");
    return {facts, Paragraph{how}};
}

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
