// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/form/line_editor.h"

#include <optional>

namespace sparkout {

/// Rows of a few numbers in one line of text: "0 50; 200 80". Empty means not given.
class RowsEditor : public LineEditor {
    Q_OBJECT

public:
    using LineEditor::LineEditor;
    [[nodiscard]] bool empty() const override { return !stored(); }

protected:
    [[nodiscard]] QString storedText() const override;
    [[nodiscard]] bool isStored(const QString& text) const override;
    [[nodiscard]] QString accept(const QString& text) override;
    [[nodiscard]] CellsText textOf(const PastedCells& cells) const override;

private:
    /// The rows of a text; empty if a row does not have the right count.
    [[nodiscard]] std::optional<NumberRows> rowsOf(const QString& text) const;
    [[nodiscard]] const NumberRows& stored() const;
};

} // namespace sparkout
