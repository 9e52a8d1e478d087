// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/run_recall.h"

#include <algorithm>

namespace sparkout {

const RecalledRun* RunRecall::find(const std::string& inputs) const {
    const auto found = m_runs.find(inputs);
    return found == m_runs.end() ? nullptr : &found->second;
}

bool RunRecall::isOpen(const std::string& inputs) const {
    const RecalledRun* run = find(inputs);
    return !run || (run->summary && !run->feeds && m_wanted.contains(inputs));
}

void RunRecall::setRuns(std::set<std::string> all, std::set<std::string> wanted) {
    m_all = std::move(all);
    m_wanted = std::move(wanted);
    std::erase_if(m_runs, [this](const auto& run) { return !m_all.contains(run.first); });
    for (auto& [inputs, run] : m_runs) {
        if (!m_wanted.contains(inputs)) {
            run.feeds.reset(); // limits the memory of a hundred kept runs
        }
    }
    std::vector<std::string> open; // drawn ones come first
    std::ranges::copy_if(m_all, std::back_inserter(open),
                         [this](const std::string& inputs) { return isOpen(inputs); });
    std::stable_partition(open.begin(), open.end(),
                          [this](const std::string& inputs) { return m_wanted.contains(inputs); });
    const bool underWay = std::ranges::all_of(
        open, [this](const std::string& inputs) { return m_pending.contains(inputs); });
    if (underWay) {
        return;
    }
    m_pending = {open.begin(), open.end()};
    m_job.start([this, open](const std::stop_token& stop, const NewestJob::Post& post) {
        for (const std::string& inputs : open) {
            RecalledRun run = recallRun(inputs, stop);
            if (stop.stop_requested()) {
                return;
            }
            post([this, inputs, run = std::move(run)] { take(inputs, run); });
        }
    });
}

void RunRecall::take(const std::string& inputs, RecalledRun run) {
    m_pending.erase(inputs);
    if (!m_all.contains(inputs)) {
        return; // deleted meanwhile
    }
    if (!m_wanted.contains(inputs)) {
        run.feeds.reset();
    }
    m_runs[inputs] = std::move(run);
    emit recalled(inputs);
}

} // namespace sparkout
