// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/cycle_response.h"
#include "core/measured/fit_data.h"

#include <cstddef>
#include <stop_token>
#include <vector>

namespace sparkout {

/// The factors of the cycle at coordinates q of these parameters, as in FitProblem.
[[nodiscard]] CycleFactors cycleFactors(const Project& project,
                                        const std::vector<FittedParameter>& list,
                                        const std::vector<double>& q);

/// Prior for the lag of a gauge that is not given: gauges filter over 0.05 to 0.3 s, so twice this
/// value is plausible. An estimate.
inline constexpr double usualLag_s = 0.15;

/// Where the search for a lag begins [s]: at 0 a change of it is one of a fitted delay or shift,
/// from which only a greater one differs.
[[nodiscard]] double startOfLag(const std::vector<FittedParameter>& list, FittedKind lag);

/// The residuals of the measured values from the simulated cycle as a function of coordinates q,
/// one for each parameter: the logarithm of a factor or a runout, otherwise the value in its unit.
/// The numbers of steps of the stages are given, so that the function is smooth.
class FitProblem {
public:
    FitProblem(const Project& project, const FitData& data,
               const std::vector<FittedParameter>& parameters, std::stop_token stop = {});

    [[nodiscard]] std::size_t residuals() const { return m_data.count() + m_priors; }
    [[nodiscard]] std::size_t values() const { return m_data.count(); }
    [[nodiscard]] std::size_t parameters() const { return m_parameters.size(); }
    [[nodiscard]] const std::vector<FittedParameter>& list() const { return m_parameters; }

    void setSteps(std::vector<int> stepsByStage);
    [[nodiscard]] const std::vector<int>& steps() const { return m_steps; }
    /// The noise of each group, by which its residuals are divided.
    void setNoise(std::vector<double> noise) { m_noise = std::move(noise); }
    [[nodiscard]] const std::vector<double>& noise() const { return m_noise; }
    /// A weight for each value, for a robust loss; empty: 1.
    void setWeights(std::vector<double> weights) { m_weights = std::move(weights); }
    [[nodiscard]] const std::vector<double>& weights() const { return m_weights; }

    [[nodiscard]] bool isStopped() const { return m_stop.stop_requested(); }

    /// Starting coordinates: factors 1 or their prior values, the others from the data.
    [[nodiscard]] std::vector<double> start();
    /// These coordinates, with the best offset of the sizes, shift and delays for the current
    /// steps, searched over the whole traces.
    [[nodiscard]] std::vector<double> startAt(std::vector<double> q);
    /// False: the cycle cannot be run there, or a stop was requested.
    bool evaluate(const std::vector<double>& q, std::vector<double>& residuals);
    /// Measured less predicted, in the unit of its group, group by group; no priors, no weights.
    bool differences(const std::vector<double>& q, std::vector<double>& values);
    /// The ends of the stages in the time of the traces.
    [[nodiscard]] std::vector<double> stageEnds(const std::vector<double>& q);
    /// The duration of the cycle [s]; 0 if it cannot be run.
    [[nodiscard]] double durationAt(const std::vector<double>& q);
    /// The step for a derivative by a coordinate.
    [[nodiscard]] static double derivativeStep(FittedKind kind);

    [[nodiscard]] static double valueOf(FittedKind kind, double q);
    [[nodiscard]] static double coordinateOf(FittedKind kind, double value);
    [[nodiscard]] CycleFactors factorsAt(const std::vector<double>& q) const {
        return cycleFactors(m_project, m_parameters, q);
    }

private:
    /// The parameters that do not change the cycle.
    struct Scalars {
        double flow = 1, dullness = 1, chipForce = 1, rubbingForce = 1, chip = 1, friction = 1,
               idle_kw = 0, offset_mm = 0, shift_s = 0, powerDelay_s = 0, forceDelay_s = 0,
               lag_s = 0, powerLag_s = 0, forceLag_s = 0, drift_mm_min = 0;
    };
    [[nodiscard]] Scalars scalarsAt(const std::vector<double>& q) const;
    /// Of a signal of the last response behind a lag.
    [[nodiscard]] double lagged(const std::vector<double>& times, const std::vector<double>& values,
                                double time, double lag_s) const;
    [[nodiscard]] double predicted(const FitGroup& group, std::size_t index,
                                   const Scalars& scalars) const;
    bool run(const CycleFactors& factors);
    [[nodiscard]] double startOfIdle() const;
    [[nodiscard]] double startOfOffset(Scalars scalars, double shift_s) const;
    [[nodiscard]] double startOfShift(Scalars scalars) const;
    [[nodiscard]] double startOfDelay(FitSource source, Scalars scalars) const;
    [[nodiscard]] bool has(FittedKind kind) const;
    [[nodiscard]] bool keepsStep(const FitGroup& group) const;

    const Project& m_project;
    const FitData& m_data;
    std::stop_token m_stop;
    std::vector<FittedParameter> m_parameters;
    bool m_hasThreshold; ///< whether the force has a threshold
    std::vector<int> m_steps;
    std::vector<double> m_noise, m_weights;
    std::size_t m_priors = 0;
    bool m_withPlaces = false;
    CycleFactors m_lastFactors; ///< factors of the last response
    CycleResponse m_response;
    bool m_hasResponse = false;
    /// Knots of its signals that lag, which the samples of a trace share.
    struct Lagged {
        const double* of = nullptr;
        double lag_s = 0;
        std::vector<double> knots;
    };
    mutable std::vector<Lagged> m_lagged;
};

/// The minimum of a problem's sum of squared residuals, by the Levenberg–Marquardt method of
/// Eigen's NonLinearOptimization (MINPACK).
struct LeastSquares {
    std::vector<double> q;
    double criterion = 0; ///< sum of the squares
    bool converged = false;
    int evaluations = 0;
};

/// The accuracy of a search: to the last digits, or enough to choose the best of several.
enum class SearchEffort { whole, rough };

/// Starts at given coordinates, of which `fixed` ones are constant. A stop of the problem ends it
/// early.
[[nodiscard]] LeastSquares minimise(FitProblem& problem, const std::vector<double>& start,
                                    const std::vector<bool>& fixed,
                                    SearchEffort effort = SearchEffort::whole);

/// Derivatives of the residuals by the coordinates, by central differences, column after column.
/// False if the cycle cannot be run near q.
bool derivatives(FitProblem& problem, const std::vector<double>& q,
                 const std::vector<std::size_t>& free, std::vector<double>& columns);

enum class RobustLoss { none, huber, tukey };
[[nodiscard]] const char* keyOf(RobustLoss loss); ///< "huber"

/// Roots of the weights ψ(u)/u of residuals in units of their noise, by which the residuals are
/// multiplied in the next step of reweighted least squares: Huber's with 1.345, Tukey's with 4.685,
/// both 95 % efficient for normal noise [HUBER1981].
[[nodiscard]] std::vector<double> robustWeights(const std::vector<double>& residuals,
                                                RobustLoss loss);

} // namespace sparkout
