// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words/remedy_words.h"

namespace sparkout {

/// Remedies in the current language, with the window's number format and names.
class RemedyText : public RemedyWording {
protected:
    [[nodiscard]] std::string translated(const char* text) const override;
    [[nodiscard]] std::string number(double value) const override;
    [[nodiscard]] std::string unit(const char* unit) const override;
    [[nodiscard]] std::string input(const char* label, const char* symbol) const override;
    [[nodiscard]] std::string requirement(ConstraintKind kind) const override;
};

} // namespace sparkout
