// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/step/formula_view.h"

#include "ui/report/format/formula_writer.h"
#include "ui/step/formula_object.h"
#include "ui/text/formula_text.h"

#include <QAbstractTextDocumentLayout>
#include <QEvent>
#include <QFontInfo>
#include <QMimeData>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFragment>

#include <algorithm>

namespace sparkout {

namespace {

constexpr double equationIndent = 16,
                 paragraphGap = 6; ///< gaps of lines in an equation, of paragraphs [px]
constexpr QChar mayBreak(0x200b);

const QString equalsSign = QStringLiteral(" = ");

/// A side with the equals sign before it.
report::FormulaNode withEquals(const report::FormulaNode& side) {
    using Node = report::FormulaNode;
    return {Node::Kind::row, {}, 2, side.value, {{Node::Kind::sign, equalsSign, 2, 0, {}}, side}};
}

QTextBlockFormat blockFormat(bool equation) {
    QTextBlockFormat format;
    format.setBottomMargin(paragraphGap);
    if (equation) {
        format.setLeftMargin(equationIndent);
        format.setTextIndent(-equationIndent);
    }
    return format;
}

} // namespace

FormulaView::FormulaView(QWidget* parent) : QTextEdit(parent), m_object(new FormulaObject(this)) {
    setReadOnly(true);
    setTabChangesFocus(true);
    document()->documentLayout()->registerHandler(FormulaObject::type, m_object);
    fit();
}

void FormulaView::setSheet(const FormulaSheet& sheet) {
    clearSheet();
    QTextCursor cursor(document());
    QTextCharFormat bold;
    bold.setFontWeight(QFont::Bold);
    cursor.setBlockFormat(blockFormat(false));
    cursor.insertText(formulaHead(sheet), bold);
    for (const FormulaStep& step : sheet.steps) {
        cursor.insertBlock(blockFormat(true), QTextCharFormat());
        const report::Formula formula = report::equation(step);
        for (std::size_t i = 0; i < formula.sides.size(); ++i) {
            const report::FormulaNode& side = formula.sides[i];
            const QString text = report::inOneLine(side);
            const bool first = i == 0;
            if (!first) {
                cursor.insertText(QString(mayBreak), QTextCharFormat());
            }
            cursor.insertText(
                QString(QChar::ObjectReplacementCharacter),
                m_object->add(first ? side : withEquals(side), first ? text : equalsSign + text));
        }
    }
}

void FormulaView::clearSheet() {
    clear();
    m_object->clear();
}

QString FormulaView::text() const {
    return plain(0, document()->characterCount());
}

QString FormulaView::textOf(const FormulaSheet& sheet) {
    QStringList lines{formulaHead(sheet)};
    for (const FormulaStep& step : sheet.steps) {
        lines << report::inOneLine(report::equation(step));
    }
    return lines.join(u'\n');
}

/// The text between two positions.
QString FormulaView::plain(int from, int to) const {
    QStringList lines;
    for (QTextBlock block = document()->findBlock(from); block.isValid() && block.position() < to;
         block = block.next()) {
        QString line;
        for (auto it = block.begin(); !it.atEnd(); ++it) {
            const QTextFragment fragment = it.fragment();
            const int begin = std::max(from, fragment.position());
            const int end = std::min(to, fragment.position() + fragment.length());
            if (begin < end) {
                const bool piece = fragment.charFormat().objectType() == FormulaObject::type;
                line += piece ? FormulaObject::textOf(fragment.charFormat())
                              : fragment.text().mid(begin - fragment.position(), end - begin);
            }
        }
        lines << line.remove(mayBreak);
    }
    return lines.join(u'\n');
}

QMimeData* FormulaView::createMimeDataFromSelection() const {
    auto* copied = new QMimeData;
    const QTextCursor selected = textCursor();
    copied->setText(plain(selected.selectionStart(), selected.selectionEnd()));
    return copied;
}

void FormulaView::fit() {
    m_object->setPixels(QFontInfo(font()).pixelSize());
    m_object->setRoom(viewport()->width() - 2 * document()->documentMargin() - equationIndent);
    document()->markContentsDirty(0, document()->characterCount());
}

void FormulaView::resizeEvent(QResizeEvent* event) {
    fit();
    QTextEdit::resizeEvent(event);
}

void FormulaView::changeEvent(QEvent* event) {
    QTextEdit::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        fit();
    }
}

} // namespace sparkout
