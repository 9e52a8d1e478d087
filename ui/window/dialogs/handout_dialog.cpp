// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/handout_dialog.h"

#include "core/project/cycle.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/session/cycle_cursor.h"
#include "ui/session/settings.h"
#include "ui/text/names.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QGroupBox>
#include <QLabel>
#include <QVBoxLayout>

#include <array>

namespace sparkout {

namespace {

constexpr int handoutWidth = 640, shortestStep = 30;
const QString answersWord = QStringLiteral("answers");

report::StepWish wishOf(const Place& at, int radius) {
    report::StepWish wish;
    wish.zone = at.zone;
    wish.section = at.zone == Zone::section ? std::optional(at.section) : std::nullopt;
    wish.stage = at.stage;
    wish.count = at.cycleCount;
    wish.step = static_cast<int>(at.step);
    wish.revolution = at.revolution;
    wish.radius = radius;
    return wish;
}

} // namespace

HandoutDialog::HandoutDialog(const OutcomePtr& outcome, const CycleCursor& cycle,
                             Settings& settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_form(new QComboBox(this))
    , m_step(new QComboBox(this))
    , m_answers(new QCheckBox(tr("&Answers to the questions, on a last page"), this)) {
    setWindowTitle(tr("Course hand-out"));
    setHelpTopic(*this, QStringLiteral("reports#handout"));
    auto* formLabel = new QLabel(tr("&Contents:"), this);
    formLabel->setBuddy(m_form);
    m_form->setObjectName(QStringLiteral("handoutForm"));
    m_form->setAccessibleName(tr("Contents of the handout"));
    m_form->addItems({tr("Hand-out with its results"), tr("Worksheet: results are left empty"),
                      tr("Key to the worksheet")});
    auto* label = new QLabel(tr("&Step that is worked out:"), this);
    label->setBuddy(m_step);
    m_step->setObjectName(QStringLiteral("handoutStep"));
    m_step->setAccessibleName(tr("Step that is worked out"));
    m_step->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_step->setMinimumContentsLength(shortestStep);
    offerSteps(outcome, cycle);
    auto* figures = new QGroupBox(tr("Charts"), this);
    connect(m_form, &QComboBox::currentIndexChanged, figures,
            [figures](int index) { figures->setEnabled(index == 0); });
    connect(m_form, &QComboBox::currentIndexChanged, m_answers,
            [this](int index) { m_answers->setEnabled(index == 0); });
    auto* column = new QVBoxLayout(figures);
    for (const report::HandoutViewRow& row : report::handoutViews()) {
        auto* box = new QCheckBox(QCoreApplication::translate("HandoutView", row.name), figures);
        box->setObjectName(QStringLiteral("view-") + QString::fromLatin1(row.key));
        column->addWidget(box);
        m_views.push_back(box);
    }
    m_answers->setObjectName(QStringLiteral("handoutAnswers"));
    recall();
    auto* buttons = new AnswerButtons(tr("&Continue"), tr("Cance&l"), this);
    buttons->acceptButton()->setObjectName(QStringLiteral("makeHandout"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(formLabel);
    layout->addWidget(m_form);
    layout->addWidget(label);
    layout->addWidget(m_step);
    layout->addWidget(figures);
    layout->addWidget(m_answers);
    layout->addWidget(buttons);
    resize(atFontSize(handoutWidth), sizeHint().height());
}

void HandoutDialog::offerSteps(const OutcomePtr& outcome, const CycleCursor& cycle) {
    const Trajectory& trajectory = outcome->trajectory;
    const auto offer = [&](const QString& text, const report::StepWish& wish) {
        if (const auto found = report::findStep(trajectory, wish)) {
            const Place& at = trajectory.passes[found->pass].place;
            QString place = Names::place(at, outcome->result.project.operation);
            if (at.revolution > 0 && at.step != Step::none) {
                place = tr("%1, revolution %2").arg(place).arg(at.revolution);
            }
            m_step->addItem(text.arg(place).arg(found->radius));
            m_wishes.push_back(wish);
        }
    };
    if (cycle.outcome() && !cycle.atStart()) {
        const Progress done = cycle.progress();
        for (std::size_t i = done.open; i < done.end; ++i) {
            offer(tr("Current moment of the cycle: %1, k = %2"),
                  wishOf(cycle.outcome()->trajectory.passes[i].place, cycle.radius()));
        }
    }
    const int standing = m_step->count();
    const auto stages = static_cast<int>(outcome->result.project.cycle->stages.size());
    for (int stage = 1; stage <= stages; ++stage) {
        report::StepWish wish;
        wish.stage = stage;
        offer(tr("The deepest cut of a stage: %1, k = %2"), wish);
    }
    offer(tr("The deepest cut of the cycle: %1, k = %2"), {});
    if (cycle.atEnd() && standing < m_step->count()) {
        m_step->setCurrentIndex(standing); // the user has not moved to the end
    }
    m_step->setEnabled(m_step->count() > 0);
}

void HandoutDialog::recall() {
    QStringList words = m_settings.handout().split(u',', Qt::SkipEmptyParts);
    const report::HandoutOptions usual;
    const bool answers = words.removeAll(answersWord) > 0;
    const auto views = report::readHandoutViews(words.join(u','));
    const bool known = !m_settings.handout().isEmpty() && views;
    m_answers->setChecked(known ? answers : usual.answers);
    for (std::size_t i = 0; i < m_views.size(); ++i) {
        m_views[i]->setChecked(
            (known ? *views : usual.views).contains(report::handoutViews()[i].view));
    }
}

report::HandoutOptions HandoutDialog::options() const {
    report::HandoutOptions options;
    if (const int index = m_step->currentIndex(); index >= 0) {
        options.step = m_wishes[static_cast<std::size_t>(index)];
    }
    options.views.clear();
    for (std::size_t i = 0; i < m_views.size(); ++i) {
        if (m_views[i]->isChecked()) {
            options.views.insert(report::handoutViews()[i].view);
        }
    }
    options.answers = m_answers->isChecked();
    return options;
}

std::optional<report::Paper> HandoutDialog::paper() const {
    constexpr std::array forms{std::optional<report::Paper>(),
                               std::optional(report::Paper::worksheet),
                               std::optional(report::Paper::worksheetKey)};
    return forms.at(static_cast<std::size_t>(m_form->currentIndex()));
}

void HandoutDialog::accept() {
    const report::HandoutOptions chosen = options();
    m_settings.setHandout(report::handoutViewText(chosen.views)
                          + (chosen.answers ? u',' + answersWord : QStringLiteral(",")));
    QDialog::accept();
}

} // namespace sparkout
