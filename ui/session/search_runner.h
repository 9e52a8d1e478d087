// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/search.h"
#include "ui/session/newest_job.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>
#include <mutex>
#include <stop_token>

namespace sparkout {

/// Searches a project's grid off the window's thread, one search at a time: a newer one drops the
/// older. Destroying it ends what runs and waits for it.
class SearchRunner : public QObject {
    Q_OBJECT

public:
    explicit SearchRunner(QObject* parent = nullptr);

    /// Scenarios that the project asks for are searched whatever the wish. A proved answer for the
    /// part alone is followed by slower cycles farther from their limits, for about as long again.
    void start(const Project& project, SearchWish wish);
    void stop(); ///< ends it; the best so far is the outcome
    void drop(); ///< ends it without an outcome
    [[nodiscard]] bool running() const { return m_progress.isActive(); }

signals:
    void progressed(const sparkout::SearchState& state);
    void answered(sparkout::SearchOutcomePtr outcome); ///< the search goes on for margins by time
    void finished(sparkout::SearchOutcomePtr outcome);

private:
    struct Shared {
        std::mutex mutex;
        SearchState state;
    };
    void tell();

    QTimer m_progress;
    QElapsedTimer m_took;
    std::shared_ptr<Shared> m_shared; ///< with the search that is running
    std::stop_source m_stop;
    NewestJob m_job; ///< the last member: gone before what its search uses
};

} // namespace sparkout
