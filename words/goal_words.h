// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal_check.h"
#include "words/issue_words.h"

#include <string>
#include <vector>

/// Goals of lessons and the results of their checks as texts. The English ones are defined here,
/// marked for translation in the contexts "Goal" and "Finding": the command line prints them, the
/// window translates them.
namespace sparkout {

/// A finding by its name in JSON.
[[nodiscard]] const char* findingKey(Finding finding);

/// "passed", "the cycle does not end by itself"; context "Finding".
[[nodiscard]] const char* findingText(Finding finding);

/// Formulates goals and their results; this class in English, with the names used in files.
class GoalWording {
public:
    GoalWording() = default;
    virtual ~GoalWording() = default;
    GoalWording(const GoalWording&) = delete;
    GoalWording& operator=(const GoalWording&) = delete;

    /// "Actual feed, rz1, stage 1, double stroke 20, E3".
    [[nodiscard]] std::string quantity(const Figure& figure, const Project& project) const;
    /// "3.21 µm".
    [[nodiscard]] std::string value(const Figure& figure, double value) const;
    /// "nz > rz2 > rz1".
    [[nodiscard]] std::string order(const Project& project,
                                    const std::vector<std::size_t>& places) const;
    /// The question of a goal, in sentences that do not reveal the answer.
    [[nodiscard]] std::string asked(const Goal& goal, const Project& project) const;
    /// The result of a goal: "passed: cycle time 2.310 min, limit 2.500 min". `showsAnswer`: a
    /// question that was not answered has the engine's answer, too, as for the teacher.
    [[nodiscard]] std::string found(const Goal& goal, const GoalResult& result,
                                    const Project& project, bool showsAnswer) const;

protected:
    [[nodiscard]] virtual std::string translated(const char* context, const char* text) const;
    /// As it was given.
    [[nodiscard]] virtual std::string number(double value) const;
    [[nodiscard]] virtual std::string fixed(double value, int decimals) const;
    /// A number with its unit, which may be empty.
    [[nodiscard]] virtual std::string withUnit(const std::string& number, const char* unit) const;
    /// A name in lower case.
    [[nodiscard]] virtual std::string inSentence(const std::string& name) const;
    [[nodiscard]] virtual std::string zoneOrSection(const Project& project,
                                                    std::size_t index) const;
    [[nodiscard]] virtual std::string step(Step step) const;
    [[nodiscard]] virtual std::string input(const std::string& path) const;
    /// The first fault of a set-up that was refused.
    [[nodiscard]] virtual std::string fault(const Issue& issue) const;

private:
    [[nodiscard]] std::string filled(const char* text, TextPlaces places) const;
    [[nodiscard]] std::string tolerance(const Figure& figure, double tolerance) const;
    [[nodiscard]] std::vector<std::string> numbers(const Goal& goal, const GoalResult& result,
                                                   const Project& project) const;
    [[nodiscard]] std::string compared(const Goal& goal, const GoalResult& result,
                                       const Project& project) const;
};

} // namespace sparkout
