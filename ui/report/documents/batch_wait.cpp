// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/batch_wait.h"

#include "ui/kit/help_topic.h"
#include "ui/views/batch/batch_text.h"

#include <QEventLoop>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {
constexpr int waitSteps = 1000;
constexpr int waitWidth = 420;
constexpr int unseen_ms = 300; ///< a batch that ends earlier shows no dialog
} // namespace

BatchWait::BatchWait(const Project& project, const QString& what, QWidget* parent)
    : QDialog(parent)
    , m_project(project)
    , m_text(new QLabel(tr("The batch of this report is being run."), this))
    , m_progress(new QProgressBar(this))
    , m_stop(new QPushButton(tr("&Stop"), this)) {
    setWindowTitle(what);
    setHelpTopic(*this, QStringLiteral("reports#passport"));
    m_text->setTextFormat(Qt::PlainText);
    m_progress->setRange(0, waitSteps);
    m_progress->setAccessibleName(tr("Progress of the batch"));
    m_progress->setMinimumWidth(waitWidth);
    m_stop->setObjectName(QStringLiteral("stopWaiting"));
    m_stop->setToolTip(tr("Stop the batch; no report is made"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_text);
    column->addWidget(m_progress);
    auto* row = new QHBoxLayout;
    row->addStretch();
    row->addWidget(m_stop);
    column->addLayout(row);
    showProgress(0, partsOf(project), -1);
    connect(m_stop, &QPushButton::clicked, this, &QDialog::reject);
    connect(&m_job, &Job::progressed, this, &BatchWait::showProgress);
}

void BatchWait::showProgress(qint64 done, qint64 parts, double left_s) {
    m_progress->setValue(static_cast<int>(done * waitSteps / std::max(parts, qint64(1))));
    m_progress->setFormat(BatchText::progress(done, parts, left_s));
}

BatchOutcomePtr BatchWait::wait() {
    m_job.start(
        partsOf(m_project),
        [project = m_project](const Job::Means& means) { return batchOf(project, means); },
        [this](const BatchOutcomePtr& outcome) {
            m_outcome = outcome;
            accept();
        });
    QEventLoop briefly;
    QTimer::singleShot(unseen_ms, &briefly, &QEventLoop::quit);
    connect(&m_job, &Job::answered, &briefly, &QEventLoop::quit);
    briefly.exec(QEventLoop::ExcludeUserInputEvents);
    if (!m_outcome) {
        exec();
        m_job.drop(); // after a stop
    }
    return m_outcome;
}

} // namespace sparkout
