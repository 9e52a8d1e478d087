// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "ui/charts/verdict_why.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/messages_panel.h"
#include "ui/kit/keyboard.h"
#include "ui/kit/tool_tips.h"
#include "ui/plot/step_sheet.h"
#include "ui/session/kept_runs.h"
#include "ui/text/texts.h"
#include "ui/views/batch/batch_view.h"
#include "ui/views/compare/compare_view.h"
#include "ui/views/compliance/compliance_view.h"
#include "ui/views/constraints/constraints_view.h"
#include "ui/views/feeds/feeds_view.h"
#include "ui/views/layers/layers_view.h"
#include "ui/views/optimise/optimise_view.h"
#include "ui/views/profiles/profiles_view.h"
#include "ui/views/sweep/sweep_view.h"
#include "ui/views/verdict/verdict_panel.h"
#include "ui/window/actions.h"
#include "ui/window/file_commands.h"
#include "ui/window/help_desk.h"
#include "ui/window/notice_bar.h"
#include "ui/window/operation_notice.h"
#include "ui/window/playback_bar.h"
#include "ui/window/run_keeper.h"
#include "ui/window/view_tabs.h"

#include "core/process/coupled_sections.h"

#include <QAbstractButton>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {

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
    ToolTips::install();
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
    connect(m_batch, &BatchView::runWanted, this, [this](const auto& change, const QString& name) {
        if (auto inputs = change(m_document.project())) {
            m_keeper->keepAside(*std::move(inputs), name);
        }
    });
    connect(optimise, &OptimiseView::editWanted, this, edit);
    auto* sweep = new SweepView(this, &m_settings);
    connect(sweep, &SweepView::editWanted, this, edit);
    auto* compare = new CompareView(*m_kept, this, &m_settings);
    m_keeper = new RunKeeper(*m_kept, m_runs, m_files->notices(), this);
    connect(compare, &CompareView::keepWanted, m_actions->keepRun, &QAction::trigger);
    connect(m_keeper, &RunKeeper::told, this, &MainWindow::tell);
    const auto tellEnd = [this](const View* view) { // its notice says how: done, stopped, refused
        return [this, view] { tell(tr("%1: ended.").arg(view->title())); };
    };
    connect(m_batch, &BatchView::batchShown, this, tellEnd(m_batch));
    connect(sweep, &SweepView::sweepShown, this, tellEnd(sweep));
    connect(optimise, &OptimiseView::searchShown, this, tellEnd(optimise));
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

const std::vector<View*>& MainWindow::views() const {
    return m_tabs->views();
}

void MainWindow::tell(const QString& text) {
    constexpr int patience_ms = 6000;
    statusBar()->showMessage(text, patience_ms);
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
        tell(refused == 0
                 ? tr("Saved.")
                 : tr("Saved; %n fields hold a refused text, their last good values were saved.",
                      nullptr, refused));
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
        m_status->setText(
            isCoupled(m_outcome->result.project)
                ? tr("The forces of the coupled sections were not found.")
                : tr("The compliance of a section is negative: the even load beyond a steady rest "
                     "presses it against the wheel. Couple the sections."));
        break;
    case RunStatus::stopped:
    case RunStatus::refused: break;
    }
    m_time->setText(tr("Computed in %1 ms").arg(QLocale().toString(m_runs.lastRun_ms(), 'f', 1)));
}

void MainWindow::showTitle() {
    const QString title = QString::fromStdString(m_document.project().title).simplified();
    QString name = m_document.filePath().isEmpty()
                       ? (title.isEmpty() ? tr("Untitled") : tr("%1 (not saved)").arg(title))
                       : printableText(QFileInfo(m_document.filePath()).fileName());
    name.replace(QStringLiteral("[*]"), QStringLiteral("[*][*]"));
    setWindowTitle(m_document.readOnly() ? tr("%1[*] (read-only) — Sparkout").arg(name)
                                         : tr("%1[*] — Sparkout").arg(name));
    setWindowModified(m_document.modified() || !m_inputs->refusals().empty());
}

/// What was given colours takes those of the palette the window has now.
void MainWindow::recolour() {
    retranslate(); // with the texts, their marks
    for (View* view : views()) {
        QEvent event(QEvent::PaletteChange); // the first came before its parts had their palettes
        QCoreApplication::sendEvent(view, &event);
    }
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
