// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the feeds view: building and connecting.
#include "ui/views/feeds_view.h"

#include "ui/metrics.h"
#include "ui/views/feeds_plot.h"
#include "ui/views/legend_strip.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

namespace sparkout {

FeedsView::FeedsView(QWidget* parent) : View(parent) {
    setObjectName(QStringLiteral("feeds"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    layout->setSpacing(metrics::tight);
    auto* bar = new QWidget(this);
    m_notice = new QLabel(this);
    m_values = new QLabel(this);
    m_legend = new LegendStrip(this);
    m_plot = new FeedsPlot(this);
    buildToolBar(bar);
    for (QLabel* label : {m_notice, m_values}) {
        label->setTextFormat(Qt::PlainText);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setWordWrap(true);
    }
    m_values->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_values->setFixedHeight(QFontMetrics(m_values->font()).lineSpacing() * 3);
    layout->addWidget(bar);
    layout->addWidget(m_notice);
    layout->addWidget(m_legend);
    layout->addWidget(m_plot, 1);
    layout->addWidget(m_values);
    layout->addStretch();
    connectTools();
    retranslate();
}

void FeedsView::buildToolBar(QWidget* bar) {
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    m_span = new QComboBox(bar);
    m_previous = new QToolButton(bar);
    m_stroke = new QSpinBox(bar);
    m_next = new QToolButton(bar);
    m_strokeLabel = new QLabel(bar);
    m_section = new QComboBox(bar);
    m_axis = new QComboBox(bar);
    m_fit = new QToolButton(bar);
    m_previous->setArrowType(Qt::LeftArrow);
    m_next->setArrowType(Qt::RightArrow);
    m_strokeLabel->setTextFormat(Qt::PlainText);
    for (QToolButton* button : {m_previous, m_next, m_fit}) {
        button->setFocusPolicy(Qt::TabFocus);
    }
    for (QComboBox* box : {m_span, m_section, m_axis}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    }
    m_stroke->setKeyboardTracking(false);
    for (QWidget* w :
         std::initializer_list<QWidget*>{m_span, m_strokeLabel, m_previous, m_stroke, m_next}) {
        row->addWidget(w);
    }
    row->addStretch();
    for (QWidget* w : std::initializer_list<QWidget*>{m_section, m_axis, m_fit}) {
        row->addWidget(w);
    }
    m_span->setObjectName(QStringLiteral("span"));
    m_stroke->setObjectName(QStringLiteral("stroke"));
    m_previous->setObjectName(QStringLiteral("previous"));
    m_next->setObjectName(QStringLiteral("next"));
    m_axis->setObjectName(QStringLiteral("axis"));
    m_section->setObjectName(QStringLiteral("section"));
    m_fit->setObjectName(QStringLiteral("fit"));
    m_notice->setObjectName(QStringLiteral("notice"));
    m_values->setObjectName(QStringLiteral("values"));
}

void FeedsView::buildLabels() {
    setAccessibleName(tr("Feeds by stage"));
    m_plot->setAccessibleName(tr("Curves of the feeds by stage"));
    m_legend->setAccessibleName(tr("Legend of the curves"));
    m_notice->setAccessibleName(tr("State of the curves"));
    m_values->setAccessibleName(tr("Values under the pointer"));
    m_span->setAccessibleName(tr("Part of the cycle in sight"));
    m_span->setToolTip(tr("Part of the cycle in sight"));
    m_span->setPlaceholderText(tr("Free choice"));
    m_axis->setAccessibleName(tr("Horizontal axis"));
    m_axis->setToolTip(tr("Horizontal axis"));
    m_section->setAccessibleName(tr("Section that is also shown"));
    m_section->setToolTip(tr("Section that is also shown"));
    m_strokeLabel->setText(tr("No.", "number of the double stroke or revolution"));
    m_previous->setAccessibleName(tr("Previous"));
    m_previous->setToolTip(tr("Previous"));
    m_next->setAccessibleName(tr("Next"));
    m_next->setToolTip(tr("Next"));
    m_values->setText(tr("Point at a curve to read its values."));
    m_fit->setText(tr("Fit"));
    m_fit->setAccessibleName(tr("Fit the whole cycle"));
    m_fit->setToolTip(tr("Show the whole cycle (double click in a plot). "
                         "Wheel: zoom; over a vertical axis: that axis. Drag: move."));
}

void FeedsView::connectTools() {
    connect(m_span, &QComboBox::currentIndexChanged, this, &FeedsView::onSpanChosen);
    connect(m_stroke, &QSpinBox::valueChanged, this, &FeedsView::onStrokeChosen);
    connect(m_previous, &QToolButton::clicked, m_stroke, &QSpinBox::stepDown);
    connect(m_next, &QToolButton::clicked, m_stroke, &QSpinBox::stepUp);
    connect(m_section, &QComboBox::currentIndexChanged, this, &FeedsView::onSectionChosen);
    connect(m_axis, &QComboBox::currentIndexChanged, this, [this] {
        m_plot->setAxis(static_cast<CycleAxis>(m_axis->currentData().toInt()));
        m_plot->replot();
    });
    const auto fit = [this] {
        m_what = Span::whole;
        m_plot->fitValues();
        applySpan();
        m_plot->replot();
    };
    connect(m_fit, &QToolButton::clicked, this, fit);
    connect(m_plot, &FeedsPlot::fitAsked, this, fit);
    connect(m_plot, &FeedsPlot::movedByUser, this, [this] {
        m_what = Span::free;
        showSpan();
    });
    connect(m_plot, &FeedsPlot::contentChanged, this, &FeedsView::showLegend);
    connect(m_plot, &FeedsPlot::pointed, this, [this](const QString& text) {
        m_values->setText(text.isEmpty() ? tr("Point at a curve to read its values.") : text);
    });
    connect(m_plot, &FeedsPlot::pointedBand, m_plot, &QWidget::setToolTip);
}

} // namespace sparkout
