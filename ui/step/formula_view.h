// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/formula.h"

#include <QTextEdit>

namespace sparkout {

class FormulaObject;

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

} // namespace sparkout
