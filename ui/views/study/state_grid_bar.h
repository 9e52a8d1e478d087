// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/views/study/state_grid_text.h"

#include <QTimer>
#include <QWidget>

#include <optional>

class QLabel;
class QSlider;
class QSpinBox;
class QToolButton;

namespace sparkout {

class RunBar;

/// Fills a project's grid of dynamic programming by itself after each change of it or of the grid's
/// size, and then proves the answer: levels and stages, buttons to stop and to run again, and
/// controls to step through the filling: first, previous, play, next, last, and a slider.
class StateGridBar : public QWidget {
    Q_OBJECT
public:
    explicit StateGridBar(QWidget* parent = nullptr);

    void follow(const Project& project); ///< fills the grid, unless that is done or running
    void forget();                       ///< before another document
    /// The last filled grid; null if there is none, or if the project has no grid.
    [[nodiscard]] const StateGridOutcomePtr& outcome() const { return m_outcome; }
    [[nodiscard]] bool busy() const { return m_job->running(); }
    [[nodiscard]] bool stale() const { return m_stale; } ///< it belongs to another project or size
    [[nodiscard]] int moment() const;
    void setMoment(int number);
    [[nodiscard]] bool isPlaying() const { return m_timer.isActive(); }
    [[nodiscard]] QString remark() const; ///< both answers, or why there is no grid
    void showState(bool accepted);        ///< false: the newest inputs are refused
    void retranslate();

signals:
    void changed();         ///< the result, or whether it is being computed
    void moved(int moment); ///< the moment has changed

private:
    QWidget* buildSteps();
    void connectSteps();
    [[nodiscard]] StateGridSize size() const;
    [[nodiscard]] bool canRun() const;
    void noteStale();
    void fill(); ///< if needed
    void run();
    void prove();
    void take(const StateGridOutcomePtr& outcome);
    void takeProof(const StateGridOutcomePtr& outcome);
    void showSize();
    void setPlaying(bool playing);
    void playOn();
    void showMoment();
    [[nodiscard]] int last() const;

    std::optional<Project> m_project;
    std::optional<int> m_ownLevels, m_ownStages; ///< chosen by the user
    StateGridOutcomePtr m_outcome;
    bool m_stale = true;
    std::optional<StateGridOutcome> m_running; ///< the running computation, without its grid
    Job* m_job;
    QSpinBox *m_levels, *m_stages;
    RunBar* m_bar;
    QToolButton *m_first, *m_previous, *m_play, *m_next, *m_end;
    QSlider* m_slider;
    QLabel* m_place;
    QTimer m_timer;
};

} // namespace sparkout
