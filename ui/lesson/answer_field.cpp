// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/answer_field.h"

#include "core/project/project.h"
#include "ui/form/number_field.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/lesson/curve_answer.h"
#include "ui/lesson/lesson_text.h"
#include "ui/text/goal_text.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

/// The order of the zones or sections, the largest first, arranged by dragging, by buttons or by
/// Ctrl+Up and Ctrl+Down; later the engine's order is shown beside it.
class OrderAnswer : public AnswerField {
    Q_DECLARE_TR_FUNCTIONS(sparkout::OrderAnswer)

public:
    OrderAnswer(OrderPrediction goal, const Project& project, QWidget* parent);

    void show(const Answer& answer) override;
    void put(Answer& answer) const override;
    [[nodiscard]] bool isWhole() const override;
    void lock() override;
    void showResult(const GoalResult& result) override;
    void retranslate() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void move(int by);
    void fill(const std::vector<std::size_t>& order);
    void fitHeight();

    OrderPrediction m_goal;
    Project m_project;
    QLabel* m_note;
    QListWidget* m_list;
    QToolButton* m_up;
    QToolButton* m_down;
    QLabel* m_resultLabel;
    QListWidget* m_result;
    std::vector<std::size_t> m_found; ///< the engine's order
};

constexpr int orderedPlaceRole = Qt::UserRole;

std::size_t orderedPlaceCount(const Project& project) {
    std::size_t count = 0;
    while (hasPlace(project, placeName(project, count)) && count < 1000) {
        ++count;
    }
    return count;
}

OrderAnswer::OrderAnswer(OrderPrediction goal, const Project& project, QWidget* parent)
    : AnswerField(parent)
    , m_goal(std::move(goal))
    , m_project(project)
    , m_note(new QLabel(this))
    , m_list(new QListWidget(this))
    , m_up(new QToolButton(this))
    , m_down(new QToolButton(this))
    , m_resultLabel(new QLabel(this))
    , m_result(new QListWidget(this)) {
    m_note->setWordWrap(true);
    m_resultLabel->setWordWrap(true);
    m_list->setObjectName(QStringLiteral("predictedOrder"));
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setDefaultDropAction(Qt::MoveAction);
    m_list->installEventFilter(this);
    m_result->setObjectName(QStringLiteral("resultOrder"));
    m_result->setSelectionMode(QAbstractItemView::NoSelection);
    m_up->setIcon(themeIcon(u"up"));
    m_down->setIcon(themeIcon(u"down"));
    for (QToolButton* button : {m_up, m_down}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
    }
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(metrics::row);
    grid->addWidget(m_note, 0, 0, 1, 2);
    grid->addWidget(m_list, 1, 0, 2, 1);
    grid->addWidget(m_up, 1, 1, Qt::AlignBottom);
    grid->addWidget(m_down, 2, 1, Qt::AlignTop);
    grid->addWidget(m_resultLabel, 0, 2);
    grid->addWidget(m_result, 1, 2, 2, 1);
    grid->setColumnStretch(0, 1);
    m_resultLabel->hide();
    m_result->hide();
    connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
    connect(m_list->model(), &QAbstractItemModel::rowsMoved, this, &AnswerField::edited);
    std::vector<std::size_t> order(orderedPlaceCount(m_project));
    std::iota(order.begin(), order.end(), std::size_t{0});
    fill(order);
    OrderAnswer::retranslate();
}

void OrderAnswer::fill(const std::vector<std::size_t>& order) {
    const QSignalBlocker blocker(m_list->model());
    m_list->clear();
    for (const std::size_t place : order) {
        auto* item = new QListWidgetItem(GoalText::place(m_project, place), m_list);
        item->setData(orderedPlaceRole, static_cast<int>(place));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
    }
    m_list->setCurrentRow(0);
    m_list->reset(); // its model emitted no signals
    m_list->setCurrentRow(0);
    fitHeight();
}

void OrderAnswer::fitHeight() {
    constexpr int most = 8;
    for (QListWidget* list : {m_list, m_result}) {
        const int rows = std::clamp(list->count(), 1, most);
        const int height = std::max(list->sizeHintForRow(0), list->fontMetrics().height());
        list->setFixedHeight(rows * height + 2 * list->frameWidth() + metrics::hair);
    }
}

void OrderAnswer::move(int by) {
    const int from = m_list->currentRow();
    const int to = from + by;
    if (from < 0 || to < 0 || to >= m_list->count() || !m_up->isEnabled()) {
        return;
    }
    QListWidgetItem* const item = m_list->takeItem(from);
    m_list->insertItem(to, item);
    m_list->setCurrentRow(to);
    emit edited();
}

bool OrderAnswer::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_list && event->type() == QEvent::KeyPress) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if ((key.modifiers() & Qt::ControlModifier)
            && (key.key() == Qt::Key_Up || key.key() == Qt::Key_Down)) {
            move(key.key() == Qt::Key_Up ? -1 : 1);
            return true;
        }
    }
    if (watched == m_list && event->type() == QEvent::FontChange) {
        fitHeight();
    }
    return AnswerField::eventFilter(watched, event);
}

void OrderAnswer::show(const Answer& answer) {
    if (answer.order && answer.order->size() == static_cast<std::size_t>(m_list->count())) {
        std::vector<std::size_t> order;
        for (const double place : *answer.order) {
            order.push_back(static_cast<std::size_t>(place));
        }
        fill(order);
    }
}

void OrderAnswer::put(Answer& answer) const {
    std::vector<double> order;
    for (int i = 0; i < m_list->count(); ++i) {
        order.push_back(m_list->item(i)->data(orderedPlaceRole).toInt());
    }
    answer.order = std::move(order);
}

bool OrderAnswer::isWhole() const {
    return m_list->count() > 0;
}

void OrderAnswer::lock() {
    m_list->setDragDropMode(QAbstractItemView::NoDragDrop);
    m_up->setEnabled(false);
    m_down->setEnabled(false);
    m_up->hide();
    m_down->hide();
}

void OrderAnswer::showResult(const GoalResult& result) {
    m_found = result.order;
    m_result->clear();
    for (const std::size_t place : m_found) {
        auto* item = new QListWidgetItem(GoalText::place(m_project, place), m_result);
        item->setFlags(Qt::ItemIsEnabled);
    }
    m_resultLabel->setVisible(!m_found.empty());
    m_result->setVisible(!m_found.empty());
    static_cast<QGridLayout*>(layout())->setColumnStretch(2, m_found.empty() ? 0 : 1);
    fitHeight();
    retranslate();
}

void OrderAnswer::retranslate() {
    const bool isDone = !m_found.empty();
    m_note->setText(isDone ? tr("Your prediction, the largest first")
                           : tr("The largest first: drag them, or move them with the buttons."));
    m_list->setAccessibleName(tr("Your prediction, the largest first"));
    m_result->setAccessibleName(tr("Result of the run, the largest first"));
    m_resultLabel->setText(tr("Result of the run, the largest first"));
    const auto name = [](QToolButton& button, const QString& text, const QString& keys) {
        button.setAccessibleName(text);
        button.setToolTip(QStringLiteral("%1 (%2)").arg(text, keys));
    };
    name(*m_up, tr("Move up"), tr("Ctrl+Up"));
    name(*m_down, tr("Move down"), tr("Ctrl+Down"));
    for (QListWidget* list : {m_list, m_result}) {
        for (int i = 0; i < list->count(); ++i) {
            const std::size_t place =
                list == m_list
                    ? static_cast<std::size_t>(list->item(i)->data(orderedPlaceRole).toInt())
                    : m_found[static_cast<std::size_t>(i)];
            list->item(i)->setText(GoalText::place(m_project, place));
        }
    }
}

/// An answer in words, which the teacher reads.
class TextAnswer : public AnswerField {
    Q_DECLARE_TR_FUNCTIONS(sparkout::TextAnswer)

public:
    TextAnswer(TextGoal goal, QWidget* parent);

    void show(const Answer& answer) override;
    void put(Answer& answer) const override;
    [[nodiscard]] bool isWhole() const override;
    void lock() override;
    void retranslate() override;

private:
    [[nodiscard]] int letters() const;
    void showLetters();

    TextGoal m_goal;
    QPlainTextEdit* m_text;
    QLabel* m_letters;
};

constexpr int answerHeight = 120, longestAnswer = 20'000;

TextAnswer::TextAnswer(TextGoal goal, QWidget* parent)
    : AnswerField(parent)
    , m_goal(goal)
    , m_text(new QPlainTextEdit(this))
    , m_letters(new QLabel(this)) {
    m_text->setObjectName(QStringLiteral("answerText"));
    m_text->setTabChangesFocus(true);
    setTextMinimumHeight(*m_text, answerHeight);
    m_letters->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::row);
    layout->addWidget(m_text);
    layout->addWidget(m_letters);
    connect(m_text, &QPlainTextEdit::textChanged, this, [this] {
        if (m_text->toPlainText().size() > longestAnswer) { // longer than a file should contain
            const QSignalBlocker blocker(m_text);
            m_text->setPlainText(m_text->toPlainText().left(longestAnswer));
        }
        showLetters();
        emit edited();
    });
    TextAnswer::retranslate();
}

void TextAnswer::show(const Answer& answer) {
    const QSignalBlocker blocker(m_text);
    m_text->setPlainText(QString::fromStdString(answer.text));
    showLetters();
}

void TextAnswer::put(Answer& answer) const {
    answer.text = m_text->toPlainText().toStdString();
}

int TextAnswer::letters() const {
    const QString text = m_text->toPlainText();
    return static_cast<int>(
        std::count_if(text.begin(), text.end(), [](QChar each) { return !each.isSpace(); }));
}

bool TextAnswer::isWhole() const {
    return letters() >= m_goal.least_letters;
}

void TextAnswer::lock() {
    m_text->setReadOnly(true);
}

void TextAnswer::showLetters() {
    m_letters->setText(tr("%1 of at least %2 characters. Your teacher reads the answer.")
                           .arg(letters())
                           .arg(m_goal.least_letters));
}

void TextAnswer::retranslate() {
    m_text->setAccessibleName(tr("Your answer"));
    showLetters();
}

/// A choice of one or several options.
class ChoiceAnswer : public AnswerField {
    Q_DECLARE_TR_FUNCTIONS(sparkout::ChoiceAnswer)

public:
    ChoiceAnswer(ChoiceGoal goal, QWidget* parent);

    void show(const Answer& answer) override;
    void put(Answer& answer) const override;
    [[nodiscard]] bool isWhole() const override;
    void lock() override;
    void retranslate() override;

private:
    ChoiceGoal m_goal;
    QLabel* m_note;
    std::vector<QCheckBox*> m_boxes;
    std::vector<MarkupText*> m_texts;
};

/// The text of an option; clicking it clicks its box.
class OptionText : public MarkupText {
public:
    OptionText(QCheckBox& box, QWidget* parent) : MarkupText(parent), m_box(box) {
        setTextInteractionFlags(Qt::NoTextInteraction);
    }

protected:
    void mouseReleaseEvent(QMouseEvent* event) override {
        if (m_box.isEnabled() && rect().contains(event->position().toPoint())) {
            m_box.click();
        }
    }

private:
    QCheckBox& m_box;
};

ChoiceAnswer::ChoiceAnswer(ChoiceGoal goal, QWidget* parent)
    : AnswerField(parent), m_goal(std::move(goal)), m_note(new QLabel(this)) {
    m_note->setWordWrap(true);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::gap);
    grid->setVerticalSpacing(metrics::gap);
    grid->setColumnStretch(1, 1);
    grid->addWidget(m_note, 0, 0, 1, 2);
    for (std::size_t i = 0; i < m_goal.options.size(); ++i) {
        auto* box = new QCheckBox(this);
        box->setObjectName(QStringLiteral("option%1").arg(i + 1));
        auto* text = new OptionText(*box, this);
        const int row = static_cast<int>(i) + 1;
        grid->addWidget(box, row, 0, Qt::AlignTop);
        grid->addWidget(text, row, 1);
        connect(box, &QCheckBox::clicked, this, &AnswerField::edited);
        m_boxes.push_back(box);
        m_texts.push_back(text);
    }
    ChoiceAnswer::retranslate();
}

void ChoiceAnswer::show(const Answer& answer) {
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        m_boxes[i]->setChecked(answer.chosen
                               && std::ranges::find(*answer.chosen, static_cast<double>(i + 1))
                                      != answer.chosen->end());
    }
}

void ChoiceAnswer::put(Answer& answer) const {
    std::vector<double> chosen;
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        if (m_boxes[i]->isChecked()) {
            chosen.push_back(static_cast<double>(i + 1));
        }
    }
    answer.chosen.reset();
    if (!chosen.empty()) {
        answer.chosen = std::move(chosen);
    }
}

bool ChoiceAnswer::isWhole() const {
    return std::ranges::any_of(m_boxes, &QCheckBox::isChecked);
}

void ChoiceAnswer::lock() {
    for (QCheckBox* box : m_boxes) {
        box->setEnabled(false);
    }
}

void ChoiceAnswer::retranslate() {
    m_note->setText(tr("Tick every correct answer; there may be more than one."));
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        m_texts[i]->setMarkup(LessonText::tagged(m_goal.options[i].text));
        m_boxes[i]->setAccessibleName(m_texts[i]->toPlainText());
    }
}

/// A number predicted before the run; later the engine's is shown below it.
class NumberAnswer : public AnswerField {
    Q_DECLARE_TR_FUNCTIONS(sparkout::NumberAnswer)

public:
    NumberAnswer(NumberPrediction goal, const Project& project, QWidget* parent);

    void show(const Answer& answer) override;
    void put(Answer& answer) const override;
    [[nodiscard]] bool isWhole() const override;
    void lock() override;
    void showResult(const GoalResult& result) override;
    void retranslate() override;

private:
    NumberPrediction m_goal;
    Project m_project;
    QLabel* m_label;
    NumberField* m_field;
    QLabel* m_unit;
    QLabel* m_resultLabel;
    QLabel* m_result;
    std::optional<double> m_value; ///< the engine's
};

NumberSpec anyNumber(const Figure& figure) {
    NumberSpec spec;
    spec.unit = rowOf(figure.name).unit;
    spec.optional = true;
    return spec;
}

NumberAnswer::NumberAnswer(NumberPrediction goal, const Project& project, QWidget* parent)
    : AnswerField(parent)
    , m_goal(std::move(goal))
    , m_project(project)
    , m_label(new QLabel(this))
    , m_field(new NumberField(anyNumber(m_goal.figure), this))
    , m_unit(new QLabel(this))
    , m_resultLabel(new QLabel(this))
    , m_result(new QLabel(this)) {
    m_field->setObjectName(QStringLiteral("predictedNumber"));
    m_result->setObjectName(QStringLiteral("resultNumber"));
    setTextMinimumWidth(*m_field, metrics::field);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::gap);
    grid->setVerticalSpacing(metrics::row);
    for (QLabel* label : {m_label, m_resultLabel}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    m_label->setBuddy(m_field);
    grid->addWidget(m_label, 0, 0);
    grid->addWidget(m_field, 0, 1);
    grid->addWidget(m_unit, 0, 2);
    grid->addWidget(m_resultLabel, 1, 0);
    grid->addWidget(m_result, 1, 1, 1, 2);
    grid->setColumnStretch(0, 1);
    m_resultLabel->hide();
    m_result->hide();
    connect(m_field, &NumberField::valueEdited, this, &AnswerField::edited);
    NumberAnswer::retranslate();
}

void NumberAnswer::show(const Answer& answer) {
    m_field->reset(answer.number);
}

void NumberAnswer::put(Answer& answer) const {
    answer.number = m_field->value();
}

bool NumberAnswer::isWhole() const {
    return m_field->value().has_value() && !m_field->refused();
}

void NumberAnswer::lock() {
    m_field->setEnabled(false);
}

void NumberAnswer::showResult(const GoalResult& result) {
    m_value = result.value;
    m_resultLabel->setVisible(m_value.has_value());
    m_result->setVisible(m_value.has_value());
    retranslate();
}

void NumberAnswer::retranslate() {
    m_label->setText(m_goal.after_run ? tr("Your answer") : tr("Your prediction"));
    m_field->setAccessibleName(
        (m_goal.after_run ? tr("Your answer: %1") : tr("Your prediction: %1"))
            .arg(GoalText::quantity(m_goal.figure, m_project)));
    m_field->retranslate();
    m_unit->setText(GoalText::unit(m_goal.figure));
    m_resultLabel->setText(tr("Result of the run"));
    m_result->setText(m_value ? GoalText::value(m_goal.figure, *m_value) : QString());
}

} // namespace

AnswerField* AnswerField::make(const LessonStep& step, const Project& project, QWidget* parent) {
    const Goal& goal = step.goal;
    switch (goal.kind()) {
    case GoalKind::prediction: return new NumberAnswer(*goal.prediction, project, parent);
    case GoalKind::curve: return new CurveAnswer(*goal.curve, project, parent);
    case GoalKind::order: return new OrderAnswer(*goal.order, project, parent);
    case GoalKind::choice: return new ChoiceAnswer(*goal.choice, parent);
    case GoalKind::text: return new TextAnswer(*goal.text, parent);
    case GoalKind::requirements:
    case GoalKind::time:
    case GoalKind::figure: break;
    }
    return nullptr;
}

} // namespace sparkout
