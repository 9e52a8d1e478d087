// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Parts of a batch that were run with a changed setting.
struct RunParts {
    std::int64_t parts = 0; ///< that there are to run; no more are run once too many are bad
    std::int64_t bad = 0;
    std::optional<Project> worst; ///< the bad one of the least margin, as it was run
    bool isGood = false;          ///< no more are bad than the batch allows
};

/// Runs parts of a project's batch with something of the project changed: how remedies are held
/// against it.
class RemedyParts {
public:
    /// Of a batch with more parts so many are taken, spread over it.
    static constexpr std::int64_t mostParts = 128;

    /// No part of a project without a batch, or of one whose batch cannot be run.
    explicit RemedyParts(Project project);

    [[nodiscard]] bool isEmpty() const { return m_parts.empty(); }
    /// What is changed of a part.
    using Change = std::function<Project(Project)>;
    /// The parts of the batch; those that were bad last come first. Nothing: it was stopped.
    [[nodiscard]] std::optional<RunParts> run(const Change& change, const std::stop_token& stop);
    /// Those of withFreshParts(), other ones for every `draw`. Nothing: it was stopped.
    [[nodiscard]] std::optional<RunParts> runFresh(const Change& change, int draw,
                                                   const std::stop_token& stop) const;

private:
    [[nodiscard]] bool isTooMany(const RunParts& run) const;

    Project m_project; ///< with its batch
    std::vector<Project> m_parts;
    std::vector<std::size_t> m_order;
    double m_allowedShare = 0;
};

} // namespace sparkout
