// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/stiffness_trial.h"

#include "core/measured/calibration.h"
#include "core/process/compliance.h"
#include "core/project/machine.h"
#include "core/project/measured.h"
#include "core/project/part.h"
#include "core/simulation/simulate.h"
#include "core/units.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

double shaftLength(const Project& project) {
    double length = 0;
    for (const ShaftSegment& segment : project.part->shaft.segments) {
        length += segment.length_mm;
    }
    return length;
}

/// The shaft on rigid units, for its bending.
Compliance bentShaft(const Project& project) {
    const Shaft& shaft = project.part->shaft;
    constexpr double rigid = std::numeric_limits<double>::infinity();
    ShaftModel model;
    for (const ShaftSegment& segment : shaft.segments) {
        model.segments.push_back({segment.length_mm, segment.diameter_mm});
    }
    model.youngsModulus_n_mm2 = shaft.youngs_modulus_gpa * units::mpaPerGpa;
    model.mounting = shaft.mounting;
    model.headstock_n_mm = model.tailstock_n_mm = model.wheelHead_n_mm = rigid;
    return Compliance(std::move(model));
}

class TrialFit {
public:
    TrialFit(const Project& project, const StiffnessRequest& request)
        : m_project(project), m_request(request), m_length_mm(shaftLength(project)) {
        if (project.part->shaft.mounting == Mounting::centres) {
            m_units = {StiffnessUnit::headstock, StiffnessUnit::tailstock};
        } else {
            m_units = {StiffnessUnit::headstock};
        }
        if (findsWheelHead()) {
            m_units.push_back(StiffnessUnit::wheel_head);
        }
    }

    StiffnessTrial fit() {
        m_trial.unknowns = m_units.size();
        m_trial.status = refusal();
        if (m_trial.status == StiffnessTrialStatus::found) {
            solve();
        }
        return std::move(m_trial);
    }

private:
    [[nodiscard]] bool findsWheelHead() const {
        return m_request.deflection == DeflectionOf::system && m_request.findWheelHead;
    }
    [[nodiscard]] bool needsWheelHead() const {
        return m_request.deflection == DeflectionOf::system && !m_request.findWheelHead;
    }

    [[nodiscard]] StiffnessTrialStatus refusal() const {
        const Part& part = *m_project.part;
        const bool chuckWithWheel =
            part.shaft.mounting == Mounting::chuck
            && findsWheelHead(); // headstock and wheel head act alike at every place
        std::vector<double> places;
        bool onShaft = true;
        for (const StiffnessReading& reading : m_request.readings) {
            onShaft = onShaft && reading.position_mm >= 0 && reading.position_mm <= m_length_mm;
            places.push_back(reading.position_mm);
        }
        if (part.surface == Surface::internal || part.shaft.segments.empty()
            || !part.shaft.steady_rests.empty() || !onShaft || chuckWithWheel
            || (needsWheelHead() && !m_project.machine->stiffness_n_um)) {
            return StiffnessTrialStatus::notMeasurable;
        }
        std::ranges::sort(places);
        places.erase(std::unique(places.begin(), places.end()), places.end());
        return places.size() < m_units.size() ? StiffnessTrialStatus::tooFewPlaces
                                              : StiffnessTrialStatus::found;
    }

    /// The contribution of a unit's compliance of 1 µm/N to γ at a place.
    [[nodiscard]] double shareOf(StiffnessUnit unit, double position_mm) const {
        const double u =
            m_project.part->shaft.mounting == Mounting::centres ? position_mm / m_length_mm : 0;
        switch (unit) {
        case StiffnessUnit::headstock: return (1 - u) * (1 - u);
        case StiffnessUnit::tailstock: return u * u;
        case StiffnessUnit::wheel_head:
        case StiffnessUnit::count_: break;
        }
        return 1;
    }

    /// A least-squares solution for given columns.
    struct Solved {
        Eigen::MatrixXd columns;
        Eigen::VectorXd values, residuals;
        bool isDetermined = false; ///< the columns are independent
        [[nodiscard]] double freedom() const {
            return static_cast<double>(columns.rows() - columns.cols());
        }
        [[nodiscard]] double squares() const { return residuals.squaredNorm(); }
    };
    static Solved solved(Eigen::MatrixXd columns, const Eigen::VectorXd& right) {
        Solved made{std::move(columns), {}, {}};
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(made.columns);
        made.isDetermined = qr.rank() == made.columns.cols();
        made.values = qr.solve(right);
        made.residuals = right - made.columns * made.values;
        return made;
    }

    /// The columns of the compliances and additional ones, each a function of reading and unit.
    template <class Column>
    [[nodiscard]] Solved with(const Eigen::MatrixXd& compliances, const Eigen::VectorXd& right,
                              Eigen::Index units, Column column) const {
        Eigen::MatrixXd all(compliances.rows(), compliances.cols() + units);
        all.leftCols(compliances.cols()) = compliances;
        for (Eigen::Index i = 0; i < all.rows(); ++i) {
            for (Eigen::Index k = 0; k < units; ++k) {
                all(i, compliances.cols() + k) =
                    column(m_request.readings[static_cast<std::size_t>(i)],
                           m_units[static_cast<std::size_t>(k)]);
            }
        }
        return solved(std::move(all), right);
    }

    /// Whether additional columns reduce the residuals by more than chance.
    static bool isBetter(const Solved& more, const Solved& plain) {
        constexpr double probability = 0.99;
        const double columns = plain.freedom() - more.freedom();
        const double least = 1e-18 * plain.columns.squaredNorm(); // for exact readings
        return more.freedom() > 0 && plain.squares() > least
               && (plain.squares() - more.squares()) * more.freedom()
                      > fisherQuantile(probability, columns, more.freedom()) * columns
                            * std::max(more.squares(), least);
    }

    /// The proportional fit, or the one with play if it is significant.
    Solved testLine(Solved plain, const Eigen::VectorXd& right) {
        // Play of the wheel head would act like that of both centres.
        const Eigen::Index units = m_project.part->shaft.mounting == Mounting::centres ? 2 : 1;
        Solved play = with(plain.columns, right, units,
                           [this](const StiffnessReading& reading, StiffnessUnit unit) {
                               const double share = shareOf(unit, reading.position_mm);
                               return std::sqrt(share); // of the unit's own movement
                           });
        const Solved bent =
            with(plain.columns, right, units,
                 [this](const StiffnessReading& reading, StiffnessUnit unit) {
                     return reading.load_n * reading.load_n * shareOf(unit, reading.position_mm);
                 });
        if (!play.isDetermined || !bent.isDetermined || !(play.freedom() > 0)) {
            return plain; // too few places with two different loads
        }
        const bool isSeen = isBetter(play, plain) || isBetter(bent, plain);
        // A deflection that begins below 0 is not due to play.
        const bool isPlay = play.squares() <= bent.squares() && play.values.tail(units).sum() > 0;
        m_trial.line = !isSeen ? LoadLine::straight : isPlay ? LoadLine::play : LoadLine::bent;
        if (m_trial.line != LoadLine::play) {
            return plain;
        }
        for (Eigen::Index k = 0; k < units; ++k) {
            m_trial.play_um.push_back(play.values[plain.values.size() + k]);
        }
        return play;
    }

    void solve() {
        const Compliance shaft = bentShaft(m_project);
        const auto rows = static_cast<Eigen::Index>(m_request.readings.size());
        const auto columns = static_cast<Eigen::Index>(m_units.size());
        Eigen::MatrixXd A(rows, columns);
        Eigen::VectorXd right(rows);
        for (Eigen::Index i = 0; i < rows; ++i) {
            const StiffnessReading& reading = m_request.readings[static_cast<std::size_t>(i)];
            double known = shaft.at(reading.position_mm) * units::umPerMm;
            if (needsWheelHead()) {
                known += 1 / m_project.machine->stiffness_n_um->wheel_head;
            }
            for (Eigen::Index k = 0; k < columns; ++k) {
                A(i, k) = reading.load_n
                          * shareOf(m_units[static_cast<std::size_t>(k)], reading.position_mm);
            }
            right[i] = reading.deflection_um - reading.load_n * known;
        }
        const Solved line = testLine(solved(std::move(A), right), right);
        const Eigen::VectorXd& c = line.values;
        m_trial.unknowns = static_cast<std::size_t>(c.size());
        m_trial.residuals_um.assign(line.residuals.data(), line.residuals.data() + rows);
        const double freedom = line.freedom();
        m_trial.rms_um = freedom > 0 ? line.residuals.norm() / std::sqrt(freedom) : 0;
        const Eigen::MatrixXd covariance =
            (line.columns.transpose() * line.columns)
                .ldlt()
                .solve(Eigen::MatrixXd::Identity(c.size(), c.size()));
        for (Eigen::Index k = 0; k < columns; ++k) {
            const StiffnessUnit unit = m_units[static_cast<std::size_t>(k)];
            if (!(c[k] > 0)) {
                m_trial.negative.push_back(unit);
                m_trial.status = StiffnessTrialStatus::negative;
                continue;
            }
            FoundStiffness found{unit, 1 / c[k], std::nullopt};
            if (freedom > 0) {
                const double half =
                    studentQuantile(0.975, freedom) * m_trial.rms_um * std::sqrt(covariance(k, k));
                found.interval95 = {1 / (c[k] + half),
                                    half < c[k] ? 1 / (c[k] - half)
                                                : std::numeric_limits<double>::infinity()};
            }
            m_trial.found.push_back(found);
        }
    }

    const Project& m_project;
    const StiffnessRequest& m_request;
    double m_length_mm;
    std::vector<StiffnessUnit> m_units;
    StiffnessTrial m_trial;
};

} // namespace

double Stiffness::*memberOf(StiffnessUnit unit) {
    switch (unit) {
    case StiffnessUnit::headstock: return &Stiffness::headstock;
    case StiffnessUnit::tailstock: return &Stiffness::tailstock;
    case StiffnessUnit::wheel_head:
    case StiffnessUnit::count_: break;
    }
    return &Stiffness::wheel_head;
}

StiffnessTrial stiffnessFromTrial(const Project& project, const StiffnessRequest& request) {
    return TrialFit(project, request).fit();
}

Project withStiffness(const Project& project, const StiffnessTrial& trial, const std::string& data,
                      const std::string& date, std::size_t readings) {
    Project calibrated = project;
    if (trial.status != StiffnessTrialStatus::found) {
        return calibrated;
    }
    Machine& machine = *calibrated.machine;
    machine.compliance_mm_per_n = std::monostate();
    Stiffness& stiffness =
        machine.stiffness_n_um ? *machine.stiffness_n_um : machine.stiffness_n_um.emplace();
    for (const FoundStiffness& found : trial.found) {
        stiffness.*memberOf(found.unit) = found.n_um;
        Calibration calibration;
        calibration.input = std::string("/machine/stiffness_n_um/") + keyOf(found.unit);
        calibration.value = found.n_um;
        if (found.interval95) {
            calibration.low = found.interval95->low;
            if (std::isfinite(found.interval95->high)) {
                calibration.high = found.interval95->high;
            }
        }
        calibration.data = data;
        calibration.count = static_cast<int>(readings);
        calibration.date = date;
        recordCalibration(calibrated, std::move(calibration));
    }
    return calibrated;
}

std::array<double, 3> stiffnessPlaces_mm(const Project& project) {
    constexpr double fromEnd = 0.1, half = 0.5;
    const double length = shaftLength(project);
    return {fromEnd * length, half * length, (1 - fromEnd) * length};
}

double stiffnessLoad_n(const Project& project) {
    constexpr double least_n = 50, rounded_n = 10;
    const SimulationResult result = simulateUnchecked(project);
    double peak = least_n;
    for (const SectionResult& section : result.sections) {
        peak = std::max(peak,
                        std::isfinite(section.peakNormalForce_n) ? section.peakNormalForce_n : 0);
    }
    return std::ceil(peak / rounded_n) * rounded_n;
}

const char* keyOf(StiffnessUnit unit) {
    switch (unit) {
    case StiffnessUnit::headstock: return "headstock";
    case StiffnessUnit::tailstock: return "tailstock";
    case StiffnessUnit::wheel_head:
    case StiffnessUnit::count_: break;
    }
    return "wheel_head";
}

} // namespace sparkout
