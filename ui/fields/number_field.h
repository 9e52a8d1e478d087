// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "ui/fields/cells_line_edit.h"
#include "ui/fields/mark.h"
#include "ui/text/shown_scale.h"

#include <QTimer>

#include <functional>
#include <optional>

namespace sparkout {

/// What a number field takes.
struct NumberSpec {
    Range hard = {};
    Range soft = {};
    const char* unit = "";
    bool integer = false;
    bool optional = false; ///< may be left empty
    const char* nullMeaning = "";
    ShownScale scale = {}; ///< from the value to what is shown and typed

    [[nodiscard]] static NumberSpec of(const Field& field);
    /// With the range that holds for the member in a project.
    [[nodiscard]] static NumberSpec of(const Field& field, const Project& project,
                                       const void* owner);
    friend bool operator==(const NumberSpec&, const NumberSpec&) = default;
};

/// A field for one number. It reads comma and point in every locale, exponents and a typographic
/// minus, and never changes what was typed: a text it cannot read or a value out of range stays
/// there, marked with its reason, while value() keeps the last good one. While one types nothing is
/// marked, and a value the other inputs do not go with waits: it may be the beginning of another.
/// Arithmetic waits as well, its result shown below the field, and Enter puts the result in its
/// place.
class NumberField : public CellsLineEdit {
    Q_OBJECT

public:
    explicit NumberField(const NumberSpec& spec, QWidget* parent = nullptr);

    [[nodiscard]] std::optional<double> value() const { return m_value; }
    void setValue(std::optional<double> value); ///< keeps a refused text as long as value stays
    void reset(std::optional<double> value);    ///< drops a refused text, too
    void revert();                              ///< back to the value before this edit
    void clearText();                           ///< as if deleted by hand
    void settle();                              ///< ends the edit, as leaving the field does
    /// Reads a text in another form than a number, in the unit of the value; taken like the result
    /// of arithmetic.
    void setReads(std::function<std::optional<double>(const QString&)> reads) {
        m_reads = std::move(reads);
    }
    /// Gives the value so many steps up or down, by which the arrow keys go; nothing where the last
    /// digit is stepped.
    void setSteps(std::function<std::optional<double>(double value, int steps)> steps) {
        m_steps = std::move(steps);
    }
    /// Says whether a value goes with the other inputs.
    void setFits(std::function<bool(std::optional<double>)> fits) { m_fits = std::move(fits); }

    [[nodiscard]] bool refused() const { return m_own.mark == Mark::error; }
    [[nodiscard]] const QString& refusal() const { return m_own.reason; }
    [[nodiscard]] bool typing() const { return m_typing.isActive(); } ///< until a pause
    [[nodiscard]] Remark remark() const;    ///< as shown: none while typing
    void setSpec(const NumberSpec& spec);   ///< judges the text anew
    void setHint(const QString& hint);      ///< what the field is for, to screen readers
    void setIssue(const Remark& issue);     ///< what the rules between fields say of the value
    void setShownText(const QString& text); ///< as if typed: a text kept from before

    void retranslate();

signals:
    void valueEdited(); ///< another good value, or the one before a text that is refused or dropped
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
    [[nodiscard]] std::optional<double> read() const;     ///< what the text means
    [[nodiscard]] std::optional<double> readForm() const; ///< by setReads()
    /// Of arithmetic or another form, "= 0.125 mm"; else empty.
    [[nodiscard]] QString result() const;
    void showResult();
    [[nodiscard]] QString stepped(int steps) const; ///< the text after so many steps
    void step(int steps);
    void showValue();
    [[nodiscard]] QString written(double value) const;
    void endTyping();
    [[nodiscard]] bool unsettled() const; ///< the text is not the value before the edit
    void describe();
    void updateRemark();

    NumberSpec m_spec;
    std::optional<double> m_value;
    std::optional<double> m_settled; ///< before the running edit: what a refused text falls back to
    std::function<bool(std::optional<double>)> m_fits;
    std::function<std::optional<double>(const QString&)> m_reads;
    std::function<std::optional<double>(double, int)> m_steps;
    bool m_waits = false; ///< the text is good, but not taken before a pause
    Remark m_own;         ///< of the text
    Remark m_issue;       ///< of the value, from validation
    Remark m_shown;
    QString m_hint;
    QTimer m_typing;
    QAction* m_icon;
};

} // namespace sparkout
