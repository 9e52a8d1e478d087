// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/remedies.h"
#include "words/issue_words.h"

#include <string>

/// Remedies as texts. The English ones are defined here, marked for translation in the context
/// "Remedy": the command line prints them, the window translates them.
namespace sparkout {

/// Formulates the remedies of a project; this class in English.
class RemedyWording {
public:
    RemedyWording() = default;
    virtual ~RemedyWording() = default;
    RemedyWording(const RemedyWording&) = delete;
    RemedyWording& operator=(const RemedyWording&) = delete;

    /// "S_t of stage 2 = 0.003 mm (0.0026…0.0034 mm)": the value to apply, and the interval in
    /// which every value helps; "Starting cycle".
    [[nodiscard]] std::string change(const Project& project, const Remedy& remedy) const;
    /// "+24 s"; "the cycle takes 33 s" if the unchanged cycle does not end by itself; for a
    /// starting cycle its time, "33 s".
    [[nodiscard]] std::string cost(const Remedy& remedy) const;
    /// "for every stock, 0 of 500 bad".
    [[nodiscard]] std::string goodFor(const Remedy& remedy) const;
    /// The complete line: "S_t of stage 2 = 0.003 mm (0.0026…0.0034 mm): +24 s; for every stock, 0
    /// of 500 bad".
    [[nodiscard]] std::string line(const Project& project, const Remedy& remedy) const;
    /// The runs for the remedy, and their results.
    [[nodiscard]] std::string proof(const Project& project, RemedyGoal goal,
                                    const Remedy& remedy) const;
    /// Why none of the tried values helps, with the violated requirements.
    [[nodiscard]] std::string conflict(const Project& project, RemedyGoal goal,
                                       const RemedyConflict& conflict) const;
    /// The stocks for which the remedies are good, and the confidence; empty without any.
    [[nodiscard]] std::string scope(const RemedyResult& result) const;
    /// The extent of an incomplete search: "Stopped after 5 of 14 settings." Otherwise empty.
    [[nodiscard]] std::string extent(const RemedyResult& result) const;

protected:
    [[nodiscard]] virtual std::string translated(const char* text) const { return text; }
    [[nodiscard]] virtual std::string number(double value) const;
    [[nodiscard]] virtual std::string unit(const char* unit) const { return unit; }
    /// Label and symbol of an input.
    [[nodiscard]] virtual std::string input(const char* label, const char* symbol) const;
    [[nodiscard]] virtual std::string requirement(ConstraintKind kind) const;

private:
    [[nodiscard]] std::string filled(const char* text, TextPlaces places) const;
    [[nodiscard]] std::string equal(const Project& project, const RemedySetting& setting,
                                    double value) const;
    [[nodiscard]] std::string withValue(const Project& project, const RemedySetting& setting,
                                        double value, const std::string& is) const;
    [[nodiscard]] std::string inUnit(const Project& project, const RemedySetting& setting,
                                     const std::string& values) const;
    [[nodiscard]] std::string intervalText(const Project& project, const Remedy& remedy) const;
    [[nodiscard]] std::string valueText(const Project& project, const RemedySetting& setting,
                                        double value) const;
    [[nodiscard]] std::string heldStocks(const Remedy& remedy) const;
    [[nodiscard]] std::string heldParts(const RemedyBatch& batch) const;
    [[nodiscard]] std::string time(double time_s) const;
};

} // namespace sparkout
