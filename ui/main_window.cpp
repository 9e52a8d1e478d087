// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/export/export_commands.h"
#include "ui/file_commands.h"
#include "ui/help/help_desk.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/messages_panel.h"
#include "ui/keyboard.h"
#include "ui/notice_bar.h"
#include "ui/operation_notice.h"
#include "ui/playback_bar.h"
#include "ui/recent_files_menu.h"
#include "ui/report/report_commands.h"
#include "ui/run_keeper.h"
#include "ui/sealed_state.h"
#include "ui/session/background.h"
#include "ui/session/kept_runs.h"
#include "ui/session/texts.h"
#include "ui/view_tabs.h"
#include "ui/views/batch_view.h"
#include "ui/views/compare_view.h"
#include "ui/views/compliance_view.h"
#include "ui/views/constraints_view.h"
#include "ui/views/feeds_view.h"
#include "ui/views/layers_view.h"
#include "ui/views/optimise_view.h"
#include "ui/views/profiles_view.h"
#include "ui/views/step_sheet.h"
#include "ui/views/sweep_view.h"
#include "ui/views/verdict_panel.h"
#include "ui/views/verdict_why.h"

#include <QAbstractButton>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QScreen>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {

constexpr QSize usualWindow(1366, 768);
constexpr QSize frameAllowance(8, 40);
constexpr int verdictWidth = 327;
constexpr int messagesHeight = 96;

/// The buttons Qt puts in by itself, which it names once and in one language, or not at all.
void nameQtButtons(const QWidget& window) {
    const auto name = [&window](const char* object, const QString& text) {
        for (auto* button : window.findChildren<QAbstractButton*>(QString::fromLatin1(object))) {
            button->setAccessibleName(text);
            button->setAccessibleDescription(text);
            button->setToolTip(text);
        }
    };
    name("qt_dockwidget_floatbutton", MainWindow::tr("Detach or attach the panel"));
    name("qt_dockwidget_closebutton", MainWindow::tr("Close the panel"));
    name("qt_toolbar_ext_button", MainWindow::tr("More commands"));
    name("qt_menubar_ext_button", MainWindow::tr("More menus"));
    name("ScrollLeftButton", MainWindow::tr("Scroll to the left"));
    name("ScrollRightButton", MainWindow::tr("Scroll to the right"));
}

} // namespace

MainWindow::MainWindow(Settings& settings, Language& language, RunController::Runner runner)
    : m_settings(settings)
    , m_language(language)
    , m_kept(new KeptRuns(m_document, this))
    , m_inputs(new InputsPanel(m_document, this, &m_settings))
    , m_tabs(new ViewTabs(this))
    , m_feeds(new FeedsView(this, &m_settings))
    , m_profiles(new ProfilesView(this, &m_settings))
    , m_constraints(new ConstraintsView(this, &m_settings))
    , m_verdict(new VerdictPanel(this))
    , m_messages(new MessagesPanel(this))
    , m_playback(new PlaybackBar(m_cursor, this))
    , m_sheet(new StepSheet(m_cursor, this))
    , m_status(new QLabel(this))
    , m_time(new QLabel(this))
    , m_actions(new Actions(*this))
    , m_files(new FileCommands(m_document, settings, this))
    , m_help(new HelpDesk(*this, settings, *m_inputs, *m_tabs, *m_actions))
    , m_runs(nullptr, std::move(runner)) {
    setWindowIcon(QIcon(QStringLiteral(":/icons/sparkout.svg")));
    setAcceptDrops(true);
    buildViews();
    m_status->setTextFormat(Qt::PlainText);
    m_time->setTextFormat(Qt::PlainText);
    statusBar()->addWidget(m_status, 1);
    statusBar()->addPermanentWidget(m_time);
    buildDocks();
    connectActions();
    connectDocument();
    retranslate();
    keepMnemonics(*this);
    restoreWindow();
}

MainWindow::~MainWindow() {
    delete m_files; // keeps the last changes of the document
    m_document.disconnect();
    delete m_inputsDock; // its fields look at the document
    delete m_sheetDock;  // it looks at the cursor of the cycle
    delete m_playback;   // likewise
}

void MainWindow::buildViews() {
    auto* compliance = new ComplianceView(this, &m_settings);
    connect(compliance, &ComplianceView::gaugeWanted, this, &MainWindow::putGauge);
    auto* layers = new LayersView(this, &m_settings);
    m_batch = new BatchView(this, &m_settings);
    auto* optimise = new OptimiseView(this, &m_settings);
    const auto edit = [this](const auto& change, const EditText& text) {
        m_document.endMerge();
        m_document.edit(change(m_document.project()), text);
    };
    connect(m_batch, &BatchView::editWanted, this, edit);
    connect(optimise, &OptimiseView::editWanted, this, edit);
    auto* sweep = new SweepView(this, &m_settings);
    connect(sweep, &SweepView::editWanted, this, edit);
    auto* compare = new CompareView(*m_kept, this, &m_settings);
    m_keeper = new RunKeeper(*m_kept, m_runs, m_files->notices(), this);
    connect(compare, &CompareView::keepWanted, m_actions->keepRun, &QAction::trigger);
    connect(m_keeper, &RunKeeper::told, this,
            [this](const QString& text) { statusBar()->showMessage(text, 6000); });
    connect(m_keeper, &RunKeeper::compareWanted, this,
            [this, compare] { m_tabs->showView(compare); });
    for (View* view : std::initializer_list<View*>{m_feeds, m_profiles, m_constraints, compliance,
                                                   layers, m_batch, sweep, optimise, compare}) {
        m_tabs->addView(view);
        view->shareCycle(&m_cursor);
    }
    auto* middle = new QWidget(this);
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_tabs, 1);
    column->addWidget(m_playback);
    setCentralWidget(m_files->notices().above(middle));
}

/// Its compliance is that of the place, so a given one goes.
void MainWindow::putGauge(double position_mm) {
    Project project = m_document.project();
    project.gauge.position_mm = position_mm;
    project.gauge.section.reset();
    project.gauge.compliance_mm_per_n.reset();
    m_document.endMerge();
    m_document.edit(std::move(project),
                    {"Edit", QT_TRANSLATE_NOOP("Edit", "Put the gauge in the best place")});
}

QDockWidget* MainWindow::addDock(QWidget* content, const QString& name, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(this);
    dock->setObjectName(name);
    dock->setWidget(content);
    addDockWidget(area, dock);
    return dock;
}

void MainWindow::buildDocks() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_inputsDock = addDock(m_inputs, QStringLiteral("inputs"), Qt::LeftDockWidgetArea);
    m_verdictDock = addDock(m_verdict, QStringLiteral("verdict"), Qt::RightDockWidgetArea);
    m_messagesDock = addDock(m_messages, QStringLiteral("messages"), Qt::BottomDockWidgetArea);
    m_sheetDock = addDock(m_sheet, QStringLiteral("step"), Qt::RightDockWidgetArea);
    QAction* const sheet = m_sheetDock->toggleViewAction();
    sheet->setIcon(themeIcon(u"formula"));
    m_playback->addTool(sheet);
    connect(sheet, &QAction::triggered, this, [this](bool shown) {
        if (shown) { // below the verdict, if it has not been moved
            resizeDocks({m_verdictDock, m_sheetDock}, {2, 3}, Qt::Vertical);
        }
    });
    m_actions->addDocks({m_inputsDock->toggleViewAction(), m_verdictDock->toggleViewAction(),
                         m_messagesDock->toggleViewAction(), sheet});
    const QList<QAction*> shows = m_actions->addViews(static_cast<int>(views().size()));
    for (int i = 0; i < shows.size(); ++i) {
        View* view = views()[std::size_t(i)];
        connect(shows[i], &QAction::triggered, this, [this, view] { m_tabs->showView(view); });
    }
}

const std::vector<View*>& MainWindow::views() const {
    return m_tabs->views();
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

void MainWindow::resetLayout() {
    m_tabs->attachAll();
    for (QDockWidget* dock : {m_inputsDock, m_verdictDock, m_messagesDock, m_sheetDock}) {
        dock->setFloating(false);
        dock->setVisible(dock != m_sheetDock);
    }
    addDockWidget(Qt::LeftDockWidgetArea, m_inputsDock);
    addDockWidget(Qt::RightDockWidgetArea, m_verdictDock);
    addDockWidget(Qt::BottomDockWidgetArea, m_messagesDock);
    splitDockWidget(m_verdictDock, m_sheetDock, Qt::Vertical);
    resizeDocks({m_inputsDock, m_verdictDock},
                {m_inputs->minimumSizeHint().width(), atFontSize(verdictWidth)}, Qt::Horizontal);
    resizeDocks({m_messagesDock}, {messagesHeight}, Qt::Vertical);
}

void MainWindow::restoreWindow() {
    // Frame and title bar need room too: on a small screen the status bar must stay in sight.
    resize(usualWindow.boundedTo(screen()->availableSize() - frameAllowance));
    resetLayout();
    if (const auto parts = unsealed(m_settings.windowGeometry(), 1)) {
        restoreGeometry(parts->front());
    }
    if (const auto parts = unsealed(m_settings.windowState(), 2)) {
        restoreState(parts->front());
        m_tabs->restoreState(parts->back());
    }
}

void MainWindow::saveWindow() {
    m_settings.setWindow(sealed({saveGeometry()}), sealed({saveState(), m_tabs->saveState()}));
}

void MainWindow::connectActions() {
    m_actions->addRecentFiles(&m_files->recentFiles());
    const auto on = [this](QAction* action, auto slot) {
        connect(action, &QAction::triggered, this, slot);
    };
    for (QAction* action :
         {m_actions->newTraverse, m_actions->newPlunge, m_actions->open, m_actions->examples,
          m_actions->save, m_actions->saveAs, m_actions->earlierVersions, m_actions->recoverWork,
          m_actions->undo, m_actions->redo, m_actions->keepRun}) {
        on(action, [this] { m_inputs->endTyping(); }); // first
    }
    on(m_actions->newTraverse, [this] { m_files->startNew(Operation::traverse); });
    on(m_actions->newPlunge, [this] { m_files->startNew(Operation::plunge); });
    on(m_actions->open, [this] { m_files->open(); });
    on(m_actions->examples, [this] { m_files->openExample(); });
    on(m_actions->save, [this] { m_files->save(); });
    on(m_actions->saveAs, [this] { m_files->saveAs(); });
    on(m_actions->earlierVersions, [this] { m_files->openEarlierVersion(); });
    on(m_actions->recoverWork, [this] { m_files->recoverWork(); });
    on(m_actions->quit, [this] { close(); });
    on(m_actions->undo, [this] {
        if (!m_inputs->dropNewestRefusal()) {
            m_document.undo();
        }
    });
    on(m_actions->redo, [this] { m_document.redo(); });
    on(m_actions->keepRun, [this] { m_keeper->keep(); });
    on(m_actions->english, [this] { setLanguage(QStringLiteral("en")); });
    on(m_actions->russian, [this] { setLanguage(QStringLiteral("ru")); });
    for (std::size_t i = 0; i < allThemes.size(); ++i) {
        on(m_actions->themes[i], [this, i] { setTheme(allThemes[i]); });
    }
    for (std::size_t i = 0; i < fontSizes.size(); ++i) {
        on(m_actions->sizes[i], [this, i] { setFontSize(fontSizes[i]); });
    }
    on(m_actions->detach, [this] { toggleDetached(); });
    on(m_actions->nextPanel, [this] { movePanel(1); });
    on(m_actions->previousPanel, [this] { movePanel(-1); });
    on(m_actions->resetLayout, [this] { resetLayout(); });
    connectReports();
}

void MainWindow::connectReports() {
    const auto outcomeOfNow = [this] {
        OutcomePtr outcome = m_outcome;
        if (m_runs.running()) { // that one is of the inputs before
            runAside([&, project = m_document.project()] { outcome = runProject(project, {}); });
        }
        return outcome;
    };
    auto* commands = new ReportCommands(
        [this, outcomeOfNow]() -> ReportCommands::Subject {
            return {outcomeOfNow(), m_document.filePath(), m_batch->batch(), &m_cursor};
        },
        m_settings, this);
    auto* exports = new ExportCommands(outcomeOfNow, m_settings, this);
    connect(exports, &ExportCommands::told, this,
            [this](const QString& text) { statusBar()->showMessage(text, 6000); });
    const auto on = [this](QAction* action, const std::function<void()>& command) {
        connect(action, &QAction::triggered, this, [this, command] {
            m_inputs->endTyping(); // first
            command();
        });
    };
    on(m_actions->exportResults, [exports] { exports->exportResults(); });
    for (const ReportActions& report : m_actions->reports) {
        const report::Kind kind = report.kind;
        const auto writes = [commands, kind](report::Format format) {
            return [commands, kind, format] { commands->exportReport(kind, format); };
        };
        on(report.preview, [commands, kind] { commands->preview(kind); });
        on(report.print, [commands, kind] { commands->print(kind); });
        on(report.pdf, writes(report::Format::pdf));
        on(report.html, writes(report::Format::html));
        on(report.markdown, writes(report::Format::markdown));
    }
}

void MainWindow::connectDocument() {
    connect(&m_document, &Document::changed, this, [this] {
        m_runs.request(m_document.project());
        showTitle();
    });
    connect(&m_document, &Document::stepped, m_inputs, &InputsPanel::revealPath);
    connect(&m_document, &Document::edited, this, [this](const Project& before) {
        tellOperation(m_files->notices(), before, m_document.project());
    });
    const auto drop = [this] { dropOperationNotice(m_files->notices()); };
    connect(&m_document, &Document::replaced, this, drop);
    connect(&m_document, &Document::replaced, this, [this] {
        for (View* view : views()) {
            view->forget();
        }
    });
    connect(&m_document, &Document::stepped, this, drop);
    connect(&m_document, &Document::historyChanged, this, [this] {
        m_actions->follow(m_document, !m_inputs->refusals().empty());
        showTitle();
    });
    connect(&m_runs, &RunController::finished, this, &MainWindow::showOutcome);
    connect(m_files, &FileCommands::saved, this, [this] {
        const int refused = static_cast<int>(m_inputs->refusals().size());
        statusBar()->showMessage(
            refused == 0
                ? tr("Saved.")
                : tr("Saved; %n fields hold a refused text, their last good values were saved.",
                     nullptr, refused),
            6000);
    });
    m_files->askRefusedTexts([this] {
        QStringList lines;
        for (const Refusal& refusal : m_inputs->refusals()) {
            lines += tr("%1: %2").arg(locationText(refusal.path), refusal.reason);
        }
        return lines;
    });
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
    const auto showInput = [this](const std::string& path) {
        m_inputsDock->show();
        m_inputs->focusPath(path);
    };
    connect(m_messages, &MessagesPanel::pathActivated, this, showInput);
    connect(m_verdict, &VerdictPanel::requirementActivated, this, &MainWindow::showRequirement);
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

/// The field it is set in, the passes it was worst in, or the profile it was measured on.
void MainWindow::showRequirement(const ConstraintResult& requirement) {
    if (const std::string path = verdict::inputPath(requirement); !path.empty()) {
        m_inputsDock->show();
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
    m_outcome = outcome;
    m_inputs->setOutcome(outcome);
    m_messages->setOutcome(outcome);
    m_cursor.setOutcome(outcome);
    for (View* view : views()) {
        view->setOutcome(outcome);
    }
    m_verdict->setOutcome(outcome);
    m_keeper->setOutcome(outcome);
    showStatus();
    emit outcomeShown();
}

void MainWindow::showStatus() {
    if (!m_outcome) {
        m_status->clear();
        m_time->clear();
        return;
    }
    if (!m_outcome->ran()) {
        const auto faults =
            std::count_if(m_outcome->issues.begin(), m_outcome->issues.end(),
                          [](const Issue& issue) { return issue.severity == Severity::error; });
        m_status->setText(tr("Not computed: %n faults in the inputs. The curves show the last "
                             "good run.",
                             nullptr, static_cast<int>(faults)));
        m_time->clear();
        return;
    }
    switch (m_outcome->result.status) {
    case RunStatus::completed: m_status->setText(tr("The cycle is complete.")); break;
    case RunStatus::cannotReachSize:
        m_status->setText(tr("The cycle cannot reach size: it stopped making progress."));
        break;
    case RunStatus::tooLong:
        m_status->setText(tr("The cycle is too long to be computed to its end."));
        break;
    case RunStatus::notSolved:
        m_status->setText(tr("The forces of the coupled sections were not found."));
        break;
    case RunStatus::stopped: break;
    }
    m_time->setText(tr("Computed in %1 ms").arg(QLocale().toString(m_runs.lastRun_ms(), 'f', 1)));
}

void MainWindow::showTitle() {
    const QString title = QString::fromStdString(m_document.project().title).simplified();
    QString name = m_document.filePath().isEmpty()
                       ? (title.isEmpty() ? tr("Untitled") : tr("%1 (not saved)").arg(title))
                       : QFileInfo(m_document.filePath()).fileName();
    name.replace(QStringLiteral("[*]"), QStringLiteral("[*][*]"));
    setWindowTitle(m_document.readOnly() ? tr("%1[*] (read-only) — Sparkout").arg(name)
                                         : tr("%1[*] — Sparkout").arg(name));
    setWindowModified(m_document.modified() || !m_inputs->refusals().empty());
}

void MainWindow::setLanguage(const QString& code) {
    m_settings.setLanguage(code);
    m_language.apply(code);
    setLocale(QLocale());
    retranslate();
}

void MainWindow::setTheme(Theme theme) {
    m_settings.setTheme(themeCode(theme));
    applyTheme(theme);
    m_actions->showTheme(theme);
}

/// The panels keep their room, the views take what is left.
void MainWindow::setFontSize(int percent) {
    m_settings.setFontSize(percent);
    applyFontSize(percent);
    m_actions->showFontSize(percent);
    resizeDocks({m_inputsDock, m_verdictDock},
                {m_inputs->minimumSizeHint().width(), atFontSize(verdictWidth)}, Qt::Horizontal);
}

/// What was given colours takes those of the palette the window has now.
void MainWindow::recolour() {
    retranslate(); // with the texts, their marks
    for (View* view : views()) {
        QEvent event(QEvent::PaletteChange); // the first came before its parts had their palettes
        QCoreApplication::sendEvent(view, &event);
    }
}

void MainWindow::movePanel(int by) {
    QList<QWidget*> panels{m_inputs, m_tabs};
    for (const View* view : views()) {
        if (QWidget* window = m_tabs->windowOf(view)) {
            panels += window;
        }
    }
    sparkout::movePanel(panels + QList<QWidget*>{m_playback, m_verdict, m_sheet, m_messages}, by);
}

void MainWindow::toggleDetached() {
    View* view = m_tabs->currentView();
    m_tabs->isDetached(view) ? m_tabs->attach(view) : m_tabs->detach(view);
}

void MainWindow::retranslate() {
    m_actions->retranslate();
    m_actions->follow(m_document, !m_inputs->refusals().empty());
    m_actions->showLanguage(m_language.code());
    m_actions->showTheme(appliedTheme());
    m_actions->showFontSize(appliedFontSize());
    m_actions->nameViews(views());
    m_playback->retranslate();
    m_inputsDock->setWindowTitle(tr("Inputs"));
    m_verdictDock->setWindowTitle(tr("Verdict"));
    m_messagesDock->setWindowTitle(tr("Messages"));
    m_sheetDock->setWindowTitle(tr("Formulas of the step"));
    m_sheet->retranslate();
    nameQtButtons(*this);
    m_inputs->setAccessibleName(tr("Inputs"));
    m_status->setAccessibleName(tr("Status"));
    m_time->setAccessibleName(tr("Computing time"));
    m_inputs->retranslate();
    m_messages->retranslate();
    for (View* view : views()) {
        view->retranslate();
    }
    m_tabs->retranslate();
    m_verdict->retranslate();
    if (m_outcome) {
        m_inputs->setOutcome(m_outcome);
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
    if (!m_files->mayClose()) {
        event->ignore();
        return;
    }
    saveWindow();
    event->accept();
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
    if (!path.isEmpty()) { // later: the program it was dragged from shall not wait for an answer
        QMetaObject::invokeMethod(
            m_files, [this, path] { m_files->openInstead(path); }, Qt::QueuedConnection);
    }
}

} // namespace sparkout
