// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/passport.h"

#include "core/project/batch.h"
#include "ui/report/documents/capability_chart.h"
#include "ui/report/documents/outcome_remarks.h"
#include "ui/report/documents/passport_figures.h"
#include "ui/report/documents/passport_inputs.h"
#include "ui/report/documents/passport_measured.h"
#include "ui/report/documents/passport_prediction.h"
#include "ui/report/documents/passport_verdict.h"
#include "ui/report/parts/begun_report.h"
#include "ui/report/parts/calibrated_table.h"
#include "ui/report/parts/cell_text.h"
#include "ui/report/parts/operation_setup.h"
#include "ui/report/parts/part_sketch.h"
#include "ui/text/dressing_text.h"
#include "ui/text/example_texts.h"
#include "ui/views/overview/overview_charts.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace sparkout::report {

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
            section(tr("A cycle that the calibration has not used"), heldOut);
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
