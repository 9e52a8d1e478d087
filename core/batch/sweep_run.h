// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/sweep.h"
#include "core/result.h"
#include "core/simulation/result.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

/// Repeats a cycle with one or two varied inputs, to show their effect on every result.

namespace sparkout {

/// A quantity reported for every point, of a zone or section or of the whole part.
struct SweepQuantity {
    std::string name; ///< "time", "least_margin", "diameter", "peak_normal_force", "peak_power", or
                      ///< that of the requirement
    std::string unit; ///< s, %, µm, N, kW …
    Zone zone = Zone::section;
    int section = -1; ///< index of the zone or section; −1: the whole part
    friend bool operator==(const SweepQuantity&, const SweepQuantity&) = default;
};

/// A quantity at a point. Missing values are NaN.
struct SweepValue {
    double value = std::numeric_limits<double>::quiet_NaN();
    double low = std::numeric_limits<double>::quiet_NaN();  ///< limits
    double high = std::numeric_limits<double>::quiet_NaN(); ///< of the drawing, the drives …
    double margin = std::numeric_limits<double>::quiet_NaN();
};

enum class SweepStatus {
    pending,    ///< not run: the sweep was stopped before it
    refused,    ///< the inputs are refused with these values
    notReached, ///< the cycle does not reach size
    done
};

struct SweepPoint {
    SweepStatus status = SweepStatus::pending;
    Issues issues;                        ///< why it is refused
    RunStatus run = RunStatus::completed; ///< the end of the cycle
    bool good = false;                    ///< every requirement is met
    std::vector<SweepValue> values;       ///< by quantity; empty unless done
};

/// A varied input and its values in rising order.
struct SweptInput {
    SweepAxis axis;
    std::string unit;
    std::vector<double> values;
};

/// The result of a sweep, a value with its inputs.
struct SweepResult {
    Project project; ///< the project with its sweep, without kept runs
    std::string engineVersion;
    std::vector<SweptInput> inputs;
    std::vector<SweepQuantity> quantities; ///< all that any point has
    std::vector<SweepPoint> points;        ///< the first input's values, for each of the second's
    bool stopped = false;
    Issues issues; ///< why no point was run, by checkSweep()

    [[nodiscard]] bool ran() const { return issues.empty(); }
    [[nodiscard]] std::size_t index(std::size_t first, std::size_t second = 0) const {
        return second * inputs.front().values.size() + first;
    }
    /// The values of the inputs at a point.
    [[nodiscard]] std::vector<double> valuesAt(std::size_t point) const;
};

struct SweepOptions {
    int threads = 0; ///< 0: as many as the processor runs at once
    std::stop_token stop;
    std::atomic<std::int64_t>* done = nullptr; ///< number of finished points during the run
};

/// The faults that prevent the sweep of a project; refused inputs are found only at each point.
[[nodiscard]] Issues checkSweep(const Project& project);

/// The values of a varied input: both ends as given, those between rounded to ten digits, each
/// whole number once.
[[nodiscard]] std::vector<double> sweepValues(const SweepAxis& axis, bool integer);

/// The number of points of a project's sweep; 0 without one.
[[nodiscard]] std::int64_t pointsOf(const Project& project);

/// Gives a project these values of varied inputs. With another wheel diameter V_k follows from the
/// machine's drive (changeWheelDiameter), unless V_k itself is varied.
void putSweptValues(Project& project, const std::vector<SweepAxis>& axes,
                    const std::vector<double>& values);

/// Runs a sweep; refuses one that fails checkSweep(). The result is independent of the number of
/// threads, bit for bit: each point is the run of the project with its values. A stop request ends
/// it within a revolution of each thread and keeps the finished points.
[[nodiscard]] SweepResult runSweep(const Project& project, const SweepOptions& options = {});

/// A point with its quantities, before they are aligned with those of all points.
struct MeasuredPoint {
    SweepPoint point;
    std::vector<SweepQuantity> quantities;
};

/// Everything a sweep reports of one run.
[[nodiscard]] MeasuredPoint measurePoint(const SimulationResult& result);

// The readable results of a sweep.

/// A quantity at a point.
struct SweepFigure {
    const SweepQuantity& quantity;
    const SweepValue& value;
};

[[nodiscard]] std::span<const Output<SweepResult>> sweepOutputs();
[[nodiscard]] std::span<const Output<SweptInput>> sweptInputOutputs();
[[nodiscard]] std::span<const Output<SweepPoint>> sweepPointOutputs();
[[nodiscard]] std::span<const Output<SweepFigure>> sweepFigureOutputs();

/// The key in files and on the command line: "cannot_reach_size".
[[nodiscard]] const char* sweepStatusKey(SweepStatus status);

/// The object of `sweep --json`, which words faults by `sentence`.
[[nodiscard]] std::string sweepJson(const SweepResult& sweep,
                                    std::string (*sentence)(const Issue& issue));

/// Quantities of one name, of all zones or of one.
struct SweepEntry {
    std::string key; ///< "radial_runout", "radial_runout 1"
    std::vector<std::size_t> quantities;
};

/// The entries of a sweep, in its order; `each`: also every zone separately.
[[nodiscard]] std::vector<SweepEntry> sweepEntries(const SweepResult& sweep, bool each);

/// The quantity of an entry with the least margin at a point, without limits the greatest value;
/// empty if the point has none.
[[nodiscard]] std::optional<std::size_t> worstAt(const SweepPoint& point, const SweepEntry& entry);

/// Whether every point was run and all have the same results as the first.
[[nodiscard]] bool changesNothing(const SweepResult& sweep);

} // namespace sparkout
