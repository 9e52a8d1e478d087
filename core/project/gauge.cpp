// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/gauge.h"

#include "core/project/conditions.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/text.h"
#include "core/units.h"

namespace sparkout {

namespace {

bool gaugeAtSection(const Project& p, const void*) {
    return !p.operation->travels && !p.gauge->position_mm;
}
bool gaugeMeetsGaps(const Project& p, const void*) {
    return !p.part->gaps.empty() && conditions::gaugeEndsAStage(p, nullptr);
}
bool gaugeFree(const Project& p, const void*) {
    return !p.operation->travels && p.gauge->position_mm;
}

} // namespace

double gaugeDelay_s(const Project& project) {
    return project.gauge->delay_s.value_or(project.machine->gauge_delay_s.value_or(0));
}

double readsTooLarge_mm(const Project& project) {
    constexpr double perMetre = 1e-6; // converts µm/m
    const Gauge& gauge = *project.gauge;
    return gauge.error_um / units::umPerMm
           + project.material->expansion_um_m_k * perMetre * project.part->diameter_mm
                 * gauge.part_warmer_k;
}

double deeperAtSize_mm(const Project& project) {
    const double half_mm = readsTooLarge_mm(project) / 2;
    return project.part->surface == Surface::external ? half_mm : -half_mm;
}

template <>
std::span<const Choice> choicesOf<Control>() {
    static const std::array choices{
        Choice{"gauge", SPARKOUT_NOOP("Choice", "by the in-process gauge")},
        Choice{"position", SPARKOUT_NOOP("Choice", "by wheel head position")}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<GaugeRule>() {
    static const std::array choices{Choice{"min", SPARKOUT_NOOP("Choice", "minimum diameter")},
                                    Choice{"mean", SPARKOUT_NOOP("Choice", "mean diameter")},
                                    Choice{"max", SPARKOUT_NOOP("Choice", "maximum diameter")}};
    return choices;
}

template <>
const StructInfo& tableOf<Gauge>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Gauge, control, .label = SPARKOUT_NOOP("Input", "Stages switch"), .page = Page::gauge,
            .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Stages switch by the in-process gauge's reading, or by "
                                           "the position the wheel head has been fed to."),
            .source = "MODEL-7"),
        SPARKOUT_FIELD(
            Gauge, rule, .label = SPARKOUT_NOOP("Input", "The gauge reads the"),
            .page = Page::gauge, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Which of the diameters of a revolution the gauge "
                                           "reports. In a bore minimum and maximum change places."),
            .formula = "D_k = R_k + R_(k + K/2)", .source = "MODEL-7"),
        SPARKOUT_FIELD(Gauge, section, .label = SPARKOUT_NOOP("Input", "Gauge at section"),
                       .symbol = "j", .hard = {0, 199},
                       .nullMeaning = SPARKOUT_NOOP("Input", "the middle one"),
                       .relevant = gaugeAtSection, .page = Page::gauge, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Section the gauge watches, counted from the headstock: from 1 "
                                    "in the window and in reports, from 0 in files and on the "
                                    "command line. In traverse grinding the gauge is in the middle "
                                    "of the zone between the reversals."),
                       .source = "MODEL-6"),
        SPARKOUT_FIELD(
            Gauge, position_mm, .label = SPARKOUT_NOOP("Input", "Gauge at a free position"),
            .symbol = "x", .unit = "mm", .hard = {0, 10000},
            .nullMeaning = SPARKOUT_NOOP("Input", "at a section"), .relevant = conditions::sections,
            .page = Page::gauge,
            .hint =
                SPARKOUT_NOOP("Input", "Position along the ground length from its headstock end."),
            .source = "MODEL-6"),
        SPARKOUT_FIELD(
            Gauge, compliance_mm_per_n, .label = SPARKOUT_NOOP("Input", "Compliance at the gauge"),
            .symbol = "γ", .unit = "mm/N", .hard = {1e-15, 1}, .soft = {1e-6, 1e-3},
            .nullMeaning = SPARKOUT_NOOP("Input", "from the shaft, or between the sections"),
            .relevant = gaugeFree, .page = Page::gauge,
            .hint = SPARKOUT_NOOP("Input", "Compliance at the gauge's free position."),
            .source = "MODEL-6"),
        SPARKOUT_FIELD(
            Gauge, datum_mm, .label = SPARKOUT_NOOP("Input", "Feeding starts before size"),
            .unit = "mm", .hard = {0, 1000, true}, .soft = {0.001, 5},
            .nullMeaning = SPARKOUT_NOOP("Input", "at first touch"),
            .relevant = conditions::byPosition, .page = Page::gauge, .usual = true,
            .hint = SPARKOUT_NOOP("Input",
                                  "Distance from the target radius at which the wheel head's feed "
                                  "starts. In a batch the wheel touches the nominal blank there: a "
                                  "larger blank is cut deeper at once, a smaller one later."),
            .formula = "R_max0 − R_t", .source = "MODEL-7"),
        SPARKOUT_FIELD(
            Gauge, spans_gaps, .label = SPARKOUT_NOOP("Input", "Gauge spans the gaps"),
            .relevant = gaugeMeetsGaps, .sparse = true, .page = Page::gauge, .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input", "A gauge for interrupted surfaces, with wide contacts or a reading held "
                         "over the gaps. Any other gauge drops into the gaps, so that only its "
                         "maximum diameter (in a bore the minimum) can be used."),
            .source = "MODEL-7"),
        SPARKOUT_FIELD(Gauge, commands, .label = SPARKOUT_NOOP("Input", "Gauge commands"),
                       .hard = {1, 5}, .page = Page::gauge, .usual = true,
                       .hint =
                           SPARKOUT_NOOP("Input", "Number of stages that the gauge can switch."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Gauge, delay_s, .label = SPARKOUT_NOOP("Input", "Gauge delay"), .symbol = "τ_g",
            .unit = "s", .hard = {0, 60}, .soft = {0, 2},
            .nullMeaning = SPARKOUT_NOOP("Input", "that of the machine's gauge, or none"),
            .relevant = conditions::gaugeEndsAStage, .page = Page::gauge, .usual = true,
            .hint =
                SPARKOUT_NOOP("Input", "Time from the gauge's reading to its command. Every stage "
                                       "that the gauge ends, also the last one, continues for this "
                                       "time in whole double strokes or revolutions."),
            .formula = "t ≥ t_m + τ_g", .source = "MODEL-7"),
        SPARKOUT_FIELD(
            Gauge, error_um, .label = SPARKOUT_NOOP("Input", "Gauge error"), .symbol = "e_g",
            .unit = "µm", .hard = {-100, 100}, .soft = {-5, 5},
            .relevant = conditions::gaugeEndsAStage, .sparse = true, .page = Page::gauge,
            .hint = SPARKOUT_NOOP("Input",
                                  "Amount by which the gauge reads the diameter too large. Under "
                                  "gauge control the part, also a bore, ends smaller by this "
                                  "amount. In a batch its random part and its drift are factors."),
            .formula = "D + e_g + α·d·ΔT", .source = "MODEL-7"),
        SPARKOUT_FIELD(
            Gauge, part_warmer_k, .label = SPARKOUT_NOOP("Input", "Part warmer at the gauge"),
            .symbol = "ΔT", .unit = "K", .hard = {-200, 200}, .soft = {-20, 20},
            .relevant = conditions::gaugeEndsAStage, .sparse = true, .page = Page::gauge,
            .hint =
                SPARKOUT_NOOP("Input", "Temperature of the part at the gauge above the temperature "
                                       "that the gauge is set for. As the part cools, it shrinks "
                                       "by α·d·ΔT. The heating by grinding is not computed."),
            .formula = "D + e_g + α·d·ΔT", .source = "MODEL-7"),
    };
    static const StructInfo info = makeTable<Gauge>(SPARKOUT_NOOP("Struct", "Gauge"), rows);
    return info;
}

} // namespace sparkout
