// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTextDocumentLayout>
#include <QTextEdit>
#include <QWheelEvent>

#include <cmath>

namespace sparkout {

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
