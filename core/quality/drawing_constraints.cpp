// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/drawing_constraints.h"

#include "core/quality/roughness.h"
#include "core/units.h"

#include <algorithm>

namespace sparkout {

namespace {

/// Which way a limit holds.
enum class Side { atLeast, atMost };

constexpr double slack_um = diameterSlack_mm * units::umPerMm;

/// Requirements in µm, held against sections or the part.
class DrawingConstraints {
public:
    DrawingConstraints(const SimulationResult& result, const PartAccuracy& accuracy)
        : m_result(result), m_accuracy(accuracy) {}

    std::vector<ConstraintResult> evaluate() {
        for (m_index = 0; m_index < m_result.sections.size(); ++m_index) {
            addSection(m_result.sections[m_index]);
        }
        const Tolerance& tolerance = m_result.project.part.tolerance;
        addPart(ConstraintKind::cylindricity, tolerance.cylindricity_um,
                m_accuracy.minimumZone.deviation());
        addPart(ConstraintKind::totalRunout, tolerance.total_runout_um, m_accuracy.totalRunout_mm);
        return std::move(m_found);
    }

private:
    void addSection(const SectionResult& section) {
        const Part& part = m_result.project.part;
        const double low = part.lower_deviation_um, high = part.upper_deviation_um;
        add(ConstraintKind::diameterMin, Side::atLeast, low,
            section.diameterDeviationMin_mm * units::umPerMm, high - low);
        add(ConstraintKind::diameterMax, Side::atMost, high,
            section.diameterDeviationMax_mm * units::umPerMm, high - low);
        const Tolerance& tolerance = part.tolerance;
        addLimit(ConstraintKind::radialRunout, tolerance.radial_runout_um,
                 section.radialRunout_mm * units::umPerMm);
        if (tolerance.roundness_um) {
            addLimit(ConstraintKind::roundness, tolerance.roundness_um,
                     m_accuracy.sections[m_index].minimumZone.deviation() * units::umPerMm);
        }
        if (tolerance.roughness_ra_um && section.lastCut) {
            const double Ra = RoughnessModel(m_result.project).roughness(section.lastCut->depth_mm);
            addLimit(ConstraintKind::roughness, tolerance.roughness_ra_um, Ra * units::umPerMm);
            m_found.back().at = section.lastCut->at;
        }
    }

    void add(ConstraintKind kind, Side side, double limit, double value, double width) {
        ConstraintResult result{kind};
        result.zone = m_result.sections[m_index].zone;
        result.section = static_cast<int>(m_index);
        result.limit = limit;
        result.value = value;
        result.isLeast = side == Side::atLeast;
        result.margin = result.isLeast ? value - limit : limit - value;
        result.relativeMargin = result.margin / width;
        result.holds = result.margin >= -slack_um;
        m_found.push_back(result);
    }

    void addLimit(ConstraintKind kind, const std::optional<double>& limit, double value) {
        if (limit) {
            add(kind, Side::atMost, *limit, value, *limit);
        }
    }

    void addPart(ConstraintKind kind, const std::optional<double>& limit, double value_mm) {
        if (limit && !m_result.sections.empty()) {
            m_index = 0;
            addLimit(kind, limit, value_mm * units::umPerMm);
            m_found.back().section = -1;
        }
    }

    const SimulationResult& m_result;
    const PartAccuracy& m_accuracy;
    std::vector<ConstraintResult> m_found;
    std::size_t m_index = 0;
};

double geometricRunout(const SimulationResult& result) {
    return result.project.machine.geometric_runout_um / units::umPerMm;
}

} // namespace

std::vector<SectionShape> shapesOf(const SimulationResult& result) {
    std::vector<SectionShape> shapes;
    for (const SectionResult& section : result.sections) {
        shapes.push_back({section.position_mm, section.radii_mm});
    }
    return shapes;
}

PartAccuracy accuracyOf(const SimulationResult& result) {
    return partAccuracy(shapesOf(result), geometricRunout(result));
}

std::vector<ConstraintResult> drawingConstraints(const SimulationResult& result,
                                                 const PartAccuracy& accuracy) {
    return DrawingConstraints(result, accuracy).evaluate();
}

PartAccuracy requiredAccuracy(const SimulationResult& result) {
    PartAccuracy accuracy;
    const Tolerance& tolerance = result.project.part.tolerance;
    const std::vector<SectionShape> shapes = shapesOf(result);
    if (shapes.empty()) {
        return accuracy;
    }
    if (tolerance.roundness_um || tolerance.cylindricity_um) {
        const Directions directions(shapes[0].radii_mm.size());
        for (std::size_t i = 0; tolerance.roundness_um && i < shapes.size(); ++i) {
            SectionAccuracy section;
            section.minimumZone = minimumZoneCircles(shapes[i].radii_mm, directions);
            accuracy.sections.push_back(section);
        }
        if (tolerance.cylindricity_um) {
            accuracy.minimumZone = minimumZoneCylinder(shapes, directions);
        }
    }
    if (tolerance.total_runout_um) {
        accuracy.totalRunout_mm = runout(shapes, geometricRunout(result));
    }
    return accuracy;
}

} // namespace sparkout
