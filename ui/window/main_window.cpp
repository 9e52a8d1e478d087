// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "core/project/gauge.h"
#include "ui/chart/plot_tools.h"
#include "ui/dialogs/file_questions.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/messages_panel.h"
#include "ui/inputs/row_sliders.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/keyboard.h"
#include "ui/kit/pdf_details.h"
#include "ui/lesson/lesson_desk.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/measured/calibration_dialog.h"
#include "ui/measured/measured_import.h"
#include "ui/report/logo.h"
#include "ui/results/verdict_table.h"
#include "ui/session/background.h"
#include "ui/session/kept_runs.h"
#include "ui/session/part_runs.h"
#include "ui/session/project_io.h"
#include "ui/session/run_controller.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"
#include "ui/views/cycle/compare_view.h"
#include "ui/views/cycle/feeds_view.h"
#include "ui/views/cycle/layers_view.h"
#include "ui/views/part/compliance_view.h"
#include "ui/views/part/overview_view.h"
#include "ui/views/part/profiles_view.h"
#include "ui/views/requirements/constraints_view.h"
#include "ui/views/requirements/verdict_panel.h"
#include "ui/views/study/batch_view.h"
#include "ui/views/study/measured_view.h"
#include "ui/views/study/optimise_view.h"
#include "ui/views/study/sweep_view.h"
#include "ui/window/actions.h"
#include "ui/window/dialogs/company_dialog.h"
#include "ui/window/dialogs/export_dialog.h"
#include "ui/window/dialogs/pack_commands.h"
#include "ui/window/dialogs/part_strip.h"
#include "ui/window/dialogs/part_window.h"
#include "ui/window/dialogs/report_commands.h"
#include "ui/window/dialogs/report_output.h"
#include "ui/window/dialogs/step_sheet.h"
#include "ui/window/dialogs/waves_dialog.h"
#include "ui/window/edit_notices.h"
#include "ui/window/file_commands.h"
#include "ui/window/help_desk.h"
#include "ui/window/lesson_wiring.h"
#include "ui/window/part_commands.h"
#include "ui/window/playback_bar.h"
#include "ui/window/recent_files_menu.h"
#include "ui/window/remedy_offers.h"
#include "ui/window/run_keeper.h"
#include "ui/window/status_line.h"
#include "ui/window/view_tabs.h"
#include "ui/window/window_layout.h"

#include <QCloseEvent>
#include <QCoreApplication>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

namespace sparkout {

MainWindow::MainWindow(Settings& settings, Language& language, RunController::Runner runner)
    : m_settings(settings)
    , m_language(language)
    , m_kept(new KeptRuns(m_document, this))
    , m_partRuns(new PartRuns(m_document, this))
    , m_inputs(new InputsPanel(m_document, this, &m_settings))
    , m_tabs(new ViewTabs(this))
    , m_feeds(new FeedsView(this, &m_settings))
    , m_profiles(new ProfilesView(this, &m_settings))
    , m_constraints(new ConstraintsView(this, &m_settings))
    , m_import(new MeasuredImport(m_document, m_settings, this))
    , m_verdict(new VerdictPanel(this))
    , m_messages(new MessagesPanel(this))
    , m_playback(new PlaybackBar(m_cursor, this))
    , m_sheet(new StepSheet(m_cursor, this))
    , m_actions(new Actions(*this))
    , m_files(new FileCommands(m_document, settings, this))
    , m_packs(new PackCommands(settings, this))
    , m_remedies(new RemedyOffers(
          m_document, m_verdict->remedies(),
          [this](const std::string& path) { m_inputs->revealPath(path); }, this))
    , m_help(new HelpDesk(*this, settings, *m_inputs, *m_tabs, *m_actions))
    , m_lesson(new LessonDesk(m_document, settings, m_files->notices(), this))
    , m_runs(nullptr, std::move(runner)) {
    ToolTips::install();
    setWindowIcon(QIcon(QStringLiteral(":/icons/sparkout.svg")));
    setAcceptDrops(true);
    buildViews();
    statusBar()->addPermanentWidget(m_playback->place(), 3);
    m_status = new StatusLine(*statusBar());
    connect(m_tabs, &ViewTabs::currentChanged, this, &MainWindow::showPlayback);
    connect(m_tabs, &ViewTabs::detachableChanged, this, &MainWindow::showPlayback);
    m_layout =
        new WindowLayout(*this, {m_inputs, m_verdict, m_messages, m_sheet, &m_lesson->panel()},
                         *m_tabs, *m_playback, m_settings);
    StockReading::instance().setOnDiameter(m_settings.stockOnDiameter());
    connectActions();
    connectPart();
    connectDocument();
    connectLesson();
    retranslate();
    keepMnemonics(*this);
    m_layout->restore();
    showPlayback();
}

MainWindow::~MainWindow() {
    delete m_lesson; // keeps its draft
    delete m_files;  // saves the last changes of the document
    m_document.disconnect();
    delete m_layout;   // with the panels that use the document and the cycle's cursor
    delete m_playback; // it uses the cursor, too
}

/// None in a laboratory work: its project would give away what a step hides.
std::optional<PdfAttachment> MainWindow::attachedProject() const {
    if (m_lesson->run().isRunning()) {
        return std::nullopt;
    }
    return projectAttachment(QFileInfo(m_document.filePath()).fileName(),
                             inputsText(m_document.setup()));
}

void MainWindow::buildViews() {
    auto* compliance = new ComplianceView(this, &m_settings);
    connect(compliance, &ComplianceView::gaugeWanted, this, &MainWindow::putGauge);
    auto* layers = new LayersView(this, &m_settings);
    m_batch = new BatchView(this, &m_settings, &m_studies);
    auto* optimise = m_optimise = new OptimiseView(this, &m_settings, &m_studies);
    const auto edit = [this](const auto& change, const EditText& text) {
        m_document.endMerge();
        m_document.edit(change(m_document.project()), text);
    };
    connect(m_batch, &BatchView::editWanted, this, edit);
    connect(m_batch, &BatchView::runWanted, this, [this](const auto& change, const QString& name) {
        if (auto inputs = change(asRun())) {
            m_keeper->keepAside(*std::move(inputs), name);
        }
    });
    optimise->setDocument(m_document);
    connect(optimise, &OptimiseView::editWanted, this, edit);
    auto* sweep = new SweepView(this, &m_settings, &m_studies);
    connect(sweep, &SweepView::editWanted, this, edit);
    m_compare = new CompareView(*m_kept, this, &m_settings);
    m_overview = new OverviewView(*m_kept, this, &m_settings);
    connectOverview();
    m_measured = new MeasuredView(m_document, this, &m_settings, &m_studies);
    connectMeasured();
    m_keeper = new RunKeeper(*m_kept, m_runs, m_studies, m_files->notices(), this);
    connect(m_compare, &CompareView::keepWanted, m_actions->keepRun, &QAction::trigger);
    connect(m_keeper, &RunKeeper::reported, this,
            [this](const QString& text) { m_status->showForAWhile(text); });
    const auto reportEnd = [this](const View* view) { // its notice has the reason
        return [this, view] { m_status->showForAWhile(tr("%1: ended.").arg(view->title())); };
    };
    for (const StudyView* view :
         std::initializer_list<StudyView*>{m_batch, m_measured, sweep, optimise}) {
        connect(view, &StudyView::ended, this, reportEnd(view));
    }
    connect(m_keeper, &RunKeeper::compareWanted, this, [this] { m_tabs->showView(m_compare); });
    for (View* view :
         std::initializer_list<View*>{m_overview, m_feeds, m_profiles, m_constraints, compliance,
                                      layers, m_batch, sweep, optimise, m_compare, m_measured}) {
        m_tabs->addView(view);
        view->shareCycle(&m_cursor);
        for (PlotTools* tools : view->findChildren<PlotTools*>()) {
            tools->setProject([this] { return attachedProject(); });
        }
    }
    auto* middle = new QWidget(this);
    m_lessonWiring = new LessonWiring(middle, this); // before the layout
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_strip = new PartStrip(m_document, *m_partRuns, middle);
    column->addWidget(m_strip);
    column->addWidget(m_tabs, 1);
    column->addWidget(m_playback);
    setCentralWidget(m_files->notices().above(m_lessonWiring->middle()));
}

void MainWindow::connectOverview() {
    connect(m_overview, &OverviewView::stageAsked, this, [this](int stage) {
        m_tabs->showView(m_feeds);
        m_feeds->showStage(stage);
    });
    connect(m_overview, &OverviewView::sectionAsked, this, [this](int section) {
        m_tabs->showView(m_profiles);
        m_profiles->showSection(section);
    });
    connect(m_overview, &OverviewView::requirementAsked, this,
            [this](const ConstraintResult& requirement) {
                m_tabs->showView(m_constraints);
                m_constraints->showRequirement(requirement);
            });
    connect(m_overview, &OverviewView::viewAsked, this, &MainWindow::showView);
    connect(m_overview, &OverviewView::keepAsked, m_actions->keepRun, &QAction::trigger);
    connect(m_batch, &StudyView::ended, m_overview,
            [this] { m_overview->setBatch(m_studies.batch.result()); });
}

void MainWindow::connectMeasured() {
    connect(m_measured, &MeasuredView::importAsked, m_actions->importMeasured, &QAction::trigger);
    connect(m_measured, &MeasuredView::calibrateAsked, m_actions->calibrate, &QAction::trigger);
    connect(m_measured, &MeasuredView::pasteAsked, this, [this] {
        m_inputs->endTyping(); // first
        m_import->paste();
    });
    connect(m_import, &MeasuredImport::imported, this, [this] { m_tabs->showView(m_measured); });
}

/// A given compliance is removed, since it belongs to the old position.
void MainWindow::putGauge(double position_mm) {
    Project project = m_document.project();
    project.gauge->position_mm = position_mm;
    project.gauge->section.reset();
    project.gauge->compliance_mm_per_n.reset();
    m_document.endMerge();
    m_document.edit(std::move(project),
                    {"Edit", QT_TRANSLATE_NOOP("Edit", "Put the gauge in the best place")});
}

/// Shows the bar if there is a recorded cycle and a visible view of its moment.
void MainWindow::showPlayback() {
    const bool any = m_cursor.outcome() && std::ranges::any_of(views(), [this](const View* view) {
                         return view->showsMoment()
                                && (m_tabs->isDetached(view) || m_tabs->currentWidget() == view);
                     });
    if (!any) {
        m_playback->setPlaying(false);
    }
    m_playback->setVisible(any);
    m_playback->place()->setVisible(any && !m_lesson->isCovered());
}

const std::vector<View*>& MainWindow::views() const {
    return m_tabs->views();
}

void MainWindow::connectActions() {
    m_actions->addDocks(m_layout->toggles());
    const QList<QAction*> shows = m_actions->addViews(static_cast<int>(views().size()));
    for (int i = 0; i < shows.size(); ++i) {
        View* view = views()[std::size_t(i)];
        connect(shows[i], &QAction::triggered, this, [this, view] { m_tabs->showView(view); });
    }
    m_actions->addRecentFiles(&m_files->recentFiles());
    const auto on = [this](QAction* action, auto slot) {
        connect(action, &QAction::triggered, this, slot);
    };
    for (QAction* action :
         {m_actions->newTraverse, m_actions->newPlunge, m_actions->open, m_actions->examples,
          m_actions->save, m_actions->saveAs, m_actions->earlierVersions, m_actions->recoverWork,
          m_actions->importMeasured, m_actions->undo, m_actions->redo, m_actions->keepRun}) {
        on(action, [this] { m_inputs->endTyping(); }); // first
    }
    on(m_actions->newTraverse, [this] { m_files->startNew(Operation::traverse); });
    on(m_actions->newPlunge, [this] { m_files->startNew(Operation::plunge); });
    on(m_actions->open, [this] { m_files->open(); });
    on(m_actions->examples, [this] { m_files->openExample(); });
    on(m_actions->save, [this] {
        if (m_lesson->isRunning()) {
            m_lesson->save();
        } else {
            m_files->save();
        }
    });
    on(m_actions->saveAs, [this] {
        if (m_lesson->isRunning()) {
            m_lesson->saveAs();
        } else {
            m_files->saveAs();
        }
    });
    on(m_actions->earlierVersions, [this] { m_files->openEarlierVersion(); });
    on(m_actions->recoverWork, [this] { m_files->recoverWork(); });
    on(m_actions->importMeasured, [this] { m_import->importFile(); });
    on(m_actions->quit, [this] { close(); });
    on(m_actions->undo, [this] {
        if (!m_inputs->dropNewestRefusal()) {
            m_document.undo();
        }
    });
    on(m_actions->redo, [this] { m_document.redo(); });
    on(m_actions->keepRun, [this] { m_keeper->keep(); });
    on(m_actions->calibrate, [this] {
        m_inputs->endTyping(); // first
        const QString done = CalibrationDialog::calibrate(m_document, this);
        if (!done.isEmpty()) {
            m_status->showForAWhile(done);
        }
    });
    on(m_actions->countedWaves, [this] {
        m_inputs->endTyping();
        WavesDialog(m_document.project(), m_settings, this).exec();
    });
    on(m_actions->english, [this] { setLanguage(QStringLiteral("en")); });
    on(m_actions->russian, [this] { setLanguage(QStringLiteral("ru")); });
    for (std::size_t i = 0; i < allThemes.size(); ++i) {
        on(m_actions->themes[i], [this, i] { setTheme(allThemes[i]); });
    }
    for (std::size_t i = 0; i < fontSizes.size(); ++i) {
        on(m_actions->sizes[i], [this, i] { setFontSize(fontSizes[i]); });
    }
    on(m_actions->stockOnDiameter, [this] {
        m_inputs->endTyping(); // commits the text of a field
        StockReading::instance().setOnDiameter(m_actions->stockOnDiameter->isChecked());
    });
    connect(&StockReading::instance(), &StockReading::changed, this, &MainWindow::showStockReading);
    on(m_actions->detach, [this] { toggleDetached(); });
    on(m_actions->nextPanel, [this] { m_layout->movePanel(1); });
    on(m_actions->previousPanel, [this] { m_layout->movePanel(-1); });
    on(m_actions->resetLayout, [this] { m_layout->reset(); });
    connectReports();
}

void MainWindow::showWholePart() {
    if (!m_partWindow) {
        m_partWindow = new PartWindow(
            m_document, *m_partRuns, [this] { return m_optimise->ticks(); }, this);
        connect(m_partWindow, &PartWindow::surfaceWanted, m_part, &PartCommands::show);
        connect(&m_partWindow->study(), &PartStudy::surfaceDone, m_partRuns, &PartRuns::takeStudy);
    }
    m_partWindow->show();
    m_partWindow->raise();
    m_partWindow->activateWindow();
}

const Project& MainWindow::asRun() const {
    return m_document.surfaceCount() > 1 && m_studies.outcome && m_studies.outcome->ran()
                   && !m_runs.running()
               ? m_studies.outcome->result.project
               : m_document.project();
}

/// A refused text exists only in a field of this surface.
bool MainWindow::mayLeaveSurface() {
    m_inputs->endTyping();
    const QStringList refused = refusedLines();
    return refused.isEmpty() || mayLoseRefused(this, refused);
}

void MainWindow::connectPart() {
    m_part = new PartCommands(
        m_document, *m_partRuns, [this] { return mayLeaveSurface(); }, this);
    m_strip->setActions(m_actions->surfaceActions());
    const auto on = [this](QAction* action, auto slot) {
        connect(action, &QAction::triggered, this, slot);
    };
    on(m_actions->addSurface, [this] { m_part->add(); });
    on(m_actions->duplicateSurface, [this] { m_part->duplicate(); });
    on(m_actions->renameSurface, [this] { m_part->rename(); });
    on(m_actions->moveSurfaceLeft, [this] { m_part->move(-1); });
    on(m_actions->moveSurfaceRight, [this] { m_part->move(1); });
    on(m_actions->removeSurface, [this] { m_part->remove(); });
    on(m_actions->previousSurface, [this] { m_part->showNext(-1); });
    on(m_actions->nextSurface, [this] { m_part->showNext(1); });
    on(m_actions->standardTimes, [this] { m_part->editTimes(); });
    on(m_actions->dressing, [this] { m_part->showDressing(); });
    on(m_actions->wholePart, [this] { showWholePart(); });
    connect(m_strip, &PartStrip::surfaceWanted, m_part, &PartCommands::show);
    connect(m_strip, &PartStrip::surfaceOnStepWanted, m_part,
            [this](std::size_t step) { m_part->add(step); });
    connect(m_strip, &PartStrip::wholePartWanted, m_actions->wholePart, &QAction::trigger);
    connect(m_part, &PartCommands::stayed, m_strip, &PartStrip::follow);
    connect(&m_document, &Document::changed, this,
            [this] { m_actions->follow(m_document, !m_inputs->refusals().empty()); });
}

void MainWindow::connectReports() {
    const auto outcomeOfNow = [this] {
        OutcomePtr outcome = m_studies.outcome;
        if (m_runs.running()) { // it belongs to the previous inputs
            runAside([&, upTo = m_document.upToPresent(), faults = m_document.newFaults()] {
                outcome = m_runs.outcomeOf(upTo, faults);
            });
        }
        return outcome;
    };
    auto* commands = new ReportCommands(
        [this, outcomeOfNow]() -> ReportCommands::Subject {
            const bool isSetup = m_document.surfaceCount() > 1 || m_document.state().wear.isGiven();
            return {outcomeOfNow(),
                    m_document.filePath(),
                    m_judge->batch(),
                    &m_cursor,
                    isSetup ? std::optional(m_document.setup()) : std::nullopt,
                    m_document.surface(),
                    m_studies.currentPrediction()};
        },
        m_settings, this);
    const auto studies = [this] { return studiesOffered(m_studies, asRun(), m_document); };
    auto* exports = new ExportCommands(outcomeOfNow, studies, m_settings, this);
    const auto on = [this](QAction* action, const std::function<void()>& command) {
        connect(action, &QAction::triggered, this, [this, command] {
            m_inputs->endTyping(); // first
            command();
        });
    };
    on(m_actions->company, [this] { editCompany(); });
    showLogoFault();
    on(m_actions->importPack, [this] {
        m_packs->importPack();
        showLogoFault();
    });
    on(m_actions->exportPack, [this] { m_packs->exportPack(); });
    connect(m_files, &FileCommands::packChosen, this, [this](const QString& path) {
        m_packs->importFile(path);
        showLogoFault();
    });
    connect(m_files, &FileCommands::measurementsChosen, m_import, &MeasuredImport::importFrom);
    on(m_actions->titlePage, [this] { TitlePageDialog(m_settings, this).exec(); });
    on(m_actions->exportResults, [exports] { exports->exportResults(); });
    auto* output = new ReportOutput(m_settings, this);
    for (std::size_t i = 0; i < m_actions->reports.size(); ++i) {
        output->connectTo(m_actions->reports[i], [this, commands, kind = report::kinds()[i].kind] {
            m_inputs->endTyping(); // first
            return commands->reportOfNow(kind);
        });
    }
}

void MainWindow::editCompany() {
    CompanyDialog(m_settings, this).exec();
    showLogoFault();
}

void MainWindow::showLogoFault() {
    static const QString key = QStringLiteral("logoFault");
    if (report::Logo::fault(m_settings.company().logo).isEmpty()) {
        m_files->notices().remove(key);
        return;
    }
    m_files->notices().add(
        {key,
         Mark::warning,
         [this] {
             return tr("The logo in the heads of documents is left out. %1")
                 .arg(report::Logo::fault(m_settings.company().logo));
         },
         {{[] { return tr("Company and signatures…"); }, [this] { editCompany(); }}}});
}

void MainWindow::setLanguage(const QString& code) {
    m_settings.setLanguage(code);
    m_language.apply(code);
    m_document.nameExample();
    setLocale(QLocale());
    retranslate();
}

void MainWindow::showStockReading() {
    const bool onDiameter = StockReading::instance().onDiameter();
    m_settings.setStockOnDiameter(onDiameter);
    m_actions->stockOnDiameter->setChecked(onDiameter);
    m_inputs->retranslate();
    m_messages->retranslate();
    if (m_studies.outcome) {
        m_inputs->setOutcome(m_studies.outcome);
    }
}

void MainWindow::setTheme(Theme theme) {
    m_settings.setTheme(themeCode(theme));
    applyTheme(theme);
    m_actions->showTheme(theme);
}

/// The panels keep their size, the views get the rest.
void MainWindow::setFontSize(int percent) {
    m_settings.setFontSize(percent);
    applyFontSize(percent);
    m_actions->showFontSize(percent);
    m_layout->fitPanels();
}

bool MainWindow::showView(const QString& name) {
    int number = 0;
    for (View* view : views()) {
        if (name == view->objectName() || name == QString::number(++number)) {
            m_tabs->showView(view);
            return true;
        }
    }
    return false;
}

void MainWindow::toggleDetached() {
    View* view = m_tabs->currentView();
    m_tabs->isDetached(view) ? m_tabs->attach(view) : m_tabs->detach(view);
}

void MainWindow::connectDocument() {
    connect(&m_document, &Document::changed, this, [this] {
        requestRun();
        showTitle();
    });
    connect(&m_document, &Document::stepped, m_inputs, &InputsPanel::revealPath);
    connect(&m_document, &Document::edited, this, [this](const Project& before) {
        showOperationNotice(m_files->notices(), before, m_document.project());
        showLawsNotice(m_files->notices(), m_document.movedLaws());
    });
    const auto drop = [this] { dropEditNotices(m_files->notices()); };
    connect(&m_document, &Document::projectReplaced, this, drop);
    connect(&m_document, &Document::projectReplaced, this, [this] {
        for (View* view : views()) {
            view->forget();
        }
        m_verdict->forget();
        m_judge->forget();
        m_isOutcomeOfBefore = true;
    });
    connect(&m_document, &Document::stepped, this, drop);
    connect(&m_document, &Document::historyChanged, this, [this] {
        m_actions->follow(m_document, !m_inputs->refusals().empty());
        showTitle();
    });
    m_judge = new CycleJudge(m_runs, m_studies, this);
    connect(&m_runs, &RunController::finished, this, &MainWindow::showOutcome);
    connect(m_judge, &CycleJudge::changed, this, [this] {
        if (!m_runs.running()) { // otherwise it belongs to the previous inputs
            showJudged();
        }
    });
    const auto askFor = [this](const std::string& path) {
        m_layout->showInputs();
        m_inputs->focusPath(path);
    };
    connect(m_files, &FileCommands::begun, this, askFor);
    connect(m_part, &PartCommands::begun, this, askFor);
    connect(m_files, &FileCommands::saved, this, [this] {
        const int refused = static_cast<int>(m_inputs->refusals().size());
        m_status->showForAWhile(
            refused == 0
                ? tr("Saved.")
                : tr(
                    "Saved. %n fields contain invalid entries; their last valid values were saved.",
                    nullptr, refused));
    });
    m_files->askRefusedTexts([this] { return refusedLines(); });
    m_recolour.setSingleShot(true);
    m_recolour.setInterval(0); // palettes reach the widgets one by one
    connect(&m_recolour, &QTimer::timeout, this, &MainWindow::recolour);
    m_refusalsTimer.setSingleShot(true);
    m_refusalsTimer.setInterval(0);
    connect(&m_refusalsTimer, &QTimer::timeout, this, [this] {
        const std::vector<Refusal> refusals = m_inputs->refusals();
        m_messages->setRefusals(refusals);
        m_verdict->setRefusedFields(static_cast<int>(refusals.size()));
        m_actions->follow(m_document, !refusals.empty());
        showTitle();
    });
    connect(m_inputs, &InputsPanel::refusalsChanged, this, [this] { m_refusalsTimer.start(); });
    const auto showInput = [this](const std::string& path) { this->showInput(path); };
    connect(m_messages, &MessagesPanel::pathActivated, this, showInput);
    for (View* view : views()) {
        connect(view, &View::inputAsked, this, showInput);
    }
    connect(m_messages, &MessagesPanel::stockFitAsked, this,
            [this] { StockFit::apply(m_document); });
    connect(m_verdict, &VerdictPanel::requirementActivated, this, &MainWindow::showRequirement);
    connect(m_verdict, &VerdictPanel::pathAsked, this, showInput);
    connect(m_constraints, &ConstraintsView::pathAsked, this, showInput);
    connect(m_constraints, &ConstraintsView::requirementEntered, this,
            &MainWindow::showRequirement);
    connect(m_constraints, &ConstraintsView::requirementChosen, this,
            [this](const ConstraintResult& requirement) {
                if (requirement.at && m_feeds->isVisible()) { // in a window of its own
                    m_feeds->showPlace(*requirement.at);
                }
            });
}

void MainWindow::connectLesson() {
    m_files->leaveLessonsTo({[this](const QString& path) { m_lesson->open(path); },
                             [this] { return m_lesson->mayLeave(); }});
    m_lesson->endTypingBy([this] { m_inputs->endTyping(); });
    connect(m_lesson, &LessonDesk::opened, this, [this](const QString& path) {
        m_files->remember(path);
        showTitle();
    });
    connect(m_lesson, &LessonDesk::uncovered, this, &MainWindow::requestRun);
    connect(m_lesson, &LessonDesk::momentWanted, this, &MainWindow::showMoment);
    connect(m_lesson, &LessonDesk::reported, this,
            [this](const QString& text) { m_status->showForAWhile(text); });
    connect(m_lesson, &LessonDesk::limitsChanged, this, [this] {
        if (m_partWindow && m_lesson->isRunning()) { // it shows the results of all surfaces
            m_partWindow->hide();
        }
        m_judge->judgeBatches(!m_lesson->isRunning()); // its steps may ask to predict them
        m_partRuns->judgeBatches(!m_lesson->isRunning());
        m_strip->tellResults(!m_lesson->isCovered()
                             && !m_lesson->hidden().isHidden(Hideable::verdict));
        m_actions->follow(m_document, !m_inputs->refusals().empty());
        showPlayback();
        showTitle();
    });
    HiddenThings& hidden = m_lesson->hidden();
    hidden.add({Hideable::keptRuns}, [this](bool away) { m_overview->offerKeeping(!away); });
    hidden.add({Hideable::calibrate}, [this](bool away) { m_measured->offerCalibration(!away); });
    hidden.add({Hideable::batchIndices}, [this](bool away) { m_batch->tellIndices(!away); });
    connect(m_keeper, &RunKeeper::kept, this, [this](const KeptRun& run) {
        if (m_lesson->isRunning()) {
            m_lesson->takeKeptRun(run);
        }
    });
    connect(this, &MainWindow::outcomeShown, m_lesson,
            [this] { m_lesson->takeOutcome(m_studies.outcome->ran()); });
    m_lessonWiring->connectTo({*m_lesson, *m_actions, *m_tabs, *m_layout, *m_inputs, *m_messages,
                               *m_remedies, *m_files, m_document, m_settings, this});
}

/// Runs nothing while a prediction is awaited, so that no result can be seen.
void MainWindow::requestRun() {
    if (!m_lesson->isCovered()) {
        m_runs.request(m_document.upToPresent(), m_document.newFaults());
        return;
    }
    m_runs.stop();
    for (View* view : views()) {
        view->forget();
    }
    m_verdict->forget();
    m_judge->forget();
    m_inputs->forgetResults();
    m_isOutcomeOfBefore = true;
    Outcome none;
    none.issues.push_back({IssueCode::missingKey, Severity::error, "/", {}, {}});
    showOutcome(std::make_shared<const Outcome>(std::move(none)));
}

void MainWindow::showMoment(const ShownMoment& moment) {
    if (!moment.view.empty()) {
        showView(QString::fromStdString(moment.view));
    }
    if (m_studies.outcome->trajectory.passes.empty()) {
        return;
    }
    if (moment.place.section) {
        m_feeds->showPlace({Zone::section, Step::none, *moment.place.section, 0,
                            moment.count.value_or(m_cursor.stroke()), 0});
        m_profiles->showSection(*moment.place.section);
    }
    LessonWiring::goTo(m_cursor, moment);
}

QStringList MainWindow::refusedLines() const {
    QStringList lines;
    for (const Refusal& refusal : m_inputs->refusals()) {
        lines += tr("%1: %2").arg(inputLocation(refusal.path), refusal.reason);
    }
    return lines;
}

/// The path may name another surface.
void MainWindow::showInput(const std::string& path) {
    std::string place = path;
    for (std::size_t i = 0; i < m_document.surfaceCount(); ++i) {
        const std::string surface = surfacePath(i) + '/';
        if (path.starts_with(surface)) {
            m_part->show(i);
            place = path.substr(surface.size() - 1);
        }
    }
    m_layout->showInputs();
    m_inputs->focusPath(place);
}

/// Shows the field of its setting, its worst pass, or the measured profile.
void MainWindow::showRequirement(const ConstraintResult& requirement) {
    if (const std::string path = verdict::inputPath(requirement); !path.empty()) {
        m_layout->showInputs();
        m_inputs->focusPath(path);
    } else if (requirement.at) {
        m_tabs->showView(m_feeds);
        m_feeds->showPlace(*requirement.at);
    } else {
        m_tabs->showView(m_profiles);
        m_profiles->showSection(requirement.section);
    }
}

void MainWindow::showOutcome(const OutcomePtr& outcome) {
    m_studies.outcome = outcome;
    m_judge->setOutcome(outcome);
    m_inputs->setOutcome(outcome);
    if (!m_lesson->isCovered()) {
        m_messages->setOutcome(outcome);
    }
    const bool isOfBefore = std::exchange(m_isOutcomeOfBefore, false);
    m_cursor.setOutcome(isOfBefore && !outcome->ran() ? nullptr : outcome); // keeps a refused one's
    for (View* view : views()) {
        view->setOutcome(outcome);
    }
    m_verdict->setOutcome(outcome);
    showJudged();
    m_remedies->setOutcome(outcome);
    m_keeper->keepAwaited();
    showPlayback();
    showStatus();
    emit outcomeShown();
}

void MainWindow::showJudged() {
    m_partRuns->setJudged(m_judge->judged());
    m_verdict->setJudged(m_judge->judged());
    m_compare->setJudged(m_judge->judged());
    if (const BatchOutcomePtr batch = m_judge->batch()) {
        m_overview->setBatch(batch);
    }
}

void MainWindow::protect(const QString& stateFolder) {
    m_files->protect(stateFolder);
    m_lesson->protect(stateFolder);
    m_packs->protect(stateFolder);
}

void MainWindow::showStatus() {
    m_status->showOutcome(m_lesson->isCovered() ? nullptr : m_studies.outcome.get(),
                          m_runs.lastRun_ms(), m_cursor.outcome() != nullptr);
}

void MainWindow::showTitle() {
    const QString title = QString::fromStdString(m_document.project().title).simplified();
    QString name = m_lesson->isRunning()
                       ? printableText(QFileInfo(m_lesson->run().file()).fileName())
                   : m_document.filePath().isEmpty()
                       ? (title.isEmpty() ? tr("Untitled") : tr("%1 (not saved)").arg(title))
                       : printableText(QFileInfo(m_document.filePath()).fileName());
    name.replace(QStringLiteral("[*]"), QStringLiteral("[*][*]"));
    const bool isReadOnly = m_document.readOnly() || m_lesson->isReadOnly();
    setWindowTitle(isReadOnly ? tr("%1[*] (read-only) — Sparkout").arg(name)
                              : tr("%1[*] — Sparkout").arg(name));
    setWindowModified(m_document.modified() || !m_inputs->refusals().empty());
}

/// Updates colours that were set explicitly from the window's palette.
void MainWindow::recolour() {
    retranslate(); // sets the marks with the texts
    for (View* view : views()) {
        QEvent event(QEvent::PaletteChange); // the first came too early
        QCoreApplication::sendEvent(view, &event);
    }
}

// Except for the views, which do so themselves.
void MainWindow::retranslate() {
    m_actions->retranslate();
    m_actions->follow(m_document, !m_inputs->refusals().empty());
    m_actions->showLanguage(m_language.code());
    m_actions->showTheme(appliedTheme());
    m_actions->showFontSize(appliedFontSize());
    m_actions->stockOnDiameter->setChecked(StockReading::instance().onDiameter());
    m_actions->nameViews(views());
    m_playback->retranslate();
    m_sheet->retranslate();
    m_layout->retranslate();
    m_status->retranslate();
    m_inputs->retranslate();
    m_messages->retranslate();
    m_tabs->retranslate();
    m_verdict->retranslate();
    m_strip->retranslate();
    m_lesson->retranslate();
    m_lessonWiring->retranslate();
    if (m_partWindow) {
        m_partWindow->retranslate();
    }
    if (m_studies.outcome) {
        m_inputs->setOutcome(m_studies.outcome);
    }
    nameShortcuts(*m_actions);
    showStatus();
    showTitle();
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        m_recolour.start();
    }
    QMainWindow::changeEvent(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    m_inputs->endTyping();
    if (!m_lessonWiring->mayClose() || !m_files->mayClose()) {
        event->ignore();
        return;
    }
    m_layout->save();
    event->accept();
}

/// A table is pasted into the view of measurements, even if only its tab has the focus.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Paste) && m_tabs->currentWidget() == m_measured) {
        emit m_measured->pasteAsked();
    } else {
        QMainWindow::keyPressEvent(event);
    }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.first().isLocalFile()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QString path = event->mimeData()->urls().value(0).toLocalFile();
    event->acceptProposedAction();
    m_inputs->endTyping();
    if (!path.isEmpty()) { // later: the source of the drag must not wait for an answer
        QMetaObject::invokeMethod(
            m_files, [this, path] { m_files->openInstead(path); }, Qt::QueuedConnection);
    }
}

} // namespace sparkout
