// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/passport.h"

#include "ui/report/documents/passport_parts.h"
#include "ui/report/parts/cycle_card_parts.h"
#include "ui/report/parts/part_sketch.h"
#include "ui/report/parts/report_values.h"
#include "ui/text/example_texts.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace sparkout::report {

namespace {

class PassportWriter {
public:
    explicit PassportWriter(const Subject& subject)
        : m_subject(subject), m_outcome(*subject.outcome), m_project(m_outcome.result.project) {}

    Report write() {
        m_report = begunReport(Passport::tr("Accuracy passport of a grinding cycle"), m_project,
                               m_subject.file, m_subject.date);
        add(CycleCard::header(m_project, m_subject.date));
        section(Passport::tr("Verdict"), Passport::verdict(m_subject));
        heading(Passport::tr("Drawing and part"));
        add(partSketch(m_subject.outcome));
        add(Passport::drawing(m_project));
        heading(Passport::tr("Tooling and settings"));
        add(CycleCard::settings(m_outcome));
        heading(Passport::tr("Regimes by stage"));
        add(CycleCard::stages(m_outcome));
        section(Passport::tr("Batch: factors and scenarios"), Passport::scenarios(m_subject));
        addPrediction();
        addProfiles();
        if (m_subject.batch) {
            section(Passport::tr("Worst part of the batch"), Passport::worst(m_subject));
        }
        if (!m_outcome.constraints.empty()) {
            heading(Passport::tr("Requirements of the nominal part"));
            add(Passport::requirements(m_outcome));
        }
        addTexts();
        section(Passport::tr("Recomputing"), Passport::recomputing(m_subject));
        heading(Passport::tr("Appendix: all inputs"));
        add(Passport::inputs(m_project));
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

    void section(const QString& name, std::vector<Block> blocks) {
        heading(name);
        std::ranges::move(blocks, std::back_inserter(m_report.blocks));
    }

    void lines(const QString& name, const QStringList& texts) {
        if (!texts.isEmpty()) {
            heading(name);
            for (const QString& text : texts) {
                add(Paragraph{text});
            }
        }
    }

    void addPrediction() {
        heading(Passport::tr("Predicted accuracy against the drawing"));
        if (!m_subject.batch) {
            add(Passport::nominal(m_outcome));
            return;
        }
        const BatchSummary& summary = m_subject.batch->summary;
        add(Passport::values(m_subject));
        if (!summary.isSample) {
            add(Paragraph{Passport::tr("Corners are no sample: they tell extremes and counts, no "
                                       "mean and no capability.")});
        }
        if (summary.characteristics.empty()) {
            return; // no part reached size
        }
        heading(Passport::tr("Capability and share out of tolerance"));
        add(Passport::capability(summary));
        if (auto chart = Passport::capabilityChart(summary)) {
            add(std::move(*chart));
        }
        if (summary.isSample) {
            heading(Passport::tr("Percentiles"));
            Table table = Passport::percentiles(summary);
            const bool hasDash = std::ranges::any_of(table.rows, [](const QStringList& row) {
                return row.contains(QStringLiteral("–"));
            });
            add(std::move(table));
            if (hasDash) {
                add(Paragraph{
                    Passport::tr("–: of so few values it would be the smallest or the largest.")});
            }
        }
        heading(Passport::tr("Distribution against the tolerance field"));
        addHistograms(summary);
    }

    /// Of the mean diameter, and of what decides when that is not a diameter.
    void addHistograms(const BatchSummary& summary) {
        const std::string usual = summary.characteristics.front().characteristic.name;
        add(Passport::histograms(summary, usual));
        const CharacteristicSummary* deciding = Passport::deciding(summary);
        if (deciding && !std::string_view(deciding->characteristic.name).starts_with(usual)) {
            add(Passport::histograms(summary, deciding->characteristic.name));
        }
    }

    void addProfiles() {
        if (!m_outcome.result.sections.empty()) {
            heading(Passport::tr("Nominal part at the end of the cycle"));
            add(Passport::alongThePart(m_outcome));
            add(Passport::crossSections(m_outcome));
        }
    }

    void addTexts() {
        lines(Passport::tr("What rests on estimates"), CycleCard::estimates(m_outcome));
        lines(Passport::tr("Remarks"), CycleCard::remarks(m_outcome));
        const QString notes = manyLines(exampleNotes(m_project.notes)).trimmed();
        lines(Passport::tr("Notes"), notes.isEmpty() ? QStringList() : QStringList{notes});
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
