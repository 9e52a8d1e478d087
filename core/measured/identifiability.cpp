// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/identifiability.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

/// The least share of a direction at which a parameter belongs to it.
constexpr double partOfDirection = 0.2;

Eigen::Index at(std::size_t i) {
    return static_cast<Eigen::Index>(i);
}

class Inquiry {
public:
    Inquiry(const std::vector<FittedParameter>& list, const FitData& data, const FlatOver& isFlat)
        : m_list(list), m_data(data), m_isFlat(isFlat) {}

    Identifiability inquire(const Eigen::MatrixXd& jacobian) {
        decompose(jacobian);
        return std::move(m_found);
    }

private:
    void decompose(const Eigen::MatrixXd& jacobian) {
        const Eigen::Index count = jacobian.cols();
        // A parameter without an effect is its own group; the columns of the others are normalised.
        Eigen::VectorXd lengths = jacobian.colwise().norm();
        const double longest = std::max(lengths.maxCoeff(), 1e-300);
        for (Eigen::Index i = 0; i < count; ++i) {
            if (lengths[i] < longest * 1e-12) {
                report({static_cast<std::size_t>(i)});
                lengths[i] = 1;
            }
        }
        const Eigen::MatrixXd scaled = jacobian * lengths.cwiseInverse().asDiagonal();
        // JᵀJ of normalised columns has the squares of the singular values; R keeps them.
        const Eigen::MatrixXd r = Eigen::HouseholderQR<Eigen::MatrixXd>(scaled)
                                      .matrixQR()
                                      .topRows(count)
                                      .template triangularView<Eigen::Upper>();
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(r, Eigen::ComputeFullV);
        const Eigen::VectorXd& values = svd.singularValues();
        const double least = values[count - 1];
        m_found.condition = least > 0 ? values[0] / least : std::numeric_limits<double>::infinity();
        Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const double value = std::max(values[i], values[0] / mostCondition / 10);
            const Eigen::VectorXd direction =
                lengths.cwiseInverse().asDiagonal() * svd.matrixV().col(i);
            covariance += direction * direction.transpose() / (value * value);
            if (values[i] * mostCondition < values[0] && values[0] > 0) {
                reportDirection(svd.matrixV().col(i));
            }
        }
        for (Eigen::Index i = 0; i < count; ++i) {
            for (Eigen::Index k = 0; k < count; ++k) {
                m_found.covariance.push_back(covariance(i, k));
            }
        }
        reportFlat(covariance);
    }

    /// If the interval is as wide as the plausible range, the profile decides.
    void reportFlat(const Eigen::MatrixXd& covariance) {
        for (std::size_t i = 0; i < m_list.size(); ++i) {
            const double error = std::sqrt(covariance(at(i), at(i)));
            const double range = plausible(i);
            if (isReported(i) || 2 * error < range || !m_isFlat(i, range)) {
                continue;
            }
            std::vector<std::size_t> group{i};
            double least = 0; // correlation
            constexpr double together = 0.95;
            for (std::size_t k = 0; k < m_list.size(); ++k) {
                const double other = std::sqrt(covariance(at(k), at(k)));
                if (k != i && 2 * other >= plausible(k)
                    && std::abs(covariance(at(i), at(k))) > together * error * other) {
                    group.push_back(k);
                    least = std::min(least, covariance(at(i), at(k)));
                }
            }
            std::ranges::sort(group);
            report(std::move(group), least < 0);
        }
    }

    /// The plausible range in the coordinate.
    [[nodiscard]] double plausible(std::size_t i) const {
        const FittedKind kind = m_list[i].kind;
        const bool isRatio = isFactor(kind) || kind == FittedKind::blank_runout;
        const double range = plausibleRange(kind);
        return isRatio ? std::log(range) : FitProblem::coordinateOf(kind, range);
    }

    [[nodiscard]] bool isReported(std::size_t i) const {
        return std::ranges::any_of(m_found.unidentified, [i](const Unidentified& one) {
            return std::ranges::find(one.parameters, i) != one.parameters.end();
        });
    }

    void reportDirection(const Eigen::VectorXd& direction) {
        std::vector<std::size_t> group;
        for (Eigen::Index i = 0; i < direction.size(); ++i) {
            if (std::abs(direction[i]) > partOfDirection
                && !isReported(static_cast<std::size_t>(i))) {
                group.push_back(static_cast<std::size_t>(i));
            }
        }
        if (!group.empty()) {
            // The changes without effect have opposite signs.
            const bool isAgainst =
                group.size() == 2 && direction[at(group[0])] * direction[at(group[1])] < 0;
            report(std::move(group), isAgainst);
        }
    }

    void report(std::vector<std::size_t> group, bool isAgainst = false) {
        const Advice advice = adviceFor(group);
        const bool isProduct =
            isAgainst && group.size() == 2 && std::ranges::all_of(group, [this](std::size_t i) {
                return isFactor(m_list[i].kind);
            });
        m_found.unidentified.push_back({std::move(group), advice, isProduct});
    }

    [[nodiscard]] Advice adviceFor(const std::vector<std::size_t>& group) const {
        const auto has = [&](FittedKind kind) {
            return std::ranges::any_of(group,
                                       [&](std::size_t i) { return m_list[i].kind == kind; });
        };
        const bool ofPlace =
            std::ranges::any_of(group, [&](std::size_t i) { return m_list[i].place.has_value(); });
        if (ofPlace) {
            return Advice::place_sizes;
        }
        if (has(FittedKind::idle_power)) {
            return m_data.has(FitSource::power) ? Advice::idle : Advice::power;
        }
        if (has(FittedKind::chip_power) || has(FittedKind::friction_power)) {
            return m_data.has(FitSource::power) ? Advice::another_feed : Advice::power;
        }
        const bool ofPower = has(FittedKind::power_delay) || has(FittedKind::power_lag);
        if (ofPower || has(FittedKind::force_delay) || has(FittedKind::force_lag)) {
            const bool isThere = m_data.has(ofPower ? FitSource::power : FitSource::force);
            return !isThere && ofPower            ? Advice::power
                   : !isThere                     ? Advice::force
                   : !m_data.has(FitSource::size) ? Advice::size
                                                  : Advice::cycle_start;
        }
        if (has(FittedKind::time_shift)) {
            return Advice::cycle_start;
        }
        if (has(FittedKind::size_offset) || has(FittedKind::gauge_lag)
            || has(FittedKind::gauge_drift)) {
            return m_data.has(FitSource::size) ? Advice::another_feed : Advice::size;
        }
        if (has(FittedKind::compliance) || has(FittedKind::flow_stress)
            || has(FittedKind::dullness)) {
            return !m_data.has(FitSource::power)   ? Advice::power
                   : !m_data.has(FitSource::force) ? Advice::force
                   : !m_data.has(FitSource::size)  ? Advice::size
                                                   : Advice::another_feed;
        }
        if (has(FittedKind::alpha) || has(FittedKind::beta)) {
            return m_data.has(FitSource::size) ? Advice::another_feed : Advice::size;
        }
        return Advice::several_parts;
    }

    const std::vector<FittedParameter>& m_list;
    const FitData& m_data;
    const FlatOver& m_isFlat;
    Identifiability m_found;
};

} // namespace

Identifiability identifiabilityOf(std::span<const double> columns, std::size_t rows,
                                  const std::vector<FittedParameter>& list, const FitData& data,
                                  const FlatOver& isFlat) {
    return Inquiry(list, data, isFlat)
        .inquire(Eigen::Map<const Eigen::MatrixXd>(columns.data(), at(rows), at(list.size())));
}

Identifiability identifiabilityAt(FitProblem& problem, const FitData& data,
                                  const LeastSquares& best) {
    std::vector<std::size_t> all(problem.parameters());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<double> columns;
    if (!derivatives(problem, best.q, all, columns)) {
        return {std::numeric_limits<double>::infinity(), {}, {}, {}};
    }
    const auto isFlat = [&](std::size_t i, double range) {
        std::vector<bool> fixed(problem.parameters(), false);
        fixed[i] = true;
        return std::ranges::any_of(std::array{range, -range}, [&](double end) {
            std::vector<double> from = best.q;
            from[i] += end;
            return minimise(problem, from, fixed).criterion < best.criterion + flatRise;
        });
    };
    Identifiability found =
        identifiabilityOf(columns, problem.residuals(), problem.list(), data, isFlat);
    found.columns = std::move(columns);
    return found;
}

} // namespace sparkout
