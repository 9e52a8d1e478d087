// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance_view.h"

#include "ui/metrics.h"
#include "ui/views/compliance_plot.h"
#include "ui/views/legend_strip.h"
#include "ui/views/names.h"
#include "ui/views/plot_tools.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
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
    , m_values(new QLabel(this)) {
    setObjectName(QStringLiteral("compliance"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    layout->setSpacing(metrics::tight);
    auto* bar = new QWidget(this);
    buildTools(bar, settings);
    for (QLabel* label : {m_summary, m_notice, m_values}) {
        label->setTextFormat(Qt::PlainText);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setWordWrap(true);
    }
    m_values->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_values->setFixedHeight(QFontMetrics(m_values->font()).lineSpacing() * 2 + 2);
    layout->addWidget(bar);
    layout->addWidget(m_notice);
    layout->addWidget(m_legend);
    layout->addWidget(m_plot, 1);
    layout->addWidget(m_values);
    m_plot->setObjectName(QStringLiteral("compliancePlot"));
    m_legend->setObjectName(QStringLiteral("complianceLegend"));
    m_notice->setObjectName(QStringLiteral("complianceNotice"));
    m_values->setObjectName(QStringLiteral("complianceValues"));
    m_summary->setObjectName(QStringLiteral("complianceSummary"));
    connect(m_plot, &CompliancePlot::contentChanged, this,
            [this] { m_legend->setEntries(m_plot->legendEntries()); });
    connect(m_plot, &CompliancePlot::pointed, this, [this](const QString& text) {
        m_values->setText(text.isEmpty() ? tr("Point at the curve to read the values.") : text);
    });
    connect(m_legend, &LegendStrip::toggled, m_plot, &CompliancePlot::toggleCurve);
    connect(m_legend, &LegendStrip::onlyAsked, m_plot, &CompliancePlot::showOnly);
    retranslate();
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
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(m_summary, 1);
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
    }
    m_plot->setDimmed(m_good && !ran);
    showState();
    m_plot->replot();
    m_tools->navigation().amendView();
    emit updated();
}

void ComplianceView::showState() {
    const bool refused = latest() && !latest()->ran();
    QString text;
    if (refused) {
        text =
            (m_good ? tr("The inputs are refused; the curves are those of the last accepted ones.")
                    : tr("The inputs are refused:"))
            + QLatin1Char('\n') + Names::refusal(latest()->issues, 2);
    } else if (!m_good) {
        text = tr("No result yet.");
    } else if (m_plot->places().empty()) {
        text =
            tr("The compliance is given, zone by zone or section by section. Leave it to stiffness "
               "and shaft on the page Machine to see what it is made of.");
    }
    m_notice->setText(text);
    m_notice->setVisible(!text.isEmpty());
    for (QWidget* part : std::initializer_list<QWidget*>{m_plot, m_legend, m_values, m_summary}) {
        part->setVisible(m_good != nullptr);
    }
    m_summary->setText(summary());
    m_tools->setEnabled(m_good != nullptr);
}

/// The order that decides which zone stays larger.
QString ComplianceView::summary() const {
    if (!m_good) {
        return {};
    }
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
    m_values->setText(tr("Point at the curve to read the values."));
    m_tools->retranslate();
    m_legend->retranslate();
    m_plot->retranslate();
    m_legend->setEntries(m_plot->legendEntries());
    showState();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ComplianceView::changeEvent(QEvent* event) {
    View::changeEvent(event);
    if (!m_tools) {
        return;
    }
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange) {
        m_legend->setEntries(m_plot->legendEntries());
    }
}

} // namespace sparkout
