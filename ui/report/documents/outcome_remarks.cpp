// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/outcome_remarks.h"

#include "core/units.h"
#include "ui/charts/result_tables.h"
#include "ui/report/parts/cell_text.h"
#include "ui/text/calibration_text.h"
#include "ui/text/names.h"

#include <algorithm>

namespace sparkout::report {

QStringList OutcomeRemarks::estimates(const Outcome& outcome) {
    std::vector<std::pair<QString, QStringList>> groups; // requirements grouped by their estimates
    for (const ConstraintResult& c : outcome.constraints) {
        const QString inputs = EstimateNames::inputs(outcome.result.project, c.kind);
        const auto same = [&inputs](const auto& group) { return group.first == inputs; };
        auto group = std::ranges::find_if(groups, same);
        if (inputs.isEmpty()) {
            continue;
        }
        if (group == groups.end()) {
            group = groups.insert(group, {inputs, {}});
        }
        const QString name = Names::constraint(c.kind);
        const QString word = group->second.isEmpty() ? name : Names::inSentence(name);
        if (!group->second.contains(name) && !group->second.contains(word)) {
            group->second << word;
        }
    }
    QStringList lines;
    for (const auto& [inputs, names] : groups) {
        lines << QStringLiteral("%1: %2.").arg(names.join(QStringLiteral(", ")), inputs);
    }
    if (!lines.isEmpty()) {
        lines.prepend(tr("These predictions rest on inputs that are estimates, to be calibrated at "
                         "the machine."));
    }
    return lines;
}

QStringList OutcomeRemarks::remarks(const Outcome& outcome) {
    QStringList lines = shopRemarks(outcome.shop);
    for (std::size_t i = 0; i < outcome.result.ifEven.size(); ++i) {
        const auto& [least_mm, most_mm] = outcome.result.ifEven[i];
        lines << tr("%1: with an even number of lobes the diameters are %2…%3 µm from nominal.")
                     .arg(Names::zoneFull(outcome.result.sections[i].zone, static_cast<int>(i)),
                          Names::signedMicrometres(least_mm * units::umPerMm),
                          Names::signedMicrometres(most_mm * units::umPerMm));
    }
    for (const Issue& issue : outcome.issues) {
        lines << manyLines(Names::issue(issue));
    }
    return lines;
}

} // namespace sparkout::report
