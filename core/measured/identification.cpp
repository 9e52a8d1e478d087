// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/identification.h"

#include "core/batch/batch_statistics.h"
#include "core/measured/batch_fit.h"
#include "core/measured/calibration.h"
#include "core/measured/fit_problem.h"
#include "core/process/contact_compliance.h"
#include "core/process/coupled_sections.h"
#include "core/project/gauge.h"
#include "core/project/part.h"
#include "core/project/validate.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <span>
#include <utility>

namespace sparkout {

namespace {

constexpr std::size_t leastToJudge = 5; ///< values
constexpr std::size_t mostStarts = 8;   ///< with different steps
constexpr double farthestEnd = 3;       ///< of an interval, relative to ± t·σ

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
                                                      : IdentificationStatus::notConverged;
            addResiduals(); // none after a stop; they may show why it did not converge
            return std::move(m_result);
        }
        Identifiability found = identifiabilityAt(m_problem, m_data, m_best);
        m_result.condition = found.condition;
        m_result.unidentified = found.unidentified;
        m_result.stepsByStage = m_problem.steps();
        addResiduals();
        if (found.unidentified.empty() && !found.covariance.empty() && !m_stop.stop_requested()) {
            const std::vector<double> white = found.covariance;
            widen(found);
            findAlike(found);
            if (m_result.unidentified.empty()) {
                findEnds(found.covariance, white);
            }
        }
        if (m_stop.stop_requested()) {
            m_result.status = IdentificationStatus::stopped;
        } else if (!m_result.unidentified.empty() || found.covariance.empty()) {
            m_result.status =
                lacks() ? IdentificationStatus::doesNotFit : IdentificationStatus::cannotTell;
        } else {
            std::vector<double> errors; // errors of the coordinates
            for (std::size_t i = 0; i < m_best.q.size(); ++i) {
                errors.push_back(std::sqrt(found.covariance[i * m_best.q.size() + i]));
            }
            if (lacks()) {
                m_result.status = IdentificationStatus::doesNotFit;
            }
            LeftOut left = outOfStep(m_project, m_data, m_problem, m_best, errors, m_stop);
            m_result.outOfStep = std::move(left.certain);
            for (const LeftOut::Possible& one : left.possible) {
                for (std::size_t i = 0; i < errors.size(); ++i) {
                    const double more = student() * std::max(0.0, one.errors[i] - errors[i]);
                    const double most = actsOnDepths(m_request.parameters[i].kind)
                                            ? std::log(mostSearchedFactor)
                                            : std::numeric_limits<double>::infinity();
                    m_alike[i].first = std::min(m_alike[i].first, std::max(one.q[i] - more, -most));
                    m_alike[i].second =
                        std::max(m_alike[i].second, std::min(one.q[i] + more, most));
                }
            }
            addValues(found);
            if (m_stop.stop_requested()) { // the values would be incomplete
                m_result = {};
                m_result.status = IdentificationStatus::stopped;
            }
        }
        return std::move(m_result);
    }

private:
    /// `fitted` if there is no objection.
    IdentificationStatus refusal() {
        if (m_data.count() <= m_request.parameters.size()) {
            return IdentificationStatus::noData;
        }
        m_problem.setSteps(stepsByGauge(m_project, factorsOf(m_project), m_stop));
        return m_stop.stop_requested()     ? IdentificationStatus::stopped
               : m_problem.steps().empty() ? IdentificationStatus::notRun
                                           : IdentificationStatus::fitted;
    }

    /// The numbers of steps are integers, and each choice has its own optimum of shift and factors:
    /// a missing step is nearly compensated by a shift of one step. So the fit starts at many
    /// factors, with the steps by the gauge and the best shift of each; then the steps follow the
    /// gauge, and finally each may change by one.
    bool fit() {
        const std::vector<bool> free(m_request.parameters.size(), false);
        m_best = minimise(m_problem, m_problem.start(), free, SearchEffort::rough);
        if (m_stop.stop_requested()) {
            return false;
        }
        const bool isByGauge = m_project.gauge->control == Control::gauge;
        tryStarts(isByGauge);
        if (isByGauge) {
            followGauge();
            trySteps();
        }
        m_best = minimise(m_problem, m_best.q, free);
        m_least = m_best.criterion;
        settleNoise();
        return m_best.converged && !m_stop.stop_requested();
    }

    /// Fits with these steps; keeps them if they fit better.
    bool betterWith(const std::vector<int>& steps, const std::vector<double>& from) {
        const std::vector<int> before = m_problem.steps();
        m_problem.setSteps(steps);
        const std::vector<bool> free(m_request.parameters.size(), false);
        LeastSquares other = minimise(m_problem, from, free, SearchEffort::rough);
        constexpr double better = 1e-9; // a smaller improvement is rounding
        const bool fitsBetter = other.criterion < m_best.criterion * (1 - better);
        m_others.push_back(fitsBetter ? m_best : other);
        if (fitsBetter) {
            m_best = std::move(other);
        } else {
            m_problem.setSteps(before);
        }
        return fitsBetter;
    }

    /// A starting point of a fit.
    struct Start {
        double criterion = 0;
        std::vector<int> steps;
        std::vector<double> q;
    };

    /// Starting factors of the depths of cut, from a quarter to four times: all of them alike, and
    /// each of the first two separately.
    [[nodiscard]] std::vector<std::vector<double>> factorsToBegin() {
        constexpr int along = 24, across = 6;
        std::vector<std::size_t> factors;
        for (std::size_t i = 0; i < m_request.parameters.size(); ++i) {
            if (actsOnDepths(m_request.parameters[i].kind)) {
                factors.push_back(i);
            }
        }
        const auto share = [](int k, int points) {
            return std::log(mostSearchedFactor) * (2.0 * k / points - 1);
        };
        const std::vector<double> start = m_problem.start();
        std::vector<std::vector<double>> found;
        for (int k = 0; !factors.empty() && k <= along; ++k) {
            found.push_back(start);
            for (const std::size_t i : factors) {
                found.back()[i] += share(k, along);
            }
        }
        for (int k = 0; factors.size() >= 2 && k <= across; ++k) {
            for (int l = 0; l <= across; ++l) {
                found.push_back(start);
                found.back()[factors[0]] += share(k, across);
                found.back()[factors[1]] += share(l, across);
            }
        }
        return found;
    }

    [[nodiscard]] double criterionAt(const std::vector<double>& q) {
        std::vector<double> residuals;
        return m_problem.evaluate(q, residuals)
                   ? std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0)
                   : std::numeric_limits<double>::infinity();
    }

    /// Fits from the best starts, one for each sequence of steps.
    void tryStarts(bool isByGauge) {
        const std::vector<int> before = m_problem.steps();
        std::vector<Start> starts;
        for (const std::vector<double>& q : factorsToBegin()) {
            if (m_stop.stop_requested()) {
                break;
            }
            const std::vector<int> steps =
                isByGauge ? stepsByGauge(m_project, m_problem.factorsAt(q), m_stop) : before;
            if (!steps.empty()) {
                m_problem.setSteps(steps);
                std::vector<double> from = m_problem.startAt(q);
                const double criterion = criterionAt(from);
                starts.push_back({criterion, steps, std::move(from)});
            }
        }
        m_problem.setSteps(before);
        std::ranges::stable_sort(starts, {}, &Start::criterion);
        std::set<std::vector<int>> tried;
        for (const Start& start : starts) {
            if (!m_stop.stop_requested() && tried.size() < mostStarts
                && tried.insert(start.steps).second) {
                betterWith(start.steps, start.q);
            }
        }
    }

    void followGauge() {
        constexpr int mostRounds = 5;
        for (int round = 0; round < mostRounds && !m_stop.stop_requested(); ++round) {
            const std::vector<int> steps =
                stepsByGauge(m_project, m_problem.factorsAt(m_best.q), m_stop);
            if (steps.empty() || steps == m_problem.steps()
                || !betterWith(steps, startWith(steps).q)) {
                return;
            }
        }
    }

    /// One step more or less in a stage, or one moved to the next stage.
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

    /// The current coordinates, or those with the shift that compensates a step more or less in one
    /// of the stages, whichever fits better with the new steps.
    [[nodiscard]] Start startWith(const std::vector<int>& steps) {
        const std::vector<int> before = m_problem.steps();
        const std::vector<FittedParameter>& list = m_request.parameters;
        const auto shift = std::ranges::find(list, FittedKind::time_shift, &FittedParameter::kind);
        const double was_s = m_problem.durationAt(m_best.q);
        m_problem.setSteps(steps);
        Start best{criterionAt(m_best.q), steps, m_best.q};
        if (shift != list.end()) {
            std::vector<double> q = m_best.q;
            q[static_cast<std::size_t>(shift - list.begin())] -= FitProblem::coordinateOf(
                FittedKind::time_shift, m_problem.durationAt(m_best.q) - was_s);
            if (const double criterion = criterionAt(q); criterion < best.criterion) {
                best = {criterion, steps, std::move(q)};
            }
        }
        m_problem.setSteps(before);
        return best;
    }

    void trySteps() {
        constexpr int mostRounds = 20;
        bool changed = true;
        for (int round = 0; changed && round < mostRounds; ++round) {
            const auto better = [this](const std::vector<int>& steps) {
                if (m_stop.stop_requested()) {
                    return false;
                }
                const Start start = startWith(steps);
                return isWorthATry(start) && betterWith(steps, start.q);
            };
            const std::vector<std::vector<int>> steps = neighbours();
            changed = std::ranges::any_of(steps, better);
        }
    }

    /// Steps that are far worse at the start are not improved by a fit.
    [[nodiscard]] bool isWorthATry(const Start& start) const {
        constexpr double farWorse = 100, leastMean = 1e-6;
        return start.criterion
               < farWorse
                     * std::max(m_best.criterion,
                                leastMean * static_cast<double>(m_problem.residuals()));
    }

    /// Estimates the noise of each group from its own residuals, and the weights of a robust loss,
    /// until nothing changes.
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

    /// RMS of each group; for a robust fit by the median, which outliers do not affect.
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

    /// A·(Σ J_i·ρ(i − j)·J_jᵀ)·A with A the covariance for white noise: the covariance of least
    /// squares for correlated noise.
    void widen(Identifiability& found) {
        const std::size_t count = m_request.parameters.size();
        const std::size_t rows = m_problem.residuals();
        std::vector<double> sum(count * count, 0);
        const Derivatives derivatives{found.columns, rows};
        const std::vector<double> stageEnds_s = m_problem.stageEnds(m_best.q);
        std::size_t row = 0;
        for (std::size_t g = 0; g < m_data.groups.size(); ++g) {
            const FitGroup& group = m_data.groups[g];
            std::vector<std::size_t> stages;
            stages.reserve(stageEnds_s.size());
            for (const double end_s : stageEnds_s) {
                stages.push_back(
                    row
                    + static_cast<std::size_t>(std::ranges::upper_bound(group.time_s, end_s)
                                               - group.time_s.begin()));
            }
            const std::size_t end = row + group.values.size();
            addFollowing(derivatives, row, end, stages,
                         m_result.residuals[g].noise.value_or(TraceNoise{.white = 1}), sum);
            row = end;
        }
        addFollowing(derivatives, row, rows, {}, {.white = 1}, sum); // known before
        const auto square = [count](std::vector<double>& values) {
            const auto size = static_cast<Eigen::Index>(count);
            return Eigen::Map<Eigen::MatrixXd>(values.data(), size, size);
        };
        const Eigen::MatrixXd white = square(found.covariance);
        square(found.covariance) = white * square(sum) * white;
    }

    /// Finds the least and greatest coordinate of each parameter that fits equally well: with other
    /// steps of the stages, or in another valley, where the criterion rises by no more than at the
    /// ends of the interval, relative to the noise. If they are farther apart than the plausible
    /// range, the parameter is undetermined.
    void findAlike(const Identifiability& found) {
        double following = 1;
        for (const FitResiduals& group : m_result.residuals) {
            if (group.noise) {
                const double share = group.noise->share(), phi = group.noise->phi;
                following = std::max(following, 1 - share + share * (1 + phi) / (1 - phi));
            }
        }
        const std::size_t count = m_request.parameters.size();
        const double freedom = static_cast<double>(m_data.count() - count);
        const double most = m_least * (1 + flatRise * following / freedom);
        for (std::size_t i = 0; i < count; ++i) {
            std::pair<double, double> ends{m_best.q[i], m_best.q[i]};
            for (const LeastSquares& other : m_others) {
                if (other.criterion <= most) {
                    ends.first = std::min(ends.first, other.q[i]);
                    ends.second = std::max(ends.second, other.q[i]);
                }
            }
            const FittedKind kind = m_request.parameters[i].kind;
            const double wide = std::sqrt(found.covariance[i * count + i]);
            if (isFactor(kind)
                && ends.second - ends.first + 2 * wide > 2 * std::log(plausibleRange(kind))) {
                m_result.unidentified.push_back({{i}, Advice::another_feed});
            }
            m_alike.push_back(ends);
        }
    }

    /// The ends of the intervals by the likelihood's profile. Where a parameter is skew, its
    /// interval ± t·σ does not end where the data are equally against it. With the others fitted
    /// anew the criterion, from its least, has risen at an end by (t·σ/σ_w)², σ_w the error for
    /// white noise: in a linear problem that is ± t·σ. Parameters that are not fitted as logarithms
    /// keep ± t·σ, and so does an end at which the root of the rise is right within a tenth. An end
    /// more than three times as far is not searched for; a parameter whose interval exceeds the
    /// plausible range because of it is undetermined.
    void findEnds(const std::vector<double>& covariance, const std::vector<double>& white) {
        const std::size_t count = m_request.parameters.size();
        const double least = criterionAt(m_best.q);
        for (std::size_t i = 0; i < count; ++i) {
            const double half = student() * std::sqrt(covariance[i * count + i]);
            const double rise = half / std::sqrt(white[i * count + i]);
            const FittedKind kind = m_request.parameters[i].kind;
            const bool isSkew = isFactor(kind) || kind == FittedKind::blank_runout;
            const auto endOn = [&](double side) {
                return isSkew ? profileEnd(i, side * half, rise, least, white) : half;
            };
            const double below = endOn(-1), above = endOn(1);
            m_ends.emplace_back(below, above);
            constexpr double almost = 0.999;
            if (std::max(below, above) > almost * farthestEnd * half
                && below + above > 2 * std::log(plausibleRange(kind))) {
                m_result.unidentified.push_back({{i}, Advice::another_feed});
            }
        }
    }

    /// The distance of an end from the best coordinate, searched from `to` on; the rise is a root.
    [[nodiscard]] double profileEnd(std::size_t i, double to, double rise, double least,
                                    const std::vector<double>& white) {
        constexpr double almostLinear = 0.1, settled = 0.02;
        constexpr int mostSteps = 6;
        const std::size_t count = m_best.q.size();
        std::vector<bool> fixed(count, false);
        fixed[i] = true;
        double at = to;
        for (int step = 0; step < mostSteps && !m_stop.stop_requested(); ++step) {
            std::vector<double> q = m_best.q;
            for (std::size_t k = 0; k < count; ++k) { // along which the others follow at first
                q[k] += at * white[i * count + k] / white[i * count + i];
            }
            const double risen = std::sqrt(std::max(
                0.0, minimise(m_problem, q, fixed, SearchEffort::rough).criterion - least));
            const double off = std::abs(risen / rise - 1);
            if (off < (step == 0 ? almostLinear : settled)) {
                break;
            }
            at = std::isfinite(risen) ? at * std::clamp(rise / risen, 0.5, 2.0) : at / 2;
            if (std::abs(at) > farthestEnd * std::abs(to)) {
                at = farthestEnd * to;
                break;
            }
        }
        return std::abs(at);
    }

    /// Whether the residuals of a trace exceed noise.
    [[nodiscard]] bool lacks() const {
        return std::ranges::any_of(
            m_result.residuals, [](const FitResiduals& group) { return group.lack.isLacking(); });
    }

    /// Student's quantile of the intervals.
    [[nodiscard]] double student() const {
        const auto count = static_cast<double>(m_request.parameters.size());
        const double freedom = std::max(1.0, static_cast<double>(m_data.count()) - count);
        return studentQuantile((1 + confidence95) / 2, freedom);
    }

    void addValues(const Identifiability& found) {
        const std::size_t count = m_request.parameters.size();
        const double t = student();
        std::vector<double> errors;
        std::vector<double> wider; // ratio of the interval to that of the covariance
        for (std::size_t i = 0; i < count; ++i) {
            const FittedKind kind = m_request.parameters[i].kind;
            const double error = std::sqrt(found.covariance[i * count + i]);
            const double q = m_best.q[i];
            FittedValue value;
            value.parameter = m_request.parameters[i];
            value.value = FitProblem::valueOf(kind, q);
            const auto [least, most] = m_alike[i];
            const auto [below, above] = m_ends[i];
            value.interval95 = {FitProblem::valueOf(kind, least - below),
                                FitProblem::valueOf(kind, most + above)};
            const bool isRelative = isFactor(kind) || kind == FittedKind::blank_runout;
            const double half = (below + above) / (2 * t) + (most - least) / 2;
            wider.push_back(half / error);
            value.error = isRelative ? half : FitProblem::valueOf(kind, half);
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
                covariances.push_back(both * unit(i) * unit(k) * wider[i] * wider[k]);
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
        const std::vector<double> stageEnds_s = m_problem.stageEnds(m_best.q);
        const double taken = static_cast<double>(m_request.parameters.size())
                             / static_cast<double>(m_data.groups.size());
        const std::vector<double> weights = weightsOf(differences);
        std::span<const double> weightsLeft(weights);
        std::vector<double> scaled;
        std::span<const double> left(differences);
        for (const FitGroup& group : m_data.groups) {
            const std::span<const double> own = left.first(group.values.size());
            left = left.subspan(own.size());
            FitResiduals residuals{group.source, group.trace, {own.begin(), own.end()}};
            residuals.rms = std::sqrt(std::inner_product(own.begin(), own.end(), own.begin(), 0.0)
                                      / static_cast<double>(own.size()));
            if (!group.time_s.empty() && own.size() >= leastToJudge) {
                const std::vector<double> counted =
                    weights.empty() ? residuals.values
                                    : withoutOutliers(own, weightsLeft.first(own.size()));
                for (std::size_t i = 0; i < own.size(); ++i) {
                    residuals.outliers += counted[i] != own[i] ? 1 : 0;
                }
                judge(group, counted, taken, stageEnds_s, residuals);
                for (const std::size_t i : overRange(group.values, own)) {
                    residuals.overRange.push_back({group.time_s[i], group.values[i]});
                }
            }
            weightsLeft = weights.empty() ? weightsLeft : weightsLeft.subspan(own.size());
            for (const double value : own) {
                scaled.push_back(residuals.rms > 0 ? value / residuals.rms : 0);
            }
            m_result.residuals.push_back(std::move(residuals));
        }
        addNormality(std::move(scaled));
    }

    /// With a robust loss a lone outlier counts as little as in the fit. Several in a row, or many,
    /// are a deficiency of the model.
    static std::vector<double> withoutOutliers(std::span<const double> values,
                                               std::span<const double> weights) {
        constexpr double outlying = 0.5, mostOfAll = 0.05;
        constexpr std::size_t mostInARow = 2;
        std::vector<double> counted(values.begin(), values.end());
        std::size_t lessened = 0;
        for (std::size_t i = 0; i < values.size();) {
            std::size_t end = i;
            while (end < values.size() && weights[end] < outlying) {
                ++end;
            }
            for (std::size_t k = i; end - i <= mostInARow && k < end; ++k, ++lessened) {
                counted[k] *= weights[k];
            }
            i = std::max(end, i + 1);
        }
        const bool areFew =
            static_cast<double>(lessened) <= mostOfAll * static_cast<double>(values.size());
        return areFew ? counted : std::vector<double>(values.begin(), values.end());
    }

    static void judge(const FitGroup& group, std::span<const double> left, double parameters,
                      const std::vector<double>& stageEnds_s, FitResiduals& residuals) {
        // For exact values the rounding of the simulation remains.
        constexpr double leastShare = 1e-6;
        const auto [least, most] = std::ranges::minmax(group.values);
        residuals.rounding = (most - least) * leastShare;
        residuals.noise = traceNoiseOf(left, std::max(group.step, residuals.rounding));
        residuals.lack = lackOfFit(left, *residuals.noise, parameters);
        if (residuals.lack.isLacking()) {
            std::vector<double> predicted = group.values;
            for (std::size_t i = 0; i < predicted.size(); ++i) {
                predicted[i] -= residuals.values[i];
            }
            residuals.unlike =
                unlikeOf(group.time_s, predicted, left, residuals.noise->variance(), stageEnds_s);
        }
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
    std::vector<LeastSquares> m_others;             ///< from other starts or with other steps
    std::vector<std::pair<double, double>> m_alike; ///< ends of equally good fits, by parameter
    std::vector<std::pair<double, double>> m_ends;  ///< distances of the intervals' ends
    double m_least = 0; ///< criterion of the best fit for the same noise
    Identification m_result;
};

/// Whether the residuals of a trace are correlated, unlike those of the right cycle: beyond three
/// standard errors of white noise, 1/√n.
bool hasStructure(const std::vector<FitResiduals>& residuals) {
    constexpr double clearly = 3;
    return std::ranges::any_of(residuals, [](const FitResiduals& group) {
        return group.trace >= 0
               && firstAutocorrelation(group.values)
                      > clearly / std::sqrt(static_cast<double>(group.values.size()));
    });
}

/// −ln of the likelihood, without the part common to all fits of the data.
double misfit(const std::vector<FitResiduals>& residuals) {
    double sum = 0;
    for (const FitResiduals& group : residuals) {
        sum += static_cast<double>(group.values.size())
               * std::log(std::max(group.rms, group.rounding));
    }
    return sum;
}

/// Whether a fit with an additional time is certainly better, relative to the noise of its
/// residuals.
bool isCertainlyBetter(const Identification& with, const Identification& without) {
    double following = 1;
    for (const FitResiduals& group : with.residuals) {
        following = std::max(following,
                             group.trace < 0 ? 1 : inflation(firstAutocorrelation(group.values)));
    }
    return 2 * (misfit(without.residuals) - misfit(with.residuals))
           > certainDelay * certainDelay * following;
}

/// Marks parameters as undetermined: with an additional time the fit is better, and does not
/// determine them.
void leaveUntold(std::vector<Unidentified> wider, Identification& found) {
    const std::size_t count = found.values.size();
    for (Unidentified& one : wider) {
        std::erase_if(one.parameters, [count](std::size_t at) { return at >= count; });
        one.isProduct = one.isProduct && one.parameters.size() > 1;
    }
    std::erase_if(wider, [](const Unidentified& one) { return one.parameters.empty(); });
    if (!wider.empty()) {
        found.status = IdentificationStatus::cannotTell;
        found.unidentified = std::move(wider);
        found.values.clear();
        found.covariance.clear();
        found.correlation.clear();
    }
}

/// Without a needed time the steps of the stages may be wrong, and no fit with the same steps
/// reveals it: repeats the whole fit with each time left out.
void addOutOfStepAnew(const Project& project, const IdentificationRequest& request,
                      const std::stop_token& stop, Identification& without) {
    std::vector<OutOfStep> found;
    std::vector<Unidentified> untold;
    const FitData data = fitDataOf(project, request.traces, request.withParts);
    for (const FittedKind kind : timesLeftOut(data, request.parameters)) {
        IdentificationRequest wider = request;
        wider.parameters.push_back({kind, {}, {}});
        const Identification with = Identifier(project, wider, stop).identify();
        if (with.residuals.empty() || !(misfit(with.residuals) < misfit(without.residuals))) {
            continue;
        }
        if (with.values.empty()) {
            if (untold.empty() && isCertainlyBetter(with, without)) {
                untold = with.unidentified;
            }
            continue;
        }
        OutOfStep one{kind, with.values.back().value, with.values.back().error, 0, 0};
        if (!isCertain(one) || !isCertainlyBetter(with, without)) {
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
    if (found.empty()) {
        leaveUntold(std::move(untold), without);
    }
    without.outOfStep = clearest(std::move(found));
}

/// Adds the force law supported by the recorded spark-out, whatever law the fit uses.
void addForceLaw(const Project& project, const std::stop_token& stop, Identification& found) {
    // The revolutions of a spark-out are separable if its beginning is known, the gauge has no lag,
    // and each radius deflects by itself.
    double begin_s = 0;
    bool isClear = found.status == IdentificationStatus::fitted && !isCoupled(project)
                   && !wheelContact(project);
    for (const FittedValue& value : found.values) {
        const FittedKind kind = value.parameter.kind;
        begin_s += kind == FittedKind::time_shift ? value.value : 0;
        isClear = isClear && kind != FittedKind::gauge_lag && kind != FittedKind::gauge_drift;
    }
    if (!isClear) {
        return;
    }
    if (const auto record = sparkOutOf(project, found.stepsByStage, begin_s)) {
        found.forceLaw = chooseForceLaw(project, *record, stop);
    }
}

/// Adds the usual ranges of the values, and the new issues of validate() for the inputs with them:
/// values outside these ranges, or refused, mean that the model does not fit.
void judgeValues(const Project& project, Identification& found) {
    const Issues before = validate(project);
    const Project calibrated = withCalibration(project, found, {}, {});
    for (Issue& issue : validate(calibrated)) {
        if (std::ranges::find(before, issue) == before.end()) {
            found.status =
                issue.severity == Severity::error ? IdentificationStatus::doesNotFit : found.status;
            found.issues.push_back(std::move(issue));
        }
    }
    const bool hasTraces = std::ranges::any_of(
        found.residuals, [](const FitResiduals& group) { return group.trace >= 0; });
    for (FittedValue& value : found.values) {
        value.usual = usualRange(project, value.parameter.kind, hasTraces);
        found.status = value.isUsual() ? found.status : IdentificationStatus::doesNotFit;
    }
}

} // namespace

Identification identify(const Project& project, const IdentificationRequest& request,
                        const std::stop_token& stop) {
    Identification found;
    const FitData data = fitDataOf(project, request.traces, request.withParts);
    const bool onlyParts =
        !data.groups.empty() && std::ranges::all_of(data.groups, [](const FitGroup& group) {
            return group.source == FitSource::parts;
        });
    const bool asksSetting =
        std::ranges::find(request.parameters, FittedKind::gauge_setting, &FittedParameter::kind)
        != request.parameters.end();
    if (!areApplicable(project, request.parameters)
        || (asksSetting && !onlyParts && !data.groups.empty())) {
        found.status = IdentificationStatus::notApplicable;
        return found;
    }
    for (Issue& issue : validate(project)) {
        if (issue.severity == Severity::error) {
            found.issues.push_back(std::move(issue));
        }
    }
    if (!found.issues.empty()) {
        found.status = IdentificationStatus::notRun;
        return found;
    }
    if (request.parameters.empty() || data.groups.empty()) {
        return found; // no data
    }
    if (onlyParts) {
        found = fitBatch(project, request, stop);
        judgeValues(project, found);
        return found;
    }
    found = Identifier(project, request, stop).identify();
    if (!found.values.empty() && found.outOfStep.empty() && hasStructure(found.residuals)) {
        addOutOfStepAnew(project, request, stop, found);
        if (stop.stop_requested()) {
            found = {};
            found.status = IdentificationStatus::stopped;
        }
    }
    if (!found.outOfStep.empty()) { // without these times the values are wrong
        found.status = IdentificationStatus::doesNotFit;
    }
    judgeValues(project, found);
    addForceLaw(project, stop, found);
    return found;
}

} // namespace sparkout
