// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal.h"
#include "core/lesson/goal_check.h"
#include "core/lesson/lesson.h"

#include <QAbstractTextDocumentLayout>
#include <QTextEdit>
#include <QWheelEvent>
#include <QWidget>

#include <cmath>

namespace sparkout {

/// A field for a student's answer to a step, by the kind of its goal.
class AnswerField : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// For a step on a project; null if the step is answered by settings of the inputs.
    [[nodiscard]] static AnswerField* make(const LessonStep& step, const Project& project,
                                           QWidget* parent);

    virtual void show(const Answer& answer) = 0;
    virtual void put(Answer& answer) const = 0;     ///< writes its contents into an answer
    [[nodiscard]] virtual bool isWhole() const = 0; ///< whether it is complete
    virtual void lock() = 0;                        ///< called when it was handed in finally
    /// Shows the engine's result beside the prediction.
    virtual void showResult(const GoalResult&) {}
    virtual void retranslate() = 0;

signals:
    void edited();
};

/// A read-only text with markup, as high as its lines. It is laid out once for a width, a long text
/// in steps; a QLabel repeats the layout many times, which takes seconds for a page with tables.
class MarkupText : public QTextEdit {
public:
    explicit MarkupText(QWidget* parent = nullptr) : QTextEdit(parent) {
        setReadOnly(true);
        setTextInteractionFlags(Qt::TextSelectableByMouse);
        setFocusPolicy(Qt::NoFocus); // read-only
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        viewport()->setAutoFillBackground(false);
        document()->setDocumentMargin(0);
        connect(document()->documentLayout(), &QAbstractTextDocumentLayout::documentSizeChanged,
                this, &MarkupText::fit);
    }

    void setMarkup(const QString& html) {
        setHtml(html);
        setAccessibleName(toPlainText());
        fit();
    }

    [[nodiscard]] QSize sizeHint() const override {
        return {QTextEdit::sizeHint().width(), height()};
    }
    [[nodiscard]] QSize minimumSizeHint() const override { return {1, height()}; }

protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); } ///< the page scrolls

private:
    void fit() { setFixedHeight(static_cast<int>(std::ceil(document()->size().height()))); }
};

} // namespace sparkout
