// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_line.h"

#include "core/process/coupled_sections.h"
#include "core/study/outcome.h"
#include "ui/text/names.h"

#include <QLabel>
#include <QLocale>
#include <QStatusBar>

#include <algorithm>

namespace sparkout {

StatusLine::StatusLine(QStatusBar& bar)
    : QObject(&bar), m_bar(bar), m_status(new QLabel(&bar)), m_time(new QLabel(&bar)) {
    m_status->setTextFormat(Qt::PlainText);
    m_time->setTextFormat(Qt::PlainText);
    m_bar.addWidget(m_status, 1);
    m_bar.addPermanentWidget(m_time);
    // A message would hide the label while it is not visible yet.
    connect(&m_bar, &QStatusBar::messageChanged, m_status,
            [this](const QString& text) { m_status->setVisible(text.isEmpty()); });
}

void StatusLine::showForAWhile(const QString& text) {
    constexpr int patience_ms = 6000;
    m_bar.showMessage(text, patience_ms);
}

void StatusLine::showOutcome(const Outcome* outcome, double lastRun_ms, bool hasCurves) {
    if (!outcome) {
        m_status->clear();
        m_time->clear();
        return;
    }
    if (Names::incomplete(outcome->issues)) {
        m_status->setText(tr("Not computed: the project is not complete."));
        m_time->clear();
        return;
    }
    if (!outcome->ran()) {
        const auto faults = static_cast<int>(
            std::count_if(outcome->issues.begin(), outcome->issues.end(),
                          [](const Issue& issue) { return issue.severity == Severity::error; }));
        m_status->setText(hasCurves
                              ? tr("Not computed: %n faults in the inputs. The curves show "
                                   "the last good run.",
                                   nullptr, faults)
                              : tr("Not computed: %n faults in the inputs.", nullptr, faults));
        m_time->clear();
        return;
    }
    switch (outcome->result.status) {
    case RunStatus::completed: m_status->setText(tr("The cycle is complete.")); break;
    case RunStatus::cannotReachSize:
        m_status->setText(tr("The cycle cannot reach size: it stopped making progress."));
        break;
    case RunStatus::tooLong:
        m_status->setText(tr("The cycle is too long to be computed to its end."));
        break;
    case RunStatus::notSolved:
        m_status->setText(
            isCoupled(outcome->result.project)
                ? tr("The forces of the coupled sections were not found.")
                : tr("The compliance of a section is negative: the even load beyond a steady rest "
                     "presses it against the wheel. Couple the sections."));
        break;
    case RunStatus::groundAway:
        m_status->setText(tr("One infeed is larger than the part: reduce the feed."));
        break;
    case RunStatus::stopped:
    case RunStatus::refused: break;
    }
    // Pictures for comparison contain no times that differ between runs.
    m_time->setText(qEnvironmentVariableIsSet("SOURCE_DATE_EPOCH")
                        ? QString()
                        : tr("Computed in %1 ms").arg(QLocale().toString(lastRun_ms, 'f', 1)));
}

void StatusLine::retranslate() {
    m_bar.clearMessage(); // it is in the previous language
    m_status->setAccessibleName(tr("Status"));
    m_time->setAccessibleName(tr("Computing time"));
}

} // namespace sparkout
