// SPDX-License-Identifier: GPL-3.0-or-later
// Projects, outcomes and events for the tests of the views.
#pragma once

#include "core/study/outcome.h"
#include "tests/two_stage_projects.h"
#include "ui/chart/view.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QTranslator>
#include <QWheelEvent>
#include <QWidget>

#include <memory>

namespace sparkout::fixtures {

inline OutcomePtr run(const Project& project) {
    return evaluate(project, {});
}

inline OutcomePtr refused() {
    auto outcome = std::make_shared<Outcome>();
    outcome->issues.push_back({IssueCode::outOfRange, Severity::error, "/wheel/width_mm",
                               Amount{5000, "mm"}, Bounds{{0.5, 1000}, "mm"}});
    return outcome;
}

/// Until the view has drawn the outcome.
inline void draw(View& view, const OutcomePtr& outcome) {
    QSignalSpy updated(&view, &View::updated);
    view.setOutcome(outcome);
    QTRY_COMPARE(updated.count(), 1);
}

/// Marks every text, so that an untranslated one shows.
class Marking : public QTranslator {
public:
    QString translate(const char*, const char* text, const char*, int) const override {
        return QStringLiteral("«") + QString::fromUtf8(text) + QStringLiteral("»");
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

inline void wheel(QWidget* widget, const QPointF& at, int delta,
                  Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
}

inline void hover(QWidget* widget, const QPointF& at) {
    QMouseEvent event(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                      Qt::NoModifier);
    QApplication::sendEvent(widget, &event);
}

/// Press, two moves and release of the left button.
inline void drag(QWidget* widget, const QPoint& from, const QPoint& to) {
    const auto send = [widget](QEvent::Type type, const QPointF& at, Qt::MouseButton button,
                               Qt::MouseButtons buttons) {
        QMouseEvent event(type, at, widget->mapToGlobal(at), button, buttons, Qt::NoModifier);
        QApplication::sendEvent(widget, &event);
    };
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    send(QEvent::MouseMove, (QPointF(from) + to) / 2, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
}

} // namespace sparkout::fixtures
