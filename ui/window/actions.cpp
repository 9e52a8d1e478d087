// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/actions.h"

#include "ui/chart/view.h"
#include "ui/kit/keyboard.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/report/course_papers.h"
#include "ui/report/report_kinds.h"
#include "ui/session/document.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

namespace sparkout {

WindowHead::WindowHead(QWidget* parent)
    : QWidget(parent), m_menus(new QMenuBar(this)), m_tools(new QToolBar(this)) {
    m_menus->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    m_tools->setObjectName(QStringLiteral("toolBar"));
    m_tools->setMovable(false);
    m_tools->setContextMenuPolicy(Qt::PreventContextMenu);
    m_tools->setIconSize({metrics::icon, metrics::icon});
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(metrics::wide);
    line->addWidget(m_menus, 0, Qt::AlignVCenter);
    line->addWidget(m_tools, 1);
}

void WindowHead::fitNames() {
    m_tools->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_named = m_tools->sizeHint().width();
    fit();
}

void WindowHead::fit() {
    const int room = width() - m_menus->sizeHint().width() - metrics::wide;
    m_tools->setToolButtonStyle(m_named > room ? Qt::ToolButtonIconOnly
                                               : Qt::ToolButtonTextBesideIcon);
}

void WindowHead::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

/// The buttons have their final style and font, and so their width, only now.
void WindowHead::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    fitNames();
}

Actions::Actions(QMainWindow& window)
    : QObject(&window)
    , newTraverse(make("newTraverse", u"traverse", QKeySequence::New))
    , newPlunge(make("newPlunge", u"plunge", Qt::CTRL | Qt::SHIFT | Qt::Key_N))
    , open(make("open", u"open", QKeySequence::Open))
    , examples(make("examples", u"examples", Qt::CTRL | Qt::Key_E))
    , save(make("save", u"save", QKeySequence::Save))
    , saveAs(make("saveAs", u"save", Qt::CTRL | Qt::SHIFT | Qt::Key_S))
    , earlierVersions(make("earlierVersions", u""))
    , recoverWork(make("recoverWork", u""))
    , company(make("company", u""))
    , titlePage(make("titlePage", u""))
    , importPack(make("importPack", u""))
    , exportPack(make("exportPack", u""))
    , importMeasured(make("importMeasured", u"", Qt::CTRL | Qt::Key_I))
    , exportResults(make("exportResults", u"export"))
    , quit(make("quit", u"", Qt::CTRL | Qt::Key_Q))
    , undo(make("undo", u"undo", QKeySequence::Undo))
    , redo(make("redo", u"redo", QKeySequence::Redo))
    , keepRun(make("keepRun", u"keep", Qt::CTRL | Qt::Key_K))
    , addSurface(make("addSurface", u"add", Qt::CTRL | Qt::SHIFT | Qt::Key_A))
    , duplicateSurface(make("duplicateSurface", u"copy"))
    , renameSurface(make("renameSurface", u"rename"))
    , moveSurfaceLeft(make("moveSurfaceLeft", u"back", Qt::CTRL | Qt::SHIFT | Qt::Key_PageUp))
    , moveSurfaceRight(
          make("moveSurfaceRight", u"forward", Qt::CTRL | Qt::SHIFT | Qt::Key_PageDown))
    , removeSurface(make("removeSurface", u"remove"))
    , previousSurface(make("previousSurface", u"", Qt::CTRL | Qt::Key_PageUp))
    , nextSurface(make("nextSurface", u"", Qt::CTRL | Qt::Key_PageDown))
    , wholePart(make("wholePart", u"part", Qt::CTRL | Qt::SHIFT | Qt::Key_W))
    , standardTimes(make("standardTimes", u""))
    , dressing(make("dressing", u""))
    , calibrate(make("calibrate", u"gauge"))
    , countedWaves(make("countedWaves", u""))
    , lessons(make("lessons", u"examples"))
    , previousStep(make("previousStep", u"back", Qt::CTRL | Qt::ALT | Qt::Key_Left))
    , nextStep(make("nextStep", u"forward", Qt::CTRL | Qt::ALT | Qt::Key_Right))
    , leaveLesson(make("leaveLesson", u""))
    , editLesson(make("editLesson", u""))
    , markWorks(make("markWorks", u""))
    , english(make("english", u""))
    , russian(make("russian", u""))
    , stockOnDiameter(make("stockOnDiameter", u""))
    , detach(make("detach", u"detach", Qt::CTRL | Qt::SHIFT | Qt::Key_D))
    , nextPanel(make("nextPanel", u"", Qt::Key_F6))
    , previousPanel(make("previousPanel", u"", Qt::SHIFT | Qt::Key_F6))
    , resetLayout(make("resetLayout", u""))
    , help(make("help", u"info", QKeySequence::HelpContents))
    , helpContents(make("helpContents", u""))
    , helpShortcuts(make("helpShortcuts", u""))
    , tour(make("tour", u""))
    , log(make("log", u""))
    , about(make("about", u""))
    , m_head(new WindowHead(&window)) {
    quit->setMenuRole(QAction::QuitRole);
    about->setMenuRole(QAction::AboutRole);
    stockOnDiameter->setCheckable(true);
    auto* languages = new QActionGroup(this);
    for (QAction* action : {english, russian}) {
        action->setCheckable(true);
        languages->addAction(action);
    }
    about->setIcon(QIcon(QStringLiteral(":/icons/sparkout.svg")));
    auto* looks = new QActionGroup(this);
    for (std::size_t i = 0; i < allThemes.size(); ++i) {
        const QByteArray name = "theme-" + themeCode(allThemes[i]).toLatin1();
        themes[i] = make(name.constData(), u"");
        themes[i]->setCheckable(true);
        looks->addAction(themes[i]);
    }
    auto* types = new QActionGroup(this);
    for (std::size_t i = 0; i < fontSizes.size(); ++i) {
        sizes[i] = make(("fontSize-" + QByteArray::number(fontSizes[i])).constData(), u"");
        sizes[i]->setCheckable(true);
        types->addAction(sizes[i]);
    }
    for (const report::KindRow& row : report::kinds()) {
        reports.push_back(makeReportActions(row.key, &window));
    }
    reports.front().print->setShortcut(QKeySequence::Print); // the daily printout
    for (const report::PaperRow& row : report::papersOfWorks()) {
        papers.push_back(makeReportActions(row.key, &window));
    }
    window.setMenuWidget(m_head);
    buildMenus(m_head->menus());
    buildToolBar(m_head->tools());
    retranslate();
}

QAction* Actions::make(const char* name, const char16_t* icon, const QKeySequence& keys) {
    auto* action = new QAction(this);
    action->setObjectName(QString::fromLatin1(name));
    const QStringView drawing(icon);
    if (!drawing.isEmpty()) {
        action->setIcon(themeIcon(drawing));
    }
    action->setShortcut(keys);
    return action;
}

void Actions::buildMenus(QMenuBar& bar) {
    m_file = bar.addMenu(QString());
    m_new = m_file->addMenu(themeIcon(u"new"), QString());
    m_new->addActions({newTraverse, newPlunge});
    m_file->addActions({open, examples});
    m_file->addSeparator();
    m_file->addActions({save, saveAs, earlierVersions, recoverWork});
    m_file->addSeparator();
    m_file->addAction(importMeasured);
    m_file->addSeparator();
    for (const ReportActions& report : reports) {
        m_file->addMenu(report.menu);
    }
    m_file->addActions({company, exportResults});
    m_packs = m_file->addMenu(QString());
    m_packs->addActions({importPack, exportPack});
    m_file->addSeparator();
    m_file->addAction(quit);
    m_edit = bar.addMenu(QString());
    QList<QKeySequence> again = QKeySequence::keyBindings(QKeySequence::Redo);
    if (const QKeySequence usual(Qt::CTRL | Qt::Key_Y); !again.contains(usual)) {
        again += usual;
    }
    redo->setShortcuts(again);
    m_edit->addActions({undo, redo});
    m_edit->addSeparator();
    m_edit->addAction(keepRun);
    buildPartMenu(bar);
    buildStudyMenu(bar);
    buildLessonMenu(bar);
    buildViewMenu(bar);
    m_help = bar.addMenu(QString());
    m_help->addActions({help, helpContents, helpShortcuts, tour, log});
    m_help->addSeparator();
    m_help->addAction(about);
}

void Actions::buildPartMenu(QMenuBar& bar) {
    m_part = bar.addMenu(QString());
    m_part->addActions(surfaceActions());
    m_part->addSeparator();
    m_part->addActions({previousSurface, nextSurface});
    m_part->addSeparator();
    m_part->addActions({wholePart, standardTimes, dressing});
}

void Actions::buildStudyMenu(QMenuBar& bar) {
    m_study = bar.addMenu(QString());
    m_study->addActions({calibrate, countedWaves});
}

void Actions::buildLessonMenu(QMenuBar& bar) {
    m_lesson = bar.addMenu(QString());
    m_lesson->addAction(lessons);
    m_lesson->addSeparator();
    m_lesson->addActions({previousStep, nextStep, leaveLesson});
    m_lesson->addSeparator();
    for (const ReportActions& paper : papers) {
        m_lesson->addMenu(paper.menu);
    }
    m_lesson->addAction(titlePage);
    m_lesson->addSeparator();
    m_lesson->addActions({editLesson, markWorks});
}

void Actions::followLesson(bool isRunning, bool isCovered) {
    m_isLesson = isRunning;
    for (QAction* action : {previousStep, nextStep, leaveLesson}) {
        action->setEnabled(isRunning);
    }
    for (const ReportActions& paper : papers) { // they show only what the work does
        paper.menu->menuAction()->setEnabled(isRunning);
        for (QAction* action : paper.all()) {
            action->setEnabled(isRunning);
        }
    }
    for (QAction* action : {standardTimes, dressing, earlierVersions, tour, editLesson}) {
        action->setEnabled(!isRunning);
    }
    for (QAction* action : {wholePart, keepRun, importMeasured, detach}) {
        if (action->isVisible()) {
            action->setEnabled(!isCovered);
        }
    }
    for (QAction* action : m_showViews) {
        if (action->isVisible()) {
            action->setEnabled(!isCovered);
        }
    }
    for (const ReportActions& report : reports) {
        for (QAction* action : report.all()) {
            if (action->isVisible()) {
                action->setEnabled(!isCovered);
            }
        }
    }
    if (exportResults->isVisible()) {
        exportResults->setEnabled(!isCovered);
    }
}

QList<QAction*> Actions::surfaceActions() const {
    return {addSurface,      duplicateSurface, renameSurface,
            moveSurfaceLeft, moveSurfaceRight, removeSurface};
}

void Actions::buildViewMenu(QMenuBar& bar) {
    m_view = bar.addMenu(QString());
    m_views = m_view->addMenu(QString());
    m_view->addActions({detach, nextPanel, previousPanel});
    m_view->addSeparator();
    m_language = m_view->addMenu(QString());
    m_language->addActions({english, russian});
    m_theme = m_view->addMenu(QString());
    m_theme->addActions({themes.begin(), themes.end()});
    m_fontSize = m_view->addMenu(QString());
    m_fontSize->addActions({sizes.begin(), sizes.end()});
    m_view->addAction(stockOnDiameter);
    m_view->addSeparator();
    m_view->addAction(resetLayout);
}

void Actions::buildToolBar(QToolBar& bar) {
    bar.addAction(m_new->menuAction());
    bar.addActions({open, save});
    bar.addSeparator();
    bar.addActions({undo, redo});
    bar.addSeparator();
    bar.addAction(keepRun);
    bar.addSeparator();
    bar.addAction(reports.front().preview); // preview of the cycle card
    bar.addSeparator();
    bar.addAction(examples);
    if (auto* button = qobject_cast<QToolButton*>(bar.widgetForAction(m_new->menuAction()))) {
        button->setPopupMode(QToolButton::InstantPopup);
    }
}

void Actions::addDocks(const QList<QAction*>& toggles) {
    m_view->addActions(toggles);
}

void Actions::addRecentFiles(QMenu* menu) {
    m_file->insertMenu(examples, menu);
}

QList<QAction*> Actions::addViews(int count) {
    for (int i = 0; i < count; ++i) {
        const auto digit = Qt::Key(Qt::Key_0 + (i + 1) % 10);
        const QKeySequence keys = // Ctrl+1 … Ctrl+9, Ctrl+0, Ctrl+Alt+1 …
            i < 10 ? Qt::CTRL | digit : Qt::CTRL | Qt::ALT | digit;
        QAction* action = make("", u"", keys);
        m_views->addAction(action);
        m_showViews += action;
    }
    return m_showViews;
}

void Actions::nameViews(const std::vector<View*>& views) {
    for (int i = 0; i < m_showViews.size(); ++i) {
        const View& view = *views[std::size_t(i)];
        m_showViews[i]->setObjectName(QStringLiteral("show-") + view.objectName());
        const QString number = QString::number(i + 1);
        m_showViews[i]->setText(
            QStringLiteral("%1&%2 %3").arg(number.chopped(1), number.last(1), view.title()));
    }
}

void Actions::follow(const Document& document, bool refusedText) {
    undo->setEnabled(document.canUndo() || refusedText);
    redo->setEnabled(document.canRedo());
    const QString undone = refusedText ? tr("invalid entry") : document.undoText();
    const QString redone = document.redoText();
    undo->setText(undone.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(undone));
    redo->setText(redone.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(redone));
    undo->setIconText(tr("Undo"));
    redo->setIconText(tr("Redo"));
    nameShortcut(*undo);
    nameShortcut(*redo);
    const std::size_t surface = document.surface(), count = document.surfaceCount();
    const bool several = count > 1;
    addSurface->setEnabled(count < limits::surfaces && !m_isLesson);
    duplicateSurface->setEnabled(count < limits::surfaces && !m_isLesson);
    renameSurface->setEnabled(several && !m_isLesson);
    removeSurface->setEnabled(several && !m_isLesson);
    moveSurfaceLeft->setEnabled(surface > 0 && !m_isLesson);
    moveSurfaceRight->setEnabled(surface + 1 < count && !m_isLesson);
    previousSurface->setEnabled(surface > 0);
    nextSurface->setEnabled(surface + 1 < count);
}

void Actions::retranslate() {
    m_file->setTitle(tr("&File"));
    m_edit->setTitle(tr("&Edit"));
    m_part->setTitle(tr("&Part"));
    m_study->setTitle(tr("&Study"));
    m_lesson->setTitle(tr("&Lesson"));
    lessons->setText(tr("Laboratory &works…"));
    previousStep->setText(tr("&Previous step"));
    nextStep->setText(tr("&Next step"));
    leaveLesson->setText(tr("&Leave the lesson"));
    editLesson->setText(tr("&Edit a work…"));
    markWorks->setText(tr("&Mark works…"));
    addSurface->setText(tr("&Add a surface…"));
    duplicateSurface->setText(tr("&Duplicate the surface…"));
    renameSurface->setText(tr("&Rename the surface…"));
    moveSurfaceLeft->setText(tr("Grind it &earlier"));
    moveSurfaceRight->setText(tr("Grind it &later"));
    removeSurface->setText(tr("Re&move the surface"));
    previousSurface->setText(tr("&Previous surface"));
    nextSurface->setText(tr("&Next surface"));
    wholePart->setText(tr("&Whole part…"));
    standardTimes->setText(tr("&Standard times and wheel wear…"));
    dressing->setText(tr("Parts &between dressings…"));
    calibrate->setText(tr("&Calibrate from measurements…"));
    countedWaves->setText(tr("Causes of &waves on a part…"));
    m_view->setTitle(tr("&View"));
    m_help->setTitle(tr("&Help"));
    m_new->setTitle(tr("&New"));
    m_new->menuAction()->setToolTip(tr("New project"));
    m_language->setTitle(tr("&Language"));
    m_theme->setTitle(tr("&Theme"));
    m_fontSize->setTitle(tr("&Font size"));
    m_views->setTitle(tr("&Show a view"));
    m_head->tools().setWindowTitle(tr("Tool bar"));
    newTraverse->setText(tr("&Traverse grinding"));
    newPlunge->setText(tr("&Plunge grinding"));
    open->setText(tr("&Open…"));
    examples->setText(tr("&Example gallery…"));
    save->setText(tr("&Save"));
    saveAs->setText(tr("Save &as…"));
    earlierVersions->setText(tr("Earlier &versions…"));
    recoverWork->setText(tr("Re&cover work…"));
    for (std::size_t i = 0; i < reports.size(); ++i) {
        reports[i].name(report::menuText(report::kinds()[i].kind));
    }
    for (std::size_t i = 0; i < papers.size(); ++i) {
        papers[i].name(report::menuText(report::papersOfWorks()[i].paper));
    }
    examples->setIconText(tr("Examples"));
    company->setText(tr("Company and si&gnatures…"));
    m_packs->setTitle(tr("Packs &for sharing"));
    importPack->setText(tr("&Import a pack…"));
    exportPack->setText(tr("&Export a pack…"));
    titlePage->setText(tr("&Title page of laboratory reports…"));
    importMeasured->setText(tr("&Import measurements…"));
    exportResults->setText(tr("Export resu&lts…"));
    quit->setText(tr("&Quit"));
    keepRun->setText(tr("&Keep the current run"));
    keepRun->setIconText(tr("Keep run"));
    reports.front().preview->setIconText(tr("Cycle card"));
    english->setText(QStringLiteral("English"));
    russian->setText(QStringLiteral("Русский"));
    stockOnDiameter->setText(tr("Stoc&k on diameter"));
    detach->setText(tr("&Detach or attach the view"));
    nextPanel->setText(tr("&Next panel"));
    previousPanel->setText(tr("&Previous panel"));
    resetLayout->setText(tr("&Reset the layout"));
    const QStringList names{tr("As the &system"), tr("&Light"), tr("&Dark"), tr("High &contrast")};
    for (std::size_t i = 0; i < themes.size(); ++i) {
        themes[i]->setText(names[qsizetype(i)]);
    }
    const QStringList types{tr("&Smaller"), tr("&Usual"), tr("&Larger"), tr("La&rgest")};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        sizes[i]->setText(tr("%1: %2 %").arg(types[qsizetype(i)]).arg(fontSizes[i]));
    }
    help->setText(tr("&Help on the focused item"));
    helpContents->setText(tr("&Contents"));
    helpShortcuts->setText(tr("&Keyboard shortcuts"));
    tour->setText(tr("&Tour of the window"));
    log->setText(tr("&Log"));
    about->setText(tr("&About Sparkout"));
    m_head->fitNames();
}

void Actions::showTheme(Theme theme) {
    themes[std::size_t(std::ranges::find(allThemes, theme) - allThemes.begin())]->setChecked(true);
}

void Actions::showFontSize(int percent) {
    const auto found = std::ranges::find(fontSizes, fontSizeFrom(percent));
    sizes[std::size_t(found - fontSizes.begin())]->setChecked(true);
}

void Actions::showLanguage(const QString& code) {
    (code == u"ru" ? russian : english)->setChecked(true);
}

} // namespace sparkout
