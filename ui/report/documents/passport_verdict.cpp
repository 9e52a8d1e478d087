// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/passport_verdict.h"

#include "core/project/batch.h"
#include "core/study/whole_batch.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/views/batch/batch_text.h"
#include "ui/views/verdict/verdict_text.h"

#include <algorithm>

namespace sparkout::report {

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

} // namespace sparkout::report
