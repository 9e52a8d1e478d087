// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/session/newest_job.h"
#include "ui/views/compliance/coupling_curves.h"
#include "ui/views/compliance/gauge_curves.h"

#include <QObject>

namespace sparkout {

/// Computes in the background what the view "Compliance" shows besides γ: the cycle for each place
/// of the gauge, or with coupled and independent sections. A newer request replaces an older one.
class ComplianceStudies : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void placeGauge(const OutcomePtr& outcome);
    void compareCoupling(const OutcomePtr& outcome); ///< requires a project that can be coupled
    void stop();
    [[nodiscard]] bool running() const { return m_running; }

    static constexpr int places = 41; ///< places of the gauge in plunge

signals:
    void progressed(int done, int total);
    void gaugePlaced(sparkout::GaugePlacementPtr placement, sparkout::OutcomePtr outcome);
    void couplingCompared(sparkout::CouplingPtr comparison, sparkout::OutcomePtr outcome);

private:
    NewestJob m_job;
    bool m_running = false;
};

} // namespace sparkout
