// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/part_outline.h"

#include "core/project/part.h"

#include <algorithm>

namespace sparkout {

namespace {

constexpr double mostTakenOfStep = 0.5; ///< of a step that counts as free
constexpr double bushWall = 1.5; ///< ratio of diameter to bore for a bush without a given body

double commonLength_mm(const PartOutline::Step& a, const PartOutline::Step& b) {
    return std::min(a.to_mm(), b.to_mm()) - std::max(a.from_mm, b.from_mm);
}

} // namespace

PartOutline PartOutline::of(const SetupState& state) {
    PartOutline outline;
    double end_mm = 0, widest_mm = 0;
    for (const SurfaceStatePtr& surface : state.surfaces) {
        const Part& part = *surface->project.part;
        Ground ground;
        ground.from_mm = part.shaft.segments.empty() ? 0 : part.shaft.ground_from_mm;
        ground.length_mm = part.length_mm;
        ground.diameter_mm = part.diameter_mm;
        ground.isInternal = part.surface == Surface::internal;
        end_mm = std::max(end_mm, ground.to_mm());
        widest_mm = std::max(widest_mm, ground.diameter_mm * (ground.isInternal ? bushWall : 1));
        outline.surfaces.push_back(ground);
    }
    double at_mm = 0;
    for (const ShaftSegment& segment : state.inFront().project.part->shaft.segments) {
        outline.steps.push_back({at_mm, segment.length_mm, segment.diameter_mm});
        at_mm += segment.length_mm;
        outline.diameter_mm = std::max(outline.diameter_mm, segment.diameter_mm);
    }
    outline.hasSteps = !outline.steps.empty();
    if (!outline.hasSteps) {
        outline.steps.push_back({0, end_mm, widest_mm});
        at_mm = end_mm;
    }
    outline.diameter_mm = std::max(outline.diameter_mm, widest_mm);
    outline.length_mm = std::max(at_mm, end_mm);
    return outline;
}

std::optional<std::size_t> PartOutline::stepAt(double x_mm) const {
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (x_mm >= steps[i].from_mm && x_mm <= steps[i].to_mm()) {
            return i;
        }
    }
    return std::nullopt;
}

std::optional<std::size_t> PartOutline::surfaceAt(double x_mm) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const Ground& ground = surfaces[i];
        if (x_mm >= ground.from_mm && x_mm <= ground.to_mm()
            && (!found || ground.length_mm < surfaces[*found].length_mm)) {
            found = i;
        }
    }
    return found;
}

bool PartOutline::isFree(std::size_t step) const {
    return std::ranges::none_of(surfaces, [&](const Ground& ground) {
        return commonLength_mm(ground, steps[step]) > mostTakenOfStep * steps[step].length_mm;
    });
}

std::optional<std::size_t> PartOutline::firstFreeStep() const {
    for (std::size_t i = 0; hasSteps && i < steps.size(); ++i) {
        if (isFree(i)) {
            return i;
        }
    }
    return std::nullopt;
}

} // namespace sparkout
