// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/fit_problem.h"

#include "core/process/force.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/NonLinearOptimization>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

/// The problem in the form for Eigen, with only the free coordinates.
class Functor {
public:
    Functor(FitProblem& problem, std::vector<double> q, std::vector<std::size_t> free)
        : m_problem(problem), m_q(std::move(q)), m_free(std::move(free)) {}

    [[nodiscard]] int inputs() const { return static_cast<int>(m_free.size()); }
    [[nodiscard]] int values() const { return static_cast<int>(m_problem.residuals()); }

    int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& residuals) {
        put(x);
        ++evaluations;
        constexpr double beyond = 1e6; // makes a step to an impossible cycle fail
        if (m_problem.evaluate(m_q, m_residuals)) {
            residuals = Eigen::Map<const Eigen::VectorXd>(m_residuals.data(), values());
        } else if (m_problem.isStopped()) {
            return -1;
        } else {
            residuals.setConstant(beyond);
        }
        return 0;
    }

    int df(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian) {
        put(x);
        if (!derivatives(m_problem, m_q, m_free, m_columns)) {
            return -1;
        }
        jacobian = Eigen::Map<const Eigen::MatrixXd>(m_columns.data(), values(), inputs());
        evaluations += 2 * inputs();
        return 0;
    }

    void put(const Eigen::VectorXd& x) {
        for (std::size_t i = 0; i < m_free.size(); ++i) {
            m_q[m_free[i]] = x[static_cast<Eigen::Index>(i)];
        }
    }
    [[nodiscard]] const std::vector<double>& q() const { return m_q; }

    int evaluations = 0;

private:
    FitProblem& m_problem;
    std::vector<double> m_q;
    std::vector<std::size_t> m_free;
    std::vector<double> m_residuals, m_columns;
};

} // namespace

bool derivatives(FitProblem& problem, const std::vector<double>& q,
                 const std::vector<std::size_t>& free, std::vector<double>& columns) {
    columns.clear();
    std::vector<double> at = q, above, below;
    for (const std::size_t i : free) {
        const double step = FitProblem::derivativeStep(problem.list()[i].kind);
        at[i] = q[i] + step;
        bool ran = problem.evaluate(at, above);
        at[i] = q[i] - step;
        ran = ran && problem.evaluate(at, below);
        at[i] = q[i];
        if (!ran) {
            return false;
        }
        for (std::size_t k = 0; k < above.size(); ++k) {
            columns.push_back((above[k] - below[k]) / (2 * step));
        }
    }
    return true;
}

LeastSquares minimise(FitProblem& problem, const std::vector<double>& start,
                      const std::vector<bool>& fixed, SearchEffort effort) {
    LeastSquares found;
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < start.size(); ++i) {
        if (!fixed[i]) {
            free.push_back(i);
        }
    }
    Functor functor(problem, start, free);
    Eigen::VectorXd x(functor.inputs());
    for (std::size_t i = 0; i < free.size(); ++i) {
        x[static_cast<Eigen::Index>(i)] = start[free[i]];
    }
    if (!free.empty() && functor.values() >= functor.inputs()) {
        Eigen::LevenbergMarquardt<Functor> method(functor);
        const bool isWhole = effort == SearchEffort::whole;
        const double tolerance = isWhole ? 1e-11 : 1e-5;
        const int mostEvaluations = isWhole ? 200 : 25;
        method.parameters.ftol = tolerance;
        method.parameters.xtol = tolerance;
        method.parameters.maxfev = mostEvaluations;
        const auto status = method.minimize(x);
        found.converged = status != Eigen::LevenbergMarquardtSpace::UserAsked
                          && status != Eigen::LevenbergMarquardtSpace::ImproperInputParameters
                          && status != Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation;
        functor.put(x);
    } else {
        found.converged = free.empty();
    }
    found.q = functor.q();
    found.evaluations = functor.evaluations;
    std::vector<double> residuals;
    if (problem.evaluate(found.q, residuals)) {
        for (const double residual : residuals) {
            found.criterion += residual * residual;
        }
    } else {
        found.converged = false;
        found.criterion = std::numeric_limits<double>::infinity();
    }
    return found;
}

const char* keyOf(RobustLoss loss) {
    return loss == RobustLoss::huber ? "huber" : loss == RobustLoss::tukey ? "tukey" : "none";
}

std::vector<double> robustWeights(const std::vector<double>& residuals, RobustLoss loss) {
    constexpr double huber = 1.345, tukey = 4.685;
    std::vector<double> weights;
    weights.reserve(residuals.size());
    for (const double residual : residuals) {
        const double u = std::abs(residual);
        switch (loss) {
        case RobustLoss::none: weights.push_back(1); break;
        case RobustLoss::huber: weights.push_back(std::sqrt(huber / std::max(u, huber))); break;
        case RobustLoss::tukey: {
            const double rest = 1 - u * u / (tukey * tukey);
            weights.push_back(std::max(0.0, rest)); // the root of (1 − (u/c)²)²
            break;
        }
        }
    }
    return weights;
}

namespace {

/// The unit of an offset's coordinate.
double coordinateUnit(FittedKind kind) {
    constexpr double offset_mm = 1e-3, shift_s = 0.1, idle_kw = 0.1;
    switch (kind) {
    case FittedKind::size_offset:
    case FittedKind::gauge_drift:
    case FittedKind::gauge_setting: return offset_mm;
    case FittedKind::time_shift:
    case FittedKind::power_delay:
    case FittedKind::force_delay:
    case FittedKind::gauge_lag:
    case FittedKind::power_lag:
    case FittedKind::force_lag: return shift_s;
    case FittedKind::idle_power: return idle_kw;
    default: return 1;
    }
}

/// Pearson's correlation coefficient; 0 for constant values.
double likeness(const std::vector<double>& a, const std::vector<double>& b) {
    const double count = static_cast<double>(a.size());
    const double meanA = std::accumulate(a.begin(), a.end(), 0.0) / count;
    const double meanB = std::accumulate(b.begin(), b.end(), 0.0) / count;
    double aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - meanA) * (a[i] - meanA);
        bb += (b[i] - meanB) * (b[i] - meanB);
        ab += (a[i] - meanA) * (b[i] - meanB);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

/// The stride through the values of a trace for finding starting values.
std::size_t strideOf(const FitGroup& group, std::size_t enough = 400) {
    return (group.values.size() + enough - 1) / enough;
}

bool isLogarithm(FittedKind kind) {
    return isFactor(kind) || kind == FittedKind::blank_runout;
}

} // namespace

CycleFactors cycleFactors(const Project& project, const std::vector<FittedParameter>& list,
                          const std::vector<double>& q) {
    CycleFactors factors = factorsOf(project);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const FittedParameter& parameter = list[i];
        const double value = FitProblem::valueOf(parameter.kind, q[i]);
        switch (parameter.kind) {
        case FittedKind::alpha: factors.alpha = value; break;
        case FittedKind::beta: factors.beta = value; break;
        case FittedKind::flow_stress: factors.flowStress = value; break;
        case FittedKind::dullness: factors.dullness = value; break;
        case FittedKind::blank_runout: factors.blankRunout_mm = value; break;
        case FittedKind::compliance:
            if (parameter.place) {
                factors.places.resize(static_cast<std::size_t>(placeCount(project)), 1);
                factors.places[static_cast<std::size_t>(*parameter.place)] = value;
            } else {
                factors.compliance = value;
            }
            break;
        default: break;
        }
    }
    return factors;
}

double startOfLag(const std::vector<FittedParameter>& list, FittedKind lag) {
    const FittedKind delay = lag == FittedKind::power_lag   ? FittedKind::power_delay
                             : lag == FittedKind::force_lag ? FittedKind::force_delay
                                                            : FittedKind::time_shift;
    const bool hasTwin = std::ranges::any_of(list, [delay](const FittedParameter& each) {
        return each.kind == FittedKind::time_shift || each.kind == delay;
    });
    return hasTwin ? usualLag_s : 0;
}

FitProblem::FitProblem(const Project& project, const FitData& data,
                       const std::vector<FittedParameter>& parameters, std::stop_token stop)
    : m_project(project)
    , m_data(data)
    , m_stop(std::move(stop))
    , m_parameters(parameters)
    , m_hasThreshold(hasThreshold(project)) {
    for (const FittedParameter& parameter : parameters) {
        m_priors += parameter.prior ? 1 : 0;
    }
    for (const FitGroup& group : data.groups) {
        m_noise.push_back(group.noise);
        m_withPlaces = m_withPlaces || (group.source == FitSource::size && group.place);
    }
}

void FitProblem::setSteps(std::vector<int> stepsByStage) {
    m_steps = std::move(stepsByStage);
    m_hasResponse = false;
}

double FitProblem::valueOf(FittedKind kind, double q) {
    return isLogarithm(kind) ? std::exp(q) : q * coordinateUnit(kind);
}

double FitProblem::coordinateOf(FittedKind kind, double value) {
    return isLogarithm(kind) ? std::log(value) : value / coordinateUnit(kind);
}

double FitProblem::derivativeStep(FittedKind kind) {
    constexpr double ofLogarithm = 1e-5, ofOffset = 1e-3;
    return isLogarithm(kind) ? ofLogarithm : ofOffset;
}

FitProblem::Scalars FitProblem::scalarsAt(const std::vector<double>& q) const {
    Scalars scalars;
    for (const FitGroup& group : m_data.groups) {
        scalars.idle_kw = group.idle_kw.value_or(scalars.idle_kw);
    }
    for (std::size_t i = 0; i < m_parameters.size(); ++i) {
        const double value = valueOf(m_parameters[i].kind, q[i]);
        switch (m_parameters[i].kind) {
        case FittedKind::flow_stress: scalars.flow = value; break;
        case FittedKind::dullness: scalars.dullness = value; break;
        case FittedKind::alpha: scalars.chipForce = m_hasThreshold ? value : 1; break;
        case FittedKind::beta: scalars.rubbingForce = m_hasThreshold ? value : 1; break;
        case FittedKind::chip_power: scalars.chip = value; break;
        case FittedKind::friction_power: scalars.friction = value; break;
        case FittedKind::idle_power: scalars.idle_kw = value; break;
        case FittedKind::size_offset: scalars.offset_mm = value; break;
        case FittedKind::time_shift: scalars.shift_s = value; break;
        case FittedKind::power_delay: scalars.powerDelay_s = value; break;
        case FittedKind::force_delay: scalars.forceDelay_s = value; break;
        case FittedKind::gauge_lag: scalars.lag_s = value; break;
        case FittedKind::power_lag: scalars.powerLag_s = value; break;
        case FittedKind::force_lag: scalars.forceLag_s = value; break;
        case FittedKind::gauge_drift: scalars.drift_mm_min = value; break;
        default: break;
        }
    }
    return scalars;
}

bool FitProblem::run(const CycleFactors& factors) {
    if (!m_hasResponse || !(factors == m_lastFactors)) {
        m_response = respond(m_project, factors, m_steps, m_withPlaces, m_stop);
        m_lastFactors = factors;
        m_lagged.clear();
        m_hasResponse = true;
    }
    return m_response.ran && !isStopped();
}

double FitProblem::durationAt(const std::vector<double>& q) {
    return run(factorsAt(q)) ? m_response.end_s.back() : 0;
}

std::vector<double> FitProblem::stageEnds(const std::vector<double>& q) {
    std::vector<double> ends;
    std::size_t step = 0;
    const bool runs = run(factorsAt(q));
    for (std::size_t z = 0; runs && z < m_steps.size(); ++z) {
        step += static_cast<std::size_t>(m_steps[z]);
        ends.push_back(m_response.end_s[std::min(step, m_response.end_s.size() - 1)]
                       + scalarsAt(q).shift_s);
    }
    return ends;
}

double FitProblem::lagged(const std::vector<double>& times, const std::vector<double>& values,
                          double time, double lag_s) const {
    auto known = std::ranges::find(m_lagged, values.data(), &Lagged::of);
    if (known == m_lagged.end()) {
        known = m_lagged.insert(known, Lagged{values.data(), lag_s, {}});
    }
    if (known->knots.empty() || known->lag_s != lag_s) {
        *known = {values.data(), lag_s, laggedKnots(times, values, lag_s)};
    }
    return laggedBetween(times, values, known->knots, time, lag_s);
}

double FitProblem::predicted(const FitGroup& group, std::size_t index,
                             const Scalars& scalars) const {
    if (group.source == FitSource::parts) {
        return m_response.deviation_um[static_cast<std::size_t>(group.places[index])];
    }
    const double delay_s = group.source == FitSource::power   ? scalars.powerDelay_s
                           : group.source == FitSource::force ? scalars.forceDelay_s
                                                              : 0;
    const double time = group.time_s[index] - scalars.shift_s - delay_s;
    if (group.source == FitSource::size) {
        const std::vector<double>& sizes =
            group.place ? m_response.placeSizes_mm[static_cast<std::size_t>(*group.place)]
                        : m_response.size_mm;
        constexpr double sPerMin = 60;
        return lagged(m_response.end_s, sizes, time, scalars.lag_s) + scalars.offset_mm
               + scalars.drift_mm_min * time / sPerMin;
    }
    const bool isForce = group.source == FitSource::force;
    const double lag_s = isForce ? scalars.forceLag_s : scalars.powerLag_s;
    const auto value = [&](const std::vector<double>& values) {
        return lagged(m_response.middle_s, values, time, lag_s);
    };
    if (isForce) {
        return scalars.flow
               * (scalars.chipForce * value(m_response.chip_n)
                  + scalars.rubbingForce * scalars.dullness * value(m_response.friction_n));
    }
    return scalars.idle_kw
           + scalars.flow
                 * (scalars.chip * value(m_response.chip_kw)
                    + scalars.dullness * scalars.friction * value(m_response.friction_kw));
}

bool FitProblem::differences(const std::vector<double>& q, std::vector<double>& values) {
    values.clear();
    if (!run(factorsAt(q))) {
        return false;
    }
    const Scalars scalars = scalarsAt(q);
    for (const FitGroup& group : m_data.groups) {
        for (std::size_t i = 0; i < group.values.size(); ++i) {
            values.push_back(group.values[i] - predicted(group, i, scalars));
        }
    }
    return true;
}

bool FitProblem::evaluate(const std::vector<double>& q, std::vector<double>& residuals) {
    if (!differences(q, residuals)) {
        return false;
    }
    std::size_t at = 0;
    for (std::size_t g = 0; g < m_data.groups.size(); ++g) {
        for (std::size_t i = 0; i < m_data.groups[g].values.size(); ++i, ++at) {
            residuals[at] *= (m_weights.empty() ? 1 : m_weights[at]) / m_noise[g];
        }
    }
    for (std::size_t i = 0; i < m_parameters.size(); ++i) {
        if (const auto& prior = m_parameters[i].prior) {
            residuals.push_back((valueOf(m_parameters[i].kind, q[i]) - prior->mean)
                                / prior->deviation);
        }
    }
    return std::ranges::all_of(residuals, [](double value) { return std::isfinite(value); });
}

double FitProblem::startOfIdle() const {
    for (const FitGroup& group : m_data.groups) {
        if (group.source == FitSource::power) {
            return group.idle_kw.value_or(std::ranges::min(group.values));
        }
    }
    return 0;
}

/// The mean difference of the sizes at this shift, by a subset of a long trace.
double FitProblem::startOfOffset(Scalars scalars, double shift_s) const {
    scalars.shift_s = shift_s;
    scalars.offset_mm = 0;
    for (const FitGroup& group : m_data.groups) {
        if (group.source == FitSource::size) {
            const std::size_t stride = strideOf(group);
            double sum = 0, count = 0;
            for (std::size_t i = 0; i < group.values.size(); i += stride) {
                sum += group.values[i] - predicted(group, i, scalars);
                ++count;
            }
            return sum / count;
        }
    }
    return 0;
}

bool FitProblem::has(FittedKind kind) const {
    return std::ranges::find(m_parameters, kind, &FittedParameter::kind) != m_parameters.end();
}

/// Whether it shares the clock of the cycle, without a delay of its own.
bool FitProblem::keepsStep(const FitGroup& group) const {
    return !(group.source == FitSource::power && has(FittedKind::power_delay))
           && !(group.source == FitSource::force && has(FittedKind::force_delay));
}

/// The best shift over the whole traces, each with its own offset, since a fit converges only near
/// the solution.
double FitProblem::startOfShift(Scalars scalars) const {
    constexpr int tries = 200;
    constexpr std::size_t enough = 100; // values of a trace: this takes most of a fit's time
    std::vector<double> apart;
    const double cycle_s = m_response.end_s.back();
    scalars.offset_mm = 0;
    const bool hasOffset = has(FittedKind::size_offset);
    double best = 0, least = std::numeric_limits<double>::infinity();
    double from = 0, to = 0;
    for (const FitGroup& group : m_data.groups) {
        if (!group.time_s.empty()) {
            from = std::min(from, group.time_s.front() - cycle_s / 2);
            to = std::max(to, group.time_s.back() - cycle_s / 2);
        }
    }
    for (int i = 0; i <= tries && !isStopped(); ++i) {
        // 0 is tried too, and kept if nothing is better.
        const double shift = i == 0 ? 0 : from + (to - from) * (i - 1) / (tries - 1);
        scalars.shift_s = shift;
        double sum = 0;
        std::optional<double> offset_mm; // offset of the first trace of sizes
        for (std::size_t g = 0; g < m_data.groups.size(); ++g) {
            const FitGroup& group = m_data.groups[g];
            if (!keepsStep(group)) {
                continue;
            }
            const std::size_t stride = strideOf(group, enough);
            apart.clear();
            for (std::size_t k = 0; k < group.values.size(); k += stride) {
                apart.push_back(group.values[k] - predicted(group, k, scalars));
            }
            if (group.source == FitSource::size && hasOffset) {
                offset_mm = offset_mm.value_or(std::accumulate(apart.begin(), apart.end(), 0.0)
                                               / static_cast<double>(apart.size()));
            }
            const double off = group.source == FitSource::size ? offset_mm.value_or(0) : 0;
            for (const double each : apart) {
                const double r = (each - off) / m_noise[g];
                sum += r * r * static_cast<double>(stride);
            }
        }
        if (sum < least) {
            least = sum;
            best = shift;
        }
    }
    return best;
}

/// The delay with the best correlation of measured and predicted values, whatever their scale.
double FitProblem::startOfDelay(FitSource source, Scalars scalars) const {
    constexpr int tries = 40;
    const double farthest_s =
        usualRange(m_project, FittedKind::power_delay, true).value_or(Interval()).high;
    double best = 0, closest = 0;
    for (int i = 0; i <= 2 * tries && !isStopped(); ++i) {
        // 0 is tried first, and kept if nothing is better.
        const int step = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
        const double delay_s = farthest_s * step / tries;
        scalars.powerDelay_s = scalars.forceDelay_s = delay_s;
        std::vector<double> measured, expected;
        for (const FitGroup& group : m_data.groups) {
            for (std::size_t k = 0; group.source == source && k < group.values.size();
                 k += strideOf(group)) {
                measured.push_back(group.values[k]);
                expected.push_back(predicted(group, k, scalars));
            }
        }
        const double follows = measured.empty() ? 0 : likeness(measured, expected);
        if (follows > closest) {
            closest = follows;
            best = delay_s;
        }
    }
    return best;
}

std::vector<double> FitProblem::start() {
    std::vector<double> q(m_parameters.size(), 0);
    constexpr double leastRunout_mm = 1e-4; // positive, for its logarithm
    for (std::size_t i = 0; i < m_parameters.size(); ++i) {
        const FittedKind kind = m_parameters[i].kind;
        if (kind == FittedKind::blank_runout) {
            q[i] =
                coordinateOf(kind, std::max(leastRunout_mm, factorsOf(m_project).blankRunout_mm));
        } else if (const auto& prior = m_parameters[i].prior;
                   isFactor(kind) && prior && prior->mean > 0) {
            q[i] = coordinateOf(kind, prior->mean);
        }
    }
    return startAt(std::move(q));
}

std::vector<double> FitProblem::startAt(std::vector<double> q) {
    const bool runs = run(factorsAt(q));
    Scalars scalars = scalarsAt(q);
    if (has(FittedKind::idle_power)) {
        scalars.idle_kw = startOfIdle();
    }
    scalars.powerDelay_s = scalars.forceDelay_s = 0;
    if (runs && has(FittedKind::time_shift)) {
        scalars.shift_s = startOfShift(scalars);
    }
    for (std::size_t i = 0; i < m_parameters.size(); ++i) {
        const FittedKind kind = m_parameters[i].kind;
        const auto found = [&]() -> std::optional<double> {
            switch (kind) {
            case FittedKind::time_shift: return scalars.shift_s;
            case FittedKind::power_delay: return runs ? startOfDelay(FitSource::power, scalars) : 0;
            case FittedKind::force_delay: return runs ? startOfDelay(FitSource::force, scalars) : 0;
            case FittedKind::size_offset: return runs ? startOfOffset(scalars, scalars.shift_s) : 0;
            case FittedKind::idle_power: return scalars.idle_kw;
            case FittedKind::gauge_lag:
            case FittedKind::power_lag:
            case FittedKind::force_lag: return startOfLag(m_parameters, kind);
            default: return std::nullopt;
            }
        }();
        q[i] = found ? coordinateOf(kind, *found) : q[i];
    }
    return q;
}

} // namespace sparkout
