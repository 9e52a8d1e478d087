// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QRect>
#include <QString>
#include <QWidget>

#include <functional>
#include <memory>
#include <vector>

class QLabel;
class QPushButton;

class QWidget;

namespace sparkout {

/// A text with buttons beside a widget of the window, with a tip that points at it.
class TourBalloon : public QWidget {
    Q_OBJECT

public:
    explicit TourBalloon(QWidget& window);

    struct Text {
        QString title, body, place; ///< place: "2 of 7"
        bool first = false, last = false;
    };
    void show(const Text& text, const QRect& target); ///< in window coordinates
    [[nodiscard]] QRect body() const;
    [[nodiscard]] QPoint tip() const; ///< what it points at, in the window                 ///< of
                                      ///< the balloon, without the tip
    [[nodiscard]] QString title() const;

signals:
    void next();
    void back();
    void ended();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void place(const QRect& target);

    QLabel* m_title;
    QLabel* m_text;
    QLabel* m_place;
    QPushButton* m_skip;
    QPushButton* m_back;
    QPushButton* m_next;
    QPoint m_tip; ///< in balloon coordinates
};

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
