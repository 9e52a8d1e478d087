// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/batch_fit.h"

#include "core/batch/batch_statistics.h"
#include "core/measured/adequacy.h"
#include "core/measured/cycle_response.h"
#include "core/measured/fit_problem.h"
#include "core/process/profile.h"
#include "core/project/measured.h"
#include "core/project/part.h"
#include "core/statistics/intervals.h"
#include "core/units.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace sparkout {

namespace {

constexpr double leastDeviation_um = 0.1;
constexpr double ofPrediction_um = 0.03; ///< as a standard deviation, by the number of stocks
/// Step of the derivative, as a logarithm: a part that makes another stroke there changes the mean
/// by a jump that must not count.
constexpr double derivativeStep = 0.1;

/// The mean size of a zone or section.
struct PlaceMean {
    std::size_t place = 0;
    double mean_um = 0;
    std::optional<double> deviation_um; ///< standard deviation of the parts
    double count = 1;
    bool isSummary = false;
};

/// The agreement of parameters with the measured means.
struct Meeting {
    double criterion = std::numeric_limits<double>::infinity();
    double setting_um = 0;     ///< setting of the gauge, relative to the project's
    Eigen::VectorXd left_um;   ///< measured less predicted
    Eigen::MatrixXd whitening; ///< makes the errors of the means independent, of size 1
};

class BatchFit {
public:
    BatchFit(const Project& project, const IdentificationRequest& request,
             const std::stop_token& stop)
        : m_project(project)
        , m_list(request.parameters)
        , m_stop(stop)
        , m_setting(static_cast<std::size_t>(
              std::ranges::find(m_list, FittedKind::gauge_setting, &FittedParameter::kind)
              - m_list.begin())) {
        for (std::size_t i = 0; i < m_list.size(); ++i) {
            if (actsOnDepths(m_list[i].kind)) {
                m_factors.push_back(i);
            }
        }
        const std::vector<MeasuredStatistics> rows = statisticsOfMeasured(project);
        const auto isListed = [](const MeasuredStatistics& row) {
            return row.quantity == MeasuredQuantity::diameter_deviation && !row.isSummary;
        };
        // Summaries refer to the listed parts, if there are any.
        const bool areListed = std::ranges::any_of(rows, isListed);
        for (const MeasuredStatistics& row : rows) {
            if (row.quantity == MeasuredQuantity::diameter_deviation
                && row.isSummary != areListed) {
                m_means.push_back({static_cast<std::size_t>(row.place), row.mean, row.deviation,
                                   static_cast<double>(row.count), row.isSummary});
                m_result.count += static_cast<std::size_t>(row.count);
            }
        }
        findCovariance();
    }

    Identification fit() {
        m_result.status = IdentificationStatus::fitted;
        if (m_means.size() < m_list.size()) {
            m_result.status = IdentificationStatus::noData;
            return std::move(m_result);
        }
        search();
        if (m_stop.stop_requested()) {
            m_result = {};
            m_result.status = IdentificationStatus::stopped;
        } else if (!std::isfinite(m_best.criterion)) {
            m_result.status = IdentificationStatus::notRun;
        } else {
            report();
            if (m_stop.stop_requested()) { // covers only some of the phases
                m_result = {};
                m_result.status = IdentificationStatus::stopped;
            }
        }
        return std::move(m_result);
    }

private:
    using Point = std::vector<double>; ///< logarithms of the factors

    [[nodiscard]] bool hasSetting() const { return m_setting < m_list.size(); }

    [[nodiscard]] CycleFactors factorsAt(const Point& point) const {
        std::vector<double> q(m_list.size(), 0);
        for (std::size_t i = 0; i < point.size(); ++i) {
            q[m_factors[i]] = point[i];
        }
        CycleFactors factors = cycleFactors(m_project, m_list, q);
        factors.blankRunout_mm = factorsOf(m_project).blankRunout_mm; // not in finished parts
        return factors;
    }

    const SizesOverPhases& sizesAt(const Point& point) {
        const auto [at, isNew] = m_known.try_emplace(point);
        if (isNew) {
            at->second = sizesOverPhases(m_project, factorsAt(point), m_stop);
        }
        return at->second;
    }

    /// Variances and covariances of the means, from the scatter of the parts.
    [[nodiscard]] Eigen::MatrixXd covarianceOfMeans(const SizesOverPhases& sizes) const {
        Eigen::MatrixXd covariance = m_covariance;
        for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
            const PlaceMean& one = m_means[static_cast<std::size_t>(i)];
            const double deviation_um = std::max(
                leastDeviation_um, one.deviation_um.value_or(sizes.deviations_um[one.place]));
            covariance(i, i) =
                deviation_um * deviation_um / one.count + ofPrediction_um * ofPrediction_um;
        }
        return covariance;
    }

    /// Finds the correlation of the means of two places from the parts measured in both. Summaries
    /// do not contain it, and few parts hardly determine it.
    void findCovariance() {
        const auto count = static_cast<Eigen::Index>(m_means.size());
        m_covariance = Eigen::MatrixXd::Zero(count, count);
        const std::size_t places = static_cast<std::size_t>(placeCount(m_project));
        std::map<std::string, std::vector<std::optional<double>>> byPart;
        for (const MeasuredPart& part : m_project.measured->parts) {
            const auto place = static_cast<std::size_t>(part.place);
            if (!part.part.empty() && !part.diameters_mm.empty() && place < places) {
                auto& sizes = byPart[part.part];
                sizes.resize(places);
                sizes[place] = std::reduce(part.diameters_mm.begin(), part.diameters_mm.end())
                               / static_cast<double>(part.diameters_mm.size());
            }
        }
        for (Eigen::Index i = 0; i < count; ++i) {
            for (Eigen::Index k = 0; k < i; ++k) {
                const PlaceMean& one = m_means[static_cast<std::size_t>(i)];
                const PlaceMean& other = m_means[static_cast<std::size_t>(k)];
                double products = 0;
                std::size_t both = 0;
                for (const auto& [name, sizes] : byPart) {
                    if (sizes[one.place] && sizes[other.place] && !one.isSummary
                        && !other.isSummary) {
                        products += (deviationOf(*sizes[one.place]) - one.mean_um)
                                    * (deviationOf(*sizes[other.place]) - other.mean_um);
                        ++both;
                    }
                }
                if (both >= fewParts) {
                    m_covariance(i, k) = m_covariance(k, i) = products
                                                              / static_cast<double>(both - 1)
                                                              / std::sqrt(one.count * other.count);
                }
            }
        }
    }

    [[nodiscard]] double deviationOf(double diameter_mm) const {
        return (diameter_mm - m_project.part->diameter_mm) * units::umPerMm;
    }

    Meeting meetingAt(const Point& point) {
        Meeting met;
        const SizesOverPhases& sizes = sizesAt(point);
        if (sizes.means_um.empty()) {
            return met;
        }
        const auto count = static_cast<Eigen::Index>(m_means.size());
        met.left_um.resize(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const PlaceMean& one = m_means[static_cast<std::size_t>(i)];
            met.left_um[i] = one.mean_um - sizes.means_um[one.place];
        }
        const Eigen::MatrixXd covariance = covarianceOfMeans(sizes);
        Eigen::LLT<Eigen::MatrixXd> factored(covariance);
        if (factored.info() != Eigen::Success) { // possible with parts that lack some places
            factored.compute(Eigen::MatrixXd(covariance.diagonal().asDiagonal()));
        }
        met.whitening = factored.matrixL().solve(Eigen::MatrixXd::Identity(count, count));
        const Eigen::VectorXd ones = met.whitening * Eigen::VectorXd::Ones(count);
        double sum = 0;
        if (hasSetting()) {
            double weight = ones.squaredNorm(), moment = ones.dot(met.whitening * met.left_um);
            double known = 0, knownWeight = 0;
            if (const auto& prior = m_list[m_setting].prior) {
                known = (prior->mean - setting_mm()) * units::umPerMm;
                knownWeight = 1 / std::pow(prior->deviation * units::umPerMm, 2);
            }
            met.setting_um = (moment + knownWeight * known) / (weight + knownWeight);
            met.left_um.array() -= met.setting_um;
            sum += knownWeight * (met.setting_um - known) * (met.setting_um - known);
        }
        sum += (met.whitening * met.left_um).squaredNorm();
        for (std::size_t i = 0; i < point.size(); ++i) {
            if (const auto& prior = m_list[m_factors[i]].prior) {
                const double off = (std::exp(point[i]) - prior->mean) / prior->deviation;
                sum += off * off;
            }
        }
        met.criterion = sum;
        return met;
    }

    double criterionAt(const Point& point) { return meetingAt(point).criterion; }

    /// The size at which the project's gauge ends the cycle.
    [[nodiscard]] double setting_mm() const { return 2 * targetRadius(*m_project.part); }

    /// A point of the scan, with all factors alike, from one end to the other.
    [[nodiscard]] Point scanPoint(int k) const {
        return Point(m_factors.size(), range * (2.0 * k / scanned - 1));
    }

    void search() {
        if (m_factors.empty()) {
            m_best = meetingAt({});
            return;
        }
        std::vector<double> criteria;
        for (int k = 0; k <= scanned && !m_stop.stop_requested(); ++k) {
            criteria.push_back(criterionAt(scanPoint(k)));
        }
        std::vector<std::pair<double, int>> valleys;
        for (int k = 0; k < static_cast<int>(criteria.size()); ++k) {
            const auto at = static_cast<std::size_t>(k);
            const bool falls = at > 0 && criteria[at - 1] < criteria[at];
            const bool rises = at + 1 < criteria.size() && criteria[at + 1] < criteria[at];
            if (!falls && !rises && std::isfinite(criteria[at])) {
                valleys.emplace_back(criteria[at], k);
            }
        }
        std::ranges::sort(valleys);
        constexpr std::size_t refined = 3;
        valleys.resize(std::min(valleys.size(), refined));
        for (const auto& [criterion, k] : valleys) {
            if (!m_stop.stop_requested()) {
                refine(scanPoint(k));
            }
        }
    }

    /// Tries both sides of each factor with decreasing steps.
    void refine(Point point) {
        double least = criterionAt(point);
        for (double step = range / scanned; step > finest; step /= 2) {
            for (bool moved = true; moved && !m_stop.stop_requested();) {
                moved = false;
                for (std::size_t i = 0; i < point.size(); ++i) {
                    for (const double by : {step, -step}) {
                        Point other = point;
                        other[i] = std::clamp(other[i] + by, -range, range);
                        if (const double criterion = criterionAt(other); criterion < least) {
                            least = criterion;
                            point = std::move(other);
                            moved = true;
                        }
                    }
                }
            }
        }
        if (least < m_best.criterion) {
            m_best = meetingAt(point);
            m_at = std::move(point);
        }
    }

    /// The derivatives of the residuals by the listed parameters, scaled by their errors, and of
    /// the prior values; the setting in µm. Parameters without an influence on finished parts have
    /// none. Empty if no cycle near the best reaches size, and after a stop.
    Eigen::MatrixXd derivatives() {
        const auto count = static_cast<Eigen::Index>(m_list.size());
        Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(m_best.left_um.size(), count);
        for (std::size_t i = 0; i < m_factors.size(); ++i) {
            Point above = m_at, below = m_at;
            above[i] += derivativeStep;
            below[i] -= derivativeStep;
            const SizesOverPhases high = sizesAt(above), low = sizesAt(below);
            if (high.means_um.empty() || low.means_um.empty()) {
                return {};
            }
            for (Eigen::Index k = 0; k < columns.rows(); ++k) {
                const std::size_t place = m_means[static_cast<std::size_t>(k)].place;
                columns(k, static_cast<Eigen::Index>(m_factors[i])) =
                    (high.means_um[place] - low.means_um[place]) / (2 * derivativeStep);
            }
        }
        if (hasSetting()) {
            columns.col(static_cast<Eigen::Index>(m_setting)).setOnes();
        }
        Eigen::MatrixXd all = Eigen::MatrixXd::Zero(columns.rows() + count, count);
        all.topRows(columns.rows()) = m_best.whitening * columns;
        for (std::size_t i = 0; i < m_list.size(); ++i) {
            const bool isShown = i == m_setting || actsOnDepths(m_list[i].kind);
            if (const auto& prior = m_list[i].prior; prior && isShown) {
                const auto at = static_cast<Eigen::Index>(i);
                all(columns.rows() + at, at) =
                    (i == m_setting ? 1 / units::umPerMm : factorOf(i)) / prior->deviation;
            }
        }
        return all;
    }

    /// The fitted value of a factor; 1 for one without an influence on finished parts.
    [[nodiscard]] double factorOf(std::size_t parameter) const {
        const auto found = std::ranges::find(m_factors, parameter);
        return found == m_factors.end()
                   ? 1
                   : std::exp(m_at[static_cast<std::size_t>(found - m_factors.begin())]);
    }

    void report() {
        const Eigen::MatrixXd columns = derivatives();
        if (columns.size() == 0) {
            m_result.status = IdentificationStatus::notRun;
            return;
        }
        m_result.stepsByStage = stepsByGauge(m_project, factorsAt(m_at), m_stop);
        // The criterion over a factor's whole plausible range follows from its error.
        const Identifiability told =
            identifiabilityOf({columns.data(), static_cast<std::size_t>(columns.size())},
                              static_cast<std::size_t>(columns.rows()), m_list, {},
                              [](std::size_t, double) { return true; });
        m_result.condition = told.condition;
        m_result.unidentified = told.unidentified;
        addResiduals();
        if (m_result.unidentified.empty()) {
            addValues(told.covariance);
        }
        if (isLacking()) {
            m_result.status = IdentificationStatus::doesNotFit;
        } else if (!m_result.unidentified.empty()) {
            m_result.status = IdentificationStatus::cannotTell;
        }
    }

    /// The degrees of freedom of the deviations behind the errors of the means.
    [[nodiscard]] double freedom() const {
        double least = std::numeric_limits<double>::infinity();
        for (const PlaceMean& one : m_means) {
            least = one.deviation_um ? std::min(least, one.count - 1) : least;
        }
        return std::isfinite(least) ? std::max(1.0, least) : manyParts;
    }

    /// Tests the model: with more means than parameters, the sum of squared residuals is about the
    /// surplus if the ground cycle is the one that was run.
    [[nodiscard]] bool isLacking() const {
        const auto known = std::ranges::count_if(
            m_list, [](const FittedParameter& one) { return one.prior.has_value(); });
        const double more = static_cast<double>(m_means.size()) + static_cast<double>(known)
                            - static_cast<double>(m_list.size());
        return more > 0 && m_best.criterion / more > fisherQuantile(confidence95, more, freedom());
    }

    void addValues(const std::vector<double>& covariance) {
        const std::size_t count = m_list.size();
        const double t = studentQuantile((1 + confidence95) / 2, freedom());
        const auto errorOf = [&](std::size_t i) { return std::sqrt(covariance[i * count + i]); };
        std::vector<double> wider(count, 1); // ratio of the interval to that of the covariance
        for (std::size_t i = 0; i < count; ++i) {
            FittedValue value{m_list[i], 1, {}, errorOf(i)};
            if (i == m_setting) {
                value.error /= units::umPerMm;
                value.value = setting_mm() + m_best.setting_um / units::umPerMm;
                value.interval95 = {value.value - t * value.error, value.value + t * value.error};
            } else {
                const auto at =
                    static_cast<std::size_t>(std::ranges::find(m_factors, i) - m_factors.begin());
                const Interval found = profileOf(at, t, value.error);
                value.error = (found.high - found.low) / (2 * t);
                wider[i] = value.error / errorOf(i);
                value.value = std::exp(m_at[at]);
                value.interval95 = {std::exp(found.low), std::exp(found.high)};
            }
            m_result.values.push_back(value);
        }
        for (std::size_t i = 0; i < count; ++i) {
            std::vector<double> covariances, correlations;
            for (std::size_t k = 0; k < count; ++k) {
                const auto unit = [this](std::size_t at) {
                    return at == m_setting ? 1 / units::umPerMm : 1;
                };
                const double both = covariance[i * count + k];
                covariances.push_back(both * unit(i) * unit(k) * wider[i] * wider[k]);
                correlations.push_back(both / (errorOf(i) * errorOf(k)));
            }
            m_result.covariance.push_back(std::move(covariances));
            m_result.correlation.push_back(std::move(correlations));
        }
    }

    /// For a single factor the interval outside which no place of the scan has a criterion within
    /// t² of the best; for several factors that of their covariance.
    Interval profileOf(std::size_t at, double t, double error) {
        if (m_factors.size() > 1) {
            return {m_at[at] - t * error, m_at[at] + t * error};
        }
        const double most = m_best.criterion + t * t;
        const auto endTowards = [&](double sign) {
            double inside = m_at[at], outside = sign * range;
            for (int k = 0; k <= scanned; ++k) {
                const Point point = scanPoint(k);
                if (sign * point[0] > sign * inside && criterionAt(point) <= most) {
                    inside = point[0];
                }
            }
            outside = std::clamp(inside + 2 * sign * range / scanned, -range, range);
            while (std::abs(outside - inside) > finest) {
                const double middle = (inside + outside) / 2;
                (criterionAt({middle}) <= most ? inside : outside) = middle;
            }
            return outside;
        };
        return {endTowards(-1), endTowards(1)};
    }

    void addResiduals() {
        FitResiduals residuals{FitSource::parts, -1, {}, 0, {}};
        for (const double left : m_best.left_um) {
            residuals.values.push_back(left);
            residuals.rms += left * left / static_cast<double>(m_best.left_um.size());
        }
        residuals.rms = std::sqrt(residuals.rms);
        m_result.residuals.push_back(std::move(residuals));
    }

    static constexpr int scanned = 40;
    /// Of the logarithms: factors of 20 and 1/20, the widest usual range, and a little more.
    static constexpr double range = 3;
    static constexpr double finest = 0.002, manyParts = 1e6;
    static constexpr std::size_t fewParts = 10;

    const Project& m_project;
    const std::vector<FittedParameter>& m_list;
    const std::stop_token& m_stop;
    std::size_t m_setting;              ///< its index in the list; the size of the list: none
    std::vector<std::size_t> m_factors; ///< indices of the others
    std::vector<PlaceMean> m_means;
    Eigen::MatrixXd m_covariance; ///< covariance of the means, without their variances
    std::map<Point, SizesOverPhases> m_known;
    Meeting m_best;
    Point m_at; ///< coordinates of the best point
    Identification m_result;
};

} // namespace

Identification fitBatch(const Project& project, const IdentificationRequest& request,
                        const std::stop_token& stop) {
    return BatchFit(project, request, stop).fit();
}

} // namespace sparkout
