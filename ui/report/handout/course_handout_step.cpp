// SPDX-License-Identifier: GPL-3.0-or-later
// The step that the hand-out works out: where it is, its formulas, its limits and its figures.
#include "ui/report/handout/course_handout_parts.h"

#include "core/limits/burn.h"
#include "core/limits/cutting.h"
#include "core/process/coupled_sections.h"
#include "core/process/profile.h"
#include "core/project/leaves.h"
#include "core/quality/depth_limits.h"
#include "core/quality/power.h"
#include "core/quality/roughness.h"
#include "core/quality/self_sharpening.h"
#include "core/quality/visit_sheet.h"
#include "core/units.h"
#include "ui/report/handout/formula_meanings.h"
#include "ui/report/parts/course_figures.h"
#include "ui/report/parts/feeds_figure.h"
#include "ui/report/parts/report_values.h"
#include "ui/text/field_text.h"
#include "ui/text/formula_text.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"

#include <QLocale>

#include <algorithm>
#include <set>

namespace sparkout::report {

namespace {

constexpr double milliwattsPerKilowatt = 1e6;
constexpr double fullTurn_deg = 360;
constexpr int percentOf = 100;
constexpr int revolutionsAround = 3; ///< a plunge's step is shown with so many at each side

/// What the formulas of a step are worked out for.
struct StepNumbers {
    const Pass& pass;
    const Visit& visit;
    double stock_mm; ///< left after the cut; negative beyond the target
};

StepNumbers numbersOf(const Outcome& outcome, const HandoutStep& step) {
    const Part& part = outcome.result.project.part;
    const Visit& visit = *visitAt(outcome.trajectory, step);
    const double side = part.surface == Surface::external ? 1 : -1;
    return {outcome.trajectory.passes[step.pass], visit,
            side * (visit.radius_mm - targetRadius(part))};
}

/// The formulas of one step, each sheet with its sources and the symbols not yet explained.
class StepFormulas {
    Q_DECLARE_TR_FUNCTIONS(CourseHandout)
public:
    StepFormulas(const Project& project, const Place& at, Citations& citations)
        : m_at(at), m_citations(citations) {
        m_explained.insert(QStringLiteral("γ")); // among the inputs, too
        for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
            if (*leaf.field->symbol && singleNumberIn(*leaf.field, leaf.owner)) {
                m_explained.insert(QString::fromUtf8(leaf.field->symbol));
            }
        }
    }
    void add(const FormulaSheet& sheet);
    void say(const QString& text) { m_blocks.emplace_back(Paragraph{text}); }
    void add(Block block) { m_blocks.push_back(std::move(block)); }
    [[nodiscard]] StepBlocks take() { return {std::move(m_blocks), std::move(m_symbols)}; }

private:
    void explain(const FormulaSheet& sheet);

    Place m_at;
    Citations& m_citations;
    FormulaWriter m_writer;
    std::set<QString> m_explained; ///< inputs, and symbols with their meanings
    std::set<QString> m_symbols;   ///< that were written
    std::vector<Block> m_blocks;
};

void StepFormulas::add(const FormulaSheet& sheet) {
    m_blocks.emplace_back(Heading{QCoreApplication::translate("Formula", sheet.name)});
    QStringList sources;
    for (const FormulaSource& source : sourcesOf(sheet, m_at)) {
        const QString key = m_citations.cite(QString::fromLatin1(source.key));
        sources << (*source.equations ? tr("%1, eq. %2", "key of a source, its equation")
                                            .arg(key, QString::fromLatin1(source.equations))
                                      : key);
    }
    say(tr("Source: %1").arg(sources.join(QStringLiteral("; "))));
    for (Block& block : m_writer.write(sheet)) {
        m_blocks.push_back(std::move(block));
    }
    explain(sheet);
}

void StepFormulas::explain(const FormulaSheet& sheet) {
    Table table;
    table.head = {tr("Symbol"), tr("Meaning")};
    table.texts = {true, true};
    table.symbols = true;
    const auto explainTerm = [&](const FormulaTerm& term) {
        const QString symbol = QString::fromUtf8(term.symbol);
        if (!isConstant(term)) {
            m_symbols.insert(symbol);
        }
        const QString meaning = isConstant(term) ? QString() : symbolMeaning(sheet, term.symbol);
        if (!meaning.isEmpty() && !m_explained.contains(symbol)
            && m_explained.insert(symbol + u'=' + meaning).second) {
            table.rows.push_back({symbol, meaning});
        }
    };
    for (const FormulaStep& step : sheet.steps) {
        explainTerm(step.result);
        std::ranges::for_each(step.terms, explainTerm);
    }
    if (!table.rows.empty()) {
        m_blocks.emplace_back(std::move(table));
    }
}

/// The limits of the depth of cut at the step, each with its formulas.
std::vector<FormulaSheet> limitSheets(const Project& project, double b, double stock) {
    std::vector<FormulaSheet> sheets;
    if (const auto& U = project.material.burn_rise_k) {
        sheets.push_back(burnLimitSheet(project, *U, std::max(0.0, stock)));
    }
    if (const auto& Ra = project.part.tolerance.roughness_ra_um;
        Ra && isRoughnessCalibrated(project)) {
        sheets.push_back(roughnessLimitSheet(project, *Ra / units::umPerMm));
    }
    if (auto sheet = selfSharpeningSheet(project)) {
        sheets.push_back(std::move(*sheet));
    }
    if (isCoupled(project)) {
        return sheets; // the sections share the power
    }
    if (const auto& N = project.machine.wheel_drive_kw) {
        sheets.push_back(wheelPowerLimitSheet(project, b, *N * milliwattsPerKilowatt));
    }
    if (const auto& N = project.machine.work_drive_kw) {
        sheets.push_back(workPowerLimitSheet(project, b, *N * milliwattsPerKilowatt));
    }
    return sheets;
}

/// The double stroke of the step, or the revolutions around it.
std::optional<Figure> feedsAround(const OutcomePtr& outcome, const HandoutStep& step) {
    const Pass& pass = outcome->trajectory.passes[step.pass];
    const FeedSeries& feeds = outcome->feeds;
    const bool strokes = feeds.operation->countsStrokes;
    const int around = strokes ? 0 : revolutionsAround;
    const int first = std::max(1, pass.place.cycleCount - around);
    const int last = std::min(feeds.strokeCount(), pass.place.cycleCount + around);
    const double start_s = feeds.strokeStart_s.at(static_cast<std::size_t>(first - 1));
    const double moment_s =
        pass.start_s + pass.duration_s * (step.radius + 1) / std::max(1, outcome->trajectory.radii);
    const QString caption =
        strokes ? CourseHandout::tr("Feeds in double stroke %1; the line marks the step")
                      .arg(pass.place.cycleCount)
                : CourseHandout::tr("Feeds around revolution %1; the line marks the step")
                      .arg(pass.place.cycleCount);
    return feedsFigure(outcome, start_s, feeds.strokeEnd_s(last), moment_s, caption);
}

} // namespace

Facts CourseHandout::stepFacts(const Outcome& outcome, const HandoutStep& step) {
    const auto [pass, visit, stock] = numbersOf(outcome, step);
    const Place& at = pass.place;
    const bool strokes = outcome.result.project.operation->countsStrokes;
    Facts facts{
        {{tr("Zone or section"), Names::zoneFull(at.zone, at.section)},
         {tr("Stage"), QString::number(at.stage)},
         {strokes ? tr("Double stroke") : tr("Revolution"), QString::number(at.cycleCount)}}};
    if (strokes) {
        facts.facts.emplace_back(
            tr("Step"), QStringLiteral("%1: %2").arg(Names::step(at.step),
                                                     Names::stepMeaning(at.zone, at.step)));
        facts.facts.emplace_back(tr("Revolution of the step"), QString::number(at.revolution));
    }
    const double angle = fullTurn_deg * step.radius / outcome.trajectory.radii;
    facts.facts.emplace_back(
        tr("Radius"),
        QStringLiteral("k = %1, φ = %2°").arg(step.radius).arg(QLocale().toString(angle, 'g', 4)));
    const auto micrometres = [](double mm) {
        return withUnit(Names::significant(mm * units::umPerMm, resultDigits), "µm");
    };
    facts.facts.emplace_back(tr("Effective width b"),
                             withUnit(Names::significant(pass.effectiveWidth_mm, 4), "mm"));
    facts.facts.emplace_back(tr("Programmed so far, tП"), micrometres(visit.programmed_mm));
    facts.facts.emplace_back(tr("Actual feed a"), micrometres(visit.actual_mm));
    facts.facts.emplace_back(tr("Stock left at this radius"), micrometres(stock));
    return facts;
}

StepBlocks CourseHandout::stepFormulas(const Outcome& outcome, const HandoutStep& step,
                                       Citations& citations) {
    const Project& project = outcome.result.project;
    const auto [pass, visit, stock] = numbersOf(outcome, step);
    const double b = pass.effectiveWidth_mm, a = visit.actual_mm;
    StepFormulas formulas(project, pass.place, citations);
    formulas.say(tr("The forces are those of the depth of cut that the elastic balance gives, "
                    "further below."));
    formulas.add(normalForceSheet(project, b, a));
    formulas.add(tangentialForceSheet(project, b, a));
    formulas.add(visitSheet(outcome.result, outcome.trajectory, step.pass, step.radius));
    formulas.add(Heading{tr("What limits the feed at this step")});
    const std::vector<FormulaSheet> sheets = limitSheets(project, b, stock);
    const bool limitsRa = project.part.tolerance.roughness_ra_um.has_value();
    const bool calibrated = isRoughnessCalibrated(project);
    if (limitsRa && !calibrated) {
        formulas.say(LimitNames::guessed());
    }
    if (sheets.empty()) {
        formulas.say(limitsRa ? tr("No other requirement of this project limits the feed.")
                              : tr("No requirement of this project limits the feed."));
        return formulas.take();
    }
    formulas.say(
        limitsRa && calibrated
            ? tr("Each requirement allows a greatest depth of cut; the formulas below say where "
                 "it comes from. Roughness limits the last cut of the cycle alone.")
            : tr("Each requirement allows a greatest depth of cut; the formulas below say where "
                 "it comes from."));
    formulas.add(limits(outcome, step));
    for (const FormulaSheet& sheet : sheets) {
        formulas.add(sheet);
    }
    return formulas.take();
}

Table CourseHandout::limits(const Outcome& outcome, const HandoutStep& step) {
    const Project& project = outcome.result.project;
    const auto [pass, visit, stock] = numbersOf(outcome, step);
    Table table;
    table.head = {tr("Requirement"), tr("Limiting depth of cut, µm"), tr("As a feed, mm/min"),
                  tr("Depth of cut of the step, µm"), tr("Share of the limit, %")};
    table.texts = {true};
    for (const DepthLimit& limit :
         depthLimits(project, pass.effectiveWidth_mm, std::max(0.0, stock))) {
        const bool shared = isCoupled(project) && requirementOf(limit.kind).sharedBySections;
        if (LimitNames::isGuess(limit.kind, project) || shared) {
            continue;
        }
        const double share = percentOf * visit.actual_mm / limit.depth_mm;
        table.rows.push_back(
            {Names::constraint(limit.kind),
             Names::significant(limit.depth_mm * units::umPerMm, resultDigits),
             Names::significant(limit.depth_mm * project.machine.work_speed_rpm, resultDigits),
             Names::significant(visit.actual_mm * units::umPerMm, resultDigits),
             limit.depth_mm > 0 ? Names::significant(share) : tr("not met at any depth")});
    }
    return table;
}

std::vector<Block> CourseHandout::figures(const OutcomePtr& outcome,
                                          const std::optional<HandoutStep>& step,
                                          const std::set<HandoutView>& views,
                                          const std::function<void()>& breathe) {
    std::vector<Block> blocks;
    const auto add = [&](std::optional<Figure> figure) {
        breathe();
        if (figure) {
            blocks.emplace_back(std::move(*figure));
        }
    };
    if (views.contains(HandoutView::feeds) && step) {
        add(feedsAround(outcome, *step));
    }
    if (views.contains(HandoutView::cycle)) {
        add(feedsFigure(outcome));
    }
    if (views.contains(HandoutView::profiles)) {
        add(profilesFigure(outcome));
    }
    if (views.contains(HandoutView::limits) && step) {
        add(limitsFigure(outcome, outcome->trajectory.passes[step->pass].place));
    }
    return blocks;
}

} // namespace sparkout::report
