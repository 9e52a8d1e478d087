// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/form/line_editor.h"

#include <optional>
#include <vector>

namespace sparkout {

/// A list of numbers in one line of text, "1; 2; 3"; for levels also from, to and step, "300…2400
/// step 100". Empty means not given, where allowed.
class NumbersEditor : public LineEditor {
    Q_OBJECT

public:
    NumbersEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent,
                  SpecOf spec = {});
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
    /// The value of a text; empty if it is invalid.
    [[nodiscard]] std::optional<Levels> read(const QString& text) const;
    /// The reason for refusing a value; empty if it is accepted.
    [[nodiscard]] QString fault(const Levels& levels) const;
    [[nodiscard]] QString grammar() const;
    [[nodiscard]] QString joined(const std::vector<double>& values) const;

    SpecOf m_spec;
};

} // namespace sparkout
