// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/machine.h"

#include "core/project/conditions.h"
#include "core/project/gauge.h"
#include "core/project/operation.h"
#include "core/project/part.h"
#include "core/project/project.h"
#include "core/project/wheel.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sparkout {

namespace {

constexpr std::string_view stagesPath("/cycle/stages/");
constexpr double onStep = 1e-6; ///< share of a step: values this near to one count as on it

double withoutLastBits(double value) {
    constexpr double tidy = 1e9;
    return std::round(value * tidy) / tidy;
}

std::string_view keyOf(std::string_view path) {
    return path.substr(path.rfind('/') + 1);
}

std::optional<std::vector<double>> MachineLimits::*statedFor(const Project& project,
                                                             std::string_view path) {
    if (path == "/machine/work_speed_rpm") {
        return &MachineLimits::work_speed_rpm;
    }
    if (path == "/machine/plunge_feed_mm_min") {
        return &MachineLimits::plunge_feed_mm_min;
    }
    if (!path.starts_with(stagesPath)) {
        return nullptr;
    }
    for (const StageFeed& feed : project.operation->feeds) {
        if (keyOf(path) == feed.key) {
            return feed.range;
        }
    }
    return keyOf(path) == "continuous_feed_mm_min" ? &MachineLimits::continuous_feed_mm_min
                                                   : nullptr;
}

} // namespace

double MachineSteps::nearest(double value) const {
    return withoutLastBits(low + std::round((value - low) / step) * step);
}

double MachineSteps::stepped(double value, int steps) const {
    if (value < 0) {
        return -stepped(-value, -steps);
    }
    const double place = (value - low) / step;
    const double from = steps > 0 ? std::floor(place + onStep) : std::ceil(place - onStep);
    const double last = std::floor((high - low) / step + onStep); // infinite if high is
    const double next = withoutLastBits(low + std::clamp(from + steps, 0.0, last) * step);
    return (next - value) * steps > 0 ? next : value; // a value beyond the ends stays unchanged
}

const std::vector<double>* machineRange(const Project& project, std::string_view path) {
    const auto stated = statedFor(project, path);
    const auto* range = stated ? &(project.machine->limits.*stated) : nullptr;
    return range && *range && (*range)->size() == 3 ? &**range : nullptr;
}

std::optional<MachineSteps> machineSteps(const Project& project, std::string_view path) {
    if (path.starts_with(stagesPath) && keyOf(path) == "stock_mm") {
        const auto& infeed = project.machine->limits.radial_feed_mm;
        return infeed && infeed->size() == 3 && infeed->back() > 0
                   ? std::optional(MachineSteps{.step = infeed->back()})
                   : std::nullopt;
    }
    const std::vector<double>* range = machineRange(project, path);
    if (!range || !((*range)[2] > 0) || !((*range)[0] <= (*range)[1])) {
        return {};
    }
    return MachineSteps{(*range)[0], (*range)[1], (*range)[2]};
}

std::optional<double> steppedOnMachine(const Project& project, std::string_view path, double value,
                                       int steps) {
    const auto on = machineSteps(project, path);
    return on ? std::optional(on->stepped(value, steps)) : std::nullopt;
}

namespace {

bool byGauge(const Project& p, const void*) {
    return p.gauge->control == Control::gauge;
}
bool byDelayOfMachine(const Project& p, const void*) {
    return conditions::gaugeEndsAStage(p, nullptr) && !p.gauge->delay_s;
}
bool onCentres(const Project& p, const void*) {
    return p.part->surface == Surface::external && p.part->shaft.mounting == Mounting::centres;
}
bool withoutRunoutOfForm(const Project& p, const void*) {
    return !isEccentricityKnown(*p.machine);
}

} // namespace

double wheelSpeed_rpm(const Project& project) {
    return project.machine->wheel_speed_m_s * units::mmPerM * units::secondsPerMinute
           / (std::numbers::pi * project.wheel->diameter_mm);
}

double wavesPerTurn(const Project& project) {
    const std::optional<WheelRunout>& runout = project.wheel->runout;
    const int waves = runout && !runout->isForced() ? runout->lobes : 1;
    return waves * wheelSpeed_rpm(project) / project.machine->work_speed_rpm;
}

int orderOfWaves(const Project& project) {
    constexpr int mostTurns = 6;
    constexpr double mostWaves = 1e8; // no number of radii resolves them
    const double ratio = std::min(wavesPerTurn(project), mostWaves / mostTurns);
    for (int q = 1; q <= mostTurns; ++q) {
        const double p = std::round(q * ratio);
        const bool canBeResolved = q == 1 || p * radiiOfLobe <= mostRadii;
        if (p >= 1 && canBeResolved && std::abs(q * ratio - p) <= nearRatio) {
            return static_cast<int>(p);
        }
    }
    return std::max(static_cast<int>(std::round(ratio)), 1);
}

int radiiForWaves(const Project& project) {
    return radiiOfLobe * orderOfWaves(project);
}

bool areWavesKnown(const Project& project) {
    return project.wheel->runout && project.part->radii_per_section >= radiiForWaves(project);
}

void resolveWaves(Project& project) {
    Part& part = *project.part;
    const int most = mostRadiiPerSection(project);
    if (project.wheel->runout && part.profile != ProfileForm::measured
        && part.radii_per_section < radiiForWaves(project)) {
        part.radii_per_section = std::min(radiiForWaves(project), most);
    }
}

int lobesOf(const MachineForm& form) {
    return form.lobes.value_or(oddLobes);
}

bool hasLobes(const Machine& machine) {
    return machine.form && machine.form->roundness_um
           && std::ranges::any_of(*machine.form->roundness_um, [](double um) { return um > 0; });
}

bool areLobesUnknown(const Machine& machine) {
    return hasLobes(machine) && !machine.form->lobes;
}

double addedRunout_um(const Machine& machine) {
    return isEccentricityKnown(machine) ? 0 : machine.geometric_runout_um;
}

bool isRoundnessKnown(const Machine& machine) {
    return machine.form && machine.form->roundness_um;
}

bool isRunoutKnown(const Machine& machine) {
    return isEccentricityKnown(machine) || machine.geometric_runout_um > 0;
}

bool isEccentricityKnown(const Machine& machine) {
    return machine.form && machine.form->runout_um;
}

void changeWheelDiameter(Project& project, double diameter_mm) {
    if (project.machine->wheel_speed_control == WheelSpeedControl::constant_revolutions) {
        project.machine->wheel_speed_m_s *= diameter_mm / project.wheel->diameter_mm;
    }
    project.wheel->diameter_mm = diameter_mm;
    resolveWaves(project);
}

template <>
std::span<const Choice> choicesOf<EntrySide>() {
    static const std::array choices{Choice{"headstock", SPARKOUT_NOOP("Choice", "headstock")},
                                    Choice{"tailstock", SPARKOUT_NOOP("Choice", "tailstock")}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<ReversalInfeed>() {
    static const std::array choices{Choice{"entry", SPARKOUT_NOOP("Choice", "at the entry")},
                                    Choice{"exit", SPARKOUT_NOOP("Choice", "at the exit")},
                                    Choice{"both", SPARKOUT_NOOP("Choice", "half at each")}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<WheelSpeedControl>() {
    static const std::array choices{
        Choice{"constant_speed", SPARKOUT_NOOP("Choice", "constant peripheral speed")},
        Choice{"constant_revolutions", SPARKOUT_NOOP("Choice", "constant revolutions")}};
    return choices;
}

template <>
const StructInfo& tableOf<Stiffness>() {
    static const std::array rows{
        SPARKOUT_FIELD(Stiffness, headstock, .label = SPARKOUT_NOOP("Input", "Headstock stiffness"),
                       .symbol = "j_h", .unit = "N/µm", .hard = {1e-3, 1e6}, .soft = {5, 1000},
                       .required = conditions::always, .page = Page::machine, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Force for one micrometre of deflection at the headstock."),
                       .formula = "G(x,x) = 1/j_w + (1 − x/L_s)²/j_h + (x/L_s)²/j_t + G_beam(x,x)",
                       .source = "MODEL-6"),
        SPARKOUT_FIELD(
            Stiffness, tailstock, .label = SPARKOUT_NOOP("Input", "Tailstock stiffness"),
            .symbol = "j_t", .unit = "N/µm", .hard = {1e-3, 1e6}, .soft = {5, 1000},
            .required = onCentres, .relevant = onCentres, .page = Page::machine, .usual = true,
            .hint =
                SPARKOUT_NOOP("Input", "Force for one micrometre of deflection at the tailstock."),
            .formula = "G(x,x) = 1/j_w + (1 − x/L_s)²/j_h + (x/L_s)²/j_t + G_beam(x,x)",
            .source = "MODEL-6"),
        SPARKOUT_FIELD(
            Stiffness, wheel_head, .label = SPARKOUT_NOOP("Input", "Wheel head stiffness"),
            .symbol = "j_w", .unit = "N/µm", .hard = {1e-3, 1e6}, .soft = {5, 1000},
            .required = conditions::always, .page = Page::machine, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Force for one micrometre of deflection at the wheel."),
            .formula = "G(x,x) = 1/j_w + (1 − x/L_s)²/j_h + (x/L_s)²/j_t + G_beam(x,x)",
            .source = "MODEL-6"),
    };
    static const StructInfo info = makeTable<Stiffness>(SPARKOUT_NOOP("Struct", "Stiffness"), rows);
    return info;
}

template <>
const StructInfo& tableOf<WheelContact>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            WheelContact, n_um_at_n, .label = SPARKOUT_NOOP("Input", "Contact stiffness at force"),
            .unit = "N, N/µm", .hard = {0, 1e7},
            .nullMeaning = SPARKOUT_NOOP("Input", "rigid contact"), .count = 2,
            .page = Page::machine,
            .hint = SPARKOUT_NOOP(
                "Input", "Rows of force and contact stiffness, beyond the sources: 0 50; 200 80."),
            .source = "HASHIMOTO2020"),
    };
    static const StructInfo info =
        makeTable<WheelContact>(SPARKOUT_NOOP("Struct", "Wheel contact"), rows);
    return info;
}

template <>
const StructInfo& tableOf<MachineLimits>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            MachineLimits, radial_feed_mm,
            .label = SPARKOUT_NOOP("Input", "Range of the radial feed"), .unit = "mm/dbl stroke",
            .hard = {0, 10}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .count = 3,
            .page = Page::machine,
            .hint = SPARKOUT_NOOP("Input", "Minimum, maximum and step, per double stroke.")),
        SPARKOUT_FIELD(MachineLimits, axial_feed_mm_min,
                       .label = SPARKOUT_NOOP("Input", "Range of the axial feed"), .unit = "mm/min",
                       .hard = {0, 1e5}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"),
                       .count = 3, .page = Page::machine,
                       .hint = SPARKOUT_NOOP("Input", "Minimum, maximum and step.")),
        SPARKOUT_FIELD(
            MachineLimits, plunge_feed_mm_min,
            .label = SPARKOUT_NOOP("Input", "Range of the plunge feed"), .unit = "mm/min",
            .hard = {0, 1000}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .count = 3,
            .page = Page::machine, .hint = SPARKOUT_NOOP("Input", "Minimum, maximum and step.")),
        SPARKOUT_FIELD(
            MachineLimits, continuous_feed_mm_min,
            .label = SPARKOUT_NOOP("Input", "Range of the continuous infeed"), .unit = "mm/min",
            .hard = {0, 1000}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .count = 3,
            .page = Page::machine,
            .hint =
                SPARKOUT_NOOP("Input", "Minimum, maximum and step of the radial infeed while the "
                                       "table travels; [0, 0, 0] for a machine without it.")),
        SPARKOUT_FIELD(
            MachineLimits, work_speed_rpm,
            .label = SPARKOUT_NOOP("Input", "Range of the work speed"), .unit = "rev/min",
            .hard = {0, 1e5}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .count = 3,
            .page = Page::machine, .hint = SPARKOUT_NOOP("Input", "Minimum, maximum and step.")),
        SPARKOUT_FIELD(MachineLimits, part_diameter_mm,
                       .label = SPARKOUT_NOOP("Input", "Maximum part diameter"), .symbol = "d_m",
                       .unit = "mm", .hard = {0.1, 1e4},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .page = Page::machine,
                       .hint = SPARKOUT_NOOP("Input", "Diameter up to which the machine grinds.")),
        SPARKOUT_FIELD(MachineLimits, part_length_mm,
                       .label = SPARKOUT_NOOP("Input", "Maximum part length"), .symbol = "L_m",
                       .unit = "mm", .hard = {1, 1e5},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .page = Page::machine,
                       .hint = SPARKOUT_NOOP("Input", "Length that the machine accepts.")),
        SPARKOUT_FIELD(
            MachineLimits, wheel_diameter_mm,
            .label = SPARKOUT_NOOP("Input", "Maximum wheel diameter"), .symbol = "D_m",
            .unit = "mm", .hard = {0.5, 2000}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"),
            .sparse = true, .page = Page::machine,
            .hint = SPARKOUT_NOOP("Input", "Diameter of a new wheel that the machine accepts.")),
        SPARKOUT_FIELD(
            MachineLimits, wheel_width_mm, .label = SPARKOUT_NOOP("Input", "Range of wheel widths"),
            .symbol = "B_m", .unit = "mm", .hard = {0.5, 1000},
            .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .count = 2, .sparse = true,
            .page = Page::machine,
            .hint =
                SPARKOUT_NOOP("Input", "Minimum and maximum width that the wheel's flanges hold.")),
        SPARKOUT_FIELD(MachineLimits, wheel_bore_mm,
                       .label = SPARKOUT_NOOP("Input", "Diameter of the wheel seat"), .symbol = "H",
                       .unit = "mm", .hard = {0.5, 1000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "any bore fits"), .sparse = true,
                       .page = Page::machine,
                       .hint =
                           SPARKOUT_NOOP("Input", "Bore of a wheel that fits; it is compared with "
                                                  "the one of the marking, 305 in 600×63×305.")),
        SPARKOUT_FIELD(
            MachineLimits, wheel_speed_m_s, .label = SPARKOUT_NOOP("Input", "Highest wheel speed"),
            .symbol = "V_m", .unit = "m/s", .hard = {1, 250},
            .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .sparse = true,
            .page = Page::machine,
            .hint =
                SPARKOUT_NOOP("Input", "Peripheral speed up to which the machine drives a wheel; a "
                                       "starting cycle uses it if the wheel allows it.")),
    };
    static const StructInfo info =
        makeTable<MachineLimits>(SPARKOUT_NOOP("Struct", "Machine ranges"), rows);
    return info;
}

template <>
const StructInfo& tableOf<MachineForm>() {
    static const std::array rows{
        SPARKOUT_FIELD(MachineForm, roundness_um,
                       .label = SPARKOUT_NOOP("Input", "Roundness deviation of the machine"),
                       .symbol = "2A_j", .unit = "µm", .hard = {0, 1000}, .soft = {0, 10},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not known"), .page = Page::machine,
                       .hint =
                           SPARKOUT_NOOP("Input", "Roundness deviation of a part ground to the "
                                                  "end, of each zone or section, in their order."),
                       .source = "MODEL-7"),
        SPARKOUT_FIELD(
            MachineForm, runout_um, .label = SPARKOUT_NOOP("Input", "Radial runout of the machine"),
            .symbol = "Δ_m", .unit = "µm", .hard = {0, 1000}, .soft = {0, 10},
            .nullMeaning = SPARKOUT_NOOP("Input", "not known"), .page = Page::machine,
            .hint = SPARKOUT_NOOP("Input",
                                  "Radial runout of a part ground to the end, of each zone or "
                                  "section, in their order; no less than the roundness deviation. "
                                  "It is the mean over all directions of the eccentricity."),
            .source = "MODEL-7"),
        SPARKOUT_FIELD(
            MachineForm, lobes, .label = SPARKOUT_NOOP("Input", "Number of lobes"), .symbol = "j",
            .hard = {2, 30}, .soft = {2, 15}, .nullMeaning = SPARKOUT_NOOP("Input", "not known"),
            .page = Page::machine,
            .hint = SPARKOUT_NOOP(
                "Input",
                "2: an oval. An even number spreads the diameter by twice the roundness deviation, "
                "an odd one does not; roundness and runout do not show which. Not known: judged as "
                "odd, with the diameters for two lobes stated beside."),
            .source = "MODEL-7"),
        SPARKOUT_FIELD(
            MachineForm, runout_at_deg,
            .label = SPARKOUT_NOOP("Input", "Direction of the eccentricity"), .symbol = "φ_1",
            .unit = "°", .hard = {0, 360},
            .nullMeaning = SPARKOUT_NOOP("Input", "the angle that gives the stated runout"),
            .page = Page::machine,
            .hint = SPARKOUT_NOOP(
                "Input",
                "Angle on the part from where a lobe is ground deepest to where the eccentricity "
                "grinds deepest. In a batch it may scatter over the whole turn."),
            .source = "MODEL-7"),
    };
    static const StructInfo info =
        makeTable<MachineForm>(SPARKOUT_NOOP("Struct", "Machine's form"), rows);
    return info;
}

template <>
const StructInfo& tableOf<SpeedVariation>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            SpeedVariation, percent, .label = SPARKOUT_NOOP("Input", "Speed variation"),
            .symbol = "s", .unit = "%", .hard = {0, 50}, .soft = {0, 20}, .page = Page::machine,
            .hint =
                SPARKOUT_NOOP("Input", "How far the work speed rises and falls about its value, "
                                       "in percent of it."),
            .source = "MODEL-16"),
        SPARKOUT_FIELD(SpeedVariation, period_s,
                       .label = SPARKOUT_NOOP("Input", "Period of the variation"), .symbol = "T",
                       .unit = "s", .hard = {0.01, 3600}, .soft = {0.5, 60}, .page = Page::machine,
                       .hint = SPARKOUT_NOOP("Input", "Time from one highest speed to the next."),
                       .source = "MODEL-16"),
    };
    static const StructInfo info =
        makeTable<SpeedVariation>(SPARKOUT_NOOP("Struct", "Variation of the work speed"), rows);
    return info;
}

namespace {

Field workSpeedVariation() {
    return SPARKOUT_FIELD(
        Machine, work_speed_variation,
        .label = SPARKOUT_NOOP("Input", "Variation of the work speed"),
        .nullMeaning = SPARKOUT_NOOP("Input", "constant speed"),
        .relevant = conditions::wheelRunout, .sparse = true, .page = Page::machine,
        .hint =
            SPARKOUT_NOOP("Input", "The work speed rises and falls during the cycle, so that the "
                                   "waves of a wheel out of true do not print onto one "
                                   "another."),
        .formula = "ψ = ψ_0 + 2π·∫L·n_k dt", .source = "MODEL-16");
}

Field wheelHeadFrequency() {
    return SPARKOUT_FIELD(
        Machine, wheel_head_frequency_hz,
        .label = SPARKOUT_NOOP("Input", "Natural frequency of the wheel head"), .symbol = "f_0",
        .unit = "Hz", .hard = {1, 1e5}, .soft = {20, 2000},
        .nullMeaning = SPARKOUT_NOOP("Input", "far above the wheel's revolutions"),
        .relevant = conditions::unbalanced, .sparse = true, .page = Page::machine,
        .hint = SPARKOUT_NOOP("Input", "Frequency at which the wheel head swings by itself. The "
                                       "nearer the wheel's revolutions are to it, the more an "
                                       "unbalance moves the wheel."),
        .formula = "e = U·ω²/(j_w·√((1 − (ω/ω_0)²)²))", .source = "MODEL-16");
}

Field zoneCompliance() {
    return SPARKOUT_FIELD(
        Machine, zone_compliance, .label = SPARKOUT_NOOP("Input", "Compliance factor by zone"),
        .symbol = "f_γ", .hard = {1e-3, 1e3}, .soft = {0.2, 5},
        .nullMeaning = SPARKOUT_NOOP("Input", "1 everywhere"), .sparse = true,
        .page = Page::machine,
        .hint =
            SPARKOUT_NOOP("Input", "Multiplies the compliance of each zone or section, in their "
                                   "order, given or computed; not with coupled sections."),
        .source = "MODEL-6");
}

Field wheelSpeedControl() {
    return SPARKOUT_FIELD(
        Machine, wheel_speed_control, .label = SPARKOUT_NOOP("Input", "Worn wheel runs at"),
        .sparse = true, .page = Page::machine,
        .hint = SPARKOUT_NOOP(
            "Input", "The quantity that the drive keeps when the wheel gets smaller, in a batch, a "
                     "sweep, a set-up and from dressing to dressing: the peripheral speed, or the "
                     "revolutions, so that the speed falls with the diameter. The wheel speed is "
                     "that of the wheel diameter as it is given."),
        .formula = "V_k = π·D·n_k", .source = "MODEL-8");
}

Field geometricRunout() {
    return SPARKOUT_FIELD(
        Machine, geometric_runout_um, .label = SPARKOUT_NOOP("Input", "Geometric runout"),
        .symbol = "Δ_m", .unit = "µm", .hard = {0, 1000}, .soft = {0, 10},
        .relevant = withoutRunoutOfForm, .page = Page::machine, .usual = true,
        .hint = SPARKOUT_NOOP(
            "Input",
            "Runout of centres and spindle; it adds to every runout. At 0 it is not known."),
        .source = "MODEL-7");
}

Field gaugeRepeatability() {
    return SPARKOUT_FIELD(
        Machine, gauge_repeatability_um, .label = SPARKOUT_NOOP("Input", "Gauge repeatability"),
        .symbol = "s_g", .unit = "µm", .hard = {0, 100}, .soft = {0.1, 3},
        .nullMeaning = SPARKOUT_NOOP("Input", "not known"), .sparse = true, .page = Page::machine,
        .hint = SPARKOUT_NOOP("Input",
                              "Standard deviation of the in-process gauge's reading of a diameter. "
                              "A batch with the gauge's error as a factor scatters by it."),
        .formula = "e_g = z·s_g + v_g·t", .source = "MODEL-8");
}

Field gaugeDrift() {
    return SPARKOUT_FIELD(
        Machine, gauge_drift_um_h, .label = SPARKOUT_NOOP("Input", "Gauge drift"), .symbol = "v_g",
        .unit = "µm/h", .hard = {-1000, 1000}, .soft = {-5, 5},
        .nullMeaning = SPARKOUT_NOOP("Input", "not known"), .sparse = true, .page = Page::machine,
        .hint =
            SPARKOUT_NOOP("Input", "Increase of the reading of the in-process gauge per hour since "
                                   "it was set. A batch with that time as a factor drifts by it."),
        .formula = "e_g = z·s_g + v_g·t", .source = "MODEL-8");
}

Field gaugeDelay() {
    return SPARKOUT_FIELD(
        Machine, gauge_delay_s, .label = SPARKOUT_NOOP("Input", "Delay of the machine's gauge"),
        .symbol = "τ_g", .unit = "s", .hard = {0, 60}, .soft = {0, 2},
        .nullMeaning = SPARKOUT_NOOP("Input", "none"), .relevant = byDelayOfMachine, .sparse = true,
        .page = Page::machine,
        .hint =
            SPARKOUT_NOOP("Input", "Time from the reading of the machine's gauge to its command, "
                                   "where the gauge delay itself is not given."),
        .formula = "t ≥ t_m + τ_g", .source = "MODEL-7");
}

Field machineForm() {
    return SPARKOUT_FIELD(
        Machine, form, .label = SPARKOUT_NOOP("Input", "Machine's form"),
        .nullMeaning = SPARKOUT_NOOP("Input", "not known"), .page = Page::machine,
        .hint = SPARKOUT_NOOP("Input", "The form error that centres, headstock and spindle "
                                       "transfer to every part, by zone or section."),
        .formula = "R_k − c(φ_k), c = A_1·cos(φ − φ_1) + A_j·cos jφ", .source = "MODEL-7");
}

} // namespace

template <>
const StructInfo& tableOf<Machine>() {
    static const std::array rows{
        SPARKOUT_FIELD(Machine, name, .label = SPARKOUT_NOOP("Input", "Machine"),
                       .page = Page::machine, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Model of the grinder.")),
        SPARKOUT_FIELD(Machine, wheel_speed_m_s, .label = SPARKOUT_NOOP("Input", "Wheel speed"),
                       .symbol = "V_k", .unit = "m/s", .hard = {1, 250}, .soft = {15, 80},
                       .required = conditions::always, .slider = true, .page = Page::machine,
                       .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Peripheral speed of the wheel."),
                       .formula = "k_s = ε_i·tg β·σ_i·V_d/V_k", .source = "MODEL-1"),
        wheelSpeedControl(),
        SPARKOUT_FIELD(Machine, work_speed_rpm, .label = SPARKOUT_NOOP("Input", "Work speed"),
                       .symbol = "n", .unit = "rev/min", .hard = {0.1, 10000}, .soft = {20, 1500},
                       .required = conditions::always, .slider = true, .page = Page::machine,
                       .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Revolutions of the part; V_d = π·d·n."),
                       .source = "MODEL-1"),
        workSpeedVariation(),
        SPARKOUT_FIELD(
            Machine, plunge_feed_mm_min,
            .label = SPARKOUT_NOOP("Input", "Plunge-in feed at reversal"), .symbol = "S_rad",
            .unit = "mm/min", .hard = {1e-4, 1000}, .soft = {0.05, 10},
            .required = conditions::travels, .relevant = conditions::travels, .slider = true,
            .page = Page::machine,
            .hint = SPARKOUT_NOOP(
                "Input",
                "Speed of the infeed at a reversal: an infeed S takes ⌈n·S/S_rad⌉ revolutions."),
            .source = "MODEL-5"),
        SPARKOUT_FIELD(
            Machine, reversal_infeed, .label = SPARKOUT_NOOP("Input", "Infeed at the reversals"),
            .relevant = conditions::travels, .sparse = true, .page = Page::machine,
            .hint =
                SPARKOUT_NOOP("Input", "Reversal at which the infeed of a double stroke takes "
                                       "place: at the entry, at the exit, or half of it at each."),
            .formula = "S_1 + S_2 = S_t", .source = "MODEL-5"),
        SPARKOUT_FIELD(
            Machine, overrun_entry_mm, .label = SPARKOUT_NOOP("Input", "Overrun at the entry"),
            .symbol = "o_1", .unit = "mm", .hard = {-1000, 1000}, .soft = {0, 100},
            .required = conditions::travels, .relevant = conditions::travels, .page = Page::machine,
            .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Distance that the wheel runs past the entry end; the "
                                           "entry reversal zone is B − o1 long."),
            .source = "MODEL-5"),
        SPARKOUT_FIELD(
            Machine, overrun_exit_mm, .label = SPARKOUT_NOOP("Input", "Overrun at the exit"),
            .symbol = "o_2", .unit = "mm", .hard = {-1000, 1000}, .soft = {0, 100},
            .required = conditions::travels, .relevant = conditions::travels, .page = Page::machine,
            .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Distance that the wheel runs past the exit end; the "
                                           "exit reversal zone is B − o2 long."),
            .source = "MODEL-5"),
        SPARKOUT_FIELD(
            Machine, dwell_entry_s, .label = SPARKOUT_NOOP("Input", "Dwell at the entry"),
            .symbol = "τ_1", .unit = "s", .hard = {0, 3600}, .soft = {0, 5},
            .required = conditions::travels, .relevant = conditions::travels, .slider = true,
            .page = Page::machine, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Spark-out at the entry reversal, twice a double "
                                           "stroke, in whole revolutions of the part."),
            .formula = "N_1 = ⌊n·τ_1 + 0.5⌋", .source = "MODEL-5"),
        SPARKOUT_FIELD(Machine, dwell_exit_s, .label = SPARKOUT_NOOP("Input", "Dwell at the exit"),
                       .symbol = "τ_2", .unit = "s", .hard = {0, 3600}, .soft = {0, 5},
                       .required = conditions::travels, .relevant = conditions::travels,
                       .slider = true, .page = Page::machine, .usual = true,
                       .hint =
                           SPARKOUT_NOOP("Input", "Spark-out at the exit reversal, once a double "
                                                  "stroke, in whole revolutions of the part."),
                       .formula = "N_2 = ⌊n·τ_2 + 0.5⌋", .source = "MODEL-5"),
        SPARKOUT_FIELD(Machine, compliance_mm_per_n, .label = SPARKOUT_NOOP("Input", "Compliance"),
                       .symbol = "γ", .unit = "mm/N", .hard = {1e-15, 1}, .soft = {1e-6, 1e-3},
                       .nullMeaning = SPARKOUT_NOOP("Input", "from stiffness and shaft"),
                       .slider = true, .page = Page::machine,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Deflection of the technological system for one newton at the "
                                    "wheel: one value a zone (traverse) or a section (plunge)."),
                       .formula = "a + γ·P_y(a) = h", .source = "MODEL-3"),
        SPARKOUT_FIELD(
            Machine, stiffness_n_um, .label = SPARKOUT_NOOP("Input", "Stiffness of the units"),
            .nullMeaning = SPARKOUT_NOOP("Input", "not stated"), .required = conditions::unbalanced,
            .page = Page::machine, .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input", "Headstock, tailstock and wheel head, for a compliance that is computed."),
            .source = "MODEL-6"),
        wheelHeadFrequency(),
        zoneCompliance(),
        geometricRunout(),
        machineForm(),
        gaugeRepeatability(),
        gaugeDrift(),
        gaugeDelay(),
        SPARKOUT_FIELD(Machine, wheel_drive_kw,
                       .label = SPARKOUT_NOOP("Input", "Wheel drive power"), .symbol = "N_k",
                       .unit = "kW", .hard = {0, 1000, true},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .page = Page::machine,
                       .usual = true, .hint = SPARKOUT_NOOP("Input", "Power of the wheel drive."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Machine, work_drive_kw, .label = SPARKOUT_NOOP("Input", "Work drive power"),
                       .symbol = "N_d", .unit = "kW", .hard = {0, 1000, true},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .page = Page::machine,
                       .hint = SPARKOUT_NOOP("Input", "Power of the work drive."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Machine, feed_change_delay_s, .label = SPARKOUT_NOOP("Input", "Feed change delay"),
            .symbol = "τ_f", .unit = "s", .hard = {0, 60}, .soft = {0, 2},
            .nullMeaning = SPARKOUT_NOOP("Input", "none"), .relevant = byGauge,
            .page = Page::machine,
            .hint = SPARKOUT_NOOP(
                "Input", "Time from the gauge's command to the feed of the next stage: a stage "
                         "that the gauge ends continues for this time in whole steps. The last "
                         "command only draws the wheel back, without delay."),
            .formula = "t ≥ t_m + τ_g + τ_f", .source = "MODEL-7"),
        SPARKOUT_FIELD(Machine, entry_side, .label = SPARKOUT_NOOP("Input", "Entry zone is at the"),
                       .relevant = conditions::travels, .page = Page::machine, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Which end of the part the wheel enters at."),
                       .source = "MODEL-6"),
        SPARKOUT_FIELD(
            Machine, wheel_contact, .label = SPARKOUT_NOOP("Input", "Wheel contact"),
            .nullMeaning = SPARKOUT_NOOP("Input", "rigid contact"), .page = Page::machine,
            .hint = SPARKOUT_NOOP("Input",
                                  "Contact compliance of the wheel in series, beyond the sources."),
            .source = "HASHIMOTO2020"),
        SPARKOUT_FIELD(Machine, limits, .label = SPARKOUT_NOOP("Input", "Machine ranges"),
                       .page = Page::machine, .source = "MODEL-8"),
    };
    static const StructInfo info = makeTable<Machine>(SPARKOUT_NOOP("Struct", "Machine"), rows);
    return info;
}

} // namespace sparkout
