// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/operation_card.h"

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/units.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace sparkout {

namespace {

/// Adds the lines one after the other.
class Writer {
public:
    Writer(const Setup& setup, const SetupRun& run) : m_setup(setup), m_run(run) {}

    OperationCard write() {
        transition(CardEntry::install, {}).auxiliary_min = auxiliary(m_setup.times.handling_s);
        add(CardEntry::fixture, {});
        for (std::size_t i = 0; i < m_setup.surfaces.size(); ++i) {
            grind(i);
        }
        transition(CardEntry::dress, {});
        control();
        transition(CardEntry::remove, {});
        if (m_run.isCompleted(m_setup)) {
            m_card.time = m_run.time;
        }
        return std::move(m_card);
    }

private:
    CardLine& add(CardEntry entry, std::optional<std::size_t> surface) {
        CardLine& line = m_card.lines.emplace_back();
        line.entry = entry;
        line.surface = surface;
        line.transition = m_transitions;
        return line;
    }
    CardLine& transition(CardEntry entry, std::optional<std::size_t> surface) {
        ++m_transitions;
        return add(entry, surface);
    }
    /// A share of the sum of times; 0 if the sum is given.
    [[nodiscard]] std::optional<double> auxiliary(double time_s) const {
        return m_setup.times.auxiliary_min ? std::nullopt
                                           : std::optional(time_s / units::secondsPerMinute);
    }

    void grind(std::size_t surface) {
        const SetupTimes& times = m_setup.times;
        const bool ran = surface < m_run.surfaces.size();
        CardLine& line = transition(CardEntry::grind, surface);
        line.auxiliary_min = auxiliary(times.approach_s + times.retreat_s + times.gauging_s
                                       + (surface > 0 ? times.positioning_s : 0));
        if (ran) {
            line.main_min = m_run.surfaces[surface].result.time_s / units::secondsPerMinute;
        }
        add(CardEntry::tooling, surface);
        const Project& project =
            ran ? m_run.surfaces[surface].result.project : m_setup.surfaces[surface].project;
        add(CardEntry::settings, surface).commands_mm = commandsOf(project);
        if (ran) {
            addRegimes(m_run.surfaces[surface].result, surface);
        }
    }

    /// Adds a transition for the surfaces of each kind, in the order of their first ones, split so
    /// that each list of names takes a few lines.
    void control() {
        constexpr std::size_t mostLetters = 200; // letters of all names
        const auto hasRoom = [this](const std::vector<std::size_t>& group, std::size_t more) {
            std::size_t letters = m_setup.surfaces[more].name.size();
            for (const std::size_t surface : group) {
                letters += m_setup.surfaces[surface].name.size();
            }
            return letters <= mostLetters;
        };
        std::vector<std::vector<std::size_t>> groups;
        const auto kindOf = [this](std::size_t surface) {
            return measuringKind(*m_setup.surfaces[surface].project.part);
        };
        for (std::size_t i = 0; i < m_setup.surfaces.size(); ++i) {
            const auto group = std::ranges::find_if(groups, [&](const auto& each) {
                return kindOf(each.front()) == kindOf(i) && hasRoom(each, i);
            });
            group == groups.end() ? groups.push_back({i}) : group->push_back(i);
        }
        for (std::vector<std::size_t>& group : groups) {
            const std::size_t first = group.front();
            transition(CardEntry::control, first).measured = std::move(group);
            add(CardEntry::measuring, first);
        }
    }

    /// The stock that the stages after each one remove.
    static std::vector<double> commandsOf(const Project& project) {
        std::vector<double> commands;
        if (project.gauge->control == Control::gauge) {
            double later_mm = 0;
            for (std::size_t z = project.cycle->stages.size(); z-- > 0;) {
                commands.push_back(later_mm);
                later_mm += project.cycle->stages[z].stock_mm;
            }
            std::ranges::reverse(commands);
        }
        return commands;
    }

    void addRegimes(const SimulationResult& result, std::size_t surface) {
        const Project& project = result.project;
        const StageFeed& radial = project.operation->radial();
        const StageFeed* const axial = project.operation->axial();
        const auto& stages = project.cycle->stages;
        for (std::size_t z = 0; z < stages.size(); ++z) {
            const Stage& stage = stages[z];
            CardRegime regime;
            regime.stage = static_cast<int>(z) + 1;
            regime.diameter_mm = project.part->diameter_mm;
            regime.length_mm = project.part->length_mm;
            regime.stock_mm = stage.stock_mm;
            regime.steps = z < result.countsByStage.size() ? result.countsByStage[z] : 0;
            regime.countsStrokes = project.operation->travels;
            regime.feeds = stage.feeds();
            regime.untilSize = stage.waitsForSize();
            regime.radialFeed = stage.feeds() ? (stage.*radial.value).value_or(0) : 0;
            if (axial) {
                regime.axialFeed_mm_min = stage.*axial->value;
            }
            regime.continuousFeed_mm_min = stage.continuousFeed_mm_min();
            regime.workSpeed_rpm = project.machine->work_speed_rpm;
            regime.workSpeed_m_min = std::numbers::pi * project.part->diameter_mm
                                     * project.machine->work_speed_rpm / units::mmPerM;
            regime.main_min = z < result.timeByStage_s.size()
                                  ? result.timeByStage_s[z] / units::secondsPerMinute
                                  : 0;
            add(CardEntry::regime, surface).regime = regime;
        }
    }

    const Setup& m_setup;
    const SetupRun& m_run;
    OperationCard m_card;
    int m_transitions = 0;
};

} // namespace

CardSymbol symbolOf(CardEntry entry) {
    switch (entry) {
    case CardEntry::install:
    case CardEntry::grind:
    case CardEntry::dress:
    case CardEntry::control:
    case CardEntry::remove: return CardSymbol::transition;
    case CardEntry::fixture:
    case CardEntry::tooling:
    case CardEntry::measuring: return CardSymbol::tooling;
    case CardEntry::regime: return CardSymbol::regime;
    case CardEntry::settings: break;
    }
    return CardSymbol::none;
}

MeasuringKind measuringKind(const Part& part) {
    const Tolerance& of = part.tolerance;
    return {part.surface == Surface::internal, of.radial_runout_um || of.total_runout_um,
            of.roundness_um || of.cylindricity_um, of.roughness_ra_um.has_value()};
}

OperationCard operationCard(const Setup& setup, const SetupRun& run) {
    return Writer(setup, run).write();
}

} // namespace sparkout
