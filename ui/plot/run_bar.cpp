// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/run_bar.h"

#include "core/units.h"
#include "ui/kit/metrics.h"
#include "ui/kit/tool_row.h"
#include "ui/session/job.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {
constexpr int progressSteps = 1000;
constexpr double quickRadii = 2e8; ///< about two seconds of one processor
} // namespace

RunBar::RunBar(const QString& name, QWidget* parent, Progress text)
    : QWidget(parent)
    , m_text(text)
    , m_run(new QPushButton(this))
    , m_stop(new QPushButton(this))
    , m_state(new QLabel(this))
    , m_progress(new QProgressBar(this)) {
    m_run->setObjectName(name + QStringLiteral("Run"));
    m_stop->setObjectName(name + QStringLiteral("Stop"));
    m_state->setObjectName(name + QStringLiteral("State"));
    m_progress->setObjectName(name + QStringLiteral("Progress"));
    m_state->setTextFormat(Qt::PlainText);
    m_progress->setRange(0, progressSteps);
    m_progress->setTextVisible(true);
}

void RunBar::layOut(std::initializer_list<QWidget*> before, std::initializer_list<QWidget*> behind,
                    int letters) {
    auto* row = new ToolRow(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(m_run);
    row->addWidget(m_stop);
    for (QWidget* part : before) {
        row->addWidget(part);
    }
    row->addText(m_state, letters, 1);
    row->addWidget(m_progress, 1);
    for (QWidget* part : behind) {
        row->addWidget(part);
    }
}

void RunBar::follow(Job& job) {
    connect(&job, &Job::progressed, this, qOverload<qint64, qint64, double>(&RunBar::showProgress));
    connect(m_stop, &QPushButton::clicked, &job, &Job::stop);
}

QString RunBar::withTimeLeft(const QString& count, double left_s) {
    if (left_s < 0) {
        return count;
    }
    constexpr double perMinute = units::secondsPerMinute;
    return left_s < 2 * perMinute
               ? tr("%1, %2 s left").arg(count).arg(std::ceil(left_s), 0, 'f', 0)
               : tr("%1, %2 min left").arg(count).arg(std::ceil(left_s / perMinute), 0, 'f', 0);
}

bool RunBar::areQuick(std::int64_t runs, std::int64_t radii) {
    return static_cast<double>(runs) * static_cast<double>(radii) <= quickRadii;
}

void RunBar::showProgress(qint64 done, qint64 parts, double left_s) {
    m_progress->setValue(static_cast<int>(done * progressSteps / std::max(parts, qint64(1))));
    m_progress->setFormat(m_text(done, parts, left_s));
}

void RunBar::showProgress(double share, const QString& text) {
    m_progress->setValue(static_cast<int>(share * progressSteps));
    m_progress->setFormat(text);
}

void RunBar::showRunning(bool runs, bool mayRun) {
    m_progress->setVisible(runs);
    m_run->setEnabled(mayRun && !runs);
    m_stop->setEnabled(runs || m_turns);
    if (m_turns) { // shows the new button before hiding the old one, so that the focus moves to it
        QPushButton* const coming = runs ? m_stop : m_run;
        QPushButton* const going = runs ? m_run : m_stop;
        coming->show();
        going->hide();
    }
    m_state->setVisible(!runs);
}

} // namespace sparkout
