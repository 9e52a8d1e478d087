// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/lesson_wiring.h"

#include "core/lesson/make_variants.h"
#include "core/simulation/progress.h"
#include "ui/chart/view.h"
#include "ui/dialogs/watched_work.h"
#include "ui/inputs/form_row.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/messages_panel.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/lesson/lesson_desk.h"
#include "ui/lesson/lesson_editor.h"
#include "ui/report/course_papers.h"
#include "ui/session/cycle_cursor.h"
#include "ui/session/document.h"
#include "ui/session/settings.h"
#include "ui/text/number_text.h"
#include "ui/window/actions.h"
#include "ui/window/dialogs/report_output.h"
#include "ui/window/file_commands.h"
#include "ui/window/remedy_offers.h"
#include "ui/window/view_tabs.h"
#include "ui/window/window_layout.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QLabel>
#include <QStackedWidget>

#include <algorithm>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

namespace sparkout {

namespace {

report::PaperWish wishOf(const Settings& settings, const QString& file) {
    report::PaperWish wish;
    wish.institution = report::Institution::fromKept(settings.titlePage());
    wish.file = file;
    wish.date = documentDay();
    wish.breathe = [] { QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents); };
    return wish;
}

} // namespace

LessonWiring::LessonWiring(QWidget* views, QObject* parent)
    : QObject(parent), m_middle(new QStackedWidget), m_cover(new QLabel) {
    m_cover->setObjectName(QStringLiteral("lessonCover"));
    m_cover->setAlignment(Qt::AlignCenter);
    m_cover->setWordWrap(true);
    m_cover->setMargin(metrics::wide);
    m_cover->setTextFormat(Qt::PlainText);
    setRelativeFont(*m_cover, 1.2);
    m_middle->addWidget(views);
    m_middle->addWidget(m_cover);
}

QWidget* LessonWiring::middle() const {
    return m_middle;
}

void LessonWiring::connectTo(const Parts& parts) {
    enter(parts);
    enterViews(parts);
    WindowLayout& layout = parts.layout;
    connect(&parts.desk.run(), &LessonRun::started, this, [&layout] { layout.showLesson(true); });
    // Does not stay on the previous view, which may show nothing of the lesson.
    connect(&parts.desk.run(), &LessonRun::started, this, [&tabs = parts.tabs] {
        const auto first = std::ranges::find_if(
            tabs.views(), [&tabs](const View* view) { return !tabs.isAway(view); });
        if (first != tabs.views().end()) {
            tabs.showView(*first);
        }
    });
    connect(&parts.desk, &LessonDesk::limitsChanged, this, [this, parts] { apply(parts); });
    LessonDesk& desk = parts.desk;
    connect(parts.actions.lessons, &QAction::triggered, &desk,
            [parts] { parts.desk.choose([parts] { return parts.files.mayDiscard(); }); });
    connectPapers(parts);
    connect(parts.actions.editLesson, &QAction::triggered, this, [this, parts] { edit(parts); });
    connect(parts.actions.markWorks, &QAction::triggered, &desk, &LessonDesk::markWorks);
    connect(parts.actions.leaveLesson, &QAction::triggered, &desk, &LessonDesk::leave);
    connect(parts.actions.previousStep, &QAction::triggered, &desk, [&desk] { desk.showNext(-1); });
    connect(parts.actions.nextStep, &QAction::triggered, &desk, [&desk] { desk.showNext(1); });
    parts.actions.followLesson(false, false);
}

void LessonWiring::enter(const Parts& parts) {
    HiddenThings& hidden = parts.desk.hidden();
    Actions& actions = parts.actions;
    RemedyOffers& remedies = parts.remedies;
    hidden.add({Hideable::remedies}, [&remedies](bool away) { remedies.offer(!away); });
    hidden.add({Hideable::verdict}, actions.wholePart);
    hidden.add({Hideable::keptRuns}, actions.keepRun);
    hidden.add({Hideable::calibrate}, actions.calibrate);
    hidden.add({Hideable::measured}, actions.importMeasured);
    hidden.add({Hideable::examples}, actions.examples);
    hidden.add({Hideable::exportResults}, actions.exportResults);
    for (const ReportActions& report : actions.reports) {
        hidden.add({Hideable::reports}, report.menu->menuAction());
        for (QAction* action : report.all()) {
            hidden.add({Hideable::reports}, action);
        }
    }
}

void LessonWiring::enterViews(const Parts& parts) {
    HiddenThings& hidden = parts.desk.hidden();
    ViewTabs& tabs = parts.tabs;
    for (std::size_t i = 0; i < tabs.views().size(); ++i) {
        View* const view = tabs.views()[i];
        if (const auto thing = viewNamed(view->objectName().toStdString())) {
            hidden.add({*thing}, [&tabs, view](bool away) { tabs.takeAway(view, away); });
            hidden.add({*thing}, parts.actions.showViews()[qsizetype(i)]);
        }
    }
}

/// Panels are hidden by a step, and together with the views.
void LessonWiring::apply(const Parts& parts) {
    const LessonDesk& desk = parts.desk;
    const bool isCovered = desk.isCovered();
    if (isCovered) {
        parts.tabs.attachAll();
    }
    m_middle->setCurrentIndex(isCovered ? 1 : 0);
    const HiddenThings& step = desk.hidden(); // empty while no lesson runs
    parts.layout.takeAway(WindowLayout::Panel::verdict,
                          isCovered || step.isHidden(Hideable::verdict));
    parts.layout.takeAway(WindowLayout::Panel::messages,
                          isCovered || step.isHidden(Hideable::messages));
    parts.layout.takeAway(WindowLayout::Panel::sheet,
                          isCovered || step.isHidden(Hideable::formulas));
    const auto access = desk.isRunning()
                            ? std::make_shared<const FormAccess>(desk.run().current(), isCovered)
                            : std::make_shared<const FormAccess>();
    parts.inputs.setAccess(access);
    parts.messages.offerStockFit(access->at("/cycle/stages") == Access::free);
    parts.actions.followLesson(desk.isRunning(), isCovered);
    if (!desk.isRunning()) {
        parts.layout.showLesson(false);
    }
}

/// A lesson is edited beside the window and tried in it; the editor returns when the trial is over.
void LessonWiring::edit(const Parts& parts) {
    if (!m_editor) {
        openEditor(parts);
    }
    m_editor->show();
    m_editor->raise();
    m_editor->activateWindow();
}

void LessonWiring::openEditor(const Parts& parts) {
    m_editor = new LessonEditor(parts.document, parts.settings, parts.window);
    if (const QString folder = parts.desk.stateFolder(); !folder.isEmpty()) {
        m_editor->protect(folder);
    }
    connect(m_editor, &LessonEditor::trialWanted, this,
            [this, parts](const Lesson& lesson, std::size_t step) {
                if (parts.files.mayDiscard() && parts.desk.tryOut(lesson, step)) {
                    m_editor->hide();
                }
            });
    connect(m_editor, &LessonEditor::projectWanted, this, [this, parts] {
        if (parts.files.mayDiscard()) {
            parts.document.startUntitled(m_editor->draft().lesson().base);
        }
    });
    connect(&parts.desk, &LessonDesk::tried, m_editor, [this, parts] { edit(parts); });
    connectPapersOfEditor(parts.settings);
}

void LessonWiring::connectPapersOfEditor(Settings& settings) {
    auto* output = new ReportOutput(settings, m_editor);
    for (const report::PaperRow& row : report::papersOfLessons()) {
        m_papers.push_back(makeReportActions(row.key, m_editor));
        m_editor->papers().addMenu(m_papers.back().menu);
        output->connectTo(m_papers.back(),
                          [this, &settings, paper = row.paper]() -> std::optional<report::Report> {
                              if (!m_editor->isWhole()) {
                                  return {};
                              }
                              Lesson lesson = m_editor->draft().lesson();
                              std::stop_source stop;
                              const bool isDone = runWatched(
                                  m_editor, tr("Best answer of the laboratory work"),
                                  [&](const KeepGoing&) {
                                      lesson = withBestTimes(std::move(lesson), stop.get_token());
                                  },
                                  stop);
                              return isDone ? std::optional(report::makePaper(
                                         paper, lesson, wishOf(settings, m_editor->draft().path())))
                                            : std::nullopt;
                          });
    }
    namePapersOfEditor();
}

void LessonWiring::namePapersOfEditor() const {
    const auto rows = report::papersOfLessons();
    for (std::size_t i = 0; i < m_papers.size(); ++i) {
        m_papers[i].name(report::menuText(rows[i].paper));
    }
}

/// Makes papers of the running work from what was handed in.
void LessonWiring::connectPapers(const Parts& parts) {
    auto* output = new ReportOutput(parts.settings, parts.window);
    const auto rows = report::papersOfWorks();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        output->connectTo(parts.actions.papers[i],
                          [&desk = parts.desk, &settings = parts.settings,
                           paper = rows[i].paper]() -> std::optional<report::Report> {
                              if (!desk.isRunning()) {
                                  return {};
                              }
                              const Work work = desk.run().work();
                              return report::makePaper(paper, work,
                                                       wishOf(settings, desk.run().file()));
                          });
    }
}

bool LessonWiring::mayClose() {
    return !m_editor || m_editor->mayClose();
}

void LessonWiring::goTo(CycleCursor& cursor, const ShownMoment& moment) {
    if (moment.count) {
        cursor.toStroke(*moment.count);
    } else if (moment.stage) { // to the end of the stage
        cursor.toStroke(0);
        cursor.step(CursorUnit::stage, *moment.stage);
    }
    if (moment.step == Step::none || !moment.count) {
        return;
    }
    const Zone zone = moment.place.zone ? static_cast<Zone>(*moment.place.zone) : Zone::rz1;
    const StrokeStep wanted = strokeStep(zone, moment.step);
    while (cursor.stroke() == *moment.count && cursor.pass()) {
        const Place& at = cursor.pass()->place;
        if (strokeStep(at.zone, at.step) == wanted) {
            return;
        }
        cursor.step(CursorUnit::step, -1);
    }
    cursor.toStroke(*moment.count); // the cycle does not have this step
}

void LessonWiring::retranslate() {
    m_cover->setText(tr("The views are covered until you have given your prediction in the panel "
                        "of the laboratory work. Then the result is shown beside it."));
    if (m_editor) {
        m_editor->retranslate();
        namePapersOfEditor();
    }
}

} // namespace sparkout
