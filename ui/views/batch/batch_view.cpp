// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/batch/batch_view.h"

#include "ui/dialogs/copy_table.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_pages.h"
#include "ui/text/names.h"
#include "ui/views/batch/batch_figures.h"
#include "ui/views/batch/batch_text.h"
#include "ui/views/batch/histogram_plot.h"
#include "ui/views/batch/pareto_plot.h"
#include "ui/views/batch/scatter_plot.h"
#include "ui/views/batch/sensitivity_plot.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>

#include <algorithm>

namespace sparkout {

namespace {

constexpr int mostStretched = 4; ///< columns of figures that have room beside each other

} // namespace

QString BatchView::title() const {
    return tr("Batch");
}

PlotTools* BatchView::tools() const {
    return m_pages->page().tools;
}

void BatchView::chooseContent() {
    m_pages->show();
    m_table->setVisible(m_pages->page().plot == m_histograms);
    m_name->setVisible(m_pages->page().plot != m_scatter && m_pages->page().plot != m_pareto);
    m_weights->setVisible(m_pages->page().plot == m_sensitivity);
    m_across->setVisible(m_pages->page().plot == m_scatter);
    m_up->setVisible(m_pages->page().plot == m_scatter);
    if (wantsIndices()) {
        runIndices();
    }
    showState();
    replotShown();
}

void BatchView::chooseWeights() {
    m_sensitivity->setKind(m_weights->currentIndex() == 0 ? SensitivityKind::ranks
                                                          : SensitivityKind::sobol);
    chooseContent();
    m_pages->page().tools->navigation().forgetViews();
}

void BatchView::chooseQuantities() {
    setQuantities();
    m_pages->showLegend();
    replotShown();
    m_pages->page().tools->navigation().forgetViews();
}

void BatchView::setQuantities() {
    if (m_batch && m_across->currentIndex() >= 0 && m_up->currentIndex() >= 0) {
        m_scatter->setBatch(m_batch, static_cast<BatchQuantity>(m_across->currentIndex()),
                            static_cast<BatchQuantity>(m_up->currentIndex()));
    }
}

std::string BatchView::chosenName() const {
    return m_name->currentData().toString().toStdString();
}

void BatchView::chooseName() {
    m_wanted = chosenName();
    showBatch();
}

// --- showing ------------------------------------------------------------------------------------

/// The characteristics of the batch, each name once, in the order of the summary.
void BatchView::fillNames() {
    const QSignalBlocker blocker(m_name);
    m_name->clear();
    if (!m_batch) {
        return;
    }
    for (const CharacteristicSummary& of : m_batch->summary.characteristics) {
        const QString key = QString::fromUtf8(of.characteristic.name);
        if (m_name->findData(key) < 0) {
            m_name->addItem(BatchText::axis(of.characteristic), key);
        }
    }
    m_name->setCurrentIndex(std::max(m_name->findData(QString::fromStdString(m_wanted)), 0));
}

/// Factors and characteristics by place; what was chosen stays, at first the factor that the
/// batch has first against the diameter.
void BatchView::fillQuantities() {
    const int quantities = m_batch ? static_cast<int>(quantityCount(*m_batch)) : 0;
    const int usual = m_batch ? static_cast<int>(m_batch->factors.size()) : 0;
    for (QComboBox* box : {m_across, m_up}) {
        const QSignalBlocker blocker(box);
        const int chosen = box->count() == quantities ? box->currentIndex() : -1;
        box->clear();
        for (int i = 0; i < quantities; ++i) {
            box->addItem(quantityName(*m_batch, static_cast<BatchQuantity>(i)));
        }
        box->setCurrentIndex(chosen >= 0 ? chosen : box == m_up ? usual : 0);
    }
    setQuantities();
}

void BatchView::showBatch() {
    fillNames();
    fillQuantities();
    std::vector<CharacteristicSummary> shown;
    if (m_batch) {
        for (const std::size_t i : drawnPlacesOf(m_batch->summary, chosenName())) {
            shown.push_back(m_batch->summary.characteristics[i]);
        }
    }
    m_histograms->setSummaries(std::move(shown));
    m_figures->show(m_batch, chosenName());
    m_table->horizontalHeader()->setSectionResizeMode(m_figures->columnCount() <= mostStretched
                                                          ? QHeaderView::Stretch
                                                          : QHeaderView::ResizeToContents);
    m_sensitivity->setBatch(m_batch, chosenName());
    m_sensitivity->setIndices(m_indices);
    m_pareto->setBatch(m_batch);
    m_pages->showLegend();
    showState();
    replotShown();
    for (const PlotPages::Page& page : m_pages->all()) {
        page.tools->navigation().amendView();
    }
}

void BatchView::replotShown() {
    m_pages->page().plot->replot(QCustomPlot::rpQueuedReplot);
}

void BatchView::showState() {
    const bool has = m_good && m_good->result.project.batch;
    const bool runs = busy();
    const bool faint = m_batch && (stale() || (latest() && !latest()->ran()));
    m_histograms->setDimmed(faint);
    m_sensitivity->setDimmed(faint);
    m_scatter->setDimmed(faint);
    m_pareto->setDimmed(faint);
    m_notice->setText(notice());
    m_notice->setVisible(!m_notice->text().isEmpty());
    m_add->setVisible(m_good && !has);
    m_runBar->setVisible(has);
    m_run->setEnabled(has && !runs);
    m_stop->setEnabled(runs);
    m_progress->setVisible(runs);
    m_state->setVisible(!runs);
    m_state->setText(m_batch ? BatchText::run(*m_batch) + u' ' + BatchText::verdict(*m_batch)
                             : QString());
    m_worst->setEnabled(!faint && m_batch && m_batch->summary.worstPart >= 0 && !runs);
    m_rows->setEnabled(!faint && m_batch && !runs);
    const bool drawn = m_batch && contentNotice().isEmpty();
    for (QWidget* part : std::initializer_list<QWidget*>{m_splitter, m_legend, m_values}) {
        part->setVisible(drawn);
    }
    for (QWidget* choice :
         std::initializer_list<QWidget*>{m_pages->content(), m_name, m_weights, m_across, m_up}) {
        choice->setEnabled(m_batch != nullptr);
    }
    for (const PlotPages::Page& page : m_pages->all()) {
        page.tools->setEnabled(drawn);
    }
    readOut();
    m_histograms->setAccessibleDescription(m_state->text());
}

QString BatchView::hint() const {
    return tr("Point at a bar or a point to read its values.");
}

QString BatchView::contentNotice() const {
    if (m_pages->page().plot == m_pareto && m_pareto->empty()) {
        return tr("No part of this batch fails a requirement.");
    }
    if (m_pages->page().plot != m_sensitivity || !m_sensitivity->empty()) {
        return {};
    }
    if (m_batch->factors.empty()) {
        return tr("No factor scatters in this batch.");
    }
    if (m_sensitivity->kind() == SensitivityKind::ranks) {
        return m_batch->summary.isSample
                   ? tr("This characteristic or one of the factors does not vary, or the parts are "
                        "too few to tell which factor matters.")
                   : tr("Corners are no sample: rank regression takes parts at random.");
    }
    if (m_batch->result.project.batch->correlation) {
        return tr("Sobol indices have no meaning for correlated factors.");
    }
    if (m_indexRunner->running()) {
        return tr("Sobol indices take parts of their own; they are being run.");
    }
    return m_indices ? tr("This characteristic does not vary, or some of the parts have none.")
                     : tr("The Sobol indices were stopped. “Run” runs them again.");
}

QString BatchView::notice() const {
    if (latest() && !latest()->ran()) {
        return (m_batch ? tr("The inputs are refused; the batch is that of the last accepted ones.")
                        : tr("The inputs are refused:"))
               + QLatin1Char('\n') + Names::refusal(latest()->issues, 2);
    }
    if (!m_good) {
        return tr("No result yet.");
    }
    if (!m_good->result.project.batch) {
        return tr("This project describes no batch. A batch is a number of parts whose stock, "
                  "runout, dullness and other factors scatter: it says which share of them keeps "
                  "the drawing. Choose the factors on the page Batch of the inputs, or start with "
                  "usual ones.");
    }
    if (m_refused) {
        return tr("The batch cannot be run:") + QLatin1Char('\n')
               + Names::refusal(m_refused->issues, 2);
    }
    if (m_batch && stale()) {
        return m_runner->running()
                   ? tr("Of the inputs before the last edit; the new batch is being run.")
                   : tr("Of the inputs before the last edit. Press “Run” for those of now.");
    }
    if (m_batch) {
        const QString content = contentNotice();
        return content.isEmpty() ? Names::uncutStrips(m_batch->result.project) : content;
    }
    return m_runner->running()
               ? QString()
               : tr(
                   "This batch takes a while: press “Run”. It can be stopped at any time and keeps "
                   "what was done.");
}

QStringList BatchView::heading() const {
    QStringList heading{title()};
    if (m_batch) {
        heading << QString::fromStdString(m_batch->result.project.title).simplified()
                << m_name->currentText() << m_state->text()
                << Names::uncutStrips(m_batch->result.project);
    }
    heading.removeAll(QString());
    return heading;
}

void BatchView::retranslate() {
    setAccessibleName(tr("Batch"));
    m_histograms->setAccessibleName(tr("Histograms, zone beside zone"));
    m_legend->setAccessibleName(tr("Legend of the batch"));
    m_notice->setAccessibleName(tr("State of the batch"));
    m_state->setAccessibleName(tr("What was run"));
    m_values->setAccessibleName(tr("Values under the mouse"));
    m_progress->setAccessibleName(tr("Progress of the batch"));
    m_table->setAccessibleName(tr("Figures of the batch"));
    m_pages->content()->setItemText(0, tr("Histograms"));
    m_pages->content()->setItemText(1, tr("Sensitivity"));
    m_pages->content()->setItemText(2, tr("Scatter"));
    m_pages->content()->setItemText(3, tr("Rejects by cause"));
    m_pareto->setAccessibleName(tr("Rejects by cause, the most frequent first"));
    m_sensitivity->setAccessibleName(tr("Which factor matters most"));
    m_scatter->setAccessibleName(tr("Parts, one quantity over another"));
    m_weights->setItemText(0, tr("Rank regression"));
    m_weights->setItemText(1, tr("Sobol indices"));
    m_weights->setAccessibleName(tr("How the weight of a factor is told"));
    m_weights->setToolTip(
        tr("Rank regression: standardised coefficients, of the parts of the batch; sign and weight "
           "as far as the dependence is monotone, which R² says. Sobol indices: share of the "
           "variance, of parts of their own."));
    m_across->setAccessibleName(tr("Quantity across"));
    m_across->setToolTip(m_across->accessibleName());
    m_up->setAccessibleName(tr("Quantity upwards"));
    m_up->setToolTip(m_up->accessibleName());
    m_pages->content()->setAccessibleName(tr("What is shown of the batch"));
    m_pages->content()->setToolTip(m_pages->content()->accessibleName());
    m_name->setAccessibleName(tr("Characteristic"));
    m_name->setToolTip(m_name->accessibleName());
    const auto name = [](QPushButton& button, const QString& text, const QString& tip) {
        button.setText(text);
        button.setAccessibleName(text);
        button.setAccessibleDescription(tip);
        button.setToolTip(tip);
    };
    name(*m_run, tr("Run"), tr("Run the parts of the batch; a quick one runs by itself"));
    name(*m_stop, tr("Stop"), tr("End the batch; what was done is kept and shown"));
    name(*m_worst, tr("Worst part"),
         tr("Keep the part with the least margin as a run beside this project and compare the two; "
            "the project stays as it is"));
    nameRows();
    name(*m_add, tr("Add a usual batch"),
         tr("50 parts whose stock, runout and dullness scatter about the present inputs; can be "
            "undone and changed on the page Batch"));
    m_legend->retranslate();
    m_histograms->retranslate();
    m_sensitivity->retranslate();
    m_figures->retranslate();
    m_table->retranslate();
    fillNames();
    fillQuantities();
    m_scatter->retranslate();
    m_pareto->retranslate();
    m_pages->showLegend();
    showState();
    for (const PlotPages::Page& page : m_pages->all()) {
        page.tools->retranslate();
        page.plot->replot(QCustomPlot::rpQueuedReplot);
    }
}

void BatchView::recolour() {
    m_pages->showLegend();
}

} // namespace sparkout
