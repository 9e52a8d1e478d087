// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/formula.h"

#include <QTextEdit>

namespace sparkout {

class FormulaObject;

/// A sheet of formulas with their numbers, typeset as in the hand-out: a line breaks before an
/// equals sign. What is copied is the same in plain text, an equation a line.
class FormulaView : public QTextEdit {
    Q_OBJECT

public:
    explicit FormulaView(QWidget* parent = nullptr);

    void setSheet(const FormulaSheet& sheet);
    void clearSheet();
    [[nodiscard]] QString text() const; ///< as it is copied
    /// The same of any sheet.
    [[nodiscard]] static QString textOf(const FormulaSheet& sheet);

protected:
    [[nodiscard]] QMimeData* createMimeDataFromSelection() const override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fit(); ///< the size of the type and the room to the view
    [[nodiscard]] QString plain(int from, int to) const;

    FormulaObject* m_object;
};

} // namespace sparkout
