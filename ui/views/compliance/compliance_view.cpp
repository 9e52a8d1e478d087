// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/compliance_view.h"

#include "ui/kit/metrics.h"
#include "ui/plot/cursor_strip.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_tools.h"
#include "ui/text/names.h"
#include "ui/views/compliance/compliance_plot.h"
#include "ui/views/compliance/compliance_studies.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

ComplianceView::ComplianceView(QWidget* parent, Settings* settings)
    : View(parent)
    , m_plot(new CompliancePlot(this))
    , m_legend(new LegendStrip(this))
    , m_summary(new QLabel(this))
    , m_notice(new QLabel(this))
    , m_values(new QLabel(this))
    , m_content(new QComboBox(this))
    , m_put(new QPushButton(this))
    , m_studies(new ComplianceStudies(this)) {
    setObjectName(QStringLiteral("compliance"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    layout->setSpacing(metrics::tight);
    auto* bar = new QWidget(this);
    buildTools(bar, settings);
    setUpNotice(*m_summary);
    setUpNotice(*m_notice);
    setUpReadout(*m_values);
    layout->addWidget(bar);
    layout->addWidget(m_summary);
    layout->addWidget(m_notice);
    layout->addWidget(m_legend);
    layout->addWidget(m_plot, 1);
    layout->addWidget(m_strip);
    layout->addWidget(m_values);
    m_plot->setObjectName(QStringLiteral("compliancePlot"));
    m_legend->setObjectName(QStringLiteral("complianceLegend"));
    m_notice->setObjectName(QStringLiteral("complianceNotice"));
    m_values->setObjectName(QStringLiteral("complianceValues"));
    m_summary->setObjectName(QStringLiteral("complianceSummary"));
    connect(m_plot, &CompliancePlot::contentChanged, this,
            [this] { m_legend->setEntries(m_plot->legendEntries()); });
    connect(m_plot, &CompliancePlot::pointed, this, &ComplianceView::readOut);
    connect(m_legend, &LegendStrip::toggled, m_plot, &CompliancePlot::toggleCurve);
    connect(m_legend, &LegendStrip::onlyAsked, m_plot, &CompliancePlot::showOnly);
    buildStudies();
    built();
}

void ComplianceView::buildStudies() {
    m_content->setObjectName(QStringLiteral("complianceContent"));
    m_put->setObjectName(QStringLiteral("putGauge"));
    for (int i = 0; i < 3; ++i) {
        m_content->addItem(QString());
    }
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
                m_plot->gauge().show(placement, of, m_plot->gaugePlace_mm());
                showStudy(of);
            });
    connect(m_studies, &ComplianceStudies::couplingCompared, this,
            [this](const CouplingPtr& comparison, const OutcomePtr& of) {
                m_plot->coupling().show(comparison);
                showStudy(of);
            });
}

void ComplianceView::chooseContent() {
    m_plot->setContent(static_cast<ComplianceContent>(m_content->currentIndex()));
    m_fitNext = true;
    m_studied.reset();
    ask();
    showState();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
    m_tools->navigation().amendView();
}

void ComplianceView::ask() {
    m_done = m_total = 0;
    const ComplianceContent content = m_plot->content();
    if (!m_good || content == ComplianceContent::compliance) {
        m_studies->stop();
    } else if (content == ComplianceContent::gauge) {
        m_studies->placeGauge(m_good);
    } else if (couplingOf(m_good->result.project) == CouplingAnswer::comparable) {
        m_studies->compareCoupling(m_good);
    } else {
        m_studies->stop();
        m_plot->coupling().show(nullptr);
        m_legend->setEntries(m_plot->legendEntries());
    }
}

void ComplianceView::showStudy(const OutcomePtr& of) {
    m_studied = of;
    if (m_fitNext) {
        m_fitNext = false;
        m_plot->fitValues();
    }
    m_plot->refitValues();
    m_legend->setEntries(m_plot->legendEntries());
    showState();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
    m_tools->navigation().amendView();
    emit updated();
}

bool ComplianceView::studied() const {
    return m_good && m_studied == m_good;
}

bool ComplianceView::canPutGauge() const {
    if (m_plot->content() != ComplianceContent::gauge || !studied() || !latest()
        || latest() != m_good || !m_plot->gauge().best()) {
        return false;
    }
    const Project& project = m_good->result.project;
    return !project.operation->hasZones && project.gauge.control == Control::gauge
           && project.gauge.position_mm != m_plot->gauge().best()->position_mm;
}

void ComplianceView::buildTools(QWidget* bar, Settings* settings) {
    PlotSubject subject;
    subject.heading = [this] {
        QStringList heading{title()};
        if (m_good) {
            heading << QString::fromStdString(m_good->result.project.title).simplified()
                    << summary();
        }
        heading.removeAll(QString());
        return heading;
    };
    subject.legend = [this] { return m_plot->legendEntries(); };
    subject.table = [this] { return m_plot->table(); };
    subject.restyle = [this] { m_plot->restyle(); };
    subject.navigation.fit = [this] { m_plot->fit(); };
    subject.navigation.axes = [this](QCPAxisRect& rect) { return m_plot->movedAxes(rect); };
    m_tools = new PlotTools(*m_plot, std::move(subject));
    m_tools->setSettings(settings);
    m_cursors = new PlotCursors(*m_plot, m_plot->cursorSubject());
    m_strip = new CursorStrip(*m_cursors, this);
    m_tools->addTool(m_cursors->toggle);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(m_content);
    row->addWidget(m_put);
    row->addStretch(1);
    row->addWidget(PlotTools::button(m_cursors->toggle, bar));
    row->addWidget(PlotTools::button(m_tools->fit, bar));
    row->addWidget(m_tools->exportButton(bar));
}

QString ComplianceView::title() const {
    return tr("Compliance");
}

void ComplianceView::showOutcome() {
    const bool ran = latest() && latest()->ran() && !latest()->result.sections.empty();
    if (ran) {
        m_good = latest();
        m_plot->setRun(m_good);
        ask();
    }
    m_plot->setDimmed(m_good && !ran);
    showState();
    m_plot->replot();
    m_tools->navigation().amendView();
    emit updated();
}

void ComplianceView::showState() {
    const QString text = notice();
    m_notice->setText(text);
    m_notice->setVisible(!text.isEmpty());
    const bool comparable =
        m_good && couplingOf(m_good->result.project) == CouplingAnswer::comparable;
    const bool drawn = m_good && (m_plot->content() != ComplianceContent::coupling || comparable);
    for (QWidget* part : std::initializer_list<QWidget*>{m_plot, m_legend, m_values}) {
        part->setVisible(drawn);
    }
    m_summary->setVisible(m_good != nullptr);
    m_content->setVisible(m_good != nullptr);
    m_put->setVisible(m_good && m_plot->content() == ComplianceContent::gauge);
    m_put->setEnabled(canPutGauge());
    m_summary->setText(summary());
    m_tools->setEnabled(drawn);
}

QString ComplianceView::notice() const {
    if (latest() && !latest()->ran()) {
        return (m_good
                    ? tr("The inputs are refused; the curves are those of the last accepted ones.")
                    : tr("The inputs are refused:"))
               + QLatin1Char('\n') + Names::refusal(latest()->issues, 2);
    }
    if (!m_good) {
        return tr("No result yet.");
    }
    const Project& project = m_good->result.project;
    switch (m_plot->content()) {
    case ComplianceContent::compliance:
        return m_plot->places().empty() ? tr(
                   "The compliance is given, zone by zone or section by section. Choose \"from "
                   "stiffness and shaft\" on the page Machine to see what it is made of.")
                                        : QString();
    case ComplianceContent::gauge:
        if (project.gauge.control == Control::position) {
            return tr("Stages end by the position of the wheel head: the gauge has no say, and all "
                      "its places are alike.");
        }
        return project.operation->hasZones
                   ? tr("In traverse grinding the gauge stands in the middle of %1. The curves say "
                        "what it would do in another zone.")
                         .arg(Names::zone(Zone::nz))
                   : QString();
    case ComplianceContent::coupling: break;
    }
    switch (couplingOf(project)) {
    case CouplingAnswer::traverse:
        return tr("Sections are coupled in plunge grinding only: there the wheel touches all of "
                  "them at once.");
    case CouplingAnswer::givenCompliance:
        return tr("The compliance is given section by section, which does not say how one section "
                  "moves another. Choose \"from stiffness and shaft\" on the page Machine.");
    case CouplingAnswer::comparable: break;
    }
    return {};
}

QString ComplianceView::summary() const {
    if (!m_good) {
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
        return tr("From no place of the gauge does the cycle reach size.");
    }
    const QString place = best->zone == Zone::section
                              ? tr("%1 mm").arg(QLocale().toString(best->position_mm, 'f', 1))
                              : Names::zone(best->zone);
    return tr("Best place: %1; there no diameter is farther than %2 µm from the middle of the "
              "field. At present, at %3 mm: %4 µm.")
        .arg(place, Names::micrometres(gauge.farthest_um(*best)),
             QLocale().toString(m_plot->gaugePlace_mm(), 'f', 1),
             Names::micrometres(gauge.farthestNow_um()));
}

/// The order that decides which zone stays larger.
QString ComplianceView::complianceSummary() const {
    const auto& sections = m_good->result.sections;
    const auto [low, high] =
        std::ranges::minmax_element(sections, {}, &SectionResult::compliance_mm_per_n);
    if (high->compliance_mm_per_n <= low->compliance_mm_per_n) {
        return tr("Equal all along.");
    }
    const auto name = [&](auto it) {
        return Names::zone(it->zone, static_cast<int>(it - sections.begin()));
    };
    return tr("%1 yields %2 times as much as %3.")
        .arg(name(high), Names::significant(high->compliance_mm_per_n / low->compliance_mm_per_n),
             name(low));
}

void ComplianceView::retranslate() {
    m_plot->setAccessibleName(tr("Compliance along the part"));
    m_legend->setAccessibleName(tr("Legend of the curves"));
    m_notice->setAccessibleName(tr("State of the curves"));
    m_values->setAccessibleName(tr("Values under the mouse"));
    m_summary->setAccessibleName(tr("Where it yields most"));
    readOut();
    m_content->setItemText(0, tr("Compliance along the part"));
    m_content->setItemText(1, tr("Where to put the gauge"));
    m_content->setItemText(2, tr("Coupled against independent sections"));
    m_content->setAccessibleName(tr("What stands below the part"));
    m_content->setToolTip(m_content->accessibleName());
    m_put->setText(tr("Put the gauge there"));
    m_put->setAccessibleName(m_put->text());
    m_put->setToolTip(tr("Make the best place the gauge's free position; can be undone"));
    m_tools->retranslate();
    m_strip->retranslate();
    m_legend->retranslate();
    m_plot->retranslate();
    m_legend->setEntries(m_plot->legendEntries());
    showState();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

QString ComplianceView::hint() const {
    return tr("Point at the curve to read the values.");
}

void ComplianceView::recolour() {
    m_legend->setEntries(m_plot->legendEntries());
}

} // namespace sparkout
