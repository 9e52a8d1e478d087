// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/theme.h"
#include "ui/session/cycle_cursor.h"
#include "ui/session/document.h"
#include "ui/session/run_controller.h"
#include "ui/session/settings.h"
#include "ui/session/studies.h"
#include "ui/text/language.h"

#include <QMainWindow>
#include <QTimer>

#include <optional>
#include <vector>

namespace sparkout {

class Actions;
class BatchView;
class CompareView;
class ConstraintsView;
class CycleJudge;
class FeedsView;
class FileCommands;
class HelpDesk;
class InputsPanel;
class KeptRuns;
class LessonDesk;
class LessonWiring;
class MeasuredImport;
class MeasuredView;
class MessagesPanel;
class OptimiseView;
class OverviewView;
class PackCommands;
class PartCommands;
class PartRuns;
class PartStrip;
class PartWindow;
class PlaybackBar;
class ProfilesView;
class RemedyOffers;
class RunKeeper;
class StatusLine;
class StepSheet;
class VerdictPanel;
class View;
class ViewTabs;
class WindowLayout;
struct PdfAttachment;
struct ShownMoment;

/// The workbench: inputs, views, verdict and messages around one document.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    MainWindow(Settings& settings, Language& language, RunController::Runner runner = evaluate);
    ~MainWindow() override;

    [[nodiscard]] Document& document() { return m_document; }
    [[nodiscard]] const RunController& runs() const { return m_runs; }
    [[nodiscard]] InputsPanel& inputs() { return *m_inputs; }
    [[nodiscard]] MessagesPanel& messages() { return *m_messages; }
    [[nodiscard]] FileCommands& files() { return *m_files; }
    /// Locks and watches the files of the window from now on, and keeps earlier versions and
    /// recovery files in this folder.
    void protect(const QString& stateFolder);
    [[nodiscard]] const std::vector<View*>& views() const; ///< in the order of their tabs
    [[nodiscard]] ViewTabs& viewTabs() { return *m_tabs; }
    bool showView(const QString& name); ///< by object name or number from 1; false if there is none
    [[nodiscard]] const Studies& studies() const { return m_studies; }
    [[nodiscard]] HelpDesk& help() { return *m_help; }
    [[nodiscard]] CycleCursor& cursor() { return m_cursor; }
    [[nodiscard]] LessonDesk& lesson() { return *m_lesson; }

signals:
    void outcomeShown(); ///< the views have received a new outcome

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void buildViews();
    [[nodiscard]] std::optional<PdfAttachment> attachedProject() const;
    void showPlayback();
    void putGauge(double position_mm); ///< position from the headstock end of the ground length
    void connectOverview();
    void connectMeasured();
    void connectActions();
    void connectReports();
    void editCompany();
    void showLogoFault(); ///< a notice while the settings have an invalid logo
    void connectDocument();
    void connectPart();
    void showWholePart();
    /// The current project with the wheel of its run; the project itself while it is running.
    [[nodiscard]] const Project& asRun() const;
    [[nodiscard]] bool mayLeaveSurface();
    [[nodiscard]] QStringList refusedLines() const;
    void showInput(const std::string& path);
    void setLanguage(const QString& code);
    void setTheme(Theme theme);
    void setFontSize(int percent);
    void showStockReading();
    void recolour();
    void toggleDetached();
    void showOutcome(const OutcomePtr& outcome);
    void showJudged();
    void showRequirement(const ConstraintResult& requirement);
    void showTitle();
    void showStatus();
    void retranslate();
    void connectLesson();
    void requestRun();
    void showMoment(const ShownMoment& moment);

    Settings& m_settings;
    Language& m_language;
    Document m_document;
    Studies m_studies;
    bool m_isOutcomeOfBefore = false; ///< the outcome of another document or surface
    CycleCursor m_cursor;
    KeptRuns* m_kept;
    PartRuns* m_partRuns;
    PartStrip* m_strip = nullptr;
    PartCommands* m_part = nullptr;
    PartWindow* m_partWindow = nullptr; ///< created on request
    InputsPanel* m_inputs;
    ViewTabs* m_tabs;
    FeedsView* m_feeds;
    ProfilesView* m_profiles;
    ConstraintsView* m_constraints;
    BatchView* m_batch = nullptr;
    OptimiseView* m_optimise = nullptr;
    OverviewView* m_overview = nullptr;
    CompareView* m_compare = nullptr;
    MeasuredView* m_measured = nullptr;
    MeasuredImport* m_import;
    VerdictPanel* m_verdict;
    MessagesPanel* m_messages;
    PlaybackBar* m_playback;
    StepSheet* m_sheet;
    StatusLine* m_status = nullptr;
    WindowLayout* m_layout = nullptr;
    Actions* m_actions;
    FileCommands* m_files;
    PackCommands* m_packs;
    RunKeeper* m_keeper = nullptr;
    RemedyOffers* m_remedies;
    HelpDesk* m_help;
    LessonDesk* m_lesson;
    LessonWiring* m_lessonWiring = nullptr;
    QTimer m_recolour;
    QTimer m_refusalsTimer; ///< gathers many remarks of one edit
    CycleJudge* m_judge = nullptr;
    RunController m_runs; ///< last member: stopped before the objects it reports to are destroyed
};

} // namespace sparkout
