// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/trial_design.h"

#include "core/measured/cycle_response.h"
#include "core/measured/fit_data.h"
#include "core/measured/fit_problem.h"
#include "core/measured/identifiability.h"
#include "core/process/force.h"
#include "core/process/system_compliance.h"
#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/measured.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/sweep.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

constexpr double feedFactors[] = {1.0 / 3, 1, 3};
constexpr double shareOfStock = 0.8; ///< fed in a trial, which ends above size
constexpr double normal95 = 1.959963984540054;
constexpr double machineShare = 0.01; ///< estimated repeatability of a machine's feed and speed

Eigen::Index numbered(std::size_t i) {
    return static_cast<Eigen::Index>(i);
}

/// Steps of a spark-out until a twentieth of the steady deflection at this infeed is left, at the
/// most compliant place: a + α·a + β·√a = previous deflection [MODEL-3].
int settlingSteps(const Project& project, double infeed_mm) {
    constexpr double share = 1.0 / 20;
    constexpr int fewest = 3, most = 200;
    const Stage& stage = project.cycle->stages.front();
    const double width =
        project.operation->axial()
            ? std::min(stage.axial_feed_mm_min.value_or(0) / project.machine->work_speed_rpm,
                       project.wheel->width_mm)
            : project.part->length_mm;
    const ForceLaw law = forceLaw(project);
    double gamma = 0;
    for (const CompliantPoint& point : compliantPoints(project)) {
        gamma = std::max(gamma, point.gamma_mm_n);
    }
    const double A = 1 + gamma * width * law.ks, C = gamma * width * law.kr;
    double left = gamma * law.normal(width, std::sqrt(infeed_mm));
    // with a threshold the part above γ·b·F'_0, which remains
    const double wanted = law.threshold ? C + share * (left - C) : share * left;
    int steps = 0;
    for (; left > wanted && steps < most; ++steps) {
        if (law.threshold) {
            left -= std::max(0.0, left - C) / A;
            continue;
        }
        const double root = 2 * left / (C + std::sqrt(C * C + 4 * A * left));
        left -= root * root;
    }
    return std::max(steps, fewest);
}

bool records(TrialRecord record, FitSource source) {
    switch (record) {
    case TrialRecord::size: return source == FitSource::size;
    case TrialRecord::power: return source == FitSource::power;
    case TrialRecord::sizeAndPower: return source == FitSource::size || source == FitSource::power;
    case TrialRecord::force: return source == FitSource::force;
    case TrialRecord::count_: break;
    }
    return false;
}

/// Traces in the form of a trial's record; derivatives do not depend on their values.
FitData plannedData(const CycleResponse& response, TrialRecord record, const TrialNoise& noise) {
    constexpr double before_s = 1; // of the cut, to show the idle power
    FitData data;
    for (const FitSource source : {FitSource::size, FitSource::power, FitSource::force}) {
        if (!records(record, source)) {
            continue;
        }
        FitGroup group;
        group.source = source;
        const double from_s = source == FitSource::size ? 0 : -before_s;
        const auto count =
            static_cast<std::size_t>((response.end_s.back() - from_s) * noise.hertz) + 1;
        for (std::size_t i = 0; i < count; ++i) {
            group.time_s.push_back(from_s + static_cast<double>(i) / noise.hertz);
        }
        group.values.assign(count, 0);
        double force_n = 0;
        for (std::size_t i = 0; i < response.chip_n.size(); ++i) {
            force_n = std::max(force_n, response.chip_n[i] + response.friction_n[i]);
        }
        group.noise = source == FitSource::size    ? noise.size_mm
                      : source == FitSource::power ? noise.power_kw
                                                   : noise.force_share * force_n;
        data.groups.push_back(std::move(group));
    }
    return data;
}

class Designer {
public:
    Designer(const Project& project, const TrialRequest& request, const std::stop_token& stop)
        : m_project(project), m_request(request), m_stop(stop) {}

    TrialDesign design() {
        TrialDesign design;
        if (m_request.parameters.empty() || !areApplicable(m_project, m_request.parameters)) {
            design.status = TrialStatus::notApplicable;
            return design;
        }
        if (hasErrors(validate(m_project)) || m_project.cycle->stages.empty()
            || !m_project.cycle->stages.front().feeds()) {
            return design;
        }
        for (const double factor : feedFactors) {
            for (int s = 0; s < static_cast<int>(TrialSparkOut::count_); ++s) {
                if (m_stop.stop_requested()) {
                    design.status = TrialStatus::stopped;
                    return design;
                }
                addTrials(design.trials, factor, static_cast<TrialSparkOut>(s));
            }
        }
        std::ranges::stable_sort(design.trials, [](const Trial& a, const Trial& b) {
            return std::pair(a.cannotTell.size(), -a.logDeterminant.value_or(0))
                   < std::pair(b.cannotTell.size(), -b.logDeterminant.value_or(0));
        });
        design.status = design.trials.empty() ? TrialStatus::notRun : TrialStatus::designed;
        return design;
    }

private:
    /// For one cycle, which is run once for all kinds of record.
    void addTrials(std::vector<Trial>& trials, double factor, TrialSparkOut sparkOut) {
        const Project project = trialProject(m_project, factor, sparkOut);
        const Stage& stage = project.cycle->stages.front();
        Trial trial;
        trial.feedFactor = factor;
        trial.radialFeed = (stage.*project.operation->radial().value).value_or(0);
        trial.sparkOut = sparkOut;
        const double infeed =
            project.operation.infeed_mm(trial.radialFeed, project.machine->work_speed_rpm);
        const double fed_mm =
            shareOfStock * project.part->stock_mm + factorsOf(project).blankRunout_mm;
        constexpr int fewest = 2, most = 20'000;
        trial.stepsByStage = {
            std::clamp(static_cast<int>(std::min<double>(fed_mm / infeed, most)), fewest, most)};
        if (sparkOut != TrialSparkOut::none) {
            trial.stepsByStage.push_back(
                project.cycle->stages.back().sparkOutSteps().value_or(fewest));
        }
        const CycleResponse response =
            respond(project, factorsOf(project), trial.stepsByStage, false, m_stop);
        if (!response.ran) {
            return;
        }
        trial.duration_s = response.end_s.back();
        for (int r = 0; r < static_cast<int>(TrialRecord::count_); ++r) {
            Trial one = trial;
            one.record = static_cast<TrialRecord>(r);
            expect(one, project, plannedData(response, one.record, m_request.noise));
            trials.push_back(std::move(one));
        }
    }

    /// The parameters of interest, followed by those that the same traces must also determine.
    [[nodiscard]] std::vector<FittedParameter> withNuisances(const FitData& data) const {
        std::vector<FittedParameter> all = m_request.parameters;
        for (const FittedKind kind : proposedParameters(data)) {
            if ((isOfRecorder(kind) || kind == FittedKind::idle_power)
                && std::ranges::find(all, kind, &FittedParameter::kind) == all.end()) {
                all.push_back({kind, {}, {}});
            }
        }
        return all;
    }

    void expect(Trial& trial, const Project& project, const FitData& data) const {
        const std::vector<FittedParameter> all = withNuisances(data);
        FitProblem problem(project, data, all, m_stop);
        problem.setSteps(trial.stepsByStage);
        trial.samples = data.count();
        std::vector<double> q;
        q.reserve(all.size());
        for (const FittedParameter& parameter : all) {
            const FittedKind kind = parameter.kind;
            q.push_back(kind == FittedKind::blank_runout ? FitProblem::coordinateOf(
                            kind, std::max(leastRunout_mm, factorsOf(project).blankRunout_mm))
                        : isLag(kind) ? FitProblem::coordinateOf(kind, startOfLag(all, kind))
                                      : 0);
        }
        std::vector<std::size_t> columns(all.size());
        std::iota(columns.begin(), columns.end(), std::size_t{0});
        std::vector<double> values;
        if (problem.residuals() < all.size() || !derivatives(problem, q, columns, values)) {
            trial.cannotTell = m_request.parameters;
            return;
        }
        evaluate(trial, q,
                 Eigen::Map<const Eigen::MatrixXd>(values.data(), numbered(problem.residuals()),
                                                   numbered(all.size())));
    }

    void evaluate(Trial& trial, const std::vector<double>& q,
                  const Eigen::MatrixXd& jacobian) const {
        const std::vector<FittedParameter>& wanted = m_request.parameters;
        const Eigen::Index count = jacobian.cols(), interest = numbered(wanted.size());
        Eigen::VectorXd lengths = jacobian.colwise().norm();
        const double longest = lengths.maxCoeff();
        std::vector<bool> unknown(wanted.size(), false);
        for (Eigen::Index i = 0; i < count; ++i) {
            if (!(lengths[i] > longest * 1e-12)) {
                lengths[i] = 1;
                if (i < interest) {
                    unknown[static_cast<std::size_t>(i)] = true;
                }
            }
        }
        const Eigen::MatrixXd scaled = jacobian * lengths.cwiseInverse().asDiagonal();
        const Eigen::MatrixXd r = Eigen::HouseholderQR<Eigen::MatrixXd>(scaled)
                                      .matrixQR()
                                      .topRows(count)
                                      .template triangularView<Eigen::Upper>();
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(r, Eigen::ComputeFullV);
        Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const double value = svd.singularValues()[i];
            const Eigen::VectorXd direction = svd.matrixV().col(i);
            if (value * mostCondition < svd.singularValues()[0]) {
                constexpr double leastPart = 0.2;
                for (Eigen::Index k = 0; k < interest; ++k) {
                    const auto place = static_cast<std::size_t>(k);
                    unknown[place] = unknown[place] || std::abs(direction[k]) > leastPart;
                }
                continue;
            }
            const Eigen::VectorXd by = lengths.cwiseInverse().asDiagonal() * direction;
            covariance += by * by.transpose() / (value * value);
        }
        const Eigen::MatrixXd ofInterest = covariance.topLeftCorner(interest, interest);
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const FittedKind kind = wanted[i].kind;
            const double error = std::sqrt(ofInterest(numbered(i), numbered(i)));
            if (unknown[i] || 2 * error > plausible(kind)) {
                trial.cannotTell.push_back(wanted[i]);
                continue;
            }
            // Adds the machine's repeatability to the noise of the record.
            const double wide = normal95 * std::hypot(error, isFactor(kind) ? machineShare : 0.0);
            trial.expected.push_back({wanted[i], error, FitProblem::valueOf(kind, q[i] - wide),
                                      FitProblem::valueOf(kind, q[i] + wide)});
        }
        if (trial.cannotTell.empty()) {
            // ln det through the factor of Cholesky, whose product may leave the range of a double.
            const Eigen::MatrixXd factor = ofInterest.llt().matrixL();
            trial.logDeterminant = -2 * factor.diagonal().array().log().sum();
        }
    }

    [[nodiscard]] static double plausible(FittedKind kind) {
        const bool isRatio = isFactor(kind) || kind == FittedKind::blank_runout;
        const double range = plausibleRange(kind);
        return isRatio ? std::log(range) : FitProblem::coordinateOf(kind, range);
    }

    static constexpr double leastRunout_mm = 1e-4; ///< positive, for its logarithm
    const Project& m_project;
    const TrialRequest& m_request;
    const std::stop_token& m_stop;
};

} // namespace

Project trialProject(const Project& project, double feedFactor, TrialSparkOut sparkOut) {
    Project trial = project;
    trial.runs.clear();
    trial.measured.reset();
    trial.batch.reset();
    trial.optimisation.reset();
    trial.sweep.reset();
    trial.gauge->control = Control::gauge; // the steps of a trial are given
    trial.gauge->datum_mm.reset();
    const StageFeed& radial = trial.operation->radial();
    Stage feeding = project.cycle->stages.front();
    if (auto& feed = feeding.*radial.value) {
        *feed *= feedFactor;
        const auto& range = project.machine->limits.*radial.range;
        if (range && range->size() == 3) {
            *feed = std::clamp(*feed, (*range)[0], (*range)[1]);
        }
    }
    feeding.stock_mm = project.part->stock_mm;
    feeding.dropSparkOut();
    trial.cycle->stages = {feeding};
    if (sparkOut != TrialSparkOut::none) {
        Stage resting = feeding;
        (resting.*radial.value).reset();
        resting.continuous_feed_mm_min.reset();
        resting.stock_mm = 0;
        resting.sparkOutFor(
            settlingSteps(trial, trial.operation.infeed_mm((feeding.*radial.value).value_or(0),
                                                           trial.machine->work_speed_rpm)));
        trial.cycle->stages.push_back(resting);
    }
    return trial;
}

TrialDesign designTrial(const Project& project, const TrialRequest& request,
                        const std::stop_token& stop) {
    return Designer(project, request, stop).design();
}

} // namespace sparkout
