// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/constraints/limit_chart.h"

#include "core/project/machine.h"
#include "core/units.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

using units::umPerMm;

double ratio(double value, double limit) {
    return limit > 0 ? value / limit : HUGE_VAL;
}

} // namespace

LimitChart::LimitChart(OutcomePtr outcome, int group, std::optional<ConstraintResult> requirement)
    : m_outcome(std::move(outcome)), m_group(group) {
    if (const LimitGroup* of = cuts()) {
        for (const ConstraintKind kind : depthLimitKinds()) {
            if (!LimitNames::isGuess(kind, m_outcome->result.project)) {
                m_limits[kind] = limitCurve(m_outcome->limits, *of, kind);
            }
        }
        m_stepless = steplessLimit(m_outcome->limits, *of);
        for (const AccuracyProof proof : {AccuracyProof::proved, AccuracyProof::estimate}) {
            if (auto by = accuracyLimit(m_outcome->result, m_outcome->limits, *of, proof)) {
                m_accuracy[proof] = std::move(by->curve);
            }
        }
        m_published =
            publishedAccuracy(m_outcome->result, m_outcome->trajectory, m_outcome->limits, *of);
        m_programmed = programmedSteps(m_outcome->result, m_outcome->limits, *of);
        findEnvelope();
    }
    setMarked(std::move(requirement));
}

void LimitChart::findEnvelope() {
    if (const auto infeed_mm = greatestInfeed_mm(m_outcome->result.project)) {
        const auto [least_mm, deepest_mm] = stocks_mm();
        m_machineFeed = {{least_mm, *infeed_mm}, {deepest_mm, *infeed_mm}};
    }
    std::vector<BoundCurve> curves;
    for (const auto& [kind, points] : m_limits) {
        if (requirementOf(kind).bindsEveryPass()) {
            curves.push_back({LimitBound::requirement, kind, points});
        }
    }
    curves.push_back({LimitBound::accuracy, {}, accuracy(AccuracyProof::proved)});
    curves.push_back({LimitBound::feed, {}, m_machineFeed});
    m_envelope = envelopeOf(curves);
}

QString LimitChart::boundName(const BoundCurve& piece) {
    switch (piece.bound) {
    case LimitBound::feed: return tr("machine's feed");
    case LimitBound::accuracy: return tr("accuracy");
    case LimitBound::requirement: return LimitNames::limit(piece.kind);
    case LimitBound::stock: break;
    }
    return {};
}

QString LimitChart::boundAt(double stock_mm) const {
    const auto at = std::ranges::find_if(m_envelope, [stock_mm](const BoundCurve& piece) {
        return piece.points.front().stock_mm <= stock_mm
               && stock_mm <= piece.points.back().stock_mm;
    });
    return at == m_envelope.end() ? QString() : boundName(*at);
}

const LimitGroup* LimitChart::cuts() const {
    return m_outcome && m_group >= 0 ? &m_outcome->limits.groups[static_cast<std::size_t>(m_group)]
                                     : nullptr;
}

const LimitPoints& LimitChart::limit(ConstraintKind kind) const {
    static const LimitPoints off;
    const auto found = m_limits.find(kind);
    return found == m_limits.end() ? off : found->second;
}

void LimitChart::setMarked(std::optional<ConstraintResult> requirement) {
    m_requirement = std::move(requirement);
    m_marked.reset();
    const LimitGroup* group = cuts();
    if (group && m_requirement) {
        m_marked = limitedCutOf(m_outcome->result, m_outcome->trajectory, *m_requirement);
        if (m_marked && limitGroupAt(m_outcome->limits, m_marked->place) != m_group) {
            m_marked.reset();
        }
    } else if (group && group->worst.depth_mm > 0 && !m_stepless.empty()) {
        m_marked = group->worst;
    }
}

std::pair<double, double> LimitChart::stocks_mm() const {
    return m_outcome ? std::pair(m_outcome->limits.least_mm, m_outcome->limits.deepest_mm)
                     : std::pair(0.0, 0.0);
}

std::vector<DepthLimit> LimitChart::limitsOf(const LimitedCut& cut) const {
    std::vector<DepthLimit> limits =
        depthLimits(m_outcome->result.project, cut.width_mm, cut.stock_mm);
    std::erase_if(limits, [this](const DepthLimit& l) { return limit(l.kind).empty(); });
    return limits;
}

QString LimitChart::markText() const {
    if (!m_marked) {
        return {};
    }
    if (m_requirement) {
        return QStringLiteral("%1: %2").arg(Names::constraint(m_requirement->kind),
                                            LimitNames::percent(1 - m_requirement->relativeMargin));
    }
    const std::vector<DepthLimit> limits = limitsOf(*m_marked);
    const DepthLimit* binding = bindingOf(limits);
    return binding ? tr("nearest to its feed limit: %1, %2")
                         .arg(LimitNames::limit(binding->kind),
                              LimitNames::percent(ratio(m_marked->depth_mm, binding->depth_mm)))
                   : QString();
}

QString LimitChart::valuesAt(const LimitedCut& cut) const {
    const auto um = [](double value_mm) { return Names::significant(value_mm * umPerMm); };
    std::vector<DepthLimit> limits = limitsOf(cut);
    std::ranges::sort(limits, {}, &DepthLimit::depth_mm);
    const DepthLimit* binding = bindingOf(limits);
    QStringList parts;
    for (const DepthLimit& limit : limits) {
        parts << QStringLiteral("%1 %2").arg(LimitNames::limit(limit.kind), um(limit.depth_mm));
        if (&limit == binding) {
            parts.back() +=
                tr(" (%1 used)").arg(LimitNames::percent(ratio(cut.depth_mm, limit.depth_mm)));
        }
    }
    QString text = tr("%1: stock left %2 µm, actual feed %3 µm, width %4 mm")
                       .arg(Names::place(cut.place, m_outcome->result.project.operation),
                            Names::signedMicrometres(cut.stock_mm * umPerMm), um(cut.depth_mm),
                            Names::significant(cut.width_mm));
    if (!parts.isEmpty()) {
        text += u'\n' + tr("Allowed feed, µm: %1").arg(parts.join(QStringLiteral("; ")));
    }
    const QString bound = boundAt(cut.stock_mm); // the requirement is marked above
    if (!bound.isEmpty() && !(binding && bound == LimitNames::limit(binding->kind))) {
        text += (parts.isEmpty() ? QStringLiteral("\n") : QStringLiteral("; "))
                + tr("binds: %1").arg(bound);
    }
    return text;
}

const LimitPoints& LimitChart::accuracy(AccuracyProof proof) const {
    static const LimitPoints none;
    const auto found = m_accuracy.find(proof);
    return found == m_accuracy.end() ? none : found->second;
}

std::optional<double> LimitChart::perMinute() const {
    const LimitGroup* group = cuts();
    if (!group || (!group->standing && m_outcome->result.project.operation->countsStrokes)) {
        return std::nullopt;
    }
    return m_outcome->result.project.machine->work_speed_rpm / umPerMm;
}

/// A cut belongs to a revolution where the wheel plunges or dwells, otherwise to a stroke.
QString LimitChart::feedLabel() const {
    const LimitGroup* group = cuts();
    const bool stroke =
        group && !group->standing && m_outcome->result.project.operation->countsStrokes;
    return stroke ? tr("Actual feed, µm per pass") : tr("Actual feed, µm per revolution");
}

CsvTable LimitChart::table(const std::function<bool(double)>& inSight,
                           const std::function<bool(ConstraintKind)>& wanted) const {
    CsvTable table;
    const LimitGroup* group = cuts();
    if (!group) {
        return table;
    }
    const bool strokes = m_outcome->result.project.operation->countsStrokes;
    table.header << tr("stage") << (strokes ? tr("double stroke") : tr("revolution"))
                 << tr("stock left, µm") << tr("actual feed, µm") << tr("width of cut, mm");
    bool named = false;
    for (const LimitedCut& cut : group->cuts) {
        if (!inSight(cut.stock_mm)) {
            continue;
        }
        const std::vector<DepthLimit> limits = limitsOf(cut);
        std::vector<CsvCell> row{double(cut.place.stage), double(cut.place.cycleCount),
                                 cut.stock_mm * umPerMm, cut.depth_mm * umPerMm, cut.width_mm};
        for (const DepthLimit& limit : limits) {
            if (wanted(limit.kind)) {
                row.emplace_back(limit.depth_mm * umPerMm);
                if (!named) {
                    table.header << tr("limit: %1, µm").arg(LimitNames::limit(limit.kind));
                }
            }
        }
        if (const DepthLimit* binding = bindingOf(limits)) {
            row.insert(row.end(), {binding->depth_mm * umPerMm, LimitNames::limit(binding->kind)});
            if (!named) {
                table.header << tr("stepless limit, µm") << tr("binding");
            }
        }
        named = true;
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace sparkout
