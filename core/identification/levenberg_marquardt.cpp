// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/levenberg_marquardt.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>
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

} // namespace sparkout
