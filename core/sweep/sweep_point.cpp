// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sweep/sweep_point.h"

#include "core/batch/characteristics.h"
#include "core/project/part.h"
#include "core/quality/constraints.h"
#include "core/quality/drawing_constraints.h"
#include "core/quality/finished_surface.h"
#include "core/units.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr double percent = 100;

class PointMeasure {
public:
    explicit PointMeasure(const SimulationResult& result)
        : m_result(result), m_constraints(evaluateConstraints(result)) {}

    MeasuredPoint measure() {
        m_measured.point.status = SweepStatus::done;
        m_measured.point.run = m_result.status;
        add("time", "s", {m_result.time_s});
        addLeastMargin();
        for (std::size_t i = 0; i < m_result.sections.size(); ++i) {
            addSection(m_result.sections[i], static_cast<int>(i));
        }
        for (const ConstraintResult& constraint : worstByKind(m_constraints)) {
            if (requirementOf(constraint.kind).scope != ConstraintScope::section) {
                add(requirementOf(constraint.kind).key, requirementOf(constraint.kind).unit,
                    valueOf(constraint));
            }
        }
        add("peak_normal_force", "N", {m_result.peakNormalForce_n});
        add("peak_power", "kW", {m_result.peakPower_w / units::wPerKw});
        return std::move(m_measured);
    }

private:
    void add(const char* name, const char* unit, const SweepValue& value, Zone zone = Zone::section,
             int section = -1) {
        m_measured.quantities.push_back({name, unit, zone, section});
        m_measured.point.values.push_back(value);
    }

    static SweepValue valueOf(const ConstraintResult& constraint) {
        if (!constraint.isWhole) {
            return {}; // strips stay uncut
        }
        SweepValue value{constraint.value};
        (constraint.isLeast ? value.low : value.high) = constraint.limit;
        value.margin = constraint.margin;
        return value;
    }

    /// Like a batch: settings, such as those limited by the machine's ranges, have no margin of
    /// that kind.
    void addLeastMargin() {
        SweepPoint& point = m_measured.point;
        point.good = true;
        std::optional<double> least;
        for (const ConstraintResult& constraint : m_constraints) {
            point.good = point.good && constraint.holds;
            if (requirementOf(constraint.kind).scope != ConstraintScope::setting
                && constraint.isWhole) {
                least =
                    std::min(least.value_or(constraint.relativeMargin), constraint.relativeMargin);
            }
        }
        if (least) {
            SweepValue value{*least * percent};
            value.low = 0;
            value.margin = value.value;
            add("least_margin", "%", value);
        }
    }

    void addSection(const SectionResult& section, int index) {
        const Part& part = *m_result.project.part;
        const auto addHere = [&](const char* name, const SweepValue& value) {
            add(name, "µm", value, section.zone, index);
        };
        if (!FinishedSurface(m_result.project).isWhole()) {
            return;
        }
        SweepValue diameter{meanDeviation_um(section, part.diameter_mm)};
        diameter.low = part.lower_deviation_um;
        diameter.high = part.upper_deviation_um;
        diameter.margin = std::min(diameter.value - diameter.low, diameter.high - diameter.value);
        addHere("diameter", diameter);
        bool runout = false, roundness = false;
        for (const ConstraintResult& constraint : m_constraints) {
            if (requirementOf(constraint.kind).scope == ConstraintScope::section
                && constraint.section == index) {
                addHere(requirementOf(constraint.kind).key, valueOf(constraint));
                runout = runout || constraint.kind == ConstraintKind::radialRunout;
                roundness = roundness || constraint.kind == ConstraintKind::roundness;
            }
        }
        if (!runout) {
            addHere(requirementOf(ConstraintKind::radialRunout).key,
                    {section.radialRunout_mm * units::umPerMm});
        }
        if (!roundness) {
            const auto place = static_cast<std::size_t>(index);
            addHere(requirementOf(ConstraintKind::roundness).key,
                    {roundnessOf(m_result, place) * units::umPerMm});
        }
    }

    const SimulationResult& m_result;
    std::vector<ConstraintResult> m_constraints;
    MeasuredPoint m_measured;
};

} // namespace

MeasuredPoint measurePoint(const SimulationResult& result) {
    return PointMeasure(result).measure();
}

} // namespace sparkout
