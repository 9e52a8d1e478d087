// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/whole_batch.h"

#include "core/batch/scenario_source.h"
#include "core/measured/adequacy.h"
#include "core/project/batch.h"
#include "core/quality/constraints.h"
#include "core/simulation/simulate.h"

#include <cstdint>
#include <utility>

namespace sparkout {

PartSink PartRowsFile::begin(const ScenarioSource& source, const std::stop_token& stop) {
    PartColumns columns = PartColumns::of(source, stop);
    const std::vector<std::string> head = m_form.head(columns);
    m_table = std::make_unique<PartTable>(std::move(columns), m_form.dialect);
    m_file.write(m_table->head(head));
    return [this](const PartRecord& record) { return m_file.write(m_table->line(record)); };
}

bool PartRowsFile::runBatch(const Project& project, BatchOptions options,
                            const KeepGoing& keepGoing) {
    const ScenarioSource source(project);
    const auto parts = static_cast<double>(source.parts());
    std::int64_t done = 0;
    options.sink = [&keepGoing, &done, parts,
                    write = begin(source, options.stop)](const PartRecord& record) {
        return keepGoing(static_cast<double>(++done) / parts) && write(record);
    };
    return !error() && sparkout::runBatch(project, options).status == BatchStatus::completed
           && finish();
}

const Characteristic* BatchOutcome::characteristicOf(std::size_t quantity) const {
    return quantity < factors.size()
               ? nullptr
               : &summary.characteristics[quantity - factors.size()].characteristic;
}

double BatchOutcome::valueOf(std::size_t row, std::size_t quantity) const {
    return quantity < factors.size()
               ? drawn[row][quantity]
               : result.statistics.rows[row].values[quantity - factors.size()];
}

bool BatchOutcome::isOutside(std::size_t row, std::size_t quantity) const {
    const Characteristic* const of = characteristicOf(quantity);
    const double value = valueOf(row, quantity);
    return of && ((of->low && value < *of->low) || (of->high && value > *of->high));
}

BatchOutcomePtr runWholeBatch(const Project& project, const BatchOptions& options) {
    auto outcome = std::make_shared<BatchOutcome>();
    outcome->result = runBatch(project, options);
    outcome->issues = outcome->result.issues;
    if (outcome->ran()) {
        outcome->summary = summarise(outcome->result);
        outcome->regressions = rankRegressions(outcome->result);
        const ScenarioSource source(outcome->result.project);
        outcome->factors = source.factors();
        for (const PartRow& row : outcome->result.statistics.rows) {
            outcome->drawn.push_back(source.values(row.part));
        }
        const Project& stated = outcome->result.project;
        outcome->notDecided = undecided(stated, evaluateConstraints(simulate(stated)));
    }
    return outcome;
}

std::int64_t partsOf(const Project& project) {
    if (!project.batch) {
        return 0;
    }
    const std::vector<GivenFactor> factors = scatteredFactors(project);
    const bool corners = project.batch->scenarios == Scenarios::corners;
    return corners || factors.empty() ? cornerCount(factors) : project.batch->parts;
}

std::int64_t partsOfIndices(const Project& project, int points) {
    return std::int64_t{points} * (static_cast<std::int64_t>(scatteredFactors(project).size()) + 2);
}

Judgement judgementOf(const Outcome& outcome, const BatchOutcome* batch,
                      const BatchOutcome* predicting) {
    const bool hasBatch = batch && batch->ran();
    const Project& project = outcome.result.project;
    return judge(outcome.result, outcome.constraints, judgeStocks(outcome.result),
                 hasBatch ? std::optional(judgeBatch(batch->result, batch->summary)) : std::nullopt,
                 predicting && predicting->ran()
                     ? greatestBias(project, judgeAdequacy(project, predicting->result))
                     : std::nullopt);
}

BatchJudgement judgeBatchOf(const Project& project, const BatchOptions& options) {
    BatchJudgement judged;
    const bool isMeasured = !statisticsOfMeasured(project).empty();
    if (!project.batch && !isMeasured) {
        return judged;
    }
    const BatchResult result = runBatch(isMeasured ? predictingProject(project) : project, options);
    if (result.status == BatchStatus::refused) {
        judged.issues = result.issues;
        return judged;
    }
    if (project.batch) {
        judged.batch = judgeBatch(result, summarise(result));
    }
    if (isMeasured && result.status == BatchStatus::completed) {
        judged.measured = greatestBias(project, judgeAdequacy(project, result));
    }
    return judged;
}

} // namespace sparkout
