// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words/judgement_words.h"

#include <QString>
#include <QStringList>

namespace sparkout {

/// Judgements in the current language, with the window's number format and names.
class JudgementText : public JudgementWording {
public:
    [[nodiscard]] static QString headline(const Judgement& judgement);
    [[nodiscard]] static QString exceptions(const std::vector<Undecided>& undecided);
    [[nodiscard]] static QString stocks(const Judgement& judgement, bool areComing = false);
    [[nodiscard]] static QString batch(const Judgement& judgement, bool isComing = false);
    /// A line for the stocks, one for the batch if there is one, and one for each undecided
    /// requirement: printed below the headline.
    [[nodiscard]] static QStringList lines(const Judgement& judgement);
    [[nodiscard]] static QStringList lines(const std::vector<Undecided>& notDecided);

protected:
    [[nodiscard]] std::string translated(const char* text) const override;
    [[nodiscard]] std::string number(double value, int decimals) const override;
    [[nodiscard]] std::string requirement(ConstraintKind kind) const override;
    [[nodiscard]] std::string where(const ConstraintResult& constraint) const override;
    [[nodiscard]] std::string ofRequirement(const char* text) const override;
    [[nodiscard]] std::string amount(const ConstraintResult& constraint) const override;
    [[nodiscard]] std::string value(const ConstraintResult& constraint) const override;
    [[nodiscard]] std::string unit(const char* unit) const override;
};

} // namespace sparkout
