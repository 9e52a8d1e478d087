// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/validate.h"

#include "core/digits.h"
#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/machine_fit.h"
#include "core/project/material.h"
#include "core/project/measured.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/range_check.h"
#include "core/project/sweep.h"
#include "core/project/wheel.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>

namespace sparkout {

namespace {

/// The distances beyond the ends of the ground length within which the shaft is no larger than a
/// given diameter: to the next shoulder, or infinite without one [mm].
struct Clearance {
    double headstock = std::numeric_limits<double>::infinity();
    double tailstock = std::numeric_limits<double>::infinity();
};
Clearance clearanceOf(const Part& part, double diameter_mm) {
    constexpr double rounding = 1e-9;
    const double from = part.shaft.ground_from_mm;
    const double to = from + part.length_mm;
    Clearance clearance;
    double begin = 0;
    for (const ShaftSegment& segment : part.shaft.segments) {
        const double end = begin + segment.length_mm;
        if (segment.diameter_mm > diameter_mm + rounding) {
            if (end <= from + rounding) {
                clearance.headstock = std::max(from - end, 0.0);
            } else if (begin >= to - rounding) {
                clearance.tailstock = std::min(clearance.tailstock, std::max(begin - to, 0.0));
            }
        }
        begin = end;
    }
    return clearance;
}

/// A bound derived from other inputs, rounded inwards to enterable digits.
double roundedBound(double bound, double (*round)(double)) {
    constexpr int digits = 4;
    constexpr double least = 1e-5; // bounds below this keep all digits
    if (!std::isfinite(bound) || bound < least) {
        return bound;
    }
    const double scale = std::pow(10.0, decimalsOf(bound, digits));
    return round(bound * scale) / scale;
}
double roundedUp(double bound) {
    return roundedBound(bound, [](double x) { return std::ceil(x); });
}
double roundedDown(double bound) {
    return roundedBound(bound, [](double x) { return std::floor(x); });
}

/// The rules between fields; each considers only values that the ranges allow.
class Rules {
public:
    Rules(const Project& project, Issues& issues) : m_project(project), m_issues(issues) {}

    void check() {
        checkPart();
        checkProfile();
        checkZoneValues();
        checkMachineForm();
        checkWheelRunout();
        checkGaps();
        checkBlank();
        project().operation->travels ? checkZones() : checkSections();
        checkCompliance();
        checkWheelContact();
        checkMachineLimits();
        checkMachineFit();
        checkWheelSpeed();
        checkReading();
        checkRecipe();
        checkForceLaw();
        checkStages();
        checkOptimisation();
        checkBatch();
        checkSweep();
        checkMeasured();
    }

private:
    const Project& project() const { return m_project; }

    /// Adds one fault for each value: a refusal by range suffices, and a rule replaces "unusual".
    void add(IssueCode code, const std::string& path, Detail value, Detail limit,
             Severity severity = Severity::error) {
        std::erase_if(m_issues, [&](const Issue& issue) {
            return issue.code == IssueCode::unusual && issue.path == path;
        });
        const bool refused = std::any_of(m_issues.begin(), m_issues.end(), [&](const Issue& issue) {
            return issue.severity == Severity::error && issue.path == path;
        });
        if (!refused) {
            m_issues.push_back({code, severity, path, std::move(value), std::move(limit)});
        }
    }
    void warn(IssueCode code, const std::string& path, Detail value, Detail limit) {
        add(code, path, std::move(value), std::move(limit), Severity::warning);
    }
    /// Whether none of these inputs, nor anything inside them, is refused; a rule on a refused
    /// input would mislead.
    [[nodiscard]] bool sound(std::initializer_list<std::string_view> paths) const {
        return std::none_of(m_issues.begin(), m_issues.end(), [&](const Issue& issue) {
            return issue.severity == Severity::error
                   && std::any_of(paths.begin(), paths.end(), [&](std::string_view path) {
                          return issue.path.starts_with(path)
                                 && (issue.path.size() == path.size()
                                     || issue.path[path.size()] == '/');
                      });
        });
    }
    [[nodiscard]] bool fieldIsSound() const {
        return sound({"/part/diameter_mm", "/part/upper_deviation_um", "/part/lower_deviation_um"});
    }
    [[nodiscard]] bool runoutIsSound() const {
        return sound({project().part->profile == ProfileForm::measured
                          ? "/part/radii_um"
                          : "/part/initial_runout_mm"});
    }
    static Amount mm(double value) { return {value, "mm"}; }
    static Amount um(double value) { return {value, "µm"}; }
    static Bounds mm(const Range& range) { return {range, "mm"}; }

    void checkPart() {
        const Part& part = *project().part;
        if (part.lower_deviation_um >= part.upper_deviation_um
            && sound({"/part/upper_deviation_um"})) {
            add(IssueCode::deviationsReversed, "/part/lower_deviation_um",
                um(part.lower_deviation_um), um(part.upper_deviation_um));
        }
        if (part.target_diameter_mm && sound({"/part/diameter_mm"})) {
            const double low = part.diameter_mm + part.lower_deviation_um / units::umPerMm;
            const double high = part.diameter_mm + part.upper_deviation_um / units::umPerMm;
            const double away = part.diameter_mm / 4;
            if (std::abs(*part.target_diameter_mm - part.diameter_mm) > away) {
                add(IssueCode::outOfRange, "/part/target_diameter_mm", mm(*part.target_diameter_mm),
                    mm(Range{part.diameter_mm - away, part.diameter_mm + away}));
            } else if (fieldIsSound()
                       && (*part.target_diameter_mm < low || *part.target_diameter_mm > high)) {
                warn(IssueCode::targetOutsideField, "/part/target_diameter_mm",
                     mm(*part.target_diameter_mm), mm(Range{low, high}));
            }
        }
        if (part.surface == Surface::internal) {
            const bool known = fieldIsSound() && runoutIsSound()
                               && sound({"/part/target_diameter_mm", "/part/stock_mm"});
            if (known && project().wheel->diameter_mm >= smallestBore()) {
                add(IssueCode::wheelTooLarge, "/wheel/diameter_mm",
                    mm(project().wheel->diameter_mm),
                    Bounds{.range = {.high = smallestBore()},
                           .unit = "mm",
                           .formula = "2R_t − 2·Π − 2·ΔR",
                           .highOpen = true});
            }
        }
    }

    /// ΔR of the blank [mm].
    double blankRunout() const {
        const Part& part = *project().part;
        if (part.profile != ProfileForm::measured || !part.radii_um || part.radii_um->empty()) {
            return part.initial_runout_mm;
        }
        return (measuredRange(part).high - measuredRange(part).low) / units::umPerMm;
    }

    /// The smallest diameter of a bore's blank, into which the wheel must fit [mm].
    double smallestBore() const {
        const Part& part = *project().part;
        const double middle =
            part.diameter_mm
            + (part.upper_deviation_um + part.lower_deviation_um) / 2 / units::umPerMm;
        return part.target_diameter_mm.value_or(middle)
               - 2 * (part.stock_mm + blankRunout() + furthestZone_mm(part));
    }

    /// Checks the values of each zone or section: their blanks must be valid.
    void checkZoneValues() {
        const Part& part = *project().part;
        const auto count = [&](const char* path, const std::optional<std::vector<double>>& own) {
            const auto places = static_cast<std::size_t>(placeCount(project()));
            const bool wrong = own && own->size() != places && sound({"/sections"});
            if (wrong) {
                add(IssueCode::wrongCount, path, countOf(own->size()), countOf(places));
            }
            return own && !wrong;
        };
        const auto least = [&](const char* path, const std::vector<double>& own, double of,
                               bool positive) {
            for (std::size_t i = 0; i < own.size(); ++i) {
                if (of + own[i] < 0 || (positive && of + own[i] <= 0)) {
                    add(IssueCode::outOfRange, std::string(path) + "/" + std::to_string(i),
                        mm(own[i]), mm(Range{-of, 5}));
                }
            }
        };
        if (count("/part/zone_stock_mm", part.zone_stock_mm) && sound({"/part/stock_mm"})) {
            least("/part/zone_stock_mm", *part.zone_stock_mm, part.stock_mm, true);
        }
        if (count("/part/zone_runout_mm", part.zone_runout_mm) && runoutIsSound()) {
            least("/part/zone_runout_mm", *part.zone_runout_mm, blankRunout(), false);
        }
        if (count("/machine/zone_compliance", project().machine->zone_compliance)
            && project().sections_coupled && !project().operation->travels) {
            add(IssueCode::notUsedHere, "/machine/zone_compliance", {}, Keys{{"sections_coupled"}});
        }
    }

    /// Checks the machine's form, which the number of radii must resolve.
    void checkMachineForm() {
        if (!project().machine->form) {
            return;
        }
        const MachineForm& form = *project().machine->form;
        const auto places = static_cast<std::size_t>(placeCount(project()));
        const auto& roundness = form.roundness_um;
        const auto& runout = form.runout_um;
        for (const auto& [path, own] :
             {std::pair(roundnessPath, &roundness), std::pair(runoutPath, &runout)}) {
            if (*own && (*own)->size() != places && sound({"/sections"})) {
                add(IssueCode::wrongCount, path, countOf((*own)->size()), countOf(places));
            }
        }
        const double most_um = tableOf<MachineForm>().find("runout_um")->hard.high;
        const bool both = roundness && runout && sound({roundnessPath, runoutPath});
        for (std::size_t i = 0; both && i < std::min(roundness->size(), runout->size()); ++i) {
            if ((*runout)[i] < (*roundness)[i]) { // no circle fits better about its axis
                add(IssueCode::outOfRange, runoutPath + ('/' + std::to_string(i)), um((*runout)[i]),
                    Bounds{{(*roundness)[i], most_um}, "µm"});
            }
        }
        if (!hasLobes(*project().machine) || !sound({roundnessPath, "/machine/form/lobes"})) {
            return;
        }
        const int least = radiiOfLobe * lobesOf(form);
        if (project().part->radii_per_section < least && sound({"/part/radii_per_section"})) {
            const double radii = tableOf<Part>().find("radii_per_section")->hard.high;
            add(IssueCode::outOfRange, "/part/radii_per_section",
                Count{project().part->radii_per_section},
                Bounds{{1.0 * least, radii}, {}, "/machine/form/lobes"});
        }
        if (areLobesUnknown(*project().machine) && fieldIsSound()) {
            const Part& part = *project().part;
            warn(IssueCode::lobesUnknown, "/machine/form/lobes",
                 um(2 * *std::ranges::max_element(*roundness)),
                 um(part.upper_deviation_um - part.lower_deviation_um));
        }
    }

    static inline const std::string roundnessPath = "/machine/form/roundness_um";
    static inline const std::string runoutPath = "/machine/form/runout_um";

    /// Checks that one of the forms of the wheel's runout is given, and what it needs.
    void checkWheelRunout() {
        if (!project().wheel->runout) {
            return;
        }
        const WheelRunout& runout = *project().wheel->runout;
        const std::string path = "/wheel/runout";
        const int forms = static_cast<int>(runout.amplitude_um.has_value())
                          + static_cast<int>(runout.unbalance_g_mm.has_value())
                          + static_cast<int>(runout.balance_grade_mm_s.has_value());
        if (forms != 1) {
            add(IssueCode::wrongCount, path, Count{forms},
                Keys{{"amplitude_um", "unbalance_g_mm", "balance_grade_mm_s"},
                     Keys::Kind::alternatives});
            return;
        }
        if (runout.balance_grade_mm_s && !runout.rotor_mass_kg) {
            const Field& mass = *tableOf<WheelRunout>().find("rotor_mass_kg");
            add(IssueCode::missingKey, path + "/rotor_mass_kg", {}, Bounds{mass.hard, mass.unit});
        }
        if (runout.isForced() && !project().machine->stiffness_n_um) {
            add(IssueCode::missingKey, "/machine/stiffness_n_um", {}, Phrase::object);
        }
        if (!sound({path, "/part/radii_per_section", "/machine/wheel_speed_m_s",
                    "/machine/work_speed_rpm", "/wheel/diameter_mm"})) {
            return;
        }
        const int least = radiiForWaves(project());
        if (project().part->radii_per_section < least) {
            add(IssueCode::wavesUnresolved, "/part/radii_per_section",
                Count{project().part->radii_per_section},
                Bounds{{.low = 1.0 * least}, {}, "/wheel/runout"});
        }
    }

    void checkProfile() {
        const Part& part = *project().part;
        const Field& radii = *tableOf<Part>().find("radii_per_section");
        if (part.radii_per_section % 2 != 0) {
            add(IssueCode::notEven, "/part/radii_per_section", Count{part.radii_per_section},
                Bounds{radii.hard, radii.unit});
        } else if (part.radii_per_section < radii.soft.low) {
            warn(IssueCode::fewRadii, "/part/radii_per_section", Count{part.radii_per_section},
                 Bounds{radii.soft, radii.unit});
        }
        if (sound({"/part/radii_per_section", "/sections", "/zone_sections"})) {
            const int most = mostRadiiPerSection(project());
            if (part.radii_per_section > most) {
                add(IssueCode::outOfRange, "/part/radii_per_section", Count{part.radii_per_section},
                    Bounds{{radii.hard.low, 1.0 * most},
                           {},
                           project().operation->travels ? "/zone_sections" : "/sections"});
            }
        }
        if (part.profile == ProfileForm::measured) {
            const std::size_t given = part.radii_um ? part.radii_um->size() : 0;
            if (given != static_cast<std::size_t>(part.radii_per_section)
                && sound({"/part/radii_per_section"})) {
                add(IssueCode::wrongCount, "/part/radii_um", countOf(given),
                    Count{part.radii_per_section, {}, "/part/radii_per_section"});
            }
        }
    }

    /// Checks that enough surface is left to measure a diameter.
    void checkGaps() {
        constexpr int leastRadii = 4;
        const Part& part = *project().part;
        if (part.gaps.empty() || part.radii_per_section % 2 != 0
            || !sound({"/part/radii_per_section", "/part/gaps"})) {
            return;
        }
        const std::vector<bool> inside = inGaps(part);
        const std::size_t half = inside.size() / 2;
        const auto ground = std::count(inside.begin(), inside.end(), false);
        bool across = false;
        for (std::size_t k = 0; k < half; ++k) {
            across = across || (!inside[k] && !inside[k + half]);
        }
        if (ground < leastRadii || !across) {
            add(IssueCode::tooMuchGap, "/part/gaps", Count{ground}, Bounds{{leastRadii}});
        }
        for (std::size_t i = 0; i < part.gaps.size(); ++i) {
            Part alone = part;
            alone.gaps = {part.gaps[i]};
            const std::vector<bool> within = inGaps(alone);
            if (part.gaps[i].width_deg > 0
                && std::find(within.begin(), within.end(), true) == within.end()) {
                warn(IssueCode::gapBetweenRadii, "/part/gaps/" + std::to_string(i) + "/width_deg",
                     Amount{part.gaps[i].width_deg, "°"},
                     Amount{360.0 / part.radii_per_section, "°"});
            }
        }
        const Gauge& gauge = *project().gauge;
        const auto& stages = project().cycle->stages;
        const bool reads =
            gauge.control == Control::gauge || (!stages.empty() && stages.back().waitsForSize());
        if (!gauge.spans_gaps && reads && gauge.rule != GaugeRule::max
            && std::find(inside.begin(), inside.end(), true) != inside.end()) {
            add(IssueCode::gaugeDropsIn, "/gauge/spans_gaps", {}, Phrase::ruleMax);
        }
    }

    /// The smallest radius of blank and part must stay a radius.
    void checkBlank() {
        const Part& part = *project().part;
        if (!sound({"/part/diameter_mm"})) {
            return;
        }
        const double greatest = part.diameter_mm / 4;
        const bool measured = part.profile == ProfileForm::measured;
        if (blankRunout() > greatest) {
            add(IssueCode::outOfRange, measured ? "/part/radii_um" : "/part/initial_runout_mm",
                Amount{blankRunout(), "mm", measured ? "ΔR" : ""}, mm(Range{0, greatest}));
        }
        if (part.surface == Surface::internal && part.stock_mm > greatest) {
            add(IssueCode::outOfRange, "/part/stock_mm", mm(part.stock_mm), mm(Range{0, greatest}));
        }
        const double deepest = part.diameter_mm / 4 * units::umPerMm;
        if (part.lower_deviation_um < -deepest) {
            add(IssueCode::outOfRange, "/part/lower_deviation_um", um(part.lower_deviation_um),
                Bounds{{-deepest}, "µm"});
        }
    }

    /// Completes a refusal of the wheel's width, if it was the first one of its input.
    void nameWheel(IssueCode code) {
        const auto refused = std::ranges::find(m_issues, code, &Issue::code);
        if (refused != m_issues.end()) {
            const Part& part = *project().part;
            const Machine& machine = *project().machine;
            refused->wheel =
                WheelNeed{part.length_mm, machine.overrun_entry_mm, machine.overrun_exit_mm};
            if (part.surface == Surface::internal) {
                refused->wheel->bore_mm = part.diameter_mm - 2 * part.stock_mm;
            }
        }
    }

    void checkZones() {
        const Wheel& wheel = *project().wheel;
        const Machine& machine = *project().machine;
        const double rz1 = wheel.width_mm - machine.overrun_entry_mm;
        const double rz2 = wheel.width_mm - machine.overrun_exit_mm;
        const Bounds below{.range = {.high = wheel.width_mm},
                           .unit = "mm",
                           .field = "/wheel/width_mm",
                           .highOpen = true};
        const bool wide = sound({"/wheel/width_mm"});
        if (wide && rz1 <= 0) {
            add(IssueCode::outOfRange, "/machine/overrun_entry_mm", mm(machine.overrun_entry_mm),
                below);
        }
        if (wide && rz2 <= 0) {
            add(IssueCode::outOfRange, "/machine/overrun_exit_mm", mm(machine.overrun_exit_mm),
                below);
        }
        const bool known = wide && sound({"/machine/overrun_entry_mm", "/machine/overrun_exit_mm"});
        if (known && rz1 > 0 && rz2 > 0 && project().part->length_mm <= rz1 + rz2) {
            add(IssueCode::zoneTooShort, "/part/length_mm", mm(project().part->length_mm),
                Bounds{.range = {.low = rz1 + rz2, .lowOpen = true},
                       .unit = "mm",
                       .formula = "2·B − o_1 − o_2"});
            nameWheel(IssueCode::zoneTooShort);
        }
        checkOverrun("/machine/overrun_entry_mm", machine.overrun_entry_mm, EntrySide::headstock);
        checkOverrun("/machine/overrun_exit_mm", machine.overrun_exit_mm, EntrySide::tailstock);
        if (project().gauge->position_mm) {
            warn(IssueCode::notUsedHere, "/gauge/position_mm", mm(*project().gauge->position_mm),
                 Phrase::plunge);
        }
        if (project().gauge->section) {
            warn(IssueCode::notUsedHere, "/gauge/section", Count{*project().gauge->section},
                 Phrase::plunge);
        }
    }

    /// The wheel cannot leave a blind bore at its wall, and has no reason to turn short of an end
    /// elsewhere. The overrun is at the headstock when the entry is at the given side.
    void checkOverrun(const char* path, double overrun_mm, EntrySide atHeadstock) {
        const Part& part = *project().part;
        const bool wall = part.surface == Surface::internal && part.blind_bore
                          && project().machine->entry_side == atHeadstock;
        if (wall && overrun_mm > 0) {
            add(IssueCode::wallOverrun, path, mm(overrun_mm), Bounds{{.high = 0}, "mm"});
        } else if (wall && overrun_mm < 0) {
            warn(IssueCode::stripAtWall, path, mm(-overrun_mm), {});
        } else if (overrun_mm < 0) {
            add(IssueCode::outOfRange, path, mm(overrun_mm), Bounds{{.low = 0}, "mm"});
        }
    }

    void checkSections() {
        const Part& part = *project().part;
        const Gauge& gauge = *project().gauge;
        const bool lengthIsSound = sound({"/part/length_mm"});
        if (lengthIsSound && project().wheel->width_mm < part.length_mm) {
            add(IssueCode::wheelTooNarrow, "/wheel/width_mm", mm(project().wheel->width_mm),
                Bounds{{part.length_mm}, "mm", "/part/length_mm"});
            nameWheel(IssueCode::wheelTooNarrow);
        }
        if (gauge.section && *gauge.section >= project().sections && sound({"/sections"})) {
            add(IssueCode::outOfRange, "/gauge/section", Count{*gauge.section},
                Bounds{{0, project().sections - 1.0}});
        }
        if (lengthIsSound && gauge.position_mm && *gauge.position_mm > part.length_mm) {
            add(IssueCode::outOfRange, "/gauge/position_mm", mm(*gauge.position_mm),
                Bounds{{0, part.length_mm}, "mm", "/part/length_mm"});
        }
    }

    /// Lowest and highest, and the step after them, in this order.
    void checkMachineLimits() {
        const MachineLimits& limits = project().machine->limits;
        for (const Field& field : tableOf<MachineLimits>().fields) {
            if (field.kind != Kind::optionalNumberList) {
                continue;
            }
            const auto& range = field.as<std::optional<std::vector<double>>>(&limits);
            const std::string lowest = std::string("/machine/limits/") + field.key + "/0";
            if (range && range->size() == field.count && (*range)[1] < (*range)[0]
                && sound({lowest})) {
                add(IssueCode::outOfRange, std::string("/machine/limits/") + field.key + "/1",
                    Amount{(*range)[1], field.unit}, Bounds{{(*range)[0]}, field.unit});
            }
        }
    }

    /// Whether the machine takes part and wheel.
    void checkMachineFit() {
        for (Issue& misfit : machineMisfits(project())) {
            if (sound({misfit.path, std::get<Bounds>(misfit.limit).field})) {
                warn(misfit.code, misfit.path, std::move(misfit.value), std::move(misfit.limit));
            }
        }
    }

    /// Checks the recipe: there must be pores between grains and bond, cuts and flats no larger
    /// than their grain, and no more flats than surface.
    void checkRecipe() {
        const Wheel& wheel = *project().wheel;
        if (!wheel.force_recipe) {
            return;
        }
        if (wheel.grain_share + wheel.bond_share >= 1
            && sound({"/wheel/grain_share", "/wheel/bond_share"})) {
            add(IssueCode::outOfRange, "/wheel/bond_share", Amount{wheel.bond_share},
                Bounds{.range = {.high = 1 - wheel.grain_share},
                       .formula = "1 − W_g",
                       .highOpen = true});
        }
        const bool counts = wheel.force_recipe->cut_width_mm || wheel.force_recipe->wear_flat_mm;
        if (!counts
            || !sound({"/wheel/grain_share", "/wheel/bond_share", "/wheel/grain_mm",
                       "/wheel/force_recipe"})) {
            return;
        }
        const RecipeShares shares = recipeShares(wheel, *wheel.force_recipe);
        checkCuts(wheel, *wheel.force_recipe, shares);
        if (sound({"/wheel/force_recipe"})) {
            checkFlats(wheel, *wheel.force_recipe, shares);
        }
    }

    /// With a threshold there is force and heat without cutting, where the contact of the sources'
    /// law has no length: temperature and pressure are not known there.
    void checkForceLaw() {
        const Material& material = *project().material;
        const Wheel& wheel = *project().wheel;
        if (material.force_law != ForceLawKind::threshold) {
            return;
        }
        const auto refuse = [this](const char* path, Detail value) {
            add(IssueCode::notWithThreshold, path, std::move(value), Quoted{"null"});
        };
        if (material.burn_rise_k) {
            refuse("/material/burn_rise_k", Amount{*material.burn_rise_k, "K"});
        }
        const bool selfSharpens = wheel.grain_surface_energy_j_m2 && wheel.grain_modulus_gpa
                                  && wheel.bond_surface_energy_j_m2 && wheel.bond_modulus_gpa;
        if (selfSharpens) {
            refuse("/wheel/grain_surface_energy_j_m2",
                   Amount{*wheel.grain_surface_energy_j_m2, "J/m²"});
        }
        if (wheel.force_recipe) {
            refuse("/wheel/force_recipe", Quoted{"{…}"});
        }
        if (project().batch && project().batch->factors.flow_stress_mpa) {
            refuse("/batch/factors/flow_stress_mpa", Quoted{"{…}"});
        }
    }

    /// Checks the cuts of the grains: no wider than a grain, no more than fit side by side, and
    /// together about the metal removed.
    void checkCuts(const Wheel& wheel, const ForceRecipe& recipe, const RecipeShares& shares) {
        constexpr double roomForTheory = 5;
        const char* const factor = "/wheel/force_recipe/contact_factor";
        const char* const width = "/wheel/force_recipe/cut_width_mm";
        if (recipe.cut_width_mm && shares.cutWidth_mm > wheel.grain_mm) {
            add(IssueCode::outOfRange, width, mm(shares.cutWidth_mm),
                Bounds{{0, wheel.grain_mm}, "mm", "/wheel/grain_mm"});
        } else if (shares.cutWidth_mm > wheel.grain_mm) {
            const double least = recipe.contact_factor * shares.cutWidth_mm / wheel.grain_mm;
            add(IssueCode::outOfRange, factor, Amount{recipe.contact_factor},
                Bounds{.range = {.low = roundedUp(least)},
                       .formula = "b_j = m_D·sin β_1/(2·n_c) ≤ d_g"});
        }
        const double densest = 2 / (std::numbers::sqrt3 * wheel.grain_mm * wheel.grain_mm);
        if (shares.cuttingGrains_mm2 > densest) {
            const double most = recipe.contact_factor * densest / shares.cuttingGrains_mm2;
            warn(IssueCode::unusualTogether, factor, Amount{recipe.contact_factor},
                 Bounds{.range = {0, roundedDown(most)}, .formula = "n_c ≤ 2/(√3·d_g²)"});
        }
        if (shares.shear > roomForTheory || shares.shear < 1 / roomForTheory) {
            const double even = shares.cutWidth_mm / shares.shear;
            warn(IssueCode::unusualTogether, width, mm(shares.cutWidth_mm),
                 Bounds{
                     .range = {roundedUp(even / roomForTheory), roundedDown(even * roomForTheory)},
                     .unit = "mm",
                     .formula = "κ = 2·b_j·n_c/(m_D·sin β_1)"});
        }
    }

    /// The wear flats, from which the dullness follows.
    void checkFlats(const Wheel& wheel, const ForceRecipe& recipe, const RecipeShares& shares) {
        constexpr double rounding = 1e-12; // relative; the length was derived from η
        const char* const flat = "/wheel/force_recipe/wear_flat_mm";
        if (!recipe.wear_flat_mm) {
            return;
        }
        const double perMm = shares.cutWidth_mm * shares.cuttingGrains_mm2;
        const Range& usual = tableOf<Wheel>().find("dullness")->soft;
        if (shares.dullness > 1 + rounding) {
            add(IssueCode::outOfRange, flat, mm(*recipe.wear_flat_mm),
                Bounds{.range = {0, roundedDown(1 / perMm)},
                       .unit = "mm",
                       .formula = "η = l_g·b_j·n_c ≤ 1"});
        } else if (*recipe.wear_flat_mm > wheel.grain_mm) {
            add(IssueCode::outOfRange, flat, mm(*recipe.wear_flat_mm),
                Bounds{{0, wheel.grain_mm}, "mm", "/wheel/grain_mm"});
        } else if (shares.dullness > usual.high || shares.dullness < usual.low) {
            warn(IssueCode::unusualTogether, flat, mm(*recipe.wear_flat_mm),
                 Bounds{.range = {roundedUp(usual.low / perMm), roundedDown(usual.high / perMm)},
                        .unit = "mm",
                        .formula = "η = l_g·b_j·n_c"});
        }
    }

    void checkWheelSpeed() {
        const double speed = project().machine->wheel_speed_m_s;
        const std::optional<double>& driven = project().machine->limits.wheel_speed_m_s;
        if (driven && speed > *driven
            && sound({"/machine/wheel_speed_m_s", "/machine/limits/wheel_speed_m_s"})) {
            add(IssueCode::outOfRange, "/machine/wheel_speed_m_s", Amount{speed, "m/s"},
                Bounds{.range = {.high = *driven},
                       .unit = "m/s",
                       .field = "/machine/limits/wheel_speed_m_s"});
        }
        const std::optional<double>& highest = project().wheel->max_speed_m_s;
        if (highest && speed > *highest
            && sound({"/machine/wheel_speed_m_s", "/wheel/max_speed_m_s"})) {
            add(IssueCode::outOfRange, "/machine/wheel_speed_m_s", Amount{speed, "m/s"},
                Bounds{
                    .range = {.high = *highest}, .unit = "m/s", .field = "/wheel/max_speed_m_s"});
        }
    }

    /// The error of the gauge's reading must not exceed the stock per side: otherwise it would read
    /// the size before the wheel touches.
    void checkReading() {
        const Gauge& gauge = *project().gauge;
        const double error_mm = std::abs(gauge.error_um) / units::umPerMm;
        const double wrong_mm = std::abs(readsTooLarge_mm(project()));
        const double most_mm = project().part->stock_mm;
        if (wrong_mm <= most_mm
            || !sound({"/part/stock_mm", "/part/diameter_mm", "/gauge/error_um",
                       "/gauge/part_warmer_k", "/material/expansion_um_m_k"})) {
            return;
        }
        if (error_mm > most_mm) {
            const double most_um = roundedDown(most_mm * units::umPerMm);
            add(IssueCode::outOfRange, "/gauge/error_um", um(gauge.error_um),
                Bounds{{-most_um, most_um}, "µm", "/part/stock_mm"});
            return;
        }
        const double perKelvin_mm =
            project().material->expansion_um_m_k * 1e-6 * project().part->diameter_mm; // from µm/m
        const double most_k = roundedDown((most_mm - error_mm) / perKelvin_mm);
        add(IssueCode::outOfRange, "/gauge/part_warmer_k", Amount{gauge.part_warmer_k, "K"},
            Bounds{{-most_k, most_k}, "K", "/part/stock_mm"});
    }

    void checkCompliance() {
        const GivenCompliance& given = project().machine->compliance_mm_per_n;
        const char* path = "/machine/compliance_mm_per_n";
        const auto* sections = std::get_if<std::vector<double>>(&given);
        if (std::holds_alternative<std::monostate>(given)) {
            checkStiffness();
            return;
        }
        if (project().sections_coupled && !project().operation->travels) {
            add(IssueCode::influenceUnknown, "/sections_coupled", Quoted{"true"},
                Phrase::computedCompliance);
        }
        if (project().operation->travels) {
            if (sections) {
                add(IssueCode::wrongType, path, Quoted{"[…]"}, Phrase::valueForEachZone);
            }
        } else if (!sections) {
            add(IssueCode::wrongType, path, Quoted{"{…}"},
                Quoted{sound({"/sections"}) ? "[γ × " + std::to_string(project().sections) + "]"
                                            : "[γ × J]"});
        } else if (sections->size() != static_cast<std::size_t>(project().sections)
                   && sound({"/sections"})) {
            add(IssueCode::wrongCount, path, countOf(sections->size()),
                Count{project().sections, {}, "/sections"});
        }
    }

    void checkStiffness() {
        const Shaft& shaft = project().part->shaft;
        const bool internal = project().part->surface == Surface::internal;
        if (!project().machine->stiffness_n_um) {
            add(IssueCode::complianceMissing, "/machine/compliance_mm_per_n", {},
                Phrase::anyCompliance);
            return;
        }
        if (internal) {
            if (!shaft.quill) {
                add(IssueCode::complianceMissing, "/part/shaft/quill", {}, Phrase::quill);
            }
            return;
        }
        const double length = lengthOf(shaft);
        const double needed = shaft.ground_from_mm + project().part->length_mm;
        if (shaft.segments.empty()) {
            add(IssueCode::complianceMissing, "/part/shaft/segments", {}, Phrase::shaftSteps);
        } else if (length < needed - 1e-9
                   && sound(
                       {"/part/shaft/segments", "/part/shaft/ground_from_mm", "/part/length_mm"})) {
            add(IssueCode::shaftTooShort, "/part/shaft/segments", mm(length),
                Bounds{{needed}, "mm"});
        }
        for (std::size_t i = 0; i < shaft.steady_rests.size(); ++i) {
            if (shaft.steady_rests[i].position_mm > length && sound({"/part/shaft/segments"})) {
                const std::string path =
                    "/part/shaft/steady_rests/" + std::to_string(i) + "/position_mm";
                add(IssueCode::outOfRange, path, mm(shaft.steady_rests[i].position_mm),
                    mm(Range{0, length}));
            }
        }
        checkShoulders();
    }

    /// Checks the room for the wheel beside the ground length, where the shaft is known. A step no
    /// higher than the blank is not a shoulder.
    void checkShoulders() {
        const Part& part = *project().part;
        const Wheel& wheel = *project().wheel;
        if (!sound({"/part"})) {
            return;
        }
        const Clearance clearance = clearanceOf(
            part, part.diameter_mm + 2 * (part.stock_mm + blankRunout() + furthestZone_mm(part)));
        if (project().operation->travels) {
            const Machine& machine = *project().machine;
            const bool entersAtHeadstock = machine.entry_side == EntrySide::headstock;
            const auto compare = [this](const char* path, double overrun_mm, double free_mm) {
                if (overrun_mm > free_mm && sound({path})) {
                    warn(IssueCode::shoulderInTheWay, path, mm(overrun_mm),
                         Bounds{{.high = roundedDown(free_mm)}, "mm"});
                }
            };
            compare("/machine/overrun_entry_mm", machine.overrun_entry_mm,
                    entersAtHeadstock ? clearance.headstock : clearance.tailstock);
            compare("/machine/overrun_exit_mm", machine.overrun_exit_mm,
                    entersAtHeadstock ? clearance.tailstock : clearance.headstock);
        } else if (const double room = clearance.headstock + part.length_mm + clearance.tailstock;
                   wheel.width_mm > room && sound({"/wheel/width_mm"})) {
            warn(IssueCode::shouldersTooNear, "/wheel/width_mm", mm(wheel.width_mm),
                 Bounds{{.high = roundedDown(room)}, "mm"});
        }
    }

    /// Checks that forces rise and stiffnesses are positive.
    void checkWheelContact() {
        const auto& contact = project().machine->wheel_contact;
        if (!contact || !contact->n_um_at_n) {
            return;
        }
        const auto& rows = *contact->n_um_at_n;
        const std::string path = "/machine/wheel_contact/n_um_at_n";
        if (rows.empty()) {
            add(IssueCode::wrongCount, path, Count{0}, Bounds{{1}});
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::string row = path + "/" + std::to_string(i);
            if (rows[i].size() != 2) {
                continue; // the ranges' fault
            }
            constexpr double softest = 1e-3;
            if (rows[i][1] < softest) {
                add(IssueCode::outOfRange, row + "/1", Amount{rows[i][1], "N/µm"},
                    Bounds{{softest}, "N/µm"});
            }
            const std::string before = path + "/" + std::to_string(i - 1) + "/0";
            if (i > 0 && !rows[i - 1].empty() && !(rows[i][0] > rows[i - 1][0])
                && sound({before})) {
                add(IssueCode::outOfRange, row + "/0", Amount{rows[i][0], "N"},
                    Bounds{{.low = rows[i - 1][0], .lowOpen = true}, "N"});
            }
        }
    }

    void checkStages() {
        const auto& stages = project().cycle->stages;
        double sum = 0;
        bool known = sound({"/part/stock_mm"});
        for (std::size_t i = 0; i < stages.size(); ++i) {
            checkStage(stages[i], i);
            sum += stages[i].stock_mm;
            known = known && sound({"/cycle/stages/" + std::to_string(i) + "/stock_mm"});
        }
        if (known && std::abs(sum - project().part->stock_mm) > 1e-9) {
            sum = std::round(sum * 1e9) / 1e9; // removes binary rounding
            warn(IssueCode::stocksDoNotSumUp, "/cycle/stages", mm(sum),
                 mm(project().part->stock_mm));
        }
        const auto commands = static_cast<std::size_t>(project().gauge->commands);
        if (project().gauge->control == Control::gauge && stages.size() > commands
            && sound({"/gauge/commands"})) {
            warn(IssueCode::tooManyStages, "/cycle/stages", countOf(stages.size()),
                 countOf(commands));
        }
    }

    void checkStage(const Stage& stage, std::size_t index) {
        const std::size_t count = project().cycle->stages.size();
        const std::string path = "/cycle/stages/" + std::to_string(index);
        const StageFeed& radial = project().operation->radial();
        const std::string feedPath = path + "/" + radial.key;
        const Field& row = *tableOf<Stage>().find(radial.key);
        const auto& feed = stage.*radial.value;
        const bool sparks = !stage.feeds();
        if (sparks && index + 1 < count) {
            add(IssueCode::sparkOutNotLast, path + "/" + Stage::sparkOutKey, countOf(index + 1),
                countOf(count));
        }
        if (sparks && feed && *feed > 0) {
            warn(IssueCode::feedUnused, feedPath, Amount{*feed, row.unit}, {});
        }
        if (!sparks && !feed) {
            add(IssueCode::missingKey, feedPath, {}, Bounds{row.read, row.unit});
        } else if (!sparks && *feed < row.read.low && !(*feed < 0 && mayRetract(project(), stage))
                   && !row.allowed(project(), &stage).contains(*feed)) {
            add(IssueCode::feedMissing, feedPath, Amount{*feed, row.unit},
                Bounds{row.read, row.unit});
        }
        if (const StageFeed* axial = project().operation->axial();
            axial && !(stage.*axial->value)) {
            const Field& axialRow = *tableOf<Stage>().find(axial->key);
            add(IssueCode::missingKey, path + "/" + axial->key, {},
                Bounds{axialRow.stated(), axialRow.unit});
        }
    }

    /// An invalid batch is no reason to refuse the cycle.
    void checkBatch() {
        for (Issue& issue : batchFaults(project())) {
            warn(issue.code, issue.path, std::move(issue.value), std::move(issue.limit));
        }
    }

    void checkSweep() {
        for (Issue& issue : sweepFaults(project())) {
            warn(issue.code, issue.path, std::move(issue.value), std::move(issue.limit));
        }
    }

    void checkMeasured() {
        for (Issue& issue : measuredFaults(project())) {
            add(issue.code, issue.path, std::move(issue.value), std::move(issue.limit),
                issue.severity);
        }
    }

    void checkOptimisation() {
        if (!project().optimisation) {
            return;
        }
        for (const Field& field : tableOf<Optimisation>().fields) {
            if (field.whole) {
                checkWhole(field, &*project().optimisation,
                           std::string("/optimisation/") + field.key);
            }
        }
    }

    /// Checks a list or levels.
    void checkWhole(const Field& field, const void* owner, const std::string& path) {
        const auto check = [&](double number, const std::string& key) {
            if (number != std::floor(number)) {
                add(IssueCode::wrongType, path + "/" + key, Amount{number}, Phrase::wholeNumber);
            }
        };
        const bool isList = field.kind == Kind::numberList;
        const auto* levels = isList ? nullptr : &field.as<Levels>(owner);
        const auto* list = isList ? &field.as<std::vector<double>>(owner)
                                  : std::get_if<std::vector<double>>(levels);
        for (std::size_t i = 0; list && i < list->size(); ++i) {
            check((*list)[i], std::to_string(i));
        }
        if (const auto* stepped = levels ? std::get_if<SteppedLevels>(levels) : nullptr) {
            check(stepped->from, "from");
            check(stepped->step, "step");
        }
    }

    const Project& m_project;
    Issues& m_issues;
};

} // namespace

Issues validate(const Project& project) {
    Issues issues = checkRanges(project);
    Rules(project, issues).check();
    return issues;
}

} // namespace sparkout
