// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/part_table.h"

#include "core/project/part.h"
#include "core/quality/light.h"
#include "core/quality/requirement.h"
#include "ui/charts/light_icon.h"
#include "ui/kit/metrics.h"
#include "ui/part/part_text.h"
#include "ui/session/surface_edits.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QGuiApplication>

#include <algorithm>
#include <optional>
#include <set>

namespace sparkout {

namespace {

struct PartTable {
    Q_DECLARE_TR_FUNCTIONS(PartTable)
};

/// With its own unit; in the common one for a spreadsheet.
ValueCell cycleTimeCell(const std::optional<double>& time_s, const TimeUnit& unit) {
    constexpr int digits = 4;
    return ValueCell::of(time_s ? std::optional(unit.of(*time_s)) : std::nullopt,
                         [&time_s](double) { return Names::time(*time_s, digits); });
}

/// The cycle that a search found; null without one.
const FoundCycle* foundBy(const SurfaceStudy& study) {
    return study.search && study.search->ran() ? study.search->answer() : nullptr;
}

ValueCell searchCell(const PartStudies& studies, int id, const TimeUnit& unit) {
    const auto found = studies.searches.find(id);
    if (found == studies.searches.end()) {
        return {};
    }
    const SurfaceStudy& study = *found->second;
    if (!study.search || !study.search->ran()) {
        return {.text = PartTable::tr("refused")};
    }
    const FoundCycle* const answer = foundBy(study);
    return answer ? cycleTimeCell(answer->time_s, unit)
                  : ValueCell{.text = PartTable::tr("none feasible")};
}

QString rejectedText(std::int64_t bad, std::int64_t parts) {
    return PartTable::tr("%1 of %2 bad").arg(bad).arg(parts);
}

/// The batch of all surfaces, otherwise that of the verdict.
ValueCell batchCell(const PartStudies& studies, int id, const std::optional<JudgedBatch>& judged) {
    const auto found = studies.batches.find(id);
    if (found == studies.batches.end()) {
        return judged ? ValueCell{.text = rejectedText(judged->bad, judged->parts)} : ValueCell{};
    }
    const SurfaceStudy& study = *found->second;
    if (!study.isSetUp) {
        return {.text = PartTable::tr("not set up")};
    }
    if (!study.issues.empty() || !study.batch || !study.batch->ran()) {
        return {.text = PartTable::tr("refused")};
    }
    const BatchSummary& summary = study.batch->summary;
    return {.text = rejectedText(summary.bad.count, summary.parts)};
}

QString nameOf(const SetupState& state, std::size_t surface) {
    return QStringLiteral("%1. %2")
        .arg(surface + 1)
        .arg(printableText(SurfaceEdits::nameOf(state, surface)));
}

std::optional<double> timeOf(const SurfaceStatus& status) {
    return status.ran() ? std::optional(status.time_s) : std::nullopt;
}

/// The unit of the times of all surfaces, and of the cycles found for them.
TimeUnit commonUnit(const std::vector<SurfaceStatus>& statuses, const PartStudies& studies) {
    double longest_s = 0;
    for (const SurfaceStatus& status : statuses) {
        longest_s = std::max(longest_s, timeOf(status).value_or(0));
    }
    for (const auto& [id, study] : studies.searches) {
        const FoundCycle* const answer = foundBy(*study);
        longest_s = std::max(longest_s, answer ? answer->time_s : 0);
    }
    return TimeUnit(longest_s);
}

QIcon iconOf(const SurfaceStatus& status) {
    return QIcon(statusPixmap(status, metrics::iconSmall, qGuiApp->devicePixelRatio()));
}

QString requirementName(const std::vector<SurfaceStatus>& statuses, ConstraintKind kind) {
    const char* const unit = requirementOf(kind).unit;
    const bool isEstimate = kind == ConstraintKind::roughness
                            && std::ranges::any_of(statuses, &SurfaceStatus::isRoughnessEstimate);
    const QString name = isEstimate ? PartTable::tr("Ra, estimate") : Names::constraint(kind);
    return *unit ? PartTable::tr("%1, %2").arg(name, unitText(unit)) : name;
}

/// "12.3 / 25" beside its light; undecided values look different from those known to be met.
ValueCell requirementCell(const SurfaceStatus& status, ConstraintKind kind) {
    const auto found = std::ranges::find(status.requirements, kind, &ConstraintResult::kind);
    if (found == status.requirements.end()) {
        return {.text = QStringLiteral("–"), .value = QString()};
    }
    return {.text = QStringLiteral("%1 / %2").arg(Names::value(*found), Names::limit(*found)),
            .icon = QIcon(lightPixmap(lightOf(*found), metrics::iconSmall,
                                      qGuiApp->devicePixelRatio(), false))};
}

} // namespace

void PartStudies::add(int id, const SurfaceStudyPtr& study) {
    (study->kind == SurfaceStudy::Kind::search ? searches : batches)[id] = study;
}

ValueTable partTable(const SetupState& state, const std::vector<SurfaceStatus>& statuses,
                     const PartStudies& studies) {
    const TimeUnit unit = commonUnit(statuses, studies);
    ValueTable table{
        .columns = {{.text = PartTable::tr("Surface"), .key = "surface", .isText = true},
                    {.text = PartTable::tr("⌀, mm"), .key = "diameter"},
                    {.text = PartTable::tr("Cycle"),
                     .name = unit.titled(PartTable::tr("Cycle")),
                     .key = "time"},
                    {.text = PartTable::tr("Verdict"), .key = "verdict", .isText = true},
                    {.text = PartTable::tr("Minimum margin"), .key = "margin", .isText = true},
                    {.text = PartTable::tr("Found"),
                     .name = unit.titled(PartTable::tr("Found")),
                     .key = "search"},
                    {.text = PartTable::tr("Batch"), .key = "batch"}},
        .isList = true};
    for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
        const SurfaceState& of = *state.surfaces[i];
        const SurfaceStatus& status = statuses[i];
        const double diameter_mm = of.project.part->diameter_mm;
        table.addRow({.text = nameOf(state, i)},
                     {{.text = nameOf(state, i)},
                      {.text = printedNumber(diameter_mm), .value = diameter_mm},
                      cycleTimeCell(timeOf(status), unit),
                      {.text = statusText(status), .icon = iconOf(status)},
                      {.text = worstText(status)},
                      searchCell(studies, of.id, unit),
                      batchCell(studies, of.id, status.judgement.batch)});
    }
    return table;
}

ValueTable surfaceComparison(const SetupState& state, const std::vector<SurfaceStatus>& statuses) {
    ValueTable table{.columns = {{.text = PartTable::tr("Value / limit"), .isText = true}},
                     .isList = true};
    std::set<ConstraintKind> kinds;
    const TimeUnit unit = commonUnit(statuses, {});
    std::vector<ValueCell> times{
        {.text = PartTable::tr("Cycle time"), .value = unit.titled(PartTable::tr("Cycle time"))}};
    for (std::size_t i = 0; i < statuses.size(); ++i) {
        table.columns.push_back({.text = nameOf(state, i), .isText = true}); // beside the lights
        times.push_back(cycleTimeCell(timeOf(statuses[i]), unit));
        for (const ConstraintResult& requirement : statuses[i].requirements) {
            kinds.insert(requirement.kind);
        }
    }
    table.addRow({.text = times.front().text}, times);
    for (const ConstraintKind kind : kinds) {
        std::vector<ValueCell> cells{{.text = requirementName(statuses, kind)}};
        for (const SurfaceStatus& status : statuses) {
            cells.push_back(requirementCell(status, kind));
        }
        table.addRow({.text = cells.front().text}, cells);
    }
    return table;
}

} // namespace sparkout
