// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"
#include "core/study/search.h"
#include "core/study/whole_batch.h"
#include "ui/session/job.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace sparkout {

/// Result of a batch or a search of one surface.
struct SurfaceStudy {
    enum class Kind { batch, search };
    Kind kind = Kind::batch;
    std::size_t surface = 0;
    bool isSetUp = true; ///< for a batch: the surface has one
    Issues issues;       ///< faults with which it, or an earlier surface, cannot be run
    BatchOutcomePtr batch;
    SearchOutcomePtr search;
};
using SurfaceStudyPtr = std::shared_ptr<const SurfaceStudy>;

/// Options ticked for the searches of all surfaces; an option that does not apply to a surface is
/// ignored there.
struct SearchTicks {
    bool phases = false; ///< the answer must be fit for any stock within one infeed
    bool refine = false; ///< refine the answer between the levels
};

/// The batches or the searches of all surfaces in their order, each with the wheel in the state
/// left by the earlier ones; in a search by the cycles found for them.
class PartStudy : public Job {
    Q_OBJECT

public:
    using Job::Job;

    void startBatches(const Setup& setup); ///< counts parts
    /// Starts the searches and counts thousandths of each; a surface without a search gets the
    /// usual one.
    void startSearches(const Setup& setup, SearchTicks ticks = {});

signals:
    void surfaceDone(sparkout::SurfaceStudyPtr study);
    void finished(bool stopped);

private:
    using One = std::function<void(SurfaceStudy&, Setup&, const Project&, const Means&)>;
    void runAll(const Setup& setup, SurfaceStudy::Kind kind, std::int64_t parts, One one);
};

} // namespace sparkout
