// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/card/part_outline.h"

#include "core/project/part.h"

#include <algorithm>

namespace sparkout::report {

namespace {

constexpr double assumedWall = 1.5; ///< outer diameter over the largest bore, if not given

/// The steps with another one placed over them.
std::vector<OutlineStep> overlaid(const std::vector<OutlineStep>& steps, const OutlineStep& over) {
    std::vector<OutlineStep> all;
    const auto add = [&all](double from, double to, double diameter) {
        if (to > from) {
            all.push_back({from, to, diameter});
        }
    };
    for (const OutlineStep& step : steps) {
        add(step.from_mm, std::min(step.to_mm, over.from_mm), step.diameter_mm);
        if (step.from_mm <= over.from_mm && over.from_mm < step.to_mm) {
            add(over.from_mm, over.to_mm, over.diameter_mm);
        }
        add(std::max(step.from_mm, over.to_mm), step.to_mm, step.diameter_mm);
    }
    return all;
}

} // namespace

PartOutline::PartOutline(const Setup& setup) {
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        const Part& part = *setup.surfaces[i].project.part;
        const double from = part.shaft.ground_from_mm;
        GroundStep step;
        step.from_mm = from;
        step.to_mm = from + part.length_mm;
        step.diameter_mm = part.diameter_mm;
        step.surface = i;
        step.isBore = part.surface == Surface::internal;
        m_ground.push_back(step);
        m_length_mm = std::max(m_length_mm, step.to_mm);
    }
    std::ranges::stable_sort(m_ground, {}, [](const GroundStep& s) { return s.from_mm; });
    addOuter(setup);
    addBores();
}

void PartOutline::addOuter(const Setup& setup) {
    double at = 0;
    for (const ShaftSegment& segment : setup.surfaces.front().project.part->shaft.segments) {
        m_outer.push_back({at, at + segment.length_mm, segment.diameter_mm});
        at += segment.length_mm;
    }
    m_length_mm = std::max(m_length_mm, at);
    if (at < m_length_mm) { // the shaft is too short for the ground surface, or not given
        double diameter = 0;
        for (const GroundStep& step : m_ground) {
            diameter = std::max(diameter, step.diameter_mm * (step.isBore ? assumedWall : 1));
        }
        m_outerKnown = std::ranges::none_of(m_ground, &GroundStep::isBore);
        m_outer.push_back(
            {at, m_length_mm, m_outer.empty() ? diameter : m_outer.back().diameter_mm});
    }
    for (const GroundStep& step : m_ground) {
        if (!step.isBore) {
            m_outer = overlaid(m_outer, step);
        }
    }
}

void PartOutline::addBores() {
    std::vector<OutlineStep> bores;
    for (const GroundStep& step : m_ground) {
        if (step.isBore) {
            bores.push_back(step);
        }
    }
    if (bores.empty()) {
        return;
    }
    // Between and beyond the bores the part has a through hole of the smaller neighbour's diameter.
    double at = 0;
    for (std::size_t i = 0; i < bores.size(); ++i) {
        if (bores[i].from_mm > at) {
            const double before = i > 0 ? bores[i - 1].diameter_mm : bores[i].diameter_mm;
            m_bores.push_back({at, bores[i].from_mm, std::min(before, bores[i].diameter_mm)});
        }
        m_bores.push_back(bores[i]);
        at = std::max(at, bores[i].to_mm);
    }
    if (at < m_length_mm) {
        m_bores.push_back({at, m_length_mm, bores.back().diameter_mm});
    }
}

double PartOutline::largest_mm() const {
    return std::ranges::max_element(m_outer, {}, &OutlineStep::diameter_mm)->diameter_mm;
}

} // namespace sparkout::report
