// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/batch_view.h"

#include "core/project/batch.h"
#include "core/study/batch_edits.h"
#include "core/study/whole_batch.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/legend.h"
#include "ui/dialogs/copy_table.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/kit/metrics.h"
#include "ui/kit/search_combo.h"
#include "ui/kit/tool_row.h"
#include "ui/text/example_texts.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/study/batch_charts.h"
#include "ui/views/study/batch_text.h"
#include "ui/views/study/sensitivity_plot.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <thread>
#include <utility>

namespace sparkout {

namespace {

struct PartRows {
    Q_DECLARE_TR_FUNCTIONS(PartRows)
};

PartTable::Dialect dialectOfParts(TableFormat format) {
    const bool russian = format == TableFormat::csvRussian;
    return {tableDialect(russian ? CsvDialect::russianExcel : CsvDialect::english),
            csvBegin().toStdString(),
            "\r\n",
            {PartRows::tr("finished").toStdString(),
             PartRows::tr("does not reach size").toStdString(),
             PartRows::tr("strips stay uncut").toStdString()},
            PartRows::tr("yes").toStdString(),
            PartRows::tr("no").toStdString(),
            1};
}

std::vector<std::string> headOfParts(const PartColumns& columns) {
    QStringList names{PartRows::tr("Part"), PartRows::tr("State"), PartRows::tr("Good"),
                      PartRows::tr("Minimum margin, relative to its limit")};
    for (const GivenFactor& factor : columns.factors) {
        names << BatchText::factorAxis(factor);
    }
    for (const Characteristic& of : columns.characteristics) {
        names << QStringLiteral("%1, %2").arg(BatchText::full(of), unitText(of.unit));
    }
    for (const ConstraintKind kind : columns.requirements) {
        names << PartRows::tr("%1: met", "a requirement").arg(Names::constraint(kind));
    }
    std::vector<std::string> head;
    for (const QString& name : names) {
        head.push_back(name.toStdString());
    }
    return head;
}

bool writeRows(const Project& project, TableFormat format, const std::filesystem::path& path,
               const KeepGoing& keepGoing, const std::stop_token& stop,
               std::optional<FileError>& error) {
    PartRowsFile file(path, SafeFileWriter::Existing::replaced, // the dialog has asked before
                      {dialectOfParts(format), headOfParts});
    BatchOptions options;
    options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
    options.stop = stop;
    const bool written = file.runBatch(project, options, keepGoing);
    error = file.error();
    return written;
}

} // namespace

bool savePartRows(QWidget* window, Settings* settings, const Project& project, TableFormat format) {
    SaveRequest request;
    request.title = PartRows::tr("All parts of the batch");
    request.name = fileNameOf({exampleTitle(project.title), request.title});
    request.suffix = tableFormatSuffix(format);
    request.filter = tableFormatFilter(format);
    request.stream = [&project, format](const std::filesystem::path& path,
                                        const KeepGoing& keepGoing, const std::stop_token& stop,
                                        std::optional<FileError>& error) {
        return writeRows(project, format, path, keepGoing, stop, error);
    };
    return saveWithDialog(window, settings, request);
}

namespace {

constexpr int histogramShare = 200, figuresShare = 220; ///< initial shares of the height
constexpr int stateLetters = 60; ///< least width of the text on the run, in letters
constexpr int mostStretched = 4; ///< greatest number of columns that fit side by side
constexpr int indexPoints = 256; ///< a power of two, as required by the Sobol sequence

/// Makes every column at least as wide as its longest word.
void fitColumns(QTableView& table) {
    const QAbstractItemModel& model = *table.model();
    const QFontMetrics text = table.fontMetrics();
    int widest = 0;
    for (int column = 0; column < model.columnCount(); ++column) {
        widest = std::max(
            widest, text.horizontalAdvance(model.headerData(column, Qt::Horizontal).toString()));
        for (int row = 0; row < model.rowCount(); ++row) {
            QString cell = model.index(row, column).data().toString();
            for (const QString& word : cell.replace(u'…', QStringLiteral("… ")).split(u' ')) {
                widest = std::max(widest, text.horizontalAdvance(word));
            }
        }
    }
    table.horizontalHeader()->setMinimumSectionSize(widest + 2 * metrics::gap);
}

} // namespace

BatchView::BatchView(QWidget* parent, Settings* settings, Studies* studies)
    : StudyView(QStringLiteral("batch"), parent, settings, studies)
    , m_histograms(new ChartPlot(this))
    , m_sensitivity(new SensitivityPlot(this))
    , m_scatter(new ChartPlot(this))
    , m_pareto(new ChartPlot(this))
    , m_splitter(new QSplitter(Qt::Vertical, this))
    , m_figures(new ValueModel(this))
    , m_name(new SearchCombo(this))
    , m_weights(new QComboBox(this))
    , m_across(new SearchCombo(this))
    , m_up(new SearchCombo(this))
    , m_bar(new RunBar(QStringLiteral("batch"), this, BatchText::progress))
    , m_worst(new QPushButton(this))
    , m_rows(new QPushButton(this))
    , m_add(new QPushButton(this)) {
    for (ViewPlot* plot :
         std::initializer_list<ViewPlot*>{m_histograms, m_sensitivity, m_scatter, m_pareto}) {
        plot->setMinimumSize(240, 120);
        addPage(*plot);
    }
    m_histograms->setGrid([this] {
        return m_shown ? BatchCharts::histograms(m_shown->summary, chosenName(), m_tellsIndices)
                       : ChartGrid();
    });
    hideUntilDrawn({m_splitter});
    setUpNotice(*m_bar->state());
    m_bar->layOut({m_worst, m_rows}, {}, stateLetters);
    share(*m_splitter, {{pages(), histogramShare}, {buildFigures(), figuresShare}});
    QVBoxLayout* const column =
        addColumn({m_choice = pageTools<ToolRow>({m_name, m_weights, m_across, m_up}), m_bar,
                   notice(), m_add, legend(), m_splitter, values()},
                  m_splitter);
    column->setAlignment(m_add, Qt::AlignLeft);
    column->addStretch(0);
    nameObjects({{m_histograms, "batchHistograms"},
                 {m_sensitivity, "batchSensitivity"},
                 {m_scatter, "batchScatter"},
                 {m_pareto, "batchPareto"},
                 {m_name, "batchCharacteristic"},
                 {m_weights, "batchWeights"},
                 {m_across, "batchAcross"},
                 {m_up, "batchUp"},
                 {m_worst, "batchWorst"},
                 {m_rows, "batchRows"},
                 {m_add, "batchAdd"},
                 {m_table, "batchFigures"}});
    buildRows();
    connectParts();
    built();
    chooseContent();
}

CopyTable* BatchView::buildFigures() {
    m_table = addTable(*m_figures, [this] {
        return batch() && m_tellsIndices ? batchFiguresTable(batch()->summary) : CsvTable();
    });
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->verticalHeader()->setHighlightSections(false);
    connect(m_table, &CopyTable::resized, this, [this] { fitColumns(*m_table); });
    return m_table;
}

/// Builds the button for the rows of all parts with a menu of the two CSV formats.
void BatchView::buildRows() {
    auto* menu = new QMenu(m_rows);
    for (const TableFormat format : {TableFormat::csvRussian, TableFormat::csvEnglish}) {
        connect(menu->addAction(QString()), &QAction::triggered, this, [this, format] {
            const BatchOutcomePtr of = batch(); // may be replaced before the end
            (void)savePartRows(window(), settings(), of->result.project, format);
        });
    }
    m_rows->setMenu(menu);
}

void BatchView::connectParts() {
    connect(content(), &QComboBox::currentIndexChanged, this, &BatchView::chooseContent);
    connect(m_name, &QComboBox::currentIndexChanged, this, &BatchView::chooseName);
    connect(m_weights, &QComboBox::currentIndexChanged, this, &BatchView::chooseWeights);
    for (QComboBox* box : {m_across, m_up}) {
        connect(box, &QComboBox::currentIndexChanged, this, &BatchView::chooseQuantities);
    }
    connect(m_bar->run(), &QPushButton::clicked, this, &BatchView::runBatch);
    m_bar->follow(studies().batch.job());
    m_bar->follow(studies().indexJob());
    connect(&studies().batch.job(), &Job::answered, this, &BatchView::takeBatch);
    connect(&studies().indexJob(), &Job::answered, this, &BatchView::takeIndices);
    connect(m_worst, &QPushButton::clicked, this, &BatchView::takeWorst);
    connect(m_add, &QPushButton::clicked, this, [this] {
        // The view shows the last accepted inputs; the current ones may have a batch.
        emit editWanted(
            [](Project project) {
                return project.batch ? project : withUsualBatch(std::move(project));
            },
            {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a batch")});
    });
}

// --- choices ------------------------------------------------------------------------------------

void BatchView::chooseContent() {
    showPage(static_cast<std::size_t>(content()->currentIndex()));
    m_table->setVisible(&front() == m_histograms);
    m_name->setVisible(&front() == m_histograms || &front() == m_sensitivity);
    m_weights->setVisible(&front() == m_sensitivity);
    m_across->setVisible(&front() == m_scatter);
    m_up->setVisible(&front() == m_scatter);
    if (wantsIndices()) {
        runIndices();
    }
    showState();
    replotFront();
}

void BatchView::chooseWeights() {
    m_sensitivity->setKind(m_weights->currentIndex() == 0 ? SensitivityKind::ranks
                                                          : SensitivityKind::sobol);
    chooseContent();
    tools()->navigation().forgetViews();
}

void BatchView::chooseQuantities() {
    setQuantities();
    replotFront();
    tools()->navigation().forgetViews();
}

void BatchView::setQuantities() {
    if (batch() && m_across->currentIndex() >= 0 && m_up->currentIndex() >= 0) {
        m_scatter->setChart([batch = batch(),
                             across = static_cast<BatchQuantity>(m_across->currentIndex()),
                             up = static_cast<BatchQuantity>(m_up->currentIndex())] {
            return BatchCharts::scatter(batch, across, up);
        });
    }
}

std::string BatchView::chosenName() const {
    return m_name->currentData().toString().toStdString();
}

void BatchView::chooseName() {
    m_wanted = chosenName();
    showBatch();
}

// --- running ------------------------------------------------------------------------------------

void BatchView::takeOutcome(const OutcomePtr&) {
    const Project& project = good()->result.project;
    studies().batch.follow(&project);
    if (!project.batch) {
        dropStudies();
    } else if (stale() && !studies().batch.running()
               && RunBar::areQuick(partsOf(project), good()->result.visits)) {
        runBatch();
    }
}

void BatchView::dropStudies() {
    studies().batch.forget();
    studies().dropIndices();
    showBatch();
}

void BatchView::runBatch() {
    if (!stale() && showsIndices() && !indices()) {
        runIndices();
        return;
    }
    const Project& project = good()->result.project;
    m_bar->showProgress(0, partsOf(project));
    studies().runBatch(project);
    showState();
}

void BatchView::takeBatch() {
    if (m_shown != batch()) {
        studies().dropIndices();
        showBatch();
        if (wantsIndices()) {
            runIndices();
        }
    }
    showState();
    emit ended();
}

bool BatchView::busy() const {
    return studies().batch.running() || studies().indexJob().running();
}

bool BatchView::showsIndices() const {
    return &front() == m_sensitivity && m_sensitivity->kind() == SensitivityKind::sobol;
}

bool BatchView::wantsIndices() const {
    return showsIndices() && batch() && !studies().haveIndicesBeenTried()
           && !batch()->factors.empty() && !batch()->result.project.batch->correlation;
}

void BatchView::runIndices() {
    m_bar->showProgress(0, partsOfIndices(batch()->result.project, indexPoints));
    studies().runIndices(indexPoints);
    showState();
}

void BatchView::takeIndices() {
    m_sensitivity->setIndices(indices());
    showState();
    replotFront();
    emit ended();
}

void BatchView::takeWorst() {
    if (batch() && !stale()) {
        const auto take = [batch = batch()](Project project) -> std::optional<Project> {
            if (!sameBatch(batch->result.project, project)) {
                return std::nullopt; // edited meanwhile
            }
            return withPart(std::move(project), batch->result, batch->summary.worstPart);
        };
        emit runWanted(take, QString::fromStdString(givenRunName(
                                 GivenName::worstPart, Names::part(batch()->summary.worstPart))));
    }
}

// --- showing ------------------------------------------------------------------------------------

/// Lists the characteristics of the batch, each name once, in the order of the summary.
void BatchView::fillNames() {
    const QSignalBlocker blocker(m_name);
    m_name->clear();
    if (!batch()) {
        return;
    }
    for (const CharacteristicSummary& of : batch()->summary.characteristics) {
        const QString key = QString::fromUtf8(of.characteristic.name);
        if (m_name->findData(key) < 0) {
            m_name->addItem(BatchText::axis(of.characteristic), key);
        }
    }
    m_name->setCurrentIndex(std::max(m_name->findData(QString::fromStdString(m_wanted)), 0));
}

/// Lists factors and characteristics by place; keeps the choice, initially the batch's first factor
/// against the diameter.
void BatchView::fillQuantities() {
    const int quantities = batch() ? static_cast<int>(batch()->quantityCount()) : 0;
    const int usual = batch() ? static_cast<int>(batch()->factors.size()) : 0;
    for (QComboBox* box : {m_across, m_up}) {
        const QSignalBlocker blocker(box);
        const int chosen = box->count() == quantities ? box->currentIndex() : -1;
        box->clear();
        for (int i = 0; i < quantities; ++i) {
            box->addItem(BatchCharts::quantityName(*batch(), static_cast<BatchQuantity>(i)));
        }
        box->setCurrentIndex(chosen >= 0 ? chosen : box == m_up ? usual : 0);
    }
    setQuantities();
}

void BatchView::showBatch() {
    m_shown = batch();
    fillNames();
    fillQuantities();
    m_histograms->remake();
    if (std::exchange(m_drawn, chosenName()) == chosenName()) {
        m_histograms->refit();
    } else {
        m_histograms->fit();
    }
    showFigures();
    m_table->horizontalHeader()->setSectionResizeMode(m_figures->columnCount() <= mostStretched
                                                          ? QHeaderView::Stretch
                                                          : QHeaderView::ResizeToContents);
    fitColumns(*m_table);
    m_sensitivity->setBatch(batch(), chosenName());
    m_sensitivity->setIndices(indices());
    m_pareto->setChart([batch = batch()] { return BatchCharts::rejects(batch); });
    showState();
    replotAll();
}

void BatchView::showFigures() {
    m_figures->setTable(batch() ? batchFigures(batch()->summary, chosenName(), m_tellsIndices)
                                : ValueTable());
}

void BatchView::tellIndices(bool tells) {
    m_tellsIndices = tells;
    showBatch();
}

bool BatchView::drawn() const {
    return batch() && contentNotice().isEmpty();
}

bool BatchView::faint() const {
    return batch() && (stale() || refused());
}

const Project* BatchView::shownProject() const {
    return batch() ? &batch()->result.project : nullptr;
}

void BatchView::showState() {
    PlotView::showState();
    const bool has = good() && good()->result.project.batch;
    m_add->setVisible(good() && !has);
    m_choice->setVisible(has || batch()); // otherwise there is no choice
    m_bar->setVisible(has);
    m_bar->showRunning(busy(), has && !refused());
    const auto found = [this] {
        return m_tellsIndices ? BatchText::verdict(*batch()) : BatchText::counts(batch()->summary);
    };
    QStringList state;
    if (batch()) {
        state = {BatchText::run(*batch()), found(),
                 BatchText::notCountedSentence(batch()->result.project)};
        state.removeAll(QString());
    }
    m_bar->state()->setText(state.join(u' '));
    const bool mayTake = batch() && !faint() && !busy();
    m_worst->setEnabled(mayTake && batch()->summary.worstPart >= 0);
    m_rows->setEnabled(mayTake);
    for (QWidget* choice :
         std::initializer_list<QWidget*>{content(), m_name, m_weights, m_across, m_up}) {
        choice->setEnabled(batch() != nullptr);
    }
    readOut();
    m_histograms->setAccessibleDescription(m_bar->state()->text());
}

// --- texts --------------------------------------------------------------------------------------

QString BatchView::title() const {
    return tr("Batch");
}

QString BatchView::hint() const {
    return tr("Point at a bar or a point to read its values.");
}

QString BatchView::contentNotice() const {
    if (&front() == m_pareto && m_pareto->chart().series.empty()) {
        return tr("No part of this batch fails a requirement.");
    }
    if (&front() != m_sensitivity || !m_sensitivity->empty()) {
        return {};
    }
    if (batch()->factors.empty()) {
        return tr("No factor scatters in this batch.");
    }
    if (m_sensitivity->kind() == SensitivityKind::ranks) {
        return batch()->summary.isSample
                   ? tr("This characteristic or one of the factors does not vary, or there are too "
                        "few parts to show which factor matters.")
                   : tr("Corner parts are not a sample: rank regression needs parts drawn at "
                        "random.");
    }
    if (batch()->result.project.batch->correlation) {
        return tr("Sobol indices have no meaning for correlated factors.");
    }
    if (studies().indexJob().running()) {
        return tr("Sobol indices need additional parts; these are being run.");
    }
    return indices() ? tr("This characteristic does not vary, or some of the parts have none.")
                     : tr("The Sobol indices were stopped. “Run” runs them again.");
}

QString BatchView::keptText() const {
    return batch() ? tr("The inputs are refused; the batch is that of the last valid inputs.")
                   : refusedText();
}

QString BatchView::remark() const {
    if (!good()->result.project.batch) {
        return tr(
            "This project describes no batch. A batch is a number of parts whose stock, runout, "
            "dullness and other factors scatter: it shows which share of them meets the drawing. "
            "Choose the factors on the page Batch of the inputs, or start with the usual factors.");
    }
    if (studies().batch.refusal()) {
        return tr("The batch cannot be run:") + QLatin1Char('\n')
               + Names::refusal(studies().batch.refusal()->issues, 2);
    }
    if (batch() && stale()) {
        return staleText(studies().batch.running(), m_bar->run()->text());
    }
    if (batch()) {
        const QString content = contentNotice();
        return content.isEmpty() ? Names::uncutStrips(batch()->result.project) : content;
    }
    return studies().batch.running() ? QString()
                                     : tr("This batch takes a while: press “Run”. It can be "
                                          "stopped at any time and keeps the finished parts.");
}

QStringList BatchView::subheading() const {
    return {m_name->currentText(), m_bar->state()->text(),
            Names::uncutStrips(batch()->result.project)};
}

void BatchView::nameParts() {
    nameAround(tr("Legend of the batch"), tr("State of the batch"), tr("Values under the mouse"));
    m_histograms->setAccessibleName(tr("Histograms, zone beside zone"));
    m_sensitivity->setAccessibleName(tr("Which factor matters most"));
    m_scatter->setAccessibleName(tr("Parts, one quantity over another"));
    m_pareto->setAccessibleName(tr("Rejects by cause, the most frequent first"));
    m_bar->state()->setAccessibleName(tr("Extent of the run"));
    m_bar->progress()->setAccessibleName(tr("Progress of the batch"));
    m_table->setAccessibleName(tr("Quantities of the batch"));
    fillChoice(*content(),
               {tr("Histograms"), tr("Sensitivity"), tr("Scatter"), tr("Rejects by cause")});
    fillChoice(*m_weights, {tr("Rank regression"), tr("Sobol indices")});
    m_weights->setAccessibleName(tr("Measure of a factor's influence"));
    m_weights->setToolTip(
        tr("Rank regression: standardised coefficients from the parts of the batch; sign and "
           "weight are valid as far as the dependence is monotone, which R² shows. Sobol indices: "
           "shares of the variance, from additional parts."));
    tell(*m_across, tr("Quantity on the horizontal axis"));
    tell(*m_up, tr("Quantity on the vertical axis"));
    tell(*content(), tr("Displayed results of the batch"));
    tell(*m_name, tr("Characteristic"));
    nameButtons();
    m_table->retranslate();
    fillNames();
    fillQuantities();
    showFigures();
}

void BatchView::nameButtons() {
    tellButton(*m_bar->run(), tr("Run"),
               tr("Run the parts of the batch; a quick one runs by itself"));
    tellButton(*m_bar->stop(), tr("Stop"),
               tr("Stop the batch; the completed parts are kept and shown"));
    tellButton(*m_worst, tr("Worst part"),
               tr("Keep the part with the minimum margin as a run and compare it with this "
                  "project, which stays unchanged"));
    tellButton(*m_rows, tr("All parts as CSV"),
               tr("Run the batch again and save a row for every part: its factors, all quantities, "
                  "and whether each requirement is met"));
    m_rows->menu()->actions()[0]->setText(tableFormatText(TableFormat::csvRussian));
    m_rows->menu()->actions()[1]->setText(tableFormatText(TableFormat::csvEnglish));
    tellButton(*m_add, tr("Add a typical batch"),
               tr("50 parts whose stock, runout and dullness scatter about the current inputs; can "
                  "be undone and changed on the page Batch"));
}

} // namespace sparkout
