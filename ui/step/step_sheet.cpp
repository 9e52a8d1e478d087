// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/step/step_sheet.h"

#include "core/quality/visit_sheet.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/step/formula_view.h"
#include "ui/text/names.h"

#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace sparkout {

StepSheet::StepSheet(CycleCursor& cycle, QWidget* parent)
    : QWidget(parent)
    , m_cycle(cycle)
    , m_zone(new QComboBox(this))
    , m_place(new QLabel(this))
    , m_sheet(new FormulaView(this)) {
    setObjectName(QStringLiteral("stepSheet"));
    setHelpTopic(*this, QStringLiteral("step"));
    m_zone->setObjectName(QStringLiteral("stepZone"));
    m_place->setObjectName(QStringLiteral("stepPlace"));
    m_sheet->setObjectName(QStringLiteral("stepFormulas"));
    m_place->setTextFormat(Qt::PlainText);
    m_place->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    column->setSpacing(metrics::tight);
    column->addWidget(m_place);
    column->addWidget(m_zone);
    column->addWidget(m_sheet, 1);
    connect(&m_cycle, &CycleCursor::moved, this, &StepSheet::follow);
    connect(m_zone, &QComboBox::activated, this, [this](int index) {
        m_wanted = m_zone->itemData(index).toULongLong();
        showSheet();
    });
    retranslate();
}

void StepSheet::follow() {
    if (isVisible()) {
        fillZones();
        showSheet();
    }
}

/// Lists the zones under the wheel; keeps the last chosen one while it is among them.
void StepSheet::fillZones() {
    const QSignalBlocker blocker(m_zone);
    m_zone->clear();
    const Progress done = m_cycle.progress();
    for (std::size_t i = done.open; i < done.end; ++i) {
        const Place& at = m_cycle.outcome()->trajectory.passes[i].place;
        QString name = Names::zoneFull(at.zone, at.section);
        if (at.step != Step::none) {
            name = tr("%1, %2: %3", "zone, E1, what that is")
                       .arg(name, Names::step(at.step), Names::stepMeaning(at.zone, at.step));
        }
        m_zone->addItem(name, static_cast<qulonglong>(sectionOf(at)));
        if (m_wanted == sectionOf(at)) {
            m_zone->setCurrentIndex(m_zone->count() - 1);
        }
    }
    m_zone->setEnabled(m_zone->count() > 1);
}

void StepSheet::showSheet() {
    const Progress done = m_cycle.progress();
    const bool any = !done.isBlank() && m_zone->currentIndex() >= 0;
    m_zone->setVisible(any);
    if (!any) {
        m_place->setText(m_cycle.outcome() ? tr(
                             "Grinding has not started. Step on or press Play below the views: the "
                             "formulas of each step are shown here with their numbers.")
                                           : tr("No cycle has been recorded."));
        m_sheet->clearSheet();
        return;
    }
    const Outcome& outcome = *m_cycle.outcome();
    const std::size_t pass = done.open + static_cast<std::size_t>(m_zone->currentIndex());
    const Place& at = outcome.trajectory.passes[pass].place;
    const QString when = Names::place(at, outcome.result.project.operation);
    const QString k = tr("radius k = %1").arg(m_cycle.radius());
    m_place->setText(at.step == Step::none
                         ? tr("%1, %2").arg(when, k)
                         : tr("%1, %2, %3").arg(when, tr("revolution %1").arg(at.revolution), k));
    const int scrolled = m_sheet->verticalScrollBar()->value();
    m_sheet->setSheet(visitSheet(outcome.result, outcome.trajectory, pass, m_cycle.radius()));
    m_sheet->verticalScrollBar()->setValue(scrolled);
}

void StepSheet::retranslate() {
    setAccessibleName(tr("Formulas of the step"));
    m_zone->setAccessibleName(tr("Zone or section under the wheel"));
    m_zone->setToolTip(m_zone->accessibleName());
    m_place->setAccessibleName(tr("Place in the cycle"));
    m_sheet->setAccessibleName(tr("Balance of the radius with its numbers"));
    fillZones();
    showSheet();
}

void StepSheet::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    follow();
}

void StepSheet::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_sheet) {
        retranslate();
    }
}

} // namespace sparkout
