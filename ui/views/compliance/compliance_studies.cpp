// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/compliance_studies.h"

#include <utility>

namespace sparkout {

void ComplianceStudies::placeGauge(const OutcomePtr& outcome) {
    m_running = true;
    m_job.start([this, outcome](const std::stop_token& stop, const NewestJob::Post& post) {
        const Project& project = outcome->result.project;
        const auto progress = [&](std::size_t done, std::size_t total) {
            post([this, done, total] { emit progressed(int(done), int(total)); });
        };
        auto placement = std::make_shared<GaugePlacement>(
            sparkout::placeGauge(project, gaugeCandidates(project, places), progress, stop));
        post([this, placement = GaugePlacementPtr(std::move(placement)), outcome] {
            m_running = false;
            emit gaugePlaced(placement, outcome);
        });
    });
}

void ComplianceStudies::compareCoupling(const OutcomePtr& outcome) {
    m_running = true;
    m_job.start([this, outcome](const std::stop_token& stop, const NewestJob::Post& post) {
        auto comparison = std::make_shared<CouplingComparison>(
            sparkout::compareCoupling(outcome->result.project, stop));
        post([this, comparison = CouplingPtr(std::move(comparison)), outcome] {
            m_running = false;
            emit couplingCompared(comparison, outcome);
        });
    });
}

void ComplianceStudies::stop() {
    m_running = false;
    m_job.stop();
}

} // namespace sparkout
