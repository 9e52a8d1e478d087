// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/passport.h"

#include "core/measured/hold_out.h"
#include "core/project/batch.h"
#include "core/project/project.h"
#include "core/study/outcome.h"
#include "core/study/whole_batch.h"
#include "ui/chart/bar_plot.h"
#include "ui/chart/chart_plot.h"
#include "ui/measured/measured_boxes.h"
#include "ui/measured/measured_text.h"
#include "ui/report/cell_text.h"
#include "ui/report/cycle_card.h"
#include "ui/report/format/report.h"
#include "ui/report/operation_setup.h"
#include "ui/report/passport_sections.h"
#include "ui/report/run_figures.h"
#include "ui/results/verdict_table.h"
#include "ui/text/dressing_text.h"
#include "ui/text/example_texts.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/views/part/longitudinal_plot.h"
#include "ui/views/part/overview_charts.h"
#include "ui/views/part/profiles_plot.h"
#include "ui/views/part/profiles_text.h"
#include "ui/views/study/batch_charts.h"
#include "ui/views/study/batch_text.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace sparkout::report {

namespace {

/// The figures of the accuracy passport, drawn in the window's thread.
class PassportFigures {
    Q_DECLARE_TR_FUNCTIONS(PassportFigures)
public:
    static Figure histograms(const BatchSummary& summary, const std::string& name);
    static Figure alongThePart(const Outcome& outcome);
    static Figure crossSections(const Outcome& outcome);
    /// A chart of the overview; empty without data.
    static std::optional<Figure> bars(OverviewChart which, BarChart chart);
    static std::optional<Figure> bars(const QString& name, BarChart chart); ///< for any other chart
};

constexpr int histogramHeight = 240, alongHeight = 300, acrossHeight = 320;
constexpr int leastBarsHeight = 110, standingBarsHeight = 230;
constexpr std::size_t mostAcross = 4; ///< cross-sections side by side

std::vector<int> allOf(const ProfileSeries& series) {
    std::vector<int> all;
    for (std::size_t i = 0; i < series.profiles.size(); ++i) {
        all.push_back(static_cast<int>(i));
    }
    return all;
}

Figure PassportFigures::histograms(const BatchSummary& summary, const std::string& name) {
    const std::vector<std::size_t> shown = placesOf(summary, name, mostPlaces);
    QStringList values;
    for (const std::size_t i : shown) {
        const CharacteristicSummary& of = summary.characteristics[i];
        if (of.count > 0) {
            values << tr("%1: %2", "zone, range of values")
                          .arg(
                              BatchText::where(of.characteristic),
                              BatchText::range({of.least.value, of.most.value}, of.characteristic));
        }
    }
    const QString axis = BatchText::axis(summary.characteristics[shown.front()].characteristic);
    const QString caption = placesOf(summary, name).size() > shown.size()
                                ? tr("%1: number of parts, where the Ppk is lowest").arg(axis)
                                : tr("%1: number of parts").arg(axis);
    ChartPlot plot;
    setUpForPaper(plot, histogramHeight);
    plot.setGrid([&] { return BatchCharts::histograms(summary, name, true); });
    return plotFigure(plot, plot.legendEntries(), caption, values.join(QStringLiteral("; ")));
}

Figure PassportFigures::alongThePart(const Outcome& outcome) {
    using enum ProfileLine;
    const ProfileSeries series = makeProfileSeries(outcome.result, outcome.trajectory);
    LongitudinalPlot plot;
    setUpForPaper(plot, alongHeight);
    plot.setDiameters(true);
    plot.setHidden({blank});
    plot.setSeries(series, shaftSteps(outcome.result.project), {});
    plot.fit();
    return plotFigure(plot, plot.entriesOf({profile, spread, target, field, gauge}),
                      tr("Diameter along the part against the tolerance band"),
                      ProfilesText::summary(series, allOf(series)));
}

Figure PassportFigures::crossSections(const Outcome& outcome) {
    using enum ProfileLine;
    const ProfileSeries series = makeProfileSeries(outcome.result, outcome.trajectory);
    std::vector<int> shown = allOf(series);
    if (shown.size() > mostAcross) {
        shown = shownSections(static_cast<int>(shown.size()), gaugeProfile(outcome.result));
    }
    ProfilesPlot plot;
    setUpForPaper(plot, acrossHeight);
    plot.setHidden({blank});
    plot.setSeries(series, shown);
    plot.fit();
    return plotFigure(plot, plot.entriesOf({profile, target, leastSquares, field}),
                      tr("Cross-sections, deviations magnified"),
                      ProfilesText::summary(series, shown));
}

std::optional<Figure> PassportFigures::bars(OverviewChart which, BarChart chart) {
    return bars(OverviewCharts::title(which), std::move(chart));
}

std::optional<Figure> PassportFigures::bars(const QString& name, BarChart chart) {
    if (chart.empty()) {
        return {};
    }
    const QString caption =
        chart.remark.isEmpty() ? name : QStringLiteral("%1. %2").arg(name, chart.remark);
    const QString description = chart.description();
    BarPlot plot;
    setUpForPaper(plot, leastBarsHeight);
    plot.resize(figureWidth, std::max(BarDrawing::leastHeight(chart, plot.font()),
                                      chart.isLying ? leastBarsHeight : standingBarsHeight));
    plot.setChart(std::move(chart));
    return plotFigure(plot, plot.legendEntries(), caption, description);
}

} // namespace

bool PassportMeasured::applies(const Project& project) {
    return !statisticsOfMeasured(project).empty();
}

Table PassportMeasured::table(const Project& project, const std::vector<AdequacyRow>& rows) {
    const ValueTable shown = adequacyTable(project, rows);
    Table table;
    for (const ValueHead& column : shown.columns) {
        table.head << column.text;
        table.texts.push_back(column.isText);
    }
    for (const std::vector<ValueCell>& row : shown.cells) {
        QStringList& cells = table.rows.emplace_back();
        for (const ValueCell& cell : row) {
            cells << cell.text;
        }
    }
    return table;
}

std::vector<Block> PassportMeasured::blocks(const Subject& subject) {
    const Project& project = subject.outcome->result.project;
    if (!subject.predicting || !subject.predicting->ran() || !applies(project)) {
        return {};
    }
    const std::vector<AdequacyRow> rows = judgeAdequacy(project, subject.predicting->result);
    std::vector<Block> blocks{table(project, rows)};
    for (const QString& sentence : MeasuredText::judgement(project, rows)) {
        blocks.emplace_back(Paragraph{sentence});
    }
    blocks.emplace_back(
        Paragraph{tr("Mean with Student's interval of 95 %; predicted: the range that contains 95 "
                     "% of %n part(s) of the batch; F: the ratio of the variance of the measured "
                     "parts to the predicted one, with the limits that it stays within by chance; "
                     "inside: measured parts within the predicted range.",
                     nullptr, static_cast<int>(subject.predicting->summary.parts))});
    for (const MeasuredQuantity quantity : MeasuredBoxes::quantities(rows)) {
        if (auto figure = PassportFigures::bars(MeasuredText::quantity(quantity),
                                                MeasuredBoxes::chart(project, rows, quantity))) {
            blocks.emplace_back(std::move(*figure));
        }
    }
    return blocks;
}

std::vector<Block> PassportMeasured::heldOut(const Project& project) {
    std::vector<Block> blocks;
    for (const QString& sentence : MeasuredText::holdOut(project, holdOut(project))) {
        blocks.emplace_back(Paragraph{sentence});
    }
    if (!blocks.empty()) {
        blocks.emplace_back(Paragraph{tr("The range in parentheses is that of the calibrated "
                                         "inputs at the ends of their 95 % intervals.")});
    }
    return blocks;
}

const CharacteristicSummary* PassportVerdict::leastCapable(const BatchSummary& summary) {
    const CharacteristicSummary* least = nullptr;
    for (const CharacteristicSummary& of : summary.characteristics) {
        if (of.ppk && (!least || of.ppk->value < least->ppk->value)) {
            least = &of;
        }
    }
    return least;
}

const CharacteristicSummary* PassportVerdict::deciding(const BatchSummary& summary) {
    const CharacteristicSummary* most = nullptr;
    for (const CharacteristicSummary& of : summary.characteristics) {
        if (of.outside.count > (most ? most->outside.count : 0)) {
            most = &of;
        }
    }
    return most ? most : leastCapable(summary);
}

Fitness PassportVerdict::fitness(const Subject& subject, const Judgement& judgement) {
    if (isFailure(judgement.state)) {
        return Fitness::unfit;
    }
    const Fitness ofBatch = subject.batch
                                ? weigh(subject.batch->summary, subject.batch->result).fitness
                                : Fitness::conditional;
    const bool isOpen =
        judgement.state == JudgedState::undecided || judgement.state == JudgedState::measuredDiffer;
    return isOpen ? std::max(ofBatch, Fitness::conditional) : ofBatch;
}

QString PassportVerdict::decision(const Subject& subject, const Judgement& judgement) {
    const bool isOfBatch =
        judgement.state == JudgedState::batchFails || !isFailure(judgement.state);
    return !isOfBatch ? JudgementText::headline(judgement)
           : subject.batch
               ? BatchText::decision(*subject.batch)
               : tr("all requirements are met; no batch is described, so scatter is not assessed");
}

std::vector<Block> PassportVerdict::verdict(const Subject& subject) {
    const Outcome& outcome = *subject.outcome;
    const Judgement judgement = judgementOf(outcome, subject.batch.get(), subject.predicting.get());
    Facts facts{
        {{tr("Prediction"), JudgementText::headline(judgement)},
         {tr("The cycle, by the prediction"), BatchText::fitness(fitness(subject, judgement))},
         {tr("Deciding result"), decision(subject, judgement)}}};
    QStringList reasons;
    if (outcome.result.status != RunStatus::completed) {
        reasons << sparkout::verdict::status(outcome.result);
    }
    for (const QString& line : JudgementText::lines(judgement)) {
        reasons << line + u'.';
    }
    if (subject.batch) {
        const BatchSummary& summary = subject.batch->summary;
        facts.facts.emplace_back(tr("Rejected parts"), BatchText::share(summary.bad));
        if (const CharacteristicSummary* least = leastCapable(summary)) {
            facts.facts.emplace_back(
                tr("Minimum Ppk"),
                QStringLiteral("%1: %2").arg(BatchText::capability(least->ppk),
                                             BatchText::full(least->characteristic)));
        }
        facts.facts.emplace_back(tr("Not counted in the batch"),
                                 BatchText::notCounted(subject.batch->result.project));
        reasons << BatchText::run(*subject.batch) + u' ' + BatchText::counts(summary);
        for (const CharacteristicSummary& of : summary.characteristics) {
            if (of.outside.count > 0) {
                reasons << tr("%1: out of tolerance %2.")
                               .arg(BatchText::full(of.characteristic),
                                    BatchText::share(of.outside));
            }
        }
        if (summary.bad.count > 0) {
            reasons << tr("Worst part, number %1: %2.")
                           .arg(Names::part(summary.worstPart),
                                JudgementText::headline(
                                    judge(subject.worst->result, subject.worst->constraints)));
        }
    } else {
        facts.facts.emplace_back(tr("Rejected parts"), tr("no batch is described"));
    }
    facts.facts.emplace_back(tr("Machining time"), sparkout::verdict::time(outcome.result));
    const QString caution =
        tr("This is the prediction of a model, to be confirmed at the machine; it is not an "
           "assessment of conformity and does not replace measurement.");
    std::vector<Block> blocks{facts};
    for (const QString& reason : reasons) {
        blocks.push_back(Paragraph{reason});
    }
    blocks.push_back(Paragraph{
        subject.batch
            ? tr("The cycle is fit when every stock within one infeed, where that is decided, and "
                 "every part that was run reach size and meet every requirement, and the lower 95 "
                 "% bounds of all Ppk reach %1; it is conditionally fit when no more parts are "
                 "rejected than the share allowed, or when a requirement, the capability or the "
                 "expected share outside is not decided or falls short. %2")
                  .arg(Names::significant(subject.batch->result.project.batch->least_ppk), caution)
            : tr("Without a batch the cycle is conditionally fit when every stock within one "
                 "infeed, where that is decided, reaches size and meets every requirement. %1")
                  .arg(caution)});
    return blocks;
}

namespace {

class PassportWriter {
    Q_DECLARE_TR_FUNCTIONS(Passport)
public:
    explicit PassportWriter(const Subject& subject)
        : m_subject(subject), m_outcome(*subject.outcome), m_project(m_outcome.result.project) {}

    Report write() {
        m_report = begunReport(tr("Accuracy passport of a grinding cycle"), m_project,
                               m_subject.file, m_subject.date);
        add(OperationSetup::header(m_project, m_subject.date));
        section(tr("Verdict"), PassportVerdict::verdict(m_subject));
        heading(tr("Drawing and part"));
        add(partSketch(m_subject.outcome));
        add(PassportInputs::drawing(m_project));
        heading(tr("Tooling and settings"));
        add(OperationSetup::settings(m_outcome));
        heading(tr("Settings by stage"));
        add(OperationSetup::stages(m_outcome));
        addBars(OverviewChart::times, OverviewCharts::times(m_outcome));
        addBars(OverviewChart::stock, OverviewCharts::stock(m_outcome));
        section(tr("Batch: factors and scenarios"), PassportInputs::scenarios(m_subject));
        addPrediction();
        addMeasured();
        addProfiles();
        if (m_subject.batch) {
            section(tr("Worst part of the batch"), PassportPrediction::worst(m_subject));
        }
        rows(tr("Requirements of the nominal part"), PassportPrediction::requirements(m_outcome));
        rows(tr("Requirements of the settings"), PassportPrediction::settings(m_outcome));
        if (!m_outcome.constraints.empty()) {
            addBars(OverviewChart::requirements, OverviewCharts::requirements(m_outcome));
        }
        addDressing();
        rows(tr("Calibrated inputs"), CalibratedTable::of(m_project));
        addTexts();
        section(tr("Recomputing"), PassportInputs::recomputing(m_subject));
        heading(tr("Appendix: all inputs"));
        add(PassportInputs::inputs(m_project));
        return std::move(m_report);
    }

private:
    void add(Block block) {
        if (std::holds_alternative<Figure>(block)) {
            m_subject.breathe();
        }
        m_report.blocks.push_back(std::move(block));
    }
    void heading(const QString& text) { add(Heading{text}); }

    void addBars(OverviewChart which, BarChart chart) {
        if (auto figure = PassportFigures::bars(which, std::move(chart))) {
            add(std::move(*figure));
        }
    }

    void section(const QString& name, std::vector<Block> blocks) {
        heading(name);
        std::ranges::move(blocks, std::back_inserter(m_report.blocks));
    }

    void rows(const QString& name, Table table) {
        if (!table.rows.empty()) {
            heading(name);
            add(std::move(table));
        }
    }

    void lines(const QString& name, const QStringList& texts) {
        if (!texts.isEmpty()) {
            heading(name);
            for (const QString& text : texts) {
                add(Paragraph{text});
            }
        }
    }

    /// The number of parts between dressings, if it is known.
    void addDressing() {
        if (m_subject.dressing && m_subject.dressing->interval.ran()) {
            const auto& [setup, interval] = *m_subject.dressing;
            heading(tr("Wheel between dressings"));
            add(Facts{DressingText::facts(setup, interval)});
        }
    }

    void addPrediction() {
        heading(tr("Predicted accuracy against the drawing"));
        if (!m_subject.batch) {
            add(PassportPrediction::nominal(m_outcome));
            return;
        }
        const BatchSummary& summary = m_subject.batch->summary;
        add(PassportPrediction::values(m_subject));
        if (!summary.isSample) {
            add(Paragraph{tr("Corner parts are not a sample: they give extremes and counts, but no "
                             "mean and no capability.")});
        }
        if (summary.characteristics.empty()) {
            return; // no part reached size
        }
        heading(tr("Capability and share out of tolerance"));
        addBars(OverviewChart::parts, OverviewCharts::parts(*m_subject.batch));
        add(PassportPrediction::capability(summary));
        if (auto chart = CapabilityChart::figure(summary)) {
            add(std::move(*chart));
        }
        if (summary.isSample) {
            heading(tr("Percentiles"));
            Table table = PassportPrediction::percentiles(summary);
            const bool hasDash = std::ranges::any_of(table.rows, [](const QStringList& row) {
                return row.contains(QStringLiteral("–"));
            });
            add(std::move(table));
            if (hasDash) {
                add(Paragraph{
                    tr("–: with so few values it would be the smallest or the largest one.")});
            }
        }
        heading(tr("Distribution against the tolerance band"));
        addHistograms(summary);
        addBars(OverviewChart::boxes,
                OverviewCharts::boxes(*m_subject.batch, statisticsOfMeasured(m_project)));
    }

    /// Shows the mean diameter, and the deciding characteristic if that is not a diameter.
    void addHistograms(const BatchSummary& summary) {
        const std::string usual = summary.characteristics.front().characteristic.name;
        add(PassportFigures::histograms(summary, usual));
        const CharacteristicSummary* deciding = PassportVerdict::deciding(summary);
        if (deciding && !std::string_view(deciding->characteristic.name).starts_with(usual)) {
            add(PassportFigures::histograms(summary, deciding->characteristic.name));
        }
    }

    void addMeasured() {
        const std::vector<Block> blocks = PassportMeasured::blocks(m_subject);
        if (!blocks.empty()) {
            section(tr("Measured parts against the prediction"), blocks);
        }
        const std::vector<Block> heldOut = PassportMeasured::heldOut(m_project);
        if (!heldOut.empty()) {
            section(tr("A cycle not used for the calibration"), heldOut);
        }
    }

    void addProfiles() {
        if (!m_outcome.result.sections.empty()) {
            heading(tr("Nominal part at the end of the cycle"));
            add(PassportFigures::alongThePart(m_outcome));
            add(PassportFigures::crossSections(m_outcome));
            addBars(OverviewChart::diameters, OverviewCharts::diameters(m_outcome));
        }
    }

    void addTexts() {
        lines(tr("Values based on estimates"), OutcomeRemarks::estimates(m_outcome));
        lines(tr("Remarks"), OutcomeRemarks::remarks(m_outcome));
        const QString notes = manyLines(exampleNotes(m_project.notes)).trimmed();
        lines(tr("Notes"), notes.isEmpty() ? QStringList() : QStringList{notes});
    }

    const Subject& m_subject;
    const Outcome& m_outcome;
    const Project& m_project;
    Report m_report;
};

} // namespace

Report passport(const Subject& subject) {
    return PassportWriter(subject).write();
}

} // namespace sparkout::report
