// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_panel.h"

#include "ui/form/mark.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/lesson/answer_field.h"
#include "ui/lesson/lesson_text.h"
#include "ui/session/lesson_run.h"
#include "ui/text/goal_text.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {

constexpr int leastLessonWidth = 290;

QLabel* lessonLabel(QWidget* parent, const char* name) {
    auto* label = new QLabel(parent);
    label->setObjectName(QString::fromLatin1(name));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setFocusPolicy(Qt::NoFocus); // read-only
    return label;
}

void emptyLayout(QVBoxLayout& layout) {
    while (QLayoutItem* const item = layout.takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

} // namespace

LessonPanel::LessonPanel(LessonRun& run, QWidget* parent)
    : QWidget(parent)
    , m_run(run)
    , m_title(lessonLabel(this, "lessonTitle"))
    , m_who(lessonLabel(this, "lessonStudent"))
    , m_points(lessonLabel(this, "lessonPoints"))
    , m_previous(new QToolButton(this))
    , m_steps(new QComboBox(this))
    , m_next(new QToolButton(this))
    , m_tabs(new QTabWidget(this))
    , m_theory(new QTextBrowser)
    , m_taskPage(new QWidget)
    , m_task(new MarkupText(m_taskPage))
    , m_asked(lessonLabel(m_taskPage, "lessonAsked"))
    , m_note(lessonLabel(m_taskPage, "lessonNote"))
    , m_handIn(new QPushButton(m_taskPage))
    , m_found(lessonLabel(m_taskPage, "lessonFound"))
    , m_attempts(lessonLabel(m_taskPage, "lessonAttempts"))
    , m_takeHint(new QPushButton(m_taskPage)) {
    setHelpTopic(*this, QStringLiteral("lessons"));
    build();
    connect(&m_run, &LessonRun::started, this, &LessonPanel::retranslate);
    connect(&m_run, &LessonRun::stepShown, this, &LessonPanel::showStep);
    connect(&m_run, &LessonRun::changed, this, &LessonPanel::showState);
}

void LessonPanel::build() {
    setMinimumWidth(leastLessonWidth);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::margin, metrics::gap, metrics::margin, metrics::gap);
    layout->setSpacing(metrics::gap);
    buildHead(*layout);
    buildTask();
    auto* scroll = new QScrollArea(this);
    scroll->setFocusPolicy(Qt::NoFocus); // its contents take the focus
    scroll->setWidget(m_taskPage);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_theory->setObjectName(QStringLiteral("lessonTheory"));
    m_theory->setOpenLinks(false);
    m_theory->setFrameShape(QFrame::NoFrame);
    m_tabs->addTab(scroll, QString());
    m_tabs->addTab(m_theory, QString());
    m_tabs->setDocumentMode(true);
    layout->addWidget(m_tabs, 1);
}

void LessonPanel::buildHead(QVBoxLayout& into) {
    setRelativeFont(*m_title, 1, true);
    into.addWidget(m_title);
    into.addWidget(m_who);
    m_steps->setObjectName(QStringLiteral("lessonSteps"));
    m_steps->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_steps->setMinimumContentsLength(8);
    m_previous->setIcon(themeIcon(u"back"));
    m_next->setIcon(themeIcon(u"forward"));
    for (QToolButton* button : {m_previous, m_next}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
    }
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::hair);
    row->addWidget(m_previous);
    row->addWidget(m_steps, 1);
    row->addWidget(m_next);
    into.addLayout(row);
    into.addWidget(m_points);
    connect(m_previous, &QToolButton::clicked, this, [this] { goTo(-1); });
    connect(m_next, &QToolButton::clicked, this, [this] { goTo(1); });
    connect(m_steps, &QComboBox::activated, this,
            [this](int index) { emit stepAsked(static_cast<std::size_t>(index)); });
}

void LessonPanel::buildTask() {
    m_task->setObjectName(QStringLiteral("lessonTask"));
    m_handIn->setObjectName(QStringLiteral("lessonHandIn"));
    m_takeHint->setObjectName(QStringLiteral("lessonHint"));
    auto* layout = new QVBoxLayout(m_taskPage);
    layout->setContentsMargins(0, metrics::gap, metrics::tight, 0);
    layout->setSpacing(metrics::margin);
    m_place = new QVBoxLayout;
    m_hints = new QVBoxLayout;
    m_hints->setSpacing(metrics::gap);
    layout->addWidget(m_task);
    layout->addWidget(m_asked);
    layout->addLayout(m_place);
    layout->addWidget(m_note);
    layout->addWidget(m_handIn);
    layout->addWidget(m_found);
    layout->addWidget(m_attempts);
    layout->addLayout(m_hints);
    layout->addWidget(m_takeHint);
    layout->addStretch(1);
    connect(m_handIn, &QPushButton::clicked, this, [this] { emit handInAsked(answer()); });
    connect(m_takeHint, &QPushButton::clicked, &m_run, &LessonRun::takeHint);
}

Answer LessonPanel::answer() const {
    Answer answer;
    if (m_field) {
        m_field->put(answer);
    }
    return answer;
}

void LessonPanel::goTo(int by) {
    const auto to = static_cast<qsizetype>(m_run.step()) + by;
    if (to >= 0 && to < static_cast<qsizetype>(m_run.lesson().steps.size())) {
        emit stepAsked(static_cast<std::size_t>(to));
    }
}

void LessonPanel::showStep() {
    emptyLayout(*m_place);
    const std::size_t step = m_run.step();
    m_field = AnswerField::make(m_run.current(), m_run.projectOf(step), m_taskPage);
    if (m_field) {
        m_place->addWidget(m_field);
        const auto handedIn = m_run.record(step).answer;
        const Answer* const draft = m_run.draft(step);
        if (draft || handedIn) {
            m_field->show(draft ? *draft : *handedIn);
        }
        connect(m_field, &AnswerField::edited, this, [this] {
            m_handIn->setEnabled(m_field->isWhole() && !m_run.isFull());
            emit edited();
        });
        setTabOrder(m_steps, m_field);
    }
    m_tabs->setCurrentIndex(0);
    retranslate();
}

void LessonPanel::showState() {
    if (m_run.isRunning()) {
        showSteps();
        showAnswered();
        showHints();
    }
}

void LessonPanel::showSteps() {
    const std::size_t count = m_run.lesson().steps.size();
    m_steps->clear();
    for (std::size_t i = 0; i < count; ++i) {
        const QString state = LessonText::mark(m_run.mark(i));
        const double most = m_run.lesson().steps[i].points;
        m_steps->addItem(
            m_run.mark(i) == LessonRun::Mark::passed
                ? tr("Step %1: %2, points: %3 of %4")
                      .arg(i + 1)
                      .arg(state, LessonText::points(m_run.pointsOf(i)), LessonText::points(most))
                : tr("Step %1: %2, points: %3").arg(i + 1).arg(state, LessonText::points(most)));
    }
    m_steps->setCurrentIndex(static_cast<int>(m_run.step()));
    m_previous->setEnabled(m_run.step() > 0);
    m_next->setEnabled(m_run.step() + 1 < count);
    m_points->setText(
        tr("Points: %1 of %2")
            .arg(LessonText::points(m_run.points()), LessonText::points(m_run.lesson().points())));
}

void LessonPanel::showAnswered() {
    const LessonStep& step = m_run.current();
    const StepRecord record = m_run.record(m_run.step());
    const GoalResult* const result = m_run.result(m_run.step());
    const bool predicts = isPrediction(step.goal);
    const bool isOver = predicts && record.answer;
    if (isOver) {
        m_field->show(*record.answer);
        m_field->lock();
        if (result) {
            m_field->showResult(*result);
        }
    }
    const bool isCovered = predicts && !isOver;
    m_note->setText(
        isCovered ? tr("Your first prediction counts. The result is shown once you have given it.")
                  : tr("Some views stay hidden until the predictions they would reveal "
                       "are given."));
    m_note->setVisible(isCovered || !m_run.openPredictions().empty());
    m_handIn->setText(predicts ? tr("Submit prediction") : m_field ? tr("Hand in") : tr("Check"));
    m_handIn->setVisible(!isOver);
    m_handIn->setEnabled((!m_field || m_field->isWhole()) && !m_run.isFull());
    m_found->setVisible(record.answer.has_value());
    if (record.answer) {
        m_found->setText(
            result ? GoalText::found(step.goal, *result, m_run.projectOf(m_run.step()), false)
                   : tr("Being checked…"));
        QPalette colours = palette();
        if (result && result->finding != Finding::forTeacher) {
            colours.setColor(QPalette::WindowText, result->passed()
                                                       ? tone(Tone::green, palette())
                                                       : markColor(Mark::error, palette()));
        }
        m_found->setPalette(colours);
    }
    m_attempts->setText(tr("Attempts: %1").arg(record.attempts));
    m_attempts->setVisible(!predicts && record.attempts > 0);
}

void LessonPanel::showHints() {
    const LessonStep& step = m_run.current();
    const std::size_t taken = m_run.record(m_run.step()).hints.size();
    emptyLayout(*m_hints);
    for (std::size_t i = 0; i < taken && i < step.hints.size(); ++i) {
        auto* hint = new MarkupText(m_taskPage);
        hint->setObjectName(QStringLiteral("lessonTakenHint"));
        hint->setMarkup(tr("<b>Hint %1</b> (−%2): %3")
                            .arg(i + 1)
                            .arg(LessonText::points(step.hints[i].price),
                                 LessonText::tagged(step.hints[i].text)));
        m_hints->addWidget(hint);
    }
    // A final or right answer needs no hints.
    const bool isOver = m_run.mark(m_run.step()) == LessonRun::Mark::passed
                        || (isPrediction(step.goal) && !m_run.isCovered());
    m_takeHint->setVisible(taken < step.hints.size() && !isOver);
    if (taken < step.hints.size()) {
        m_takeHint->setText(tr("Hint %1 of %2, price in points: %3")
                                .arg(taken + 1)
                                .arg(step.hints.size())
                                .arg(LessonText::points(step.hints[taken].price)));
        m_takeHint->setEnabled(!m_run.isFull());
    }
}

void LessonPanel::retranslate() {
    m_tabs->setAccessibleName(tr("Task, aim and theory"));
    m_tabs->setTabText(0, tr("Task"));
    m_tabs->setTabText(1, tr("Aim and theory"));
    m_theory->setAccessibleName(tr("Aim and theory"));
    m_steps->setAccessibleName(tr("Steps of the laboratory work"));
    const auto name = [](QToolButton& button, const QString& text) {
        button.setAccessibleName(text);
        button.setToolTip(text);
    };
    name(*m_previous, tr("Previous step"));
    name(*m_next, tr("Next step"));
    if (!m_run.isRunning()) {
        m_handIn->setText(tr("Hand in"));
        m_takeHint->setText(tr("Take a hint"));
        return;
    }
    const Lesson& lesson = m_run.lesson();
    const Work& work = m_run.work();
    m_title->setText(LessonText::of(lesson.title));
    const QString student = QString::fromStdString(work.name);
    const QString group = QString::fromStdString(work.group);
    m_who->setText(group.isEmpty()
                       ? tr("%1, variant %2").arg(student).arg(work.variant)
                       : tr("%1, group %2, variant %3").arg(student, group).arg(work.variant));
    m_theory->setHtml(QStringLiteral("<h3>%1</h3><p>%2</p><h3>%3</h3>%4")
                          .arg(tr("Aim"), LessonText::markup(lesson.aim), tr("Theory"),
                               LessonText::markup(lesson.theory)));
    const LessonStep& step = m_run.current();
    m_task->setMarkup(LessonText::markup(step.task));
    m_asked->setText(GoalText::asked(step.goal, m_run.projectOf(m_run.step())));
    m_asked->setVisible(isMetBySetting(step.goal.kind())); // other tasks are complete
    if (m_field) {
        m_field->retranslate();
    }
    showState();
}

void LessonPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        retranslate();
    }
}

} // namespace sparkout
