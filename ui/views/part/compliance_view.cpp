// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part/compliance_view.h"

#include "core/project/gauge.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_cursors.h"
#include "ui/kit/tool_row.h"
#include "ui/text/names.h"
#include "ui/views/part/compliance_plot.h"

#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
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

ComplianceView::ComplianceView(QWidget* parent, Settings* settings)
    : PlotView(QStringLiteral("compliance"), parent, settings)
    , m_plot(new CompliancePlot(this))
    , m_summary(new QLabel(this))
    , m_content(new QComboBox(this))
    , m_put(new QPushButton(this))
    , m_studies(new ComplianceStudies(this)) {
    addPlot(*m_plot);
    addCursors(*m_plot);
    hideUntilDrawn({m_plot});
    setUpNotice(*m_summary);
    auto* bar = new QWidget(this);
    buildTools(bar);
    addColumn({bar, m_summary, notice(), legend(), m_plot, strip(), values()}, m_plot)
        ->addStretch();
    nameObjects({{m_plot, "compliancePlot"},
                 {m_summary, "complianceSummary"},
                 {m_content, "complianceContent"},
                 {m_put, "putGauge"}});
    buildStudies();
    built();
}

void ComplianceView::buildStudies() {
    connect(m_content, &QComboBox::currentIndexChanged, this, &ComplianceView::chooseContent);
    connect(m_put, &QPushButton::clicked, this, [this] {
        if (canPutGauge()) {
            emit gaugeWanted(m_plot->gauge().best()->position_mm);
        }
    });
    connect(m_studies, &ComplianceStudies::progressed, this, [this](int done, int total) {
        m_done = done;
        m_total = total;
        m_summary->setText(summary());
    });
    connect(m_studies, &ComplianceStudies::gaugePlaced, this,
            [this](const GaugePlacementPtr& placement, const OutcomePtr& of) {
                m_plot->setGauge(placement, of);
                showStudy(of);
            });
    connect(m_studies, &ComplianceStudies::couplingCompared, this,
            [this](const CouplingPtr& comparison, const OutcomePtr& of) {
                m_plot->setCoupling(comparison);
                showStudy(of);
            });
}

void ComplianceView::chooseContent() {
    m_plot->setContent(static_cast<ComplianceContent>(m_content->currentIndex()));
    m_fitNext = true;
    m_studied.reset();
    ask();
    showState();
    replotAll();
}

void ComplianceView::ask() {
    m_done = m_total = 0;
    const ComplianceContent content = m_plot->content();
    if (!good() || content == ComplianceContent::compliance) {
        m_studies->stop();
    } else if (content == ComplianceContent::gauge) {
        m_studies->placeGauge(good());
    } else if (couplingOf(good()->result.project) == CouplingAnswer::comparable) {
        m_studies->compareCoupling(good());
    } else {
        m_studies->stop();
        m_plot->setCoupling(nullptr);
    }
}

void ComplianceView::showStudy(const OutcomePtr& of) {
    m_studied = of;
    if (m_fitNext) {
        m_fitNext = false;
        m_plot->fitValues();
    }
    m_plot->refitValues();
    showLegend();
    showState();
    replotAll();
    emit updated();
}

bool ComplianceView::studied() const {
    return good() && m_studied == good();
}

bool ComplianceView::canPutGauge() const {
    if (m_plot->content() != ComplianceContent::gauge || !studied() || !latest()
        || latest() != good() || !m_plot->gauge().best()) {
        return false;
    }
    const Project& project = good()->result.project;
    return !project.operation->travels && project.gauge->control == Control::gauge
           && project.gauge->position_mm != m_plot->gauge().best()->position_mm;
}

void ComplianceView::buildTools(QWidget* bar) {
    auto* row = rowIn<ToolRow>(bar);
    row->addWidget(m_content);
    row->addWidget(m_put);
    row->addStretch(1);
    addButtons(*row, {cursors()->toggle, tools()->fit});
}

QString ComplianceView::title() const {
    return tr("Compliance");
}

void ComplianceView::takeOutcome(const OutcomePtr&) {
    m_plot->setRun(good());
    ask();
}

void ComplianceView::dropOutcome() {
    m_studied.reset();
    ask();
}

bool ComplianceView::drawn() const {
    return good()
           && (m_plot->content() != ComplianceContent::coupling
               || couplingOf(good()->result.project) == CouplingAnswer::comparable);
}

void ComplianceView::showState() {
    PlotView::showState();
    m_summary->setVisible(good() != nullptr);
    m_content->setVisible(good() != nullptr);
    m_put->setVisible(good() && m_plot->content() == ComplianceContent::gauge);
    m_put->setEnabled(canPutGauge());
    m_summary->setText(summary());
}

QString ComplianceView::remark() const {
    const Project& project = good()->result.project;
    switch (m_plot->content()) {
    case ComplianceContent::compliance:
        return m_plot->gamma().places().empty()
                   ? tr("The compliance is given, zone by zone or section by section. Choose “from "
                        "stiffness and shaft” on the page Machine to see its components.")
                   : QString();
    case ComplianceContent::gauge:
        if (project.gauge->control == Control::position) {
            return tr("Stages end by the position of the wheel head: the position of the gauge has "
                      "no effect.");
        }
        return project.operation->travels ? tr("In traverse grinding the gauge is in the middle of "
                                               "%1. The curves show its effect in another zone.")
                                                .arg(Names::zone(Zone::nz))
                                          : QString();
    case ComplianceContent::coupling: break;
    }
    switch (couplingOf(project)) {
    case CouplingAnswer::traverse:
        return tr("Sections are coupled in plunge grinding only: there the wheel touches all of "
                  "them at once.");
    case CouplingAnswer::givenCompliance:
        return tr(
            "The compliance is given section by section, which does not determine how a force in "
            "one section deflects another. Choose “from stiffness and shaft” on the page Machine.");
    case CouplingAnswer::comparable: break;
    }
    return {};
}

QString ComplianceView::summary() const {
    if (!good()) {
        return {};
    }
    const ComplianceContent content = m_plot->content();
    if (content == ComplianceContent::compliance) {
        return complianceSummary();
    }
    if (m_studies->running()) {
        return m_total > 0 ? tr("Computing… %1 of %2").arg(m_done).arg(m_total) : tr("Computing…");
    }
    if (!studied()) {
        return {};
    }
    return content == ComplianceContent::gauge ? gaugeSummary() : m_plot->coupling().summary();
}

QString ComplianceView::gaugeSummary() const {
    const GaugeCurves& gauge = m_plot->gauge();
    const GaugePosition* best = gauge.best();
    if (!best) {
        return tr("The cycle does not reach size with the gauge in any place.");
    }
    const QString place = best->zone == Zone::section
                              ? tr("%1 mm").arg(QLocale().toString(best->position_mm, 'f', 1))
                              : Names::zone(best->zone);
    return tr("Best place: %1; there all diameters are within %2 µm of the middle of the tolerance "
              "band. Current place, %3 mm: %4 µm.")
        .arg(place, Names::micrometres(gauge.farthest_um(*best)),
             QLocale().toString(m_plot->gaugePlace_mm(), 'f', 1),
             Names::micrometres(gauge.farthestNow_um()));
}

/// Explains which zone stays larger.
QString ComplianceView::complianceSummary() const {
    const auto& sections = good()->result.sections;
    const auto [low, high] =
        std::ranges::minmax_element(sections, {}, &SectionResult::compliance_mm_per_n);
    if (high->compliance_mm_per_n <= low->compliance_mm_per_n) {
        return tr("Uniform along the length.");
    }
    const auto name = [&](auto it) {
        return Names::zone(it->zone, static_cast<int>(it - sections.begin()));
    };
    return tr("%1 yields %2 times as much as %3.")
        .arg(name(high), Names::significant(high->compliance_mm_per_n / low->compliance_mm_per_n),
             Names::within(name(low)));
}

void ComplianceView::nameParts() {
    nameAround(tr("Legend of the curves"), tr("State of the curves"), tr("Values under the mouse"));
    m_plot->setAccessibleName(tr("Compliance along the part"));
    m_summary->setAccessibleName(tr("Most compliant place"));
    fillChoice(*m_content, {tr("Compliance along the part"), tr("Position of the gauge"),
                            tr("Coupled against independent sections")});
    tell(*m_content, tr("Curves below the part"));
    m_put->setText(tr("Put the gauge there"));
    m_put->setAccessibleName(m_put->text());
    m_put->setToolTip(tr("Sets the gauge's free position to the best place; can be undone"));
}

QString ComplianceView::hint() const {
    return tr("Point at the curve to read the values.");
}

} // namespace sparkout
