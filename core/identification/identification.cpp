// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/identification/applicable.h"
#include "core/identification/fit_problem.h"
#include "core/identification/levenberg_marquardt.h"
#include "core/project/gauge.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/statistics/comparison.h"
#include "core/statistics/median.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace sparkout {

namespace {

constexpr double confidence = 0.95;

class Identifier {
public:
    Identifier(const Project& project, const IdentificationRequest& request,
               const std::stop_token& stop)
        : m_project(project)
        , m_request(request)
        , m_stop(stop)
        , m_data(fitDataOf(project, request.traces, request.withParts))
        , m_problem(project, m_data, request.parameters, stop) {}

    Identification identify() {
        m_result.withoutFactor = m_data.withoutFactor;
        m_result.count = m_data.count();
        m_result.status = refusal();
        if (m_result.status != IdentificationStatus::fitted) {
            return std::move(m_result);
        }
        if (!fit()) {
            m_result.status = m_stop.stop_requested() ? IdentificationStatus::stopped
                              : m_best.converged      ? IdentificationStatus::againstGauge
                                                      : IdentificationStatus::notConverged;
            return std::move(m_result);
        }
        const Identifiability found = identifiabilityAt(m_problem, m_data, m_best);
        m_result.condition = found.condition;
        m_result.unidentified = found.unidentified;
        m_result.stepsByStage = m_problem.steps();
        if (m_stop.stop_requested()) {
            m_result.status = IdentificationStatus::stopped;
        } else if (!found.unidentified.empty() || found.covariance.empty()) {
            m_result.status = IdentificationStatus::cannotTell;
        } else {
            addValues(found);
            addResiduals();
            std::vector<double> errors; // of the coordinates
            for (std::size_t i = 0; i < m_best.q.size(); ++i) {
                errors.push_back(std::sqrt(found.covariance[i * m_best.q.size() + i]));
            }
            m_result.outOfStep = outOfStep(m_project, m_data, m_problem, m_best, errors, m_stop);
            if (m_stop.stop_requested()) { // the values would lack what was not asked
                m_result = {};
                m_result.status = IdentificationStatus::stopped;
            }
        }
        return std::move(m_result);
    }

private:
    /// `fitted` where nothing speaks against it.
    IdentificationStatus refusal() {
        const std::vector<FittedParameter>& list = m_request.parameters;
        if (!areApplicable(m_project, list)) {
            return IdentificationStatus::notApplicable;
        }
        for (Issue& issue : validate(m_project)) {
            if (issue.severity == Severity::error) {
                m_result.issues.push_back(std::move(issue));
            }
        }
        if (!m_result.issues.empty()) {
            return IdentificationStatus::notRun;
        }
        if (list.empty() || m_data.count() <= list.size()) {
            return IdentificationStatus::noData;
        }
        m_problem.setSteps(stepsByGauge(m_project, factorsOf(m_project), m_stop));
        return m_stop.stop_requested()     ? IdentificationStatus::stopped
               : m_problem.steps().empty() ? IdentificationStatus::notRun
                                           : IdentificationStatus::fitted;
    }

    /// The steps of the stages are whole numbers: the rest is fitted for given ones, then they are
    /// what the gauge would ask for there, then each of them may be one more or less. Traces show
    /// how many there were; where finished parts alone were measured, only the gauge tells it, and
    /// what it would not bring about is no answer.
    bool fit() {
        const std::vector<bool> free(m_request.parameters.size(), false);
        m_best = minimise(m_problem, m_problem.start(), free);
        if (m_stop.stop_requested()) {
            return false;
        }
        if (m_project.gauge->control == Control::gauge) {
            m_onlyGaugeTells = std::ranges::none_of(
                m_data.groups, [](const FitGroup& group) { return !group.time_s.empty(); });
            m_isConsistent = m_onlyGaugeTells && isOfGauge();
            if (m_onlyGaugeTells) {
                tryStepsOfGauge();
            }
            followGauge();
            trySteps();
        }
        settleNoise();
        return m_best.converged && !m_stop.stop_requested() && (!m_onlyGaugeTells || isOfGauge());
    }

    /// Whether the gauge would ask for these steps with these values.
    [[nodiscard]] bool isOfGauge() const {
        return stepsByGauge(m_project, m_problem.factorsAt(m_best.q), m_stop) == m_problem.steps();
    }

    /// Fits with other steps; keeps them where they fit better.
    bool betterWith(const std::vector<int>& steps) {
        return betterWith(steps, isAstray() ? m_problem.start() : m_best.q);
    }
    bool betterWith(const std::vector<int>& steps, const std::vector<double>& from) {
        const std::vector<int> before = m_problem.steps();
        m_problem.setSteps(steps);
        const std::vector<bool> free(m_request.parameters.size(), false);
        LeastSquares other = minimise(m_problem, from, free);
        constexpr double better = 1e-9; // by no more than rounding is not better
        const bool fitsBetter = other.criterion < m_best.criterion * (1 - better);
        std::swap(m_best, other);
        if (!m_onlyGaugeTells) {
            if (fitsBetter) {
                return true;
            }
        } else if (const bool isConsistent = isOfGauge();
                   isConsistent != m_isConsistent ? isConsistent : fitsBetter) {
            m_isConsistent = isConsistent;
            return true;
        }
        std::swap(m_best, other);
        m_problem.setSteps(before);
        return false;
    }

    /// With wrong steps a factor may run off to 0, where every further fit would stay.
    [[nodiscard]] bool isAstray() const {
        constexpr double farthest = 1.4; // a factor of 4
        for (std::size_t i = 0; i < m_best.q.size(); ++i) {
            if (isFactor(m_request.parameters[i].kind) && std::abs(m_best.q[i]) > farthest) {
                return true;
            }
        }
        return false;
    }

    /// The steps that the gauge asks for anywhere in a range of each factor, each of them once.
    void tryStepsOfGauge() {
        constexpr double most = 3; // times as much, and as little
        constexpr int points = 24;
        const std::vector<double> start = m_problem.start();
        std::set<std::vector<int>> tried{m_problem.steps()};
        for (std::size_t i = 0; i < start.size(); ++i) {
            for (int k = 0;
                 isFactor(m_request.parameters[i].kind) && k <= points && !m_stop.stop_requested();
                 ++k) {
                std::vector<double> q = start;
                q[i] += std::log(most) * (2.0 * k / points - 1);
                const std::vector<int> steps =
                    stepsByGauge(m_project, m_problem.factorsAt(q), m_stop);
                if (!steps.empty() && tried.insert(steps).second) {
                    betterWith(steps, q);
                }
            }
        }
    }

    void followGauge() {
        constexpr int mostRounds = 5;
        for (int round = 0; round < mostRounds && !m_stop.stop_requested(); ++round) {
            const std::vector<int> steps =
                stepsByGauge(m_project, m_problem.factorsAt(m_best.q), m_stop);
            if (steps.empty() || steps == m_problem.steps() || !betterWith(steps)) {
                return;
            }
        }
    }

    /// One more or less of a stage, or one from a stage to the next.
    [[nodiscard]] std::vector<std::vector<int>> neighbours() const {
        const std::vector<int>& now = m_problem.steps();
        std::vector<std::vector<int>> found;
        for (const int change : {1, -1}) {
            for (std::size_t z = 0; z < now.size(); ++z) {
                std::vector<int> steps = now;
                steps[z] += change;
                found.push_back(steps);
                if (z + 1 < now.size()) {
                    steps[z + 1] -= change;
                    found.push_back(std::move(steps));
                }
            }
        }
        std::erase_if(found, [](const std::vector<int>& steps) {
            return std::ranges::any_of(steps, [](int count) { return count < 0; });
        });
        return found;
    }

    void trySteps() {
        constexpr int mostRounds = 20;
        bool changed = true;
        for (int round = 0; changed && round < mostRounds; ++round) {
            const auto better = [this](const std::vector<int>& steps) {
                return !m_stop.stop_requested() && isWorthATry(steps) && betterWith(steps);
            };
            const std::vector<std::vector<int>> steps = neighbours();
            changed = std::ranges::any_of(steps, better);
        }
    }

    /// Of steps that are far worse as things stand no fit will make better ones.
    bool isWorthATry(const std::vector<int>& steps) {
        const std::vector<int> before = m_problem.steps();
        m_problem.setSteps(steps);
        std::vector<double> residuals;
        const bool ran = m_problem.evaluate(m_best.q, residuals);
        m_problem.setSteps(before);
        const double sum =
            std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
        constexpr double hopeless = 100;
        return ran
               && sum < hopeless
                            * std::max(m_best.criterion,
                                       1e-6 * static_cast<double>(residuals.size()));
    }

    /// The noise of each group from its own residuals, and the weights of a robust loss, until
    /// nothing changes.
    void settleNoise() {
        constexpr int mostRounds = 12;
        for (int round = 0; round < mostRounds && !m_stop.stop_requested(); ++round) {
            const std::vector<double> before = m_best.q;
            std::vector<double> differences;
            if (!m_problem.differences(m_best.q, differences)) {
                return;
            }
            m_problem.setNoise(noiseOf(differences));
            m_problem.setWeights(weightsOf(differences));
            const std::vector<bool> free(m_request.parameters.size(), false);
            m_best = minimise(m_problem, m_best.q, free);
            double change = 0;
            for (std::size_t i = 0; i < before.size(); ++i) {
                change = std::max(change, std::abs(before[i] - m_best.q[i]));
            }
            constexpr double settled = 1e-9;
            if (round > 0 && change < settled) {
                return;
            }
        }
    }

    /// RMS of each group; of a robust fit by the median, which outliers do not move.
    std::vector<double> noiseOf(const std::vector<double>& differences) const {
        constexpr double leastShare = 1e-9;
        std::vector<double> noise;
        std::size_t at = 0;
        const double taken = static_cast<double>(m_request.parameters.size());
        const double all = static_cast<double>(m_data.count());
        for (const FitGroup& group : m_data.groups) {
            std::vector<double> sizes;
            double squares = 0;
            for (std::size_t i = 0; i < group.values.size(); ++i, ++at) {
                squares += differences[at] * differences[at];
                sizes.push_back(std::abs(differences[at]));
            }
            // Each group gives up its share of the degrees of freedom.
            const double count = static_cast<double>(sizes.size());
            const double rms = std::sqrt(squares / (count * (1 - taken / all)));
            const double found = m_request.loss == RobustLoss::none
                                     ? rms
                                     : deviationPerMedian * medianOf(std::move(sizes));
            noise.push_back(std::max(found, leastShare * group.noise));
        }
        return noise;
    }

    std::vector<double> weightsOf(const std::vector<double>& differences) const {
        if (m_request.loss == RobustLoss::none) {
            return {};
        }
        std::vector<double> scaled;
        std::size_t at = 0;
        for (std::size_t g = 0; g < m_data.groups.size(); ++g) {
            for (std::size_t i = 0; i < m_data.groups[g].values.size(); ++i, ++at) {
                scaled.push_back(differences[at] / m_problem.noise()[g]);
            }
        }
        return robustWeights(scaled, m_request.loss);
    }

    void addValues(const Identifiability& found) {
        const std::size_t count = m_request.parameters.size();
        const double freedom =
            std::max(1.0, static_cast<double>(m_data.count()) - static_cast<double>(count));
        const double t = studentQuantile((1 + confidence) / 2, freedom);
        std::vector<double> errors;
        for (std::size_t i = 0; i < count; ++i) {
            const FittedKind kind = m_request.parameters[i].kind;
            const double error = std::sqrt(found.covariance[i * count + i]);
            const double q = m_best.q[i];
            FittedValue value;
            value.parameter = m_request.parameters[i];
            value.value = FitProblem::valueOf(kind, q);
            value.interval95 = {FitProblem::valueOf(kind, q - t * error),
                                FitProblem::valueOf(kind, q + t * error)};
            const bool isRelative = isFactor(kind) || kind == FittedKind::blank_runout;
            value.error = isRelative ? error : FitProblem::valueOf(kind, error);
            errors.push_back(error);
            m_result.values.push_back(value);
        }
        for (std::size_t i = 0; i < count; ++i) {
            std::vector<double> covariances, correlations;
            for (std::size_t k = 0; k < count; ++k) {
                const double both = found.covariance[i * count + k];
                const auto unit = [this](std::size_t at) {
                    const FittedKind kind = m_request.parameters[at].kind;
                    const bool isRelative = isFactor(kind) || kind == FittedKind::blank_runout;
                    return isRelative ? 1 : FitProblem::valueOf(kind, 1);
                };
                covariances.push_back(both * unit(i) * unit(k));
                correlations.push_back(both / (errors[i] * errors[k]));
            }
            m_result.covariance.push_back(std::move(covariances));
            m_result.correlation.push_back(std::move(correlations));
        }
    }

    void addResiduals() {
        std::vector<double> differences;
        if (!m_problem.differences(m_best.q, differences)) {
            return;
        }
        std::vector<double> scaled;
        std::size_t at = 0;
        for (const FitGroup& group : m_data.groups) {
            FitResiduals residuals{group.source, group.trace, {}, 0, group.traceNoise()};
            for (std::size_t i = 0; i < group.values.size(); ++i, ++at) {
                residuals.values.push_back(differences[at]);
                residuals.rms += differences[at] * differences[at];
            }
            residuals.rms = std::sqrt(residuals.rms / static_cast<double>(group.values.size()));
            for (const double value : residuals.values) {
                scaled.push_back(residuals.rms > 0 ? value / residuals.rms : 0);
            }
            m_result.residuals.push_back(std::move(residuals));
        }
        addNormality(std::move(scaled));
    }

    void addNormality(std::vector<double> scaled) {
        constexpr std::size_t least = 20, most = 2000;
        if (scaled.size() < least) {
            return;
        }
        std::vector<double> taken;
        const std::size_t stride = (scaled.size() + most - 1) / most;
        for (std::size_t i = 0; i < scaled.size(); i += stride) {
            taken.push_back(scaled[i]);
        }
        std::ranges::sort(taken);
        if (taken.front() < taken.back()) {
            m_result.normality = shapiroWilk(taken);
        }
    }

    const Project& m_project;
    const IdentificationRequest& m_request;
    const std::stop_token& m_stop;
    FitData m_data;
    FitProblem m_problem;
    LeastSquares m_best;
    bool m_onlyGaugeTells = false; ///< no trace shows how many steps there were
    bool m_isConsistent = false;   ///< then: whether the gauge asks for those of the best
    Identification m_result;
};

/// Whether the residuals of a trace follow each other, as those of the right cycle do not: beyond
/// three standard errors of white noise, 1/√n.
bool hasStructure(const std::vector<FitResiduals>& residuals) {
    constexpr double clearly = 3;
    return std::ranges::any_of(residuals, [](const FitResiduals& group) {
        return group.trace >= 0
               && firstAutocorrelation(group.values)
                      > clearly / std::sqrt(static_cast<double>(group.values.size()));
    });
}

/// −ln of the likelihood, less what is the same for any fit of the same data.
double misfit(const std::vector<FitResiduals>& residuals) {
    double sum = 0;
    for (const FitResiduals& group : residuals) {
        sum += static_cast<double>(group.values.size()) * std::log(group.rms);
    }
    return sum;
}

/// For want of a time the steps of the stages may have gone astray, where no fit with the same
/// steps finds it: all is fitted anew, from the beginning, with each time left out.
std::vector<OutOfStep> outOfStepAnew(const Project& project, const IdentificationRequest& request,
                                     const std::stop_token& stop, const Identification& without) {
    std::vector<OutOfStep> found;
    const FitData data = fitDataOf(project, request.traces, request.withParts);
    for (const FittedKind kind : timesLeftOut(data, request.parameters)) {
        IdentificationRequest wider = request;
        wider.parameters.push_back({kind, {}, {}});
        const Identification with = Identifier(project, wider, stop).identify();
        if (with.status != IdentificationStatus::fitted
            || !(misfit(with.residuals) < misfit(without.residuals))) {
            continue;
        }
        OutOfStep one{kind, with.values.back().value, with.values.back().error, 0, 0};
        double rho = 0;
        for (const FitResiduals& group : with.residuals) {
            rho = group.trace >= 0 ? std::max(rho, firstAutocorrelation(group.values)) : rho;
        }
        one.error_s *= std::sqrt(inflation(rho));
        if (!isCertain(one)) {
            continue;
        }
        double most = -1;
        for (std::size_t i = 0; i < without.values.size(); ++i) {
            const double from = without.values[i].value, to = with.values[i].value;
            const bool isRelative = isFactor(without.values[i].parameter.kind)
                                    || without.values[i].parameter.kind == FittedKind::blank_runout;
            const double moved =
                std::abs(isRelative ? std::log(to / from) : to - from) / without.values[i].error;
            if (moved > most) {
                most = moved;
                one.parameter = i;
                one.value = to;
            }
        }
        found.push_back(one);
    }
    return found;
}

} // namespace

bool FitResiduals::isInDoubt() const {
    return noise && rms > mostRmsOfNoise * *noise;
}

bool Identification::isInDoubt() const {
    return std::ranges::any_of(residuals, &FitResiduals::isInDoubt);
}

Identification identify(const Project& project, const IdentificationRequest& request,
                        const std::stop_token& stop) {
    Identification found = Identifier(project, request, stop).identify();
    if (found.status == IdentificationStatus::fitted && found.outOfStep.empty()
        && hasStructure(found.residuals)) {
        found.outOfStep = outOfStepAnew(project, request, stop, found);
        if (stop.stop_requested()) {
            found = {};
            found.status = IdentificationStatus::stopped;
        }
    }
    return found;
}

} // namespace sparkout
