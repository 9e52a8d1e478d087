// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

/// Issues as texts. The English ones are defined here, marked for translation: the command line and
/// the Python module print them, the window translates them.

namespace sparkout {

/// Placeholder names of a sentence, and their values.
using TextPlaces = std::initializer_list<std::pair<const char*, std::string>>;

/// A sentence with its placeholders filled, "{change}: {cost}"; a placeholder may occur twice.
[[nodiscard]] std::string placedText(const std::string& sentence, TextPlaces places);

struct IssueWords {
    const char* key;      ///< name of the code for other programs
    const char* sentence; ///< with the placeholders {value} and {limit}; context "Issue"
};

[[nodiscard]] IssueWords wordsOf(IssueCode code);
[[nodiscard]] const char* wordsOf(Phrase phrase); ///< context "Limit"

/// Formulates issues; this class in English, with numbers and paths as in the file.
class Wording {
public:
    Wording() = default;
    virtual ~Wording() = default;
    Wording(const Wording&) = delete;
    Wording& operator=(const Wording&) = delete;

    /// The sentence of an issue with value and limit filled in.
    [[nodiscard]] std::string sentence(const Issue& issue) const;
    /// A value or limit; empty if there is none.
    [[nodiscard]] std::string detail(const Detail& detail) const;

protected:
    [[nodiscard]] virtual std::string translated(const char* context,
                                                 const std::string& text) const;
    [[nodiscard]] virtual std::string number(double value) const;
    [[nodiscard]] virtual std::string numeral(const std::string& digits) const;
    [[nodiscard]] virtual std::string input(const std::string& path) const;
    [[nodiscard]] virtual std::string formula(const std::string& letters) const;

private:
    [[nodiscard]] std::string wheels(const WheelNeed& need) const;
    [[nodiscard]] std::string text(std::monostate) const;
    [[nodiscard]] std::string text(const Amount& amount) const;
    [[nodiscard]] std::string text(const Count& count) const;
    [[nodiscard]] std::string text(const Bounds& bounds) const;
    [[nodiscard]] std::string text(const Keys& keys) const;
    [[nodiscard]] std::string text(Phrase phrase) const;
    [[nodiscard]] std::string text(const Numeral& value) const;
    [[nodiscard]] std::string text(const Quoted& value) const;
    [[nodiscard]] std::string withUnit(const std::string& number, std::string_view unit) const;
    [[nodiscard]] std::string inBrackets(std::string_view field, std::string_view letters) const;
};

/// The sentence in English.
[[nodiscard]] inline std::string issueSentence(const Issue& issue) {
    return Wording().sentence(issue);
}

} // namespace sparkout
