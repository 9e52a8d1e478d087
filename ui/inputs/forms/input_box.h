// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/fields/refusal.h"
#include "ui/inputs/forms/section_box.h"

#include <vector>

namespace sparkout {

/// A box of a page with its own fields, for inputs that are not single rows of a table.
class InputBox : public SectionBox {
    Q_OBJECT

public:
    using SectionBox::SectionBox;

    virtual void showProject(bool replaced) = 0; ///< replaced: drop refused texts
    virtual void setOutcome(const OutcomePtr& outcome) = 0;
    virtual void forgetResults() {} ///< removes results shown beside the inputs
    virtual void retranslate() = 0;
    [[nodiscard]] virtual std::vector<Refusal> refusals() const = 0;
    /// Restores the document's value in a refused field; false if it is not here.
    virtual bool dropRefusal(const std::string& path) = 0;
    [[nodiscard]] virtual bool holds(const std::string& path) const = 0;
    virtual void focusPath(const std::string& path) = 0;

signals:
    void refusalsChanged();
};

} // namespace sparkout
