// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_pages.h"

#include "ui/kit/metrics.h"
#include "ui/plot/legend_strip.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QStackedWidget>

#include <qcustomplot.h>

#include <utility>

namespace sparkout {

PlotPages::PlotPages(QWidget& view, LegendStrip& legend, std::function<QStringList()> heading,
                     Settings* settings, Chosen chosen)
    : QObject(&view)
    , m_view(view)
    , m_legend(legend)
    , m_heading(std::move(heading))
    , m_settings(settings)
    , m_stack(new QStackedWidget(&view)) {
    if (chosen == Chosen::inBox) {
        m_content = new QComboBox(&view);
    }
    connect(&legend, &LegendStrip::toggled, this, [this](int key) { page().toggle(key); });
    connect(&legend, &LegendStrip::onlyAsked, this, [this](int key) { page().showOnly(key); });
}

void PlotPages::finish(Page page, PlotSubject subject) {
    subject.heading = m_heading;
    page.tools = new PlotTools(*page.plot, std::move(subject));
    page.tools->setSettings(m_settings);
    page.buttons = new QWidget(&m_view);
    auto* row = new QHBoxLayout(page.buttons);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(PlotTools::button(page.tools->fit, page.buttons));
    row->addWidget(page.tools->exportButton(page.buttons));
    m_stack->addWidget(page.plot);
    m_pages.push_back(std::move(page));
    if (m_content) {
        m_content->addItem(QString()); // the first becomes the one in sight
    }
}

const PlotPages::Page& PlotPages::page() const {
    return m_pages[m_shown];
}

void PlotPages::addButtons(QLayout& row) const {
    for (const Page& page : m_pages) {
        row.addWidget(page.buttons);
    }
}

void PlotPages::show() {
    show(static_cast<std::size_t>(m_content->currentIndex()));
}

void PlotPages::show(std::size_t index) {
    m_shown = index;
    m_stack->setCurrentWidget(page().plot);
    for (const Page& other : m_pages) {
        other.buttons->setVisible(&other == &page());
    }
    showLegend();
}

void PlotPages::showLegend() {
    if (!m_pages.empty()) { // a plot may tell of its content before it is added
        m_legend.setEntries(page().legend());
    }
}

} // namespace sparkout
