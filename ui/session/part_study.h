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

/// What a batch or a search of one surface came to.
struct SurfaceStudy {
    enum class Kind { batch, search };
    Kind kind = Kind::batch;
    std::size_t surface = 0;
    bool isSetUp = true; ///< the surface has a batch, if that is asked for
    Issues issues;       ///< with which it, or a surface before it, cannot be run
    BatchOutcomePtr batch;
    SearchOutcomePtr search;
};
using SurfaceStudyPtr = std::shared_ptr<const SurfaceStudy>;

/// What is ticked for the searches of all surfaces; of one that cannot be asked so it is left out.
struct SearchTicks {
    bool phases = false; ///< the answer holds in every phase of the stock
    bool refine = false; ///< goes on between the levels
};

/// The batches or the searches of all surfaces, one after the other in their order, each with the
/// wheel as those before leave it: in a search as the cycles found do.
class PartStudy : public Job {
    Q_OBJECT

public:
    using Job::Job;

    void startBatches(const Setup& setup); ///< counts parts
    /// Counts thousandths of a surface's search; one that has none is searched by a usual one.
    void startSearches(const Setup& setup, SearchTicks ticks = {});

signals:
    void surfaceDone(sparkout::SurfaceStudyPtr study);
    void finished(bool stopped);

private:
    using One = std::function<void(SurfaceStudy&, Setup&, const Project&, const Means&)>;
    void runAll(const Setup& setup, SurfaceStudy::Kind kind, std::int64_t parts, One one);
};

} // namespace sparkout
