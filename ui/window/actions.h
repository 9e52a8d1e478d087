// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/font_size.h"
#include "ui/kit/theme.h"
#include "ui/window/dialogs/report_output.h"

#include <QAction>
#include <QMenu>
#include <QWidget>

#include <array>
#include <vector>

class QMenuBar;
class QToolBar;

class QMainWindow;

namespace sparkout {

/// The head of the window: menus and tools on one line. The tools have names beside their icons if
/// all fit.
class WindowHead : public QWidget {
    Q_OBJECT

public:
    explicit WindowHead(QWidget* parent);

    [[nodiscard]] QMenuBar& menus() { return *m_menus; }
    [[nodiscard]] QToolBar& tools() { return *m_tools; }
    void fitNames(); ///< after a change of the texts

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void fit();

    QMenuBar* m_menus;
    QToolBar* m_tools;
    int m_named = 0; ///< width of the tools with their names
};

class Document;
class View;

/// The commands of the window, its menus and the tool bar.
class Actions : public QObject {
    Q_OBJECT

public:
    explicit Actions(QMainWindow& window);

    void addDocks(const QList<QAction*>& toggles); ///< to the View menu
    void addRecentFiles(QMenu* menu);              ///< to the File menu
    /// An entry for each view, with Ctrl and its number.
    [[nodiscard]] QList<QAction*> addViews(int count);
    /// Shows what can be undone, with its name; a refused text is undone first.
    void follow(const Document& document, bool refusedText);
    void retranslate();
    /// Disables what is meaningless in a lesson, or would bypass it, while one runs.
    void followLesson(bool isRunning, bool isCovered);
    void showLanguage(const QString& code);
    void showTheme(Theme theme);
    void showFontSize(int percent);
    [[nodiscard]] QList<QAction*> surfaceActions() const; ///< on the current surface
    void nameViews(const std::vector<View*>& views);
    [[nodiscard]] const QList<QAction*>& showViews() const { return m_showViews; }

    QAction* newTraverse;
    QAction* newPlunge;
    QAction* open;
    QAction* examples;
    QAction* save;
    QAction* saveAs;
    QAction* earlierVersions;
    QAction* recoverWork;
    std::vector<ReportActions> reports; ///< in the order of the table of kinds
    std::vector<ReportActions> papers;  ///< of a laboratory work, in the order of their table
    QAction* company;                   ///< company and signatures in their heads
    QAction* titlePage;                 ///< the title page of laboratory reports
    QAction* importPack;
    QAction* exportPack;
    QAction* importMeasured;
    QAction* exportResults; ///< results and trace, as tables
    QAction* quit;
    QAction* undo;
    QAction* redo;
    QAction* keepRun;
    QAction* addSurface;
    QAction* duplicateSurface;
    QAction* renameSurface;
    QAction* moveSurfaceLeft; ///< earlier in the order of grinding
    QAction* moveSurfaceRight;
    QAction* removeSurface;
    QAction* previousSurface;
    QAction* nextSurface;
    QAction* wholePart;
    QAction* standardTimes;
    QAction* dressing;
    QAction* calibrate;    ///< calibrates from measurements
    QAction* countedWaves; ///< what can have left them
    QAction* lessons;      ///< shipped lessons
    QAction* previousStep;
    QAction* nextStep;
    QAction* leaveLesson;
    QAction* editLesson; ///< creates or changes a laboratory work
    QAction* markWorks;
    QAction* english;
    QAction* russian;
    std::array<QAction*, allThemes.size()> themes; ///< in the order of allThemes
    std::array<QAction*, fontSizes.size()> sizes;  ///< in the order of fontSizes
    QAction* stockOnDiameter;                      ///< in the inputs, otherwise per side
    QAction* detach;                               ///< or attach: the current view
    QAction* nextPanel;
    QAction* previousPanel;
    QAction* resetLayout;
    QAction* help; ///< on the focused widget
    QAction* helpContents;
    QAction* helpShortcuts;
    QAction* tour;
    QAction* log;
    QAction* about;

private:
    QAction* make(const char* name, const char16_t* icon, const QKeySequence& keys = {});
    void buildMenus(QMenuBar& bar);
    void buildPartMenu(QMenuBar& bar);
    void buildStudyMenu(QMenuBar& bar);
    void buildLessonMenu(QMenuBar& bar);
    void buildViewMenu(QMenuBar& bar);
    void buildToolBar(QToolBar& bar);

    WindowHead* m_head;
    QMenu* m_file;
    QMenu* m_edit;
    QMenu* m_part;
    QMenu* m_study;
    QMenu* m_lesson;
    QMenu* m_view;
    QMenu* m_language;
    QMenu* m_theme;
    QMenu* m_fontSize;
    QMenu* m_views;
    QMenu* m_help;
    QMenu* m_new;
    QMenu* m_packs;
    QList<QAction*> m_showViews;
    bool m_isLesson = false;
};

} // namespace sparkout
