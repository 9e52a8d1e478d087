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
    std::int64_t parts = 0; ///< number of parts; running ends once too many are bad
    std::int64_t bad = 0;
    std::optional<Project> worst; ///< the bad one with the least margin, as run
    bool isGood = false;          ///< no more are bad than the batch allows
};

/// Runs parts of a project's batch with a change of the project, to check remedies.
class RemedyParts {
public:
    /// Number of parts taken from a larger batch, spread over it.
    static constexpr std::int64_t mostParts = 128;

    /// Has no parts for a project without a batch, or with an invalid one.
    explicit RemedyParts(Project project);

    [[nodiscard]] bool isEmpty() const { return m_parts.empty(); }
    /// A change of a part.
    using Change = std::function<Project(Project)>;
    /// Runs the parts of the batch, first those that were bad last time. Empty after a stop.
    [[nodiscard]] std::optional<RunParts> run(const Change& change, const std::stop_token& stop);
    /// Runs the parts of withFreshParts(), different ones for every `draw`. Empty after a stop.
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
