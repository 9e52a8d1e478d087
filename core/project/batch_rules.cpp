// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/batch_rules.h"

#include "core/cholesky.h"
#include "core/project/batch.h"
#include "core/project/given_factors.h"
#include "core/project/machine.h"
#include "core/project/validate.h"

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

} // namespace sparkout
