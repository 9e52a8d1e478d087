// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/editors/line_editor.h"

#include <optional>
#include <vector>

namespace sparkout {

/// A list of numbers in one line of text, "1; 2; 3"; where the member takes levels also from, to
/// and step, "300…2400 step 100". Empty is not given, where that may be.
class NumbersEditor : public LineEditor {
    Q_OBJECT

public:
    using LineEditor::LineEditor;
    [[nodiscard]] bool wide() const override { return !*field().unit; }
    [[nodiscard]] bool empty() const override { return stored() == Levels(); }

protected:
    [[nodiscard]] QString storedText() const override;
    [[nodiscard]] bool isStored(const QString& text) const override;
    [[nodiscard]] QString accept(const QString& text) override;
    [[nodiscard]] CellsText textOf(const PastedCells& cells) const override;

private:
    [[nodiscard]] Levels stored() const;
    void put(const Levels& levels, void* to) const;
    /// What a text means; nothing when it cannot be read.
    [[nodiscard]] std::optional<Levels> read(const QString& text) const;
    /// Why what a text means is not taken; empty when it is.
    [[nodiscard]] QString fault(const Levels& levels) const;
    [[nodiscard]] QString grammar() const;
};

} // namespace sparkout
