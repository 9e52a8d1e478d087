// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QRect>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

class QWidget;

namespace sparkout {

class TourBalloon;

/// A part of the window shown by the tour.
struct TourStep {
    /// Makes it visible; returns its area in the window, empty: the step is skipped.
    std::function<QRect()> target;
    std::function<QString()> title; ///< translated
    std::function<QString()> text;
};

/// A tour of the window: a balloon beside one part after the other. Escape ends it.
class Tour : public QObject {
    Q_OBJECT

public:
    Tour(QWidget& window, std::vector<TourStep> steps);
    ~Tour() override;

    void start();
    void end();
    [[nodiscard]] bool running() const;
    [[nodiscard]] int step() const { return m_step; }
    [[nodiscard]] const TourBalloon* balloon() const { return m_balloon.get(); }

signals:
    void finished(); ///< was completed, or skipped

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void go(int by);
    bool showStep(); ///< false: its part is not visible

    QWidget& m_window;
    std::vector<TourStep> m_steps;
    std::unique_ptr<TourBalloon> m_balloon;
    int m_step = 0;
};

} // namespace sparkout
