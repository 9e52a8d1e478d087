// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/out_of_step.h"

#include "core/identification/identifiability.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

constexpr double leastDrift_mm_min = 1e-5;
constexpr double leastDelay_s = 1e-4; ///< resolution of a recorder's clock

bool hasTimes(const FitGroup& group) {
    return !group.time_s.empty();
}

/// Whether the data have the delayed quantity, and another one as its reference.
bool isOfData(FittedKind kind, const FitData& data) {
    if (kind == FittedKind::time_shift) {
        return std::ranges::any_of(data.groups, hasTimes);
    }
    if (kind == FittedKind::gauge_lag || kind == FittedKind::gauge_drift) {
        return data.has(FitSource::size);
    }
    const FitSource source = kind == FittedKind::power_delay ? FitSource::power : FitSource::force;
    return data.has(source) && std::ranges::any_of(data.groups, [source](const FitGroup& group) {
               return hasTimes(group) && group.source != source;
           });
}

/// RMS of each group.
std::vector<double> noiseByGroup(const FitData& data, const std::vector<double>& differences,
                                 const std::vector<double>& before) {
    constexpr double leastShare = 1e-9;
    std::vector<double> noise;
    std::size_t at = 0;
    for (std::size_t g = 0; g < data.groups.size(); ++g) {
        double squares = 0;
        const std::size_t count = data.groups[g].values.size();
        for (std::size_t i = 0; i < count; ++i, ++at) {
            squares += differences[at] * differences[at];
        }
        noise.push_back(
            std::max(std::sqrt(squares / static_cast<double>(count)), leastShare * before[g]));
    }
    return noise;
}

/// The greatest inflation of the groups recorded over time.
double inflationOf(const FitData& data, const std::vector<double>& differences) {
    double most = 1;
    std::span<const double> left(differences);
    for (const FitGroup& group : data.groups) {
        if (hasTimes(group)) {
            most = std::max(most, inflation(firstAutocorrelation(left.first(group.values.size()))));
        }
        left = left.subspan(group.values.size());
    }
    return most;
}

/// A fit with an additional time.
class WiderFit {
public:
    WiderFit(const Project& project, const FitData& data, const FitProblem& fitted, FittedKind kind,
             const std::stop_token& stop)
        : m_list(withTime(fitted.list(), kind))
        , m_data(data)
        , m_problem(project, data, m_list, stop) {
        m_problem.setSteps(fitted.steps());
        m_problem.setNoise(fitted.noise());
        m_problem.setWeights(fitted.weights());
    }

    /// Adds the result, unless the time is 0 as far as the data determine it.
    void find(const LeastSquares& best, const std::vector<double>& errors, LeftOut& leftOut) {
        std::vector<double> from = best.q;
        from.push_back(0);
        if (!isWorthAFit(from)) {
            return;
        }
        const std::vector<bool> free(m_list.size(), false);
        LeastSquares wider = minimise(m_problem, from, free);
        std::vector<double> differences;
        if (!m_problem.differences(wider.q, differences)) {
            return;
        }
        m_problem.setNoise(noiseByGroup(m_data, differences, m_problem.noise()));
        wider = minimise(m_problem, wider.q, free);
        if (!wider.converged || m_problem.isStopped()
            || !m_problem.differences(wider.q, differences)) {
            return;
        }
        const Identifiability told = identifiabilityAt(m_problem, m_data, wider);
        if (!told.unidentified.empty() || told.covariance.empty()) {
            return;
        }
        OutOfStep found;
        found.kind = m_list.back().kind;
        found.amount = FitProblem::valueOf(found.kind, wider.q.back());
        const double wide = std::sqrt(inflationOf(m_data, differences));
        found.error = FitProblem::valueOf(found.kind, std::sqrt(told.covariance.back())) * wide;
        if (!isCertain(found)) {
            if (std::abs(found.amount) > possibleDelay * found.error) {
                LeftOut::Possible& one = leftOut.possible.emplace_back();
                for (std::size_t i = 0; i < best.q.size(); ++i) {
                    one.q.push_back(wider.q[i]);
                    one.errors.push_back(std::sqrt(told.covariance[i * wider.q.size() + i]) * wide);
                }
            }
            return;
        }
        double most = 0;
        for (std::size_t i = 0; i < best.q.size(); ++i) {
            const double moved = std::abs(wider.q[i] - best.q[i]) / errors[i];
            if (moved > most) {
                most = moved;
                found.parameter = i;
            }
        }
        found.value = FitProblem::valueOf(m_list[found.parameter].kind, wider.q[found.parameter]);
        leftOut.certain.push_back(found);
    }

    /// Adds fits with the time held at an amount, if they fit about as well as the best.
    void findHeld(const LeastSquares& best, const std::vector<double>& errors, double amount,
                  LeftOut& leftOut) {
        std::vector<double> from = best.q, residuals, differences;
        from.push_back(0);
        if (!m_problem.evaluate(from, residuals)) {
            return;
        }
        const double least =
            std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
        from.back() = FitProblem::coordinateOf(m_list.back().kind, amount);
        std::vector<bool> fixed(m_list.size(), false);
        fixed.back() = true;
        LeastSquares held = minimise(m_problem, from, fixed);
        if (!held.converged || !m_problem.differences(held.q, differences)) {
            return;
        }
        const auto freedom = static_cast<double>(m_problem.values() - best.q.size());
        const double most =
            least * (1 + flatRise * inflationOf(m_data, differences) / std::max(freedom, 1.0));
        if (held.criterion <= most) {
            held.q.pop_back();
            leftOut.possible.push_back({std::move(held.q), errors});
        }
    }

private:
    /// Whether the residuals of the fit support the time by enough standard errors, to first order:
    /// for J = Q·R the last element of Qᵀr, since the last column of R is orthogonal to the other
    /// ones.
    bool isWorthAFit(const std::vector<double>& q) {
        std::vector<std::size_t> all(q.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        std::vector<double> columns, residuals;
        if (!derivatives(m_problem, q, all, columns) || !m_problem.evaluate(q, residuals)) {
            return false;
        }
        const auto rows = static_cast<Eigen::Index>(residuals.size());
        const auto count = static_cast<Eigen::Index>(q.size());
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(
            Eigen::Map<const Eigen::MatrixXd>(columns.data(), rows, count));
        Eigen::VectorXd turned = Eigen::Map<const Eigen::VectorXd>(residuals.data(), rows);
        turned.applyOnTheLeft(qr.householderQ().adjoint());
        return std::abs(turned[count - 1]) > possibleDelay;
    }

    static std::vector<FittedParameter> withTime(std::vector<FittedParameter> list,
                                                 FittedKind kind) {
        list.push_back({kind, {}, {}});
        return list;
    }

    std::vector<FittedParameter> m_list;
    const FitData& m_data;
    FitProblem m_problem;
};

} // namespace

double firstAutocorrelation(std::span<const double> residuals) {
    double squares = 0, products = 0;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        squares += residuals[i] * residuals[i];
        products += i > 0 ? residuals[i] * residuals[i - 1] : 0;
    }
    return squares > 0 ? products / squares : 0;
}

double inflation(double autocorrelation) {
    const double rho = std::clamp(autocorrelation, 0.0, 0.99);
    return (1 + rho) / (1 - rho);
}

bool isCertain(const OutOfStep& found) {
    const double least = found.kind == FittedKind::gauge_drift ? leastDrift_mm_min : leastDelay_s;
    return std::abs(found.amount) >= std::max(least, certainDelay * found.error);
}

std::vector<FittedKind> timesLeftOut(const FitData& data,
                                     const std::vector<FittedParameter>& fitted) {
    std::vector<FittedKind> left;
    for (const FittedKind kind :
         {FittedKind::time_shift, FittedKind::power_delay, FittedKind::force_delay,
          FittedKind::gauge_lag, FittedKind::gauge_drift}) {
        if (std::ranges::find(fitted, kind, &FittedParameter::kind) == fitted.end()
            && isOfData(kind, data)) {
            left.push_back(kind);
        }
    }
    return left;
}

LeftOut outOfStep(const Project& project, const FitData& data, const FitProblem& fitted,
                  const LeastSquares& best, const std::vector<double>& errors,
                  const std::stop_token& stop) {
    LeftOut found;
    for (const FittedKind kind : timesLeftOut(data, fitted.list())) {
        if (stop.stop_requested()) {
            break;
        }
        WiderFit wider(project, data, fitted, kind, stop);
        wider.find(best, errors, found);
        if (kind == FittedKind::gauge_lag) {
            for (const double lag_s : {usualLag_s, 2 * usualLag_s}) {
                WiderFit(project, data, fitted, kind, stop).findHeld(best, errors, lag_s, found);
            }
        }
    }
    return found;
}

} // namespace sparkout
