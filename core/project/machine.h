// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout {

struct Project;

/// The values that a control of the machine can be set to: low + k·step, up to high.
struct MachineSteps {
    double low = 0, high = std::numeric_limits<double>::infinity();
    double step = 0; ///< positive

    [[nodiscard]] double nearest(double value) const; ///< the value may lie beyond the ends
    /// The value that number of steps up or down, within the ends. A negative feed, which retracts
    /// the wheel, is stepped by its size.
    [[nodiscard]] double stepped(double value, int steps) const;
};

/// The machine's range for an input, by the input's path: [lowest, highest, step]; null if it has
/// none.
[[nodiscard]] const std::vector<double>* machineRange(const Project& project,
                                                      std::string_view path);
/// The values that an input can take on the machine. The stock of a stage follows the steps of the
/// radial feed per double stroke, which are those of the wheel slide's position. Empty where the
/// machine states no step.
[[nodiscard]] std::optional<MachineSteps> machineSteps(const Project& project,
                                                       std::string_view path);
/// The value of an input that number of machine steps up or down; empty without steps.
[[nodiscard]] std::optional<double> steppedOnMachine(const Project& project, std::string_view path,
                                                     double value, int steps);

enum class EntrySide { headstock, tailstock };
/// The reversals at which a double stroke is fed by S_t; `both`: S_t/2 at each.
enum class ReversalInfeed { entry, exit, both };

/// Stiffness of the machine's units [N/µm].
struct Stiffness {
    double headstock = 60;
    double tailstock = 40;
    double wheel_head = 50;
};

/// Wheel contact stiffness in series, rising with load (an option beyond the sources).
struct WheelContact {
    NumberRows n_um_at_n; ///< rows of [force N, stiffness N/µm]
};

/// The machine's adjustment ranges, [lowest, highest, step] each, and the sizes of part and wheel
/// that it takes; not given: unlimited.
struct MachineLimits {
    std::optional<std::vector<double>> radial_feed_mm;
    std::optional<std::vector<double>> axial_feed_mm_min;
    std::optional<std::vector<double>> plunge_feed_mm_min;
    std::optional<std::vector<double>> continuous_feed_mm_min;
    std::optional<std::vector<double>> work_speed_rpm;
    std::optional<double> part_diameter_mm; ///< largest; not given: not limited [mm]
    std::optional<double> part_length_mm;   ///< largest; not given: not limited [mm]
    /// Largest diameter of a new wheel, [lowest, highest] width, and bore of its seat; not given:
    /// not limited [mm]
    std::optional<double> wheel_diameter_mm;
    std::optional<std::vector<double>> wheel_width_mm;
    std::optional<double> wheel_bore_mm;
    std::optional<double> wheel_speed_m_s; ///< highest V_k; not given: not limited [m/s]
};

/// The error of form that centres, headstock and spindle transfer to every part, by zone or
/// section: their axis moves towards the wheel by c(φ), and the part has R − c, a bore R + c
/// [MODEL-7].
struct MachineForm {
    std::optional<std::vector<double>> roundness_um; ///< 2·A_j; not given: not known [µm]
    std::optional<std::vector<double>> runout_um;    ///< of A_1 and A_j; not given: not known [µm]
    std::optional<int> lobes;                        ///< j; not given: not known
    /// Angle from a lobe's deepest point to that of A_1; not given: the one that gives the stated
    /// runout [°]
    std::optional<double> runout_at_deg;
    friend bool operator==(const MachineForm&, const MachineForm&) = default;
};

/// The work speed rises and falls about its value, against waves that print onto one another
/// [MODEL-16].
struct SpeedVariation {
    double percent = 10; ///< s, to either side [%]
    double period_s = 5; ///< T [s]
    friend bool operator==(const SpeedVariation&, const SpeedVariation&) = default;
};

/// The quantity that the wheel's drive keeps constant as the wheel's diameter falls [MODEL-8]: V_k,
/// or the revolutions, so that V_k falls with the diameter.
enum class WheelSpeedControl { constant_speed, constant_revolutions };

/// The grinder: speeds, table travel, dwells, compliance, drives.
struct Machine {
    std::string name;
    double wheel_speed_m_s = 30; ///< V_k of the wheel at its given diameter [m/s]
    WheelSpeedControl wheel_speed_control = WheelSpeedControl::constant_speed;
    double work_speed_rpm = 180;                        ///< n [rev/min]
    std::optional<SpeedVariation> work_speed_variation; ///< not given: the speed is constant
    double plunge_feed_mm_min = 0.5;                    ///< S_rad, plunge-in at a reversal [mm/min]
    ReversalInfeed reversal_infeed = ReversalInfeed::entry;
    double overrun_entry_mm = 12;        ///< o1 [mm]
    double overrun_exit_mm = 12;         ///< o2 [mm]
    double dwell_entry_s = 0;            ///< spark-out at the entry reversal [s]
    double dwell_exit_s = 0;             ///< spark-out at the exit reversal [s]
    GivenCompliance compliance_mm_per_n; ///< γ; not given: from stiffness and shaft [mm/N]
    std::optional<Stiffness> stiffness_n_um;
    /// ω_0/2π of the wheel head; not given: far above the wheel's revolutions [Hz]
    std::optional<double> wheel_head_frequency_hz;
    std::optional<std::vector<double>> zone_compliance; ///< factor on γ of each zone or section
    double geometric_runout_um = 0;  ///< runout of centres and spindle, added to every runout [µm]
    std::optional<MachineForm> form; ///< if given, geometric_runout_um is not used
    // Repeatability and drift of the in-process gauge; not given: unknown, without scatter in a
    // batch.
    std::optional<double> gauge_repeatability_um; ///< s_g, standard deviation of a reading [µm]
    std::optional<double> gauge_drift_um_h; ///< v_g, drift of the reading since it was set [µm/h]
    /// τ_g of its gauge, for a project that states no delay of the gauge; not given: none [s]
    std::optional<double> gauge_delay_s;
    std::optional<double> wheel_drive_kw; ///< [kW]; not given: not limited
    std::optional<double> work_drive_kw;  ///< [kW]; not given: not limited
    /// Delay from the gauge's command to the next stage's feed; not given: none [s]
    std::optional<double> feed_change_delay_s;
    EntrySide entry_side = EntrySide::headstock;
    std::optional<WheelContact> wheel_contact;
    MachineLimits limits;
};

/// Changes the wheel's diameter on a drive that keeps V_k or the revolutions [MODEL-8]; used by
/// batch, sweep, set-up and dressing.
void changeWheelDiameter(Project& project, double diameter_mm);

/// Numbers of lobes to assume where it is not known: an odd number changes no diameter, an even
/// number changes them all.
inline constexpr int oddLobes = 3, evenLobes = 2;
/// Number of radii per lobe or wave, so that its height is resolved to 1 − cos(π/12) = 3.4 %.
inline constexpr int radiiOfLobe = 12;

/// n_k [rev/min].
[[nodiscard]] double wheelSpeed_rpm(const Project& project);
/// Waves of the wheel in one turn of the work, L·n_k/n [MODEL-16]; with one wave where its runout
/// is not given.
[[nodiscard]] double wavesPerTurn(const Project& project);
/// A ratio L·n_k/n this near to p/q lays the waves of q turns of the work onto those of the q turns
/// before: over ten turns, a usual spark-out, they shift by less than half of their length
/// [BADGER2010].
inline constexpr double nearRatio = 0.05;
/// The number of waves around the work that the wheel prints: p where the ratio is near to p/q with
/// q up to 6, beyond which a long spark-out leaves less than an eighth of e, and mostRadii resolve
/// p waves; else the ratio itself.
[[nodiscard]] int orderOfWaves(const Project& project);
/// The least number of radii that resolves these waves.
[[nodiscard]] int radiiForWaves(const Project& project);
/// Whether the wheel's waves are known: its runout is given, and the radii resolve them, which a
/// valid project's do.
[[nodiscard]] bool areWavesKnown(const Project& project);
/// After another speed or wheel diameter: takes as many radii as its waves need, if they are fewer
/// and those of the blank are not typed.
void resolveWaves(Project& project);

/// The given number of lobes, or oddLobes.
[[nodiscard]] int lobesOf(const MachineForm& form);
/// Whether the machine prints lobes, and whether their number is not known.
[[nodiscard]] bool hasLobes(const Machine& machine);
[[nodiscard]] bool areLobesUnknown(const Machine& machine);

/// The machine's runout that is added to every runout as a number [µm]: 0 with a form that has
/// runouts, which are part of its radii.
[[nodiscard]] double addedRunout_um(const Machine& machine);
/// Whether roundness, cylindricity and runouts include the machine's own error; otherwise they are
/// those of the process alone.
[[nodiscard]] bool isRoundnessKnown(const Machine& machine);
[[nodiscard]] bool isRunoutKnown(const Machine& machine);
/// Whether radii include the machine's own eccentricity: a runout without a form is only a number.
[[nodiscard]] bool isEccentricityKnown(const Machine& machine);

template <>
std::span<const Choice> choicesOf<EntrySide>();
template <>
std::span<const Choice> choicesOf<ReversalInfeed>();
template <>
std::span<const Choice> choicesOf<WheelSpeedControl>();
template <>
const StructInfo& tableOf<Stiffness>();
template <>
const StructInfo& tableOf<WheelContact>();
template <>
const StructInfo& tableOf<MachineLimits>();
template <>
const StructInfo& tableOf<MachineForm>();
template <>
const StructInfo& tableOf<SpeedVariation>();
template <>
const StructInfo& tableOf<Machine>();

} // namespace sparkout
