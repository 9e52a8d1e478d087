// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/batch.h"

#include "core/cholesky.h"
#include "core/project/conditions.h"
#include "core/project/given_factors.h"
#include "core/project/machine.h"
#include "core/project/project.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/text.h"

#include <algorithm>
#include <string>
#include <utility>

namespace sparkout {

namespace {

class BatchRules {
public:
    explicit BatchRules(const Project& project)
        : m_project(project)
        , m_correlation(project.batch->correlation)
        , m_factors(givenFactors(project)) {}

    Issues check() {
        for (const GivenFactor& factor : m_factors) {
            checkForm(factor);
        }
        checkMatrix();
        const Batch& batch = *m_project.batch;
        checkZones("/batch/zone_stock_mm", batch.zone_stock_mm);
        checkZones("/batch/zone_runout_mm", batch.zone_runout_mm);
        checkZones("/batch/zone_compliance", batch.zone_compliance);
        checkCount();
        return std::move(m_issues);
    }

private:
    void checkForm(const GivenFactor& factor) {
        const std::string path = std::string("/batch/factors/") + factorKey(factor.kind);
        const Factor& law = factor.law;
        if (factor.kind == FactorKind::runoutAt && !m_project.machine->form) {
            add(IssueCode::notUsedHere, path, {}, Keys{{"/machine/form"}});
            return;
        }
        if (factor.kind == FactorKind::wheelPhase && !m_project.wheel->runout) {
            add(IssueCode::notUsedHere, path, {}, Keys{{"/wheel/runout"}});
            return;
        }
        if (factor.kind == FactorKind::machineForm && !m_project.machine->form
            && m_project.machine->geometric_runout_um <= 0) {
            add(IssueCode::notUsedHere, path, {},
                Keys{{"/machine/form", "/machine/geometric_runout_um"}});
            return;
        }
        const int forms =
            static_cast<int>(law.uniform.has_value()) + static_cast<int>(law.normal.has_value())
            + static_cast<int>(law.triangular.has_value())
            + static_cast<int>(law.measured.has_value()) + static_cast<int>(law.grows.has_value());
        if (forms != 1) {
            const bool isNone = forms == 0;
            add(isNone ? IssueCode::noLaw : IssueCode::wrongCount, path,
                isNone ? Detail() : Count{forms},
                Keys{{"uniform", "normal", "triangular", "measured", "grows"},
                     Keys::Kind::alternatives});
            return;
        }
        checkValues(law.uniform, path + "/uniform", factor, true);
        checkValues(law.triangular, path + "/triangular", factor, true);
        checkValues(law.measured, path + "/measured", factor, false);
        checkValues(law.grows, path + "/grows", factor, false); // it may also fall
        checkNormal(factor, path);
        if (law.measured && law.measured->empty()) {
            add(IssueCode::wrongCount, path + "/measured", Count{0}, Bounds{{1}});
        }
        if (law.parts_between_dressings && !law.grows) {
            add(IssueCode::notUsedHere, path + "/parts_between_dressings", {}, Keys{{"grows"}});
        }
    }

    void checkNormal(const GivenFactor& factor, const std::string& path) {
        const Factor& law = factor.law;
        if (!law.normal) {
            if (law.within) {
                add(IssueCode::notUsedHere, path + "/within", {}, Keys{{"normal"}});
            }
            return;
        }
        if (law.normal->size() == 2) { // otherwise the range check reports it
            checkSpread(*law.normal, path + "/normal", factor);
        }
        checkValues(law.within, path + "/within", factor, true);
    }

    void checkSpread(const std::vector<double>& normal, const std::string& path,
                     const GivenFactor& factor) {
        checkValue(normal[0], path + "/0", factor);
        if (normal[1] < 0) {
            add(IssueCode::outOfRange, path + "/1", Amount{normal[1]}, Bounds{{0}});
        }
    }

    void checkValue(double value, const std::string& path, const GivenFactor& factor) {
        if (!factor.allowed.contains(value)) {
            add(IssueCode::outOfRange, path, Amount{value}, Bounds{factor.allowed});
        }
    }

    void checkValues(const std::optional<std::vector<double>>& values, const std::string& path,
                     const GivenFactor& factor, bool rising) {
        for (std::size_t i = 0; values && i < values->size(); ++i) {
            const std::string at = path + "/" + std::to_string(i);
            checkValue((*values)[i], at, factor);
            if (rising && i > 0 && (*values)[i] < (*values)[i - 1]) {
                add(IssueCode::outOfRange, at, Amount{(*values)[i]}, Bounds{{(*values)[i - 1]}});
            }
        }
    }

    void checkMatrix() {
        const std::string path = "/batch/correlation";
        if (!m_correlation) {
            return;
        }
        const auto& matrix = *m_correlation;
        const std::size_t n = m_factors.size();
        if (matrix.size() != n) {
            add(IssueCode::wrongCount, path, countOf(matrix.size()), countOf(n));
            return;
        }
        for (std::size_t i = 0; i < n; ++i) {
            if (matrix[i].size() != n) {
                add(IssueCode::wrongCount, path + "/" + std::to_string(i),
                    countOf(matrix[i].size()), countOf(n));
                return;
            }
        }
        const std::size_t before = m_issues.size();
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j <= i; ++j) {
                checkPair(matrix, i, j);
            }
        }
        if (m_issues.size() == before && !choleskyFactor(matrix)) {
            add(IssueCode::outOfRange, path, Quoted{"[…]"}, Phrase::positiveDefinite);
        }
    }

    void checkZones(const std::string& path, const NumberRows& ranges) {
        if (!ranges) {
            return;
        }
        const auto places = static_cast<std::size_t>(placeCount(m_project));
        if (ranges->size() != places) {
            add(IssueCode::wrongCount, path, countOf(ranges->size()), countOf(places));
        }
        for (std::size_t i = 0; i < ranges->size(); ++i) {
            const std::vector<double>& ends = (*ranges)[i];
            if (ends.size() == 2 && ends[1] < ends[0]) { // otherwise the table check reports it
                add(IssueCode::outOfRange, path + "/" + std::to_string(i) + "/1", Amount{ends[1]},
                    Bounds{{ends[0]}});
            }
        }
    }

    /// Counts the factors of the zones together with those of the part.
    void checkCount() {
        const std::size_t all = m_factors.size() + zoneFactors(m_project).size();
        if (all > limits::factors) {
            add(IssueCode::wrongCount, "/batch", countOf(all),
                Bounds{{0, static_cast<double>(limits::factors)}});
        }
    }

    void checkPair(const std::vector<std::vector<double>>& matrix, std::size_t i, std::size_t j) {
        const std::string path =
            "/batch/correlation/" + std::to_string(i) + "/" + std::to_string(j);
        const double value = matrix[i][j];
        if (i == j && value != 1) {
            add(IssueCode::outOfRange, path, Amount{value}, Amount{1});
        } else if (value != matrix[j][i]) {
            add(IssueCode::outOfRange, path, Amount{value}, Amount{matrix[j][i]});
        } else if (i != j && value != 0 && (m_factors[i].isLaw() || m_factors[j].isLaw())) {
            add(IssueCode::outOfRange, path, Amount{value}, Amount{0});
        }
    }

    void add(IssueCode code, std::string path, Detail value, Detail limit) {
        if (m_issues.size() < limits::issues) {
            m_issues.push_back(
                {code, Severity::error, std::move(path), std::move(value), std::move(limit)});
        }
    }

    const Project& m_project;
    const NumberRows& m_correlation;
    std::vector<GivenFactor> m_factors;
    Issues m_issues;
};

} // namespace

Issues batchFaults(const Project& project) {
    return project.batch ? BatchRules(project).check() : Issues();
}

namespace {

bool hasMachineForm(const Project& p, const void*) {
    return p.machine->form.has_value();
}

} // namespace

template <>
std::span<const Choice> choicesOf<Scenarios>() {
    static const std::array choices{
        Choice{"corners", SPARKOUT_NOOP("Choice", "all corners")},
        Choice{"latin_hypercube", SPARKOUT_NOOP("Choice", "Latin hypercube")},
        Choice{"sobol", SPARKOUT_NOOP("Choice", "Sobol sequence")},
        Choice{"random", SPARKOUT_NOOP("Choice", "random")}};
    return choices;
}

template <>
const StructInfo& tableOf<Factor>() {
    static const std::array rows{
        SPARKOUT_FIELD(Factor, uniform, .label = SPARKOUT_NOOP("Input", "Uniform"),
                       .hard = {-1e6, 1e6}, .nullMeaning = SPARKOUT_NOOP("Input", "not this form"),
                       .count = 2, .page = Page::batch, .usual = true,
                       .hint =
                           SPARKOUT_NOOP("Input", "Minimum and maximum value; equal, a constant.")),
        SPARKOUT_FIELD(Factor, normal, .label = SPARKOUT_NOOP("Input", "Normal"),
                       .hard = {-1e6, 1e6}, .nullMeaning = SPARKOUT_NOOP("Input", "not this form"),
                       .count = 2, .page = Page::batch, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Mean and standard deviation.")),
        SPARKOUT_FIELD(Factor, within, .label = SPARKOUT_NOOP("Input", "Within"),
                       .hard = {-1e6, 1e6}, .nullMeaning = SPARKOUT_NOOP("Input", "not truncated"),
                       .count = 2, .page = Page::batch, .usual = true,
                       .hint =
                           SPARKOUT_NOOP("Input", "Bounds that truncate the normal distribution.")),
        SPARKOUT_FIELD(Factor, triangular, .label = SPARKOUT_NOOP("Input", "Triangular"),
                       .hard = {-1e6, 1e6}, .nullMeaning = SPARKOUT_NOOP("Input", "not this form"),
                       .count = 3, .page = Page::batch, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Minimum, most frequent and maximum value.")),
        SPARKOUT_FIELD(Factor, measured, .label = SPARKOUT_NOOP("Input", "Measured"),
                       .hard = {-1e6, 1e6}, .nullMeaning = SPARKOUT_NOOP("Input", "not this form"),
                       .page = Page::batch, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Values of measured blanks, each as frequent as any other; "
                                    "`sparkout-cli batch --measured` reads them from a CSV.")),
        SPARKOUT_FIELD(
            Factor, grows, .label = SPARKOUT_NOOP("Input", "Grows"), .hard = {-1e6, 1e6},
            .nullMeaning = SPARKOUT_NOOP("Input", "not this form"), .count = 2, .page = Page::batch,
            .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input", "Values of the first and of the last part between two dressings.")),
        SPARKOUT_FIELD(Factor, parts_between_dressings,
                       .label = SPARKOUT_NOOP("Input", "Parts between dressings"), .hard = {1, 1e6},
                       .nullMeaning = SPARKOUT_NOOP("Input", "the whole batch"),
                       .page = Page::batch, .usual = true,
                       .hint =
                           SPARKOUT_NOOP("Input", "Number of parts ground between two dressings.")),
    };
    static const StructInfo info = makeTable<Factor>(SPARKOUT_NOOP("Struct", "Factor"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Factors>() {
    static const std::array rows{
        SPARKOUT_FIELD(Factors, stock_mm, .label = SPARKOUT_NOOP("Input", "Stock per side"),
                       .unit = "mm", .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"),
                       .page = Page::batch, .usual = true),
        SPARKOUT_FIELD(Factors, initial_runout_mm,
                       .label = SPARKOUT_NOOP("Input", "Initial runout"), .unit = "mm",
                       .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"),
                       .page = Page::batch, .usual = true),
        SPARKOUT_FIELD(Factors, dullness, .label = SPARKOUT_NOOP("Input", "Dullness"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"),
                       .page = Page::batch, .usual = true),
        SPARKOUT_FIELD(Factors, wheel_diameter_mm,
                       .label = SPARKOUT_NOOP("Input", "Wheel diameter"), .unit = "mm",
                       .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"),
                       .page = Page::batch),
        SPARKOUT_FIELD(Factors, flow_stress_mpa, .label = SPARKOUT_NOOP("Input", "Flow stress"),
                       .unit = "MPa", .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"),
                       .page = Page::batch),
        SPARKOUT_FIELD(Factors, compliance, .label = SPARKOUT_NOOP("Input", "Compliance"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"),
                       .page = Page::batch, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Factor on every compliance.")),
        SPARKOUT_FIELD(
            Factors, contact_width_mm, .label = SPARKOUT_NOOP("Input", "Contact width"),
            .symbol = "b", .unit = "mm", .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"),
            .page = Page::batch,
            .hint = SPARKOUT_NOOP("Input", "Traverse: the wheel's width, from which the widths of "
                                           "cut follow. Plunge: the ground length.")),
        SPARKOUT_FIELD(
            Factors, machine_form, .label = SPARKOUT_NOOP("Input", "Machine's form"),
            .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"), .page = Page::batch,
            .hint = SPARKOUT_NOOP(
                "Input", "Factor on the roundness deviation and runout that the machine prints, of "
                         "all zones or sections; without a form on its geometric runout."),
            .source = "MODEL-7"),
        SPARKOUT_FIELD(
            Factors, runout_at_deg,
            .label = SPARKOUT_NOOP("Input", "Direction of the eccentricity"), .symbol = "φ_1",
            .unit = "°", .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"),
            .relevant = hasMachineForm, .page = Page::batch,
            .hint = SPARKOUT_NOOP(
                "Input", "Uniform from 0 to 360° where parts are clamped at random angles."),
            .source = "MODEL-7"),
        SPARKOUT_FIELD(
            Factors, wheel_phase_deg, .label = SPARKOUT_NOOP("Input", "Phase of the wheel"),
            .symbol = "ψ_0", .unit = "°", .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"),
            .relevant = conditions::wheelRunout, .page = Page::batch,
            .hint = SPARKOUT_NOOP("Input", "Uniform from 0 to 360°, as the wheel stands at any "
                                           "angle when a cycle begins."),
            .source = "MODEL-16"),
        SPARKOUT_FIELD(
            Factors, gauge_error, .label = SPARKOUT_NOOP("Input", "Random error of the gauge"),
            .symbol = "z", .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"),
            .page = Page::batch,
            .hint = SPARKOUT_NOOP(
                "Input",
                "Number of standard deviations; it multiplies the machine's gauge repeatability. A "
                "normal law with mean 0 and deviation 1 is the gauge of the machine as given."),
            .formula = "e_g = z·s_g + v_g·t", .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Factors, gauge_age_h, .label = SPARKOUT_NOOP("Input", "Time since the gauge was set"),
            .symbol = "t", .unit = "h", .nullMeaning = SPARKOUT_NOOP("Input", "it does not drift"),
            .page = Page::batch,
            .hint = SPARKOUT_NOOP("Input",
                                  "It multiplies the machine's gauge drift. Growing from 0, it "
                                  "rises by the piece time from part to part; the parts between "
                                  "dressings are those from one setting of the gauge to the next."),
            .formula = "e_g = z·s_g + v_g·t", .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Factors, part_warmer_k, .label = SPARKOUT_NOOP("Input", "Part warmer at the gauge"),
            .symbol = "ΔT", .unit = "K", .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"),
            .page = Page::batch,
            .hint = SPARKOUT_NOOP("Input", "Difference from the temperature that the gauge is set "
                                           "for: as the part cools, it shrinks by α·d·ΔT."),
            .formula = "D + e_g + α·d·ΔT", .source = "MODEL-7"),
    };
    static const StructInfo info = makeTable<Factors>(SPARKOUT_NOOP("Struct", "Factors"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Batch>() {
    static const std::array rows{
        SPARKOUT_FIELD(Batch, parts, .label = SPARKOUT_NOOP("Input", "Parts"), .hard = {1, 1e6},
                       .page = Page::batch, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Number of parts simulated."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Batch, seed, .label = SPARKOUT_NOOP("Input", "Seed"),
                       .hard = {0, 2147483647}, .page = Page::batch,
                       .hint = SPARKOUT_NOOP("Input", "The same seed gives the same batch."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Batch, scenarios, .label = SPARKOUT_NOOP("Input", "Scenarios"), .page = Page::batch,
            .hint = SPARKOUT_NOOP("Input", "Method of sampling the factors."), .source = "MODEL-8"),
        SPARKOUT_FIELD(Batch, factors, .label = SPARKOUT_NOOP("Input", "Factors"),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Batch, zone_stock_mm, .label = SPARKOUT_NOOP("Input", "Further stock by zone"),
            .symbol = "δΠ", .unit = "mm", .hard = {-5, 5},
            .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"), .count = 2, .sparse = true,
            .page = Page::batch,
            .hint = SPARKOUT_NOOP("Input",
                                  "Minimum and maximum difference of each zone or section from the "
                                  "stock of the part, in their order; they scatter independently "
                                  "and uniformly. Two equal values are a constant."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Batch, zone_runout_mm, .label = SPARKOUT_NOOP("Input", "Further runout by zone"),
            .symbol = "δ(ΔR)", .unit = "mm", .hard = {-5, 5},
            .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"), .count = 2, .sparse = true,
            .page = Page::batch,
            .hint = SPARKOUT_NOOP("Input",
                                  "Minimum and maximum difference of each zone or section from the "
                                  "initial runout of the part, in their order; they scatter "
                                  "independently and uniformly. Two equal values are a constant."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Batch, zone_compliance, .label = SPARKOUT_NOOP("Input", "Compliance factor by zone"),
            .symbol = "f_γ", .hard = {1e-3, 1e3},
            .nullMeaning = SPARKOUT_NOOP("Input", "does not scatter"), .count = 2, .sparse = true,
            .page = Page::batch,
            .hint =
                SPARKOUT_NOOP("Input", "Minimum and maximum factor on the compliance of each zone "
                                       "or section, in their order; they scatter independently and "
                                       "uniformly. Two equal values are a constant."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Batch, correlation, .label = SPARKOUT_NOOP("Input", "Correlation"), .hard = {-1, 1},
            .nullMeaning = SPARKOUT_NOOP("Input", "independent"), .page = Page::batch,
            .hint =
                SPARKOUT_NOOP("Input", "Correlation matrix of the factors given, in their order."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Batch, least_ppk, .label = SPARKOUT_NOOP("Input", "Minimum Ppk"), .symbol = "P_pk",
            .hard = {0, 99}, .soft = {0, 2}, .page = Page::batch, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "The verdict calls a cycle fit when the lower 95 % "
                                           "bounds of all Ppk reach it, else conditionally fit."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Batch, most_outside_share, .label = SPARKOUT_NOOP("Input", "Maximum share outside"),
            .hard = {0, 1}, .nullMeaning = SPARKOUT_NOOP("Input", "every part must be good"),
            .page = Page::batch, .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input",
                "Share of the parts that may be rejected before the cycle is unfit; when more of "
                "them are expected to be out of tolerance, it is conditionally fit."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Batch, measuring_uncertainty_um,
            .label = SPARKOUT_NOOP("Input", "Measuring uncertainty"), .symbol = "u", .unit = "µm",
            .hard = {0, 1000}, .soft = {0, 5}, .sparse = true, .page = Page::batch,
            .hint = SPARKOUT_NOOP("Input",
                                  "Standard uncertainty of one measured value of a finished part. "
                                  "It counts as scatter of the prediction, and it widens the "
                                  "interval of the bias, for it may be the same for all parts."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Batch, bias_limit_um, .label = SPARKOUT_NOOP("Input", "Limit of bias"), .unit = "µm",
            .hard = {1e-3, 1e5}, .nullMeaning = SPARKOUT_NOOP("Input", "a tenth of the tolerance"),
            .sparse = true, .page = Page::batch,
            .hint =
                SPARKOUT_NOOP("Input", "Up to this difference the measured mean and the predicted "
                                       "one count as the same. Where the drawing has no tolerance "
                                       "either, it is half the predicted standard deviation."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(Batch, form_measuring_uncertainty_um,
                       .label = SPARKOUT_NOOP("Input", "Measuring uncertainty of form"),
                       .symbol = "u_f", .unit = "µm", .hard = {0, 1000}, .soft = {0, 5},
                       .nullMeaning = SPARKOUT_NOOP("Input", "as for the size"), .sparse = true,
                       .page = Page::batch,
                       .hint =
                           SPARKOUT_NOOP("Input", "Standard uncertainty of one measured roundness, "
                                                  "runout or cylindricity of a finished part."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Batch, form_bias_limit_um, .label = SPARKOUT_NOOP("Input", "Limit of bias of form"),
            .unit = "µm", .hard = {1e-3, 1e5},
            .nullMeaning =
                SPARKOUT_NOOP("Input", "as for the size, otherwise a tenth of the tolerance"),
            .sparse = true, .page = Page::batch,
            .hint =
                SPARKOUT_NOOP("Input", "Up to this difference the means of measured and predicted "
                                       "roundness, runout or cylindricity count as the same."),
            .source = "MODEL-8"),
    };
    static const StructInfo info = makeTable<Batch>(SPARKOUT_NOOP("Struct", "Batch"), rows);
    return info;
}

} // namespace sparkout
