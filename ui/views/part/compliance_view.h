// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/chart/plot_view.h"
#include "ui/session/job.h"
#include "ui/views/part/compliance_curves.h"

#include <QObject>

class QLabel;
class QPushButton;

namespace sparkout {

class CompliancePlot;

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

/// The view "Compliance": the part on its supports, to scale, and the compliance along it by its
/// parts; or the best place of the gauge, or the effect of coupled sections.
class ComplianceView : public PlotView {
    Q_OBJECT
public:
    explicit ComplianceView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] CompliancePlot* plot() const { return m_plot; }
    [[nodiscard]] QString title() const override;

signals:
    void gaugeWanted(double position_mm); ///< position from the headstock end of the ground length

protected:
    [[nodiscard]] QString hint() const override;
    void nameParts() override;
    void takeOutcome(const OutcomePtr& before) override;
    void dropOutcome() override;
    [[nodiscard]] bool drawn() const override;
    void showState() override;
    [[nodiscard]] QString remark() const override;
    [[nodiscard]] QStringList subheading() const override { return {summary()}; }

private:
    void buildTools(QWidget* bar);
    void buildStudies();
    void chooseContent();
    void ask(); ///< requests what the content needs besides the run
    void showStudy(const OutcomePtr& of);
    [[nodiscard]] QString summary() const;
    [[nodiscard]] QString complianceSummary() const;
    [[nodiscard]] QString gaugeSummary() const;
    [[nodiscard]] bool studied() const; ///< whether the studies belong to the shown run
    [[nodiscard]] bool canPutGauge() const;

    CompliancePlot* m_plot;
    QLabel* m_summary;
    QComboBox* m_content;
    QPushButton* m_put;
    ComplianceStudies* m_studies;
    OutcomePtr m_studied; ///< run of the shown diameters
    int m_done = 0, m_total = 0;
    bool m_fitNext = false; ///< fit the view at the next result
};

} // namespace sparkout
