// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/formula.h"
#include "ui/report/format/form_sheet.h"
#include "ui/session/cycle_cursor.h"

#include <QObject>
#include <QTextCharFormat>
#include <QTextEdit>
#include <QTextObjectInterface>
#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QLabel;

namespace sparkout {

/// Typeset pieces of formulas within a text. Their vertical middle is the axis, the height of a
/// minus sign, so that all pieces of a line share a base line.
class FormulaObject : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    static constexpr int type = QTextFormat::UserObject + 1;

    explicit FormulaObject(QObject* parent) : QObject(parent) {}

    void clear() { m_pieces.clear(); }
    /// The format of the character that represents a piece; `text` is its one-line form.
    [[nodiscard]] QTextCharFormat add(const report::FormulaNode& node, const QString& text);
    [[nodiscard]] static QString textOf(const QTextFormat& format);
    void setPixels(double fontSize) { m_pixels = fontSize; } ///< font size of the text
    void setRoom(double width) { m_room = width; }           ///< a wider piece is pressed together

    QSizeF intrinsicSize(QTextDocument* document, int position, const QTextFormat& format) override;
    void drawObject(QPainter* painter, const QRectF& rect, QTextDocument* document, int position,
                    const QTextFormat& format) override;

private:
    [[nodiscard]] const report::FormulaBox& piece(const QTextFormat& format) const;
    [[nodiscard]] double scaleOf(const report::FormulaBox& box) const;
    [[nodiscard]] static double halfHeight(const report::FormulaBox& box);

    std::vector<report::FormulaBox> m_pieces;
    double m_pixels = 12;
    double m_room = 1e6;
};

/// A sheet of formulas with their numbers, typeset as in the hand-out: a line breaks before an
/// equals sign. Copies are plain text, one line for each equation.
class FormulaView : public QTextEdit {
    Q_OBJECT

public:
    explicit FormulaView(QWidget* parent = nullptr);

    void setSheet(const FormulaSheet& sheet);
    void clearSheet();
    [[nodiscard]] QString text() const; ///< as copied
    [[nodiscard]] static QString textOf(const FormulaSheet& sheet);

protected:
    [[nodiscard]] QMimeData* createMimeDataFromSelection() const override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fit(); ///< fits the font size and the layout to the view
    [[nodiscard]] QString plain(int from, int to) const;

    FormulaObject* m_object;
};

/// The formulas of the current step of the cycle, with their numbers: the balance of the last
/// ground radius, in each zone or section under the wheel at that moment.
class StepSheet : public QWidget {
    Q_OBJECT
public:
    explicit StepSheet(CycleCursor& cycle, QWidget* parent = nullptr);
    void retranslate();
    [[nodiscard]] QSize sizeHint() const override { return {327, 380}; }

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void follow(); ///< only while it is visible
    void fillZones();
    void showSheet();

    CycleCursor& m_cycle;
    QComboBox* m_zone;
    QLabel* m_place;
    FormulaView* m_sheet;
    std::optional<std::size_t> m_wanted; ///< zone or section the user chose
};

} // namespace sparkout
