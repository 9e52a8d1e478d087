// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/overview/overview_tile.h"

#include "ui/bars/bar_plot.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/plot/legend.h"
#include "ui/plot/plot_tools.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

OverviewTile::OverviewTile(const QString& name, QWidget* parent)
    : QFrame(parent)
    , m_title(new QLabel(this))
    , m_enlarge(new QToolButton(this))
    , m_legend(new LegendStrip(this))
    , m_plot(new BarPlot(this))
    , m_remark(new QLabel(this))
    , m_empty(new QLabel(this))
    , m_step(new QPushButton(this)) {
    setObjectName(name);
    m_enlarge->setObjectName(name + QStringLiteral("Enlarge"));
    m_legend->setObjectName(name + QStringLiteral("Legend"));
    m_plot->setObjectName(name + QStringLiteral("Plot"));
    m_step->setObjectName(name + QStringLiteral("Step"));
    setFrameShape(QFrame::StyledPanel);
    setRelativeFont(*m_title, 1, true);
    for (QLabel* label : {m_title, m_remark, m_empty}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
    }
    m_enlarge->setIcon(themeIcon(u"enlarge"));
    m_enlarge->setAutoRaise(true);
    m_enlarge->setFocusPolicy(Qt::TabFocus);
    m_plot->setLeads(true);
    m_plot->setMinimumWidth(160);
    auto* head = new QHBoxLayout;
    head->setSpacing(metrics::hair);
    head->addWidget(m_title, 1);
    head->addWidget(m_enlarge);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::gap, metrics::tight, metrics::gap, metrics::tight);
    column->setSpacing(metrics::tight);
    column->addLayout(head);
    column->addWidget(m_legend);
    column->addWidget(m_plot, 1);
    column->addWidget(m_remark);
    column->addStretch();
    column->addWidget(m_empty);
    column->addWidget(m_step, 0, Qt::AlignLeft);
    column->addStretch();
    connect(m_enlarge, &QToolButton::clicked, this, &OverviewTile::enlargeAsked);
    connect(m_step, &QPushButton::clicked, this, &OverviewTile::stepAsked);
    connect(m_plot, &ViewPlot::contentChanged, this, &OverviewTile::showLegend);
    connect(m_legend, &LegendStrip::toggled, m_plot, &BarPlot::toggleCurve);
    connect(m_legend, &LegendStrip::onlyAsked, m_plot, &BarPlot::showOnly);
    showParts();
}

void OverviewTile::addExport() {
    auto* head = static_cast<QHBoxLayout*>(layout()->itemAt(0)->layout());
    head->addWidget(m_plot->tools()->exportButton(this));
}

void OverviewTile::setTitle(const QString& title) {
    m_title->setText(title);
    m_plot->setAccessibleName(title);
    nameStep();
}

QString OverviewTile::title() const {
    return m_title->text();
}

bool OverviewTile::isEmpty() const {
    return m_plot->chart().empty();
}

QString OverviewTile::emptyText() const {
    return isEmpty() ? m_empty->text() : QString();
}

void OverviewTile::setChart(BarChart chart) {
    m_remark->setText(chart.remark);
    m_plot->setChart(std::move(chart));
    m_plot->setAccessibleDescription(m_plot->chart().description());
    showParts();
}

void OverviewTile::setEmpty(const QString& text, const QString& step) {
    m_empty->setText(text);
    m_step->setText(step);
    nameStep();
    setChart({});
}

void OverviewTile::nameStep() {
    m_step->setAccessibleName(m_step->text().isEmpty() ? title() : m_step->text());
}

void OverviewTile::showParts() {
    const bool drawn = !isEmpty();
    m_plot->setVisible(drawn);
    m_remark->setVisible(drawn && !m_remark->text().isEmpty());
    m_empty->setVisible(!drawn);
    m_step->setVisible(!drawn && !m_step->text().isEmpty());
    if (m_plot->tools()) {
        m_plot->tools()->setEnabled(drawn);
    }
    m_enlarge->setEnabled(drawn || m_isAlone);
    fitHeight();
    showLegend();
}

void OverviewTile::fitHeight() {
    m_plot->setMinimumHeight(BarDrawing::leastHeight(m_plot->chart(), m_plot->font()));
}

void OverviewTile::showLegend() {
    const LegendEntries entries = m_plot->legendEntries();
    m_legend->setVisible(!isEmpty() && !entries.empty());
    m_legend->setEntries(entries);
}

void OverviewTile::setAlone(bool isAlone) {
    m_isAlone = isAlone;
    m_enlarge->setIcon(themeIcon(isAlone ? u"reduce" : u"enlarge"));
    m_enlarge->setEnabled(isAlone || !isEmpty());
    retranslate();
}

void OverviewTile::retranslate() {
    const QString text = m_isAlone ? tr("Back to all charts") : tr("Enlarge: %1").arg(title());
    m_enlarge->setAccessibleName(text);
    m_enlarge->setToolTip(m_isAlone ? tr("Back to all charts (Esc)")
                                    : tr("Enlarge this chart to the whole page"));
    m_legend->retranslate();
    m_legend->setAccessibleName(tr("Legend: %1").arg(title()));
}

} // namespace sparkout
