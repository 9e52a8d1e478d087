// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words/goal_words.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout {

/// Goals of lessons in the current language, with the window's number format and names.
class GoalText : public GoalWording {
    Q_DECLARE_TR_FUNCTIONS(GoalText)
public:
    [[nodiscard]] static QString quantity(const Figure& figure, const Project& project);
    /// A quantity with its unit after a comma, if it has one.
    [[nodiscard]] static QString quantityAndUnit(const Figure& figure, const Project& project);
    [[nodiscard]] static QString unit(const Figure& figure); ///< may be empty
    /// A value without and with its unit.
    [[nodiscard]] static QString number(const Figure& figure, double value);
    [[nodiscard]] static QString value(const Figure& figure, double value);
    [[nodiscard]] static QString place(const Project& project, std::size_t index);
    [[nodiscard]] static QString order(const Project& project,
                                       const std::vector<std::size_t>& places);
    /// The abscissa of a curve: "Double stroke", "Stage", "Zone".
    [[nodiscard]] static QString along(const CurvePrediction& goal, const Project& project);
    /// A place on that axis: "20", "НЗ".
    [[nodiscard]] static QString alongAt(const CurvePrediction& goal, double at,
                                         const Project& project);
    [[nodiscard]] static QString finding(Finding finding);
    [[nodiscard]] static QString asked(const Goal& goal, const Project& project);
    /// A sentence.
    [[nodiscard]] static QString found(const Goal& goal, const GoalResult& result,
                                       const Project& project, bool showsAnswer);

protected:
    [[nodiscard]] std::string translated(const char* context, const char* text) const override;
    [[nodiscard]] std::string number(double value) const override;
    [[nodiscard]] std::string fixed(double value, int decimals) const override;
    [[nodiscard]] std::string withUnit(const std::string& number, const char* unit) const override;
    [[nodiscard]] std::string inSentence(const std::string& name) const override;
    [[nodiscard]] std::string zoneOrSection(const Project& project,
                                            std::size_t index) const override;
    [[nodiscard]] std::string step(Step step) const override;
    [[nodiscard]] std::string input(const std::string& path) const override;
    [[nodiscard]] std::string fault(const Issue& issue) const override;
};

} // namespace sparkout
