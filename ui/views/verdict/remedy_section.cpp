// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict/remedy_section.h"

#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {

QLabel* wrapping(QWidget* parent, const QString& name) {
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setMinimumWidth(1);
    return label;
}

/// Marked up so that a tool tip wraps.
QString paragraph(const std::string& text) {
    return QStringLiteral("<p>%1</p>").arg(withIndices(QString::fromStdString(text)));
}

} // namespace

RemedySection::RemedySection(QWidget* parent)
    : QWidget(parent)
    , m_title(wrapping(this, QStringLiteral("remediesTitle")))
    , m_note(wrapping(this, QStringLiteral("remediesNote")))
    , m_end(new QPushButton(this)) {
    setHelpTopic(*this, QStringLiteral("verdict#remedies"));
    build();
    retranslate();
}

void RemedySection::build() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::tight);
    layout->addWidget(m_title);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        Line& line = m_lines[i];
        line.line = new QWidget(this);
        line.text = wrapping(line.line, QStringLiteral("remedy%1").arg(i + 1));
        line.text->setTextFormat(Qt::RichText);
        line.text->setTextInteractionFlags(Qt::TextSelectableByMouse);
        line.take = new QPushButton(line.line);
        line.take->setObjectName(QStringLiteral("takeRemedy%1").arg(i + 1));
        auto* row = new QHBoxLayout(line.line);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(metrics::gap);
        row->addWidget(line.text, 1);
        row->addWidget(line.take, 0, Qt::AlignTop);
        layout->addWidget(line.line);
        connect(line.take, &QPushButton::clicked, this, [this, i] {
            if (m_result && i < m_result->remedies.size()) {
                emit wanted(Remedy(m_result->remedies[i])); // a copy: the result may go
            }
        });
    }
    m_note->setTextFormat(Qt::RichText);
    m_note->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_end->setObjectName(QStringLiteral("endRemedies"));
    auto* foot = new QHBoxLayout;
    foot->setSpacing(metrics::gap);
    foot->addWidget(m_note, 1);
    foot->addWidget(m_end, 0, Qt::AlignTop);
    layout->addLayout(foot);
    connect(m_end, &QPushButton::clicked, this, &RemedySection::endWanted);
}

void RemedySection::setRemedies(OutcomePtr outcome, std::shared_ptr<const RemedyResult> result,
                                bool running) {
    m_outcome = std::move(outcome);
    m_result = std::move(result);
    m_running = running;
    setEnabled(true);
    showResult();
}

void RemedySection::setStale() {
    m_running = false;
    setEnabled(false);
    showResult();
}

void RemedySection::clear() {
    m_outcome.reset();
    m_result.reset();
    m_running = false;
    showResult();
}

void RemedySection::showResult() {
    const bool says = m_result && m_result->goal != RemedyGoal::none;
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const bool shown = says && i < m_result->remedies.size();
        m_lines[i].line->setVisible(shown);
        if (shown) {
            showLine(i);
        }
    }
    m_title->setText(says && m_result->goal == RemedyGoal::room ? tr("Ways to a larger margin")
                                                                : tr("Possible remedies"));
    m_note->setText(says ? withIndices(note()) : QString());
    m_note->setVisible(!m_note->text().isEmpty());
    m_end->setVisible(says && m_running);
    setVisible(says);
}

void RemedySection::showLine(std::size_t index) {
    const RemedyText words;
    const Remedy& remedy = m_result->remedies[index];
    const QString line = QString::fromStdString(words.line(project(), remedy));
    const QString proof = paragraph(words.proof(project(), m_result->goal, remedy));
    const Line& shown = m_lines[index];
    shown.text->setText(withIndices(keptTogether(line)));
    shown.text->setToolTip(proof);
    shown.take->setText(tr("Apply"));
    shown.take->setToolTip(proof);
    shown.take->setAccessibleName(tr("Apply the change: %1").arg(line));
}

QString RemedySection::note() const {
    const RemedyText words;
    if (m_running) {
        return tr("%1 of %2 settings tried.").arg(m_result->tried).arg(m_result->settings);
    }
    QStringList sentences;
    if (m_result->found > m_result->remedies.size()) {
        sentences +=
            tr("Settings that help: %1; shown are those that cost least.").arg(m_result->found);
    }
    sentences += QString::fromStdString(words.scope(*m_result));
    sentences += QString::fromStdString(words.extent(*m_result));
    if (m_result->conflict) {
        sentences +=
            QString::fromStdString(words.conflict(project(), m_result->goal, *m_result->conflict));
    }
    sentences.removeAll(QString());
    return sentences.join(u' ');
}

void RemedySection::retranslate() {
    for (const Line& line : m_lines) {
        line.text->setAccessibleName(tr("Change that helps"));
        line.take->setAccessibleName(tr("Apply the change"));
    }
    m_note->setAccessibleName(tr("Settings tried"));
    m_end->setText(tr("Stop"));
    m_end->setAccessibleName(tr("Stop looking for changes that help"));
    showResult();
}

std::string RemedyText::translated(const char* text) const {
    return QCoreApplication::translate("Remedy", text).toStdString();
}

std::string RemedyText::number(double value) const {
    return printedNumber(value).toStdString();
}

std::string RemedyText::unit(const char* unit) const {
    return unitText(unit).toStdString();
}

std::string RemedyText::input(const char* label, const char* symbol) const {
    return QStringLiteral("%1 %2").arg(inputText(label), QString::fromUtf8(symbol)).toStdString();
}

std::string RemedyText::requirement(ConstraintKind kind) const {
    return Names::constraint(kind).toStdString();
}

} // namespace sparkout
