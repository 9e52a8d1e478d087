// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "ui/form/mark.h"
#include "ui/table/pasted_cells.h"
#include "ui/text/shown_scale.h"

#include <QLineEdit>
#include <QTimer>

#include <functional>
#include <optional>
#include <utility>

namespace sparkout {

/// A text field that passes on several cells of a spreadsheet when they are pasted.
class CellsLineEdit : public QLineEdit {
    Q_OBJECT

public:
    using QLineEdit::QLineEdit;

    /// Sets the receiver of cells; without one they are pasted as text.
    void setTakesCells(std::function<void(const PastedCells&)> take) { m_take = std::move(take); }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    bool takeCells();

    std::function<void(const PastedCells&)> m_take;
};

/// The allowed numbers of a field.
struct NumberSpec {
    Range hard = {};
    Range soft = {};
    const char* unit = "";
    bool integer = false;
    bool optional = false; ///< may be empty
    const char* nullMeaning = "";
    ShownScale scale = {}; ///< from the value to the displayed number

    [[nodiscard]] static NumberSpec of(const Field& field);
    /// With the allowed range of the member in a project.
    [[nodiscard]] static NumberSpec of(const Field& field, const Project& project,
                                       const void* owner);
    friend bool operator==(const NumberSpec&, const NumberSpec&) = default;
};

/// A field for one number. It accepts comma and point in every locale, exponents and a typographic
/// minus, and never changes typed text: an unreadable text or a value out of range stays, marked
/// with its reason, while value() keeps the last valid one. During typing nothing is marked, and a
/// value that conflicts with other inputs waits, since it may be incomplete. Arithmetic waits as
/// well, with its result shown below the field, until Enter replaces it by the result.
class NumberField : public CellsLineEdit {
    Q_OBJECT

public:
    explicit NumberField(const NumberSpec& spec, QWidget* parent = nullptr);

    [[nodiscard]] std::optional<double> value() const { return m_value; }
    void setValue(std::optional<double> value); ///< keeps a refused text if value is unchanged
    void reset(std::optional<double> value);    ///< also drops a refused text
    void revert();                              ///< back to the value before this edit
    void clearText();                           ///< as if deleted by hand
    void settle();                              ///< ends the edit, like leaving the field
    /// Sets a reader for other notations of a number, in the unit of the value; its results are
    /// treated like those of arithmetic.
    void setReads(std::function<std::optional<double>(const QString&)> reads) {
        m_reads = std::move(reads);
    }
    /// Sets the steps of the arrow keys; without it, or if it returns nothing, the last digit is
    /// stepped.
    void setSteps(std::function<std::optional<double>(double value, int steps)> steps) {
        m_steps = std::move(steps);
    }
    /// Sets a check of a value against the other inputs.
    void setFits(std::function<bool(std::optional<double>)> fits) { m_fits = std::move(fits); }

    [[nodiscard]] bool refused() const { return m_own.mark == Mark::error; }
    [[nodiscard]] const QString& refusal() const { return m_own.reason; }
    [[nodiscard]] bool typing() const { return m_typing.isActive(); } ///< until a pause
    [[nodiscard]] Remark remark() const;    ///< as displayed: none while typing
    void setSpec(const NumberSpec& spec);   ///< judges the text anew
    void setHint(const QString& hint);      ///< purpose of the field, for screen readers
    void setIssue(const Remark& issue);     ///< result of the rules between fields
    void setShownText(const QString& text); ///< as if typed: a text kept from before

    void retranslate();

signals:
    void valueEdited(); ///< a new valid value, or a dropped text
    void remarkChanged();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void evaluate();
    [[nodiscard]] Remark judge(std::optional<double>& value) const;
    [[nodiscard]] Remark judgeNumber(double value) const;
    [[nodiscard]] std::optional<double> read() const;     ///< the value of the text
    [[nodiscard]] std::optional<double> readForm() const; ///< by setReads()
    /// For arithmetic or another notation, "= 0.125 mm"; otherwise empty.
    [[nodiscard]] QString result() const;
    void showResult();
    [[nodiscard]] QString stepped(int steps) const; ///< the text after this number of steps
    void step(int steps);
    void showValue();
    [[nodiscard]] QString written(double value) const;
    void endTyping();
    [[nodiscard]] bool unsettled() const; ///< the text is not the value before the edit
    void describe();
    void updateRemark();

    NumberSpec m_spec;
    std::optional<double> m_value;
    std::optional<double> m_settled; ///< before the running edit: restored if a text is refused
    std::function<bool(std::optional<double>)> m_fits;
    std::function<std::optional<double>(const QString&)> m_reads;
    std::function<std::optional<double>(double, int)> m_steps;
    bool m_waits = false; ///< the text is valid, but waits for a pause
    Remark m_own;         ///< remark on the text
    Remark m_issue;       ///< remark on the value, from validation
    Remark m_shown;
    QString m_hint;
    QTimer m_typing;
    QAction* m_icon;
};

} // namespace sparkout
