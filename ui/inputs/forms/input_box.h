// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/inputs/editors/number_lines.h"
#include "ui/inputs/forms/section_box.h"

#include <string>
#include <vector>

namespace sparkout {

/// A box of a page for an input that is not a single row of a table: numbers below one another, and
/// the reason of a mark of them all.
class InputBox : public SectionBox {
    Q_OBJECT

public:
    InputBox(std::string path, const Field& field, int depth, Document& document, QWidget* parent);

    [[nodiscard]] const std::string& path() const { return m_path; }
    virtual void showProject(bool replaced) = 0; ///< replaced: drop refused texts
    virtual void setOutcome(const OutcomePtr& outcome) = 0;
    virtual void forgetResults() {} ///< removes results shown beside the inputs
    virtual void retranslate() = 0;
    [[nodiscard]] std::vector<Refusal> refusals() const { return m_numbers->refusals(); }
    /// Restores the document's value in a refused field; false if it is not here.
    bool dropRefusal(const std::string& path) { return m_numbers->dropRefusal(path); }
    [[nodiscard]] bool holds(const std::string& path) const;
    virtual void focusPath(const std::string& path) { m_numbers->focusPath(path); }

signals:
    void refusalsChanged();

protected:
    [[nodiscard]] const Field& field() const { return m_field; }
    [[nodiscard]] Document& document() const { return m_document; }
    [[nodiscard]] NumberLines& numbers() const { return *m_numbers; }
    [[nodiscard]] ReasonLabel& reason() const { return *m_reason; }

private:
    std::string m_path;
    const Field& m_field;
    Document& m_document;
    NumberLines* m_numbers;
    ReasonLabel* m_reason;
};

} // namespace sparkout
