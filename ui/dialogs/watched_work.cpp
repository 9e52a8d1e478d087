// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/watched_work.h"

#include "ui/kit/metrics.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QDialog>
#include <QEventLoop>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QThread>
#include <QTimer>
#include <QVBoxLayout>

#include <atomic>
#include <memory>

namespace sparkout {

namespace {

constexpr int unfelt_ms = 20; // shorter work needs no event loop
constexpr int quick_ms = 400; // shorter work needs no dialog, which would only flash
constexpr int tick_ms = 50;
constexpr int barSteps = 1000; // number of steps of the bar
constexpr int barWidth = 360;

/// The progress of the work, and a button to stop it.
class WatchDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(WatchDialog)
public:
    WatchDialog(QWidget* window, const QString& told) : QDialog(window), m_bar(new QProgressBar) {
        const QString text = printableText(told); // it may name a file
        setWindowTitle(text);
        auto* label = new QLabel(text);
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        m_bar->setRange(0, 0); // busy, until the progress is known
        m_bar->setMinimumWidth(barWidth);
        m_bar->setAccessibleName(tr("Progress"));
        auto* stop = new QPushButton(tr("&Stop"));
        stop->setObjectName(QStringLiteral("stopWork"));
        connect(stop, &QPushButton::clicked, this, &QDialog::reject);
        auto* row = new QHBoxLayout;
        row->addWidget(m_bar, 1);
        row->addWidget(stop);
        auto* column = new QVBoxLayout(this);
        column->setSpacing(metrics::wide);
        column->addWidget(label);
        column->addLayout(row);
    }
    void show(double share) {
        m_bar->setRange(0, share > 0 ? barSteps : 0);
        m_bar->setValue(static_cast<int>(share * barSteps));
    }

private:
    QProgressBar* m_bar;
};

/// Waits briefly, without keys and clicks.
void waitAMoment(QThread& thread) {
    QEventLoop loop;
    QObject::connect(&thread, &QThread::finished, &loop, &QEventLoop::quit);
    QTimer::singleShot(quick_ms, &loop, &QEventLoop::quit);
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    if (!thread.isFinished()) {
        loop.exec(QEventLoop::ExcludeUserInputEvents);
    }
    QGuiApplication::restoreOverrideCursor();
}

} // namespace

bool runWatched(QWidget* window, const QString& text,
                const std::function<void(const KeepGoing&)>& work, std::stop_source stop) {
    std::atomic<double> share = 0;
    const std::unique_ptr<QThread> thread(QThread::create([&] {
        work([&](double done) {
            share = done;
            return !stop.stop_requested();
        });
    }));
    thread->start();
    if (!thread->wait(unfelt_ms)) {
        waitAMoment(*thread);
    }
    if (!thread->isFinished()) {
        WatchDialog dialog(window, text);
        QTimer ticks;
        QObject::connect(&ticks, &QTimer::timeout, &dialog, [&] { dialog.show(share); });
        QObject::connect(thread.get(), &QThread::finished, &dialog, &QDialog::accept);
        ticks.start(tick_ms);
        if (!thread->isFinished() && dialog.exec() == QDialog::Rejected) {
            stop.request_stop();
        }
        thread->wait();
    }
    return !stop.stop_requested();
}

} // namespace sparkout
