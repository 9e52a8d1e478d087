// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/characteristics.h"

#include <condition_variable>
#include <map>
#include <mutex>
#include <stop_token>
#include <utility>

namespace sparkout {

/// Restores the order of parts that several threads run, for a sink. It holds few of them: a thread
/// far ahead of the slowest part waits.
class PartQueue {
public:
    /// `first` is the place of the first part.
    PartQueue(const PartSink& sink, std::int64_t first, std::stop_token stop)
        : m_sink(sink), m_next(first), m_stop(std::move(stop)) {}

    /// False if the sink wants no more, or a stop was requested.
    bool put(std::int64_t place, PartRecord record);

private:
    const PartSink& m_sink;
    std::mutex m_mutex;
    std::condition_variable_any m_moved;
    std::map<std::int64_t, PartRecord> m_waiting; ///< waiting parts by place
    std::int64_t m_next;
    std::stop_token m_stop;
    bool m_over = false;
};

} // namespace sparkout
