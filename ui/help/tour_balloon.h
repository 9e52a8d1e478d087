// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

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

} // namespace sparkout
