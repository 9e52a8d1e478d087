// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/measured_view.h"

#include "core/project/batch.h"
#include "core/project/measured.h"
#include "core/study/batch_edits.h"
#include "ui/chart/bar_plot.h"
#include "ui/chart/legend.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/tool_row.h"
#include "ui/measured/measured_boxes.h"
#include "ui/measured/measured_text.h"
#include "ui/session/document.h"
#include "ui/text/names.h"
#include "ui/views/study/data_sheet.h"

#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr int boxesShare = 200, judgedShare = 200; ///< initial shares of the height
constexpr int comparisonLetters = 40; ///< least width of the text on the comparison, in letters

struct PredictionProgress {
    Q_DECLARE_TR_FUNCTIONS(MeasuredView)
public:
    static QString text(qint64 done, qint64 parts, double left_s) {
        return RunBar::withTimeLeft(
            tr("%1 of %2 parts predicted").arg(QLocale().toString(done), QLocale().toString(parts)),
            left_s);
    }
};

} // namespace

MeasuredView::MeasuredView(Document& document, QWidget* parent, Settings* settings,
                           Studies* studies)
    : StudyView(QStringLiteral("measured"), parent, settings, studies)
    , m_boxes(new BarPlot(this))
    , m_model(new ValueModel(this))
    , m_judgement(new QLabel(this))
    , m_splitter(new QSplitter(Qt::Vertical, this))
    , m_sheets(new QStackedWidget(this))
    , m_sheet(new QComboBox(this))
    , m_quantity(new QComboBox(this))
    , m_bar(new RunBar(QStringLiteral("measured"), this, PredictionProgress::text))
    , m_import(new QPushButton(this))
    , m_paste(new QPushButton(this))
    , m_calibrate(new QPushButton(this))
    , m_start(new QPushButton(this)) {
    m_boxes->setMinimumSize(240, 120);
    addPage(*m_boxes);
    constexpr int valueLines = 4;
    setUpReadout(*values(), valueLines);
    setUpNotice(*m_bar->state());
    setUpNotice(*m_judgement);
    m_bar->layOut({}, {}, comparisonLetters);
    m_sheets->addWidget(buildComparison());
    for (std::size_t i = 0; i < m_data.size(); ++i) {
        m_data[i] = new DataSheet(static_cast<DataModel::List>(i), document, settings, m_sheets);
        m_sheets->addWidget(m_data[i]);
    }
    QVBoxLayout* const column =
        addColumn({buildTools(), m_bar, notice(), m_start, legend(), m_sheets, values()}, m_sheets);
    column->setAlignment(m_start, Qt::AlignLeft);
    nameObjects({{m_boxes, "measuredBoxes"},
                 {m_table, "measuredTable"},
                 {m_judgement, "measuredJudgement"},
                 {m_sheet, "measuredSheet"},
                 {m_quantity, "measuredQuantity"},
                 {m_import, "measuredImport"},
                 {m_paste, "measuredPaste"},
                 {m_calibrate, "measuredCalibrate"},
                 {m_start, "measuredStart"}});
    m_table->setArrangeable(settings);
    connectParts();
    built();
    chooseSheet();
}

QWidget* MeasuredView::buildTools() {
    auto* bar = new QWidget(this);
    auto* row = rowIn<ToolRow>(bar);
    addBoxes(*row, {m_sheet, m_quantity});
    row->addStretch(1);
    row->addWidget(m_import);
    row->addWidget(m_paste);
    row->addWidget(m_calibrate);
    addPageButtons(*row);
    return bar;
}

QWidget* MeasuredView::buildComparison() {
    m_table = addTable(*m_model);
    m_table->setUniformRows();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->verticalHeader()->hide();
    m_table->setMinimumHeight(80);
    auto* below = new QWidget(m_splitter);
    auto* column = new QVBoxLayout(below);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_table, 2);
    m_judged = new QScrollArea(below);
    m_judged->setObjectName(QStringLiteral("measuredJudgementArea"));
    m_judged->setWidget(m_judgement);
    m_judged->setWidgetResizable(true);
    m_judged->setFrameShape(QFrame::NoFrame);
    m_judged->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_judgement->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    column->addWidget(m_judged, 1);
    share(*m_splitter, {{pages(), boxesShare}, {below, judgedShare}});
    hideUntilDrawn({m_splitter});
    auto* page = new QWidget(m_sheets);
    auto* around = new QVBoxLayout(page);
    around->setContentsMargins(0, 0, 0, 0);
    around->addWidget(m_splitter, 1);
    return page;
}

void MeasuredView::connectParts() {
    connect(m_sheet, &QComboBox::currentIndexChanged, this, &MeasuredView::chooseSheet);
    connect(m_quantity, &QComboBox::currentIndexChanged, this, &MeasuredView::chooseQuantity);
    connect(m_bar->run(), &QPushButton::clicked, this, &MeasuredView::runBatch);
    m_bar->follow(studies().prediction.job());
    connect(&studies().prediction.job(), &Job::answered, this, &MeasuredView::takeBatch);
    connect(&studies().heldOut.job(), &Job::answered, this, &MeasuredView::judge);
    connect(m_import, &QPushButton::clicked, this, &MeasuredView::importAsked);
    connect(m_start, &QPushButton::clicked, this, &MeasuredView::importAsked);
    connect(m_paste, &QPushButton::clicked, this, &MeasuredView::pasteAsked);
    connect(m_calibrate, &QPushButton::clicked, this, &MeasuredView::calibrateAsked);
    connect(m_table, &CopyTable::rowChosen, this, [this](int row) {
        const int at = m_quantity->findData(
            static_cast<int>(m_rows.at(static_cast<std::size_t>(row)).measured.quantity));
        m_quantity->setCurrentIndex(at);
    });
}

/// Handles keys that its fields and tables ignore.
void MeasuredView::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Paste)) {
        emit pasteAsked();
    } else {
        PlotView::keyPressEvent(event);
    }
}

// --- choices ------------------------------------------------------------------------------------

bool MeasuredView::isComparing() const {
    return m_sheet->currentIndex() <= comparison;
}

void MeasuredView::chooseSheet() {
    m_sheets->setCurrentIndex(std::max(m_sheet->currentIndex(), 0));
    showState();
    showLegend();
    replotAll();
}

void MeasuredView::chooseQuantity() {
    if (m_quantity->currentIndex() >= 0) {
        m_wanted = static_cast<MeasuredQuantity>(m_quantity->currentData().toInt());
        showComparison();
    }
}

void MeasuredView::fillQuantities() {
    const QSignalBlocker blocker(m_quantity);
    m_quantity->clear();
    for (const MeasuredQuantity quantity : MeasuredBoxes::quantities(m_rows)) {
        m_quantity->addItem(MeasuredText::quantity(quantity), static_cast<int>(quantity));
    }
    m_quantity->setCurrentIndex(std::max(m_quantity->findData(static_cast<int>(m_wanted)), 0));
}

// --- running ------------------------------------------------------------------------------------

bool MeasuredView::hasStatistics() const {
    return m_hasStatistics;
}

void MeasuredView::takeOutcome(const OutcomePtr&) {
    const Project& project = good()->result.project;
    m_hasStatistics = !statisticsOfMeasured(project).empty();
    StudyOf<HeldOut>& heldOut = studies().heldOut;
    heldOut.follow(&project);
    if (heldOut.stale() && !heldOut.running()) {
        studies().runHoldOut(project);
    }
    const Project predicting = predictingProject(project);
    studies().prediction.follow(&predicting);
    if (!hasStatistics()) {
        dropStudies();
        return;
    }
    if (stale() && !busy() && RunBar::areQuick(partsOf(predicting), good()->result.visits)) {
        runBatch();
    }
    judge();
}

void MeasuredView::dropOutcome() {
    m_hasStatistics = false;
    studies().heldOut.forget();
    judge();
}

void MeasuredView::dropStudies() {
    studies().prediction.forget();
    judge();
    showState();
}

void MeasuredView::runBatch() {
    const Project predicting = predictingProject(good()->result.project);
    m_bar->showProgress(0, partsOf(predicting));
    studies().runPrediction(predicting);
    showState();
}

void MeasuredView::takeBatch() {
    if (!studies().prediction.refusal()) {
        judge();
    }
    showState();
    emit ended();
}

void MeasuredView::judge() {
    const bool has = batch() && good() && hasStatistics();
    const Project& project = good() ? good()->result.project : Project();
    m_rows = has ? judgeAdequacy(project, batch()->result) : std::vector<AdequacyRow>();
    m_model->update(adequacyTable(project, m_rows));
    m_judgement->setText(has ? (MeasuredText::judgement(project, m_rows)
                                + MeasuredText::holdOut(project, studies().currentHeldOut()))
                                   .join(u'\n')
                             : QString());
    fillQuantities();
    showComparison();
}

// --- showing ------------------------------------------------------------------------------------

void MeasuredView::showComparison() {
    const auto chosen = static_cast<MeasuredQuantity>(m_quantity->currentData().toInt());
    m_boxes->setChart(
        m_rows.empty() ? BarChart() : MeasuredBoxes::chart(good()->result.project, m_rows, chosen));
    m_boxes->setAccessibleDescription(m_boxes->chart().description());
    showState();
    showLegend();
    replotAll();
}

bool MeasuredView::drawn() const {
    return isComparing() && !m_rows.empty();
}

bool MeasuredView::faint() const {
    return !m_rows.empty() && (stale() || refused());
}

QString MeasuredView::stateText() const {
    if (m_rows.empty()) {
        return {};
    }
    const auto agreeing =
        std::ranges::count(m_rows, AdequacyVerdict::adequate, &AdequacyRow::verdict);
    const QString predicted = tr("The prediction is of a batch of %n part(s).", nullptr,
                                 static_cast<int>(batch()->summary.parts));
    return predicted + u' '
           + (speaksForModel(m_rows)
                  ? tr("No contradiction with the model; %1 of %2 comparisons agree.")
                  : tr("The model does not agree with the parts; %1 of %2 comparisons agree."))
                 .arg(agreeing)
                 .arg(m_rows.size());
}

void MeasuredView::showState() {
    PlotView::showState();
    const bool isEmpty = !hasStatistics();
    m_bar->setVisible(isComparing() && !isEmpty);
    m_start->setVisible(isComparing() && isEmpty && good() && !refused());
    m_bar->showRunning(busy(), hasStatistics() && !refused());
    m_bar->state()->setText(stateText());
    m_quantity->setVisible(isComparing() && m_quantity->count() > 0);
    readOut();
}

// --- texts --------------------------------------------------------------------------------------

QString MeasuredView::title() const {
    return tr("Measured");
}

QString MeasuredView::hint() const {
    const QString point = tr("Point at a box to read its values.");
    const QString& remark = m_boxes->chart().remark;
    return remark.isEmpty() ? point : point + u' ' + remark;
}

QString MeasuredView::keptText() const {
    return m_rows.empty()
               ? refusedText()
               : tr("The inputs are refused; the prediction is that of the last valid inputs.");
}

void MeasuredView::offerCalibration(bool offers) {
    m_calibrate->setVisible(offers);
}

QString MeasuredView::recordedText() const {
    const OptionalShared<Measured>& measured = good()->result.project.measured;
    if (!measured || measured->traces.empty()) {
        return {};
    }
    QStringList names;
    for (const MeasuredTrace& trace : measured->traces) {
        names << Names::inSentence(MeasuredText::trace(trace.quantity));
    }
    const QString recorded =
        tr("Recorded over time: %1. The view Feeds draws it over the simulated curves, "
           "“Calibrate…” fits the process to it, the list “Traces” keeps it. No part is "
           "measured yet that could be compared with the predicted batch.")
            .arg(names.join(QStringLiteral("; ")));
    return (QStringList(recorded)
            + MeasuredText::holdOut(good()->result.project, studies().currentHeldOut()))
        .join(u'\n');
}

QString MeasuredView::remark() const {
    if (!isComparing()) {
        return {};
    }
    if (!hasStatistics()) {
        if (const QString recorded = recordedText(); !recorded.isEmpty()) {
            return recorded;
        }
        return tr("No part is measured yet. Measured diameters, runout, roundness, cylindricity "
                  "and roughness will be shown here beside the predicted batch, with a verdict on "
                  "the model. Import a table of a measuring machine, paste one from a spreadsheet "
                  "(Ctrl+V), or enter the statistics of a printed table under “Statistics”.");
    }
    if (studies().prediction.refusal()) {
        return tr("The predicted batch cannot be run:") + QLatin1Char('\n')
               + Names::refusal(studies().prediction.refusal()->issues, 2);
    }
    if (batch() && stale()) {
        return staleText(busy(), m_bar->run()->text());
    }
    if (!batch()) {
        return busy() ? QString()
                      : tr("The predicted batch takes a while: press “Run”. It can be stopped at "
                           "any time.");
    }
    return good()->result.project.batch
               ? QString()
               : tr("This project describes no batch, so the prediction is one part without "
                    "scatter. Choose the scattering factors on the page Batch of the inputs.");
}

QStringList MeasuredView::subheading() const {
    return {m_quantity->currentText(), m_bar->state()->text(), m_boxes->chart().remark};
}

void MeasuredView::nameParts() {
    nameAround(tr("Legend of the comparison"), tr("State of the comparison"),
               tr("Values under the mouse"));
    m_boxes->setAccessibleName(tr("Measured parts beside the predicted ones"));
    m_bar->state()->setAccessibleName(tr("Extent of the comparison"));
    m_bar->progress()->setAccessibleName(tr("Progress of the batch"));
    m_table->setAccessibleName(tr("Measured against predicted"));
    m_judgement->setAccessibleName(tr("Verdict on the model"));
    m_judged->setAccessibleName(tr("Verdict on the model"));
    fillChoice(*m_sheet, {tr("Comparison"), tr("Parts"), tr("Statistics"), tr("Traces")});
    tell(*m_sheet, tr("Displayed results of the measurements"));
    tell(*m_quantity, tr("Measured quantity"));
    tellButton(*m_bar->run(), tr("Run"), tr("Run the predicted batch; a quick one runs by itself"));
    tellButton(*m_bar->stop(), tr("Stop"),
               tr("Stop the batch; the completed parts are kept and shown"));
    tellButton(*m_import, tr("Import…"),
               tr("Read a table of measured parts or of traces from a file"));
    tellButton(*m_paste, tr("Paste…"),
               tr("Read a table that was copied from a spreadsheet (Ctrl+V)"));
    tellButton(*m_calibrate, tr("Calibrate…"),
               tr("Fit compliance, force and wheel to the measurements"));
    tellButton(*m_start, tr("Import measurements…"),
               tr("Read a table of measured parts or of traces from a file"));
    for (DataSheet* sheet : m_data) {
        sheet->retranslate();
    }
    m_table->retranslate();
    if (good()) {
        judge();
    } else {
        m_model->update(adequacyTable({}, {}));
    }
}

} // namespace sparkout
