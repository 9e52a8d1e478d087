// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feeds/trace_comparer.h"

#include <utility>

namespace sparkout {

TraceComparer::TraceComparer(QObject* parent) : QObject(parent) {}

void TraceComparer::compare(const OutcomePtr& outcome) {
    m_running = true;
    m_job.start([this, outcome](const std::stop_token& stop, const NewestJob::Post& post) {
        auto traces = std::make_shared<std::vector<TraceComparison>>(
            compareTraces(outcome->result.project, outcome->result.countsByStage, stop));
        post([this, outcome, found = TraceComparisonsPtr(std::move(traces))] {
            m_running = false;
            emit compared(found, outcome);
        });
    });
}

void TraceComparer::drop() {
    m_running = false;
    m_job.stop();
}

} // namespace sparkout
