// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/printed_form.h"

#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

constexpr double pi = std::numbers::pi;

double valueOfPlace(const std::optional<std::vector<double>>& values_um, std::size_t place) {
    return values_um && place < values_um->size() ? (*values_um)[place] / units::umPerMm : 0;
}

/// The curves cos φ, sin φ and cos jφ at even angles, the components of all forms with j lobes.
class Waves {
public:
    explicit Waves(int lobes)
        : m_lobes(lobes)
        , m_points(static_cast<std::size_t>(std::max(fewestPoints, pointsOfLobe * lobes)))
        , m_cos(m_points)
        , m_sin(m_points)
        , m_lobe(m_points)
        , m_c(m_points) {
        for (std::size_t i = 0; i < m_cos.size(); ++i) {
            const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(m_points);
            m_cos[i] = std::cos(angle);
            m_sin[i] = std::sin(angle);
            m_lobe[i] = std::cos(lobes * angle);
        }
    }

    /// max c − min c.
    double runout_mm(const PrintedForm& form) {
        const double x = form.eccentricity_mm * std::cos(form.at);
        const double y = form.eccentricity_mm * std::sin(form.at);
        std::size_t most = 0, least = 0;
        for (std::size_t i = 0; i < m_points; ++i) {
            m_c[i] = x * m_cos[i] + y * m_sin[i] + form.lobe_mm * m_lobe[i];
            most = m_c[i] > m_c[most] ? i : most;
            least = m_c[i] < m_c[least] ? i : least;
        }
        return extremeNear(most) - extremeNear(least);
    }

    /// The mean over all φ_1: the runout repeats with each lobe, is symmetric within one, and for
    /// even j repeats once more.
    double mean_mm(PrintedForm form) {
        constexpr int directions = 12;
        double sum = 0;
        for (int i = 0; i < directions; ++i) {
            form.at = reach() * (i + 0.5) / directions;
            sum += runout_mm(form);
        }
        return sum / directions;
    }

    /// The period of the runout over φ_1.
    [[nodiscard]] double reach() const { return pi / m_lobes / (m_lobes % 2 == 0 ? 2 : 1); }

private:
    static constexpr int fewestPoints = 72, pointsOfLobe = 24;

    /// The extreme of the parabola through a point and its neighbours.
    [[nodiscard]] double extremeNear(std::size_t i) const {
        const double at = m_c[i];
        const double before = m_c[(i + m_points - 1) % m_points], after = m_c[(i + 1) % m_points];
        const double bend = before - 2 * at + after;
        return bend == 0 ? at : at - (after - before) * (after - before) / (8 * bend);
    }

    int m_lobes;
    std::size_t m_points;
    std::vector<double> m_cos, m_sin, m_lobe, m_c;
};

/// The zero of a function that rises from negative to positive, by a bracketed secant method.
template <class Value>
double between(double low, double high, const Value& value) {
    constexpr int mostTries = 40;
    constexpr double nearEnough = 1e-9, exact_mm = 1e-12;
    double atLow = value(low), atHigh = value(high), middle = low;
    for (int i = 0, side = 0; i < mostTries && high - low > nearEnough * high; ++i) {
        middle = atHigh > atLow ? (low * atHigh - high * atLow) / (atHigh - atLow) : low;
        middle = std::clamp(middle, low, high);
        const double at = value(middle);
        if (std::abs(at) < exact_mm) {
            break;
        }
        if (at < 0) {
            low = middle;
            atLow = at;
            atHigh /= side < 0 ? 2 : 1;
            side = -1;
        } else {
            high = middle;
            atHigh = at;
            atLow /= side > 0 ? 2 : 1;
            side = 1;
        }
    }
    return middle;
}

/// Determines A_1, and φ_1 if not given, from a runout that is the mean over all φ_1.
void fitEccentricity(PrintedForm& form, double runout_mm, bool isDirected) {
    Waves waves(form.lobes);
    form.eccentricity_mm = between(0, runout_mm / 2, [&](double a) {
        PrintedForm tried = form;
        tried.eccentricity_mm = a;
        return waves.mean_mm(tried) - runout_mm;
    });
    if (isDirected) {
        return;
    }
    // From φ_1 = 0, where lobe and eccentricity are deepest together, the runout rises for even j
    // and falls for odd j.
    const double sign = form.lobes % 2 == 0 ? 1 : -1;
    form.at = between(0, waves.reach(), [&](double angle) {
        PrintedForm tried = form;
        tried.at = angle;
        return sign * (waves.runout_mm(tried) - runout_mm);
    });
}

} // namespace

double PrintedForm::at_mm(double angle) const {
    return eccentricity_mm * std::cos(angle - at) + lobe_mm * std::cos(lobes * angle);
}

double printedRunout_mm(const PrintedForm& form) {
    return form.lobe_mm == 0 ? 2 * form.eccentricity_mm : Waves(form.lobes).runout_mm(form);
}

Project withEvenLobes(Project project) {
    project.machine->form->lobes = evenLobes;
    return project;
}

namespace {

PrintedForm fitted(const MachineForm& given, std::size_t place) {
    PrintedForm form;
    form.lobes = lobesOf(given);
    form.lobe_mm = valueOfPlace(given.roundness_um, place) / 2;
    const double runout_mm = valueOfPlace(given.runout_um, place);
    if (given.runout_at_deg) {
        form.at = *given.runout_at_deg * pi / 180;
    }
    if (form.lobe_mm == 0) {
        form.eccentricity_mm = runout_mm / 2;
    } else if (runout_mm > 2 * form.lobe_mm) {
        fitEccentricity(form, runout_mm, given.runout_at_deg.has_value());
    }
    return form;
}

} // namespace

PrintedForm printedForm(const Project& project, std::size_t place) {
    const std::optional<MachineForm>& given = project.machine->form;
    if (!given) {
        return {};
    }
    // Batches and searches run the same machine again and again.
    thread_local MachineForm last;
    thread_local std::vector<std::optional<PrintedForm>> found;
    if (!(last == *given)) {
        last = *given;
        found.clear();
    }
    found.resize(std::max(found.size(), place + 1));
    if (!found[place]) {
        found[place] = fitted(*given, place);
    }
    return *found[place];
}

std::vector<double> printedDepths(const Project& project, std::size_t place) {
    const PrintedForm form = printedForm(project, place);
    std::vector<double> depths;
    const int radii = project.part->radii_per_section;
    for (int k = 0; form.most_mm() > 0 && k < radii; ++k) {
        depths.push_back(form.at_mm(2 * pi * k / radii));
    }
    return depths;
}

namespace {

/// The greatest of all zones or sections.
template <class Value>
double greatestOf(const Project& project, const Value& value) {
    double most = 0;
    for (int place = 0; project.machine->form && place < placeCount(project); ++place) {
        most = std::max(most, value(printedForm(project, static_cast<std::size_t>(place))));
    }
    return most;
}

} // namespace

double mostOfDiameters_mm(const Project& project) {
    return greatestOf(
        project, [](const PrintedForm& form) { return form.lobes % 2 == 0 ? form.lobe_mm : 0; });
}

double mostPrinted_mm(const Project& project) {
    return greatestOf(project, [](const PrintedForm& form) { return form.most_mm(); });
}

} // namespace sparkout
