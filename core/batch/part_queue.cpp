// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/part_queue.h"

#include <utility>

namespace sparkout {

bool PartQueue::put(std::int64_t place, PartRecord record) {
    constexpr std::int64_t most = 1024; // parts ahead of the slowest
    std::unique_lock lock(m_mutex);
    m_moved.wait(lock, m_stop, [&] { return m_over || place - m_next < most; });
    if (m_over || m_stop.stop_requested()) {
        return false;
    }
    m_waiting.emplace(place, std::move(record));
    bool moved = false;
    for (auto next = m_waiting.find(m_next); next != m_waiting.end();
         next = m_waiting.find(++m_next)) {
        m_over = m_over || !m_sink(next->second);
        m_waiting.erase(next);
        moved = true;
    }
    if (moved) {
        m_moved.notify_all();
    }
    return !m_over;
}

} // namespace sparkout
