// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/strict_json.h"

#include "core/printable.h"

#include "core/file/project_file.h"
#include "core/project/validate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace sparkout {

namespace {

using nlohmann::json;

/// Builds the value and refuses values beyond the limits before building them.
class Builder : public nlohmann::json_sax<json> {
public:
    Builder(Issues& issues, const std::stop_token& stop) : m_issues(issues), m_stop(stop) {}

    json root;
    bool syntaxError = false;
    std::size_t errorPosition = 0;

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool binary(binary_t&) override { return false; }
    bool string(string_t& value) override { return checkLength(value) && add(std::move(value)); }

    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& value) override {
        if (!checkLength(value)) {
            return false;
        }
        const bool duplicate = m_open.back().value->contains(value);
        m_open.back().key = std::move(value);
        if (duplicate) {
            m_issues.push_back({IssueCode::duplicateKey, Severity::error, path(), {}, {}});
        }
        return m_issues.size() < limits::issues;
    }

    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::detail::exception& exception) override {
        constexpr int numberOverflow = 406;
        if (exception.id == numberOverflow) {
            m_issues.push_back({IssueCode::outOfRange, Severity::error, path(),
                                Numeral{token.substr(0, 60)}, Numeral{"-1.8e308…1.8e308"}});
            return false;
        }
        syntaxError = true;
        errorPosition = position;
        return false;
    }

private:
    struct Open {
        json* value;
        std::string key;
    };

    /// The path of the value being read: the members of the outer values are placed already, that
    /// of the innermost one is not.
    std::string path() const {
        std::string text;
        for (const Open& open : m_open) {
            const std::size_t placed = &open == &m_open.back() ? 0 : 1;
            text += '/';
            text += open.value->is_array() ? std::to_string(open.value->size() - placed)
                                           : pathStep(open.key);
        }
        return text;
    }

    bool checkLength(const std::string& value) {
        if (value.size() <= limits::stringBytes) {
            return true;
        }
        m_issues.push_back({IssueCode::stringTooLong, Severity::error, path(),
                            countOf(value.size(), "bytes"), countOf(limits::stringBytes, "bytes")});
        return false;
    }

    json* place(json value) {
        if (m_open.empty()) {
            root = std::move(value);
            return &root;
        }
        json& parent = *m_open.back().value;
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        json& member = parent[m_open.back().key];
        member = std::move(value);
        return &member;
    }

    bool add(json value) {
        if (!count()) {
            return false;
        }
        place(std::move(value));
        return true;
    }

    bool count() {
        if (++m_values <= limits::values) {
            return !m_stop.stop_requested();
        }
        m_issues.push_back(
            {IssueCode::tooManyValues, Severity::error, {}, {}, countOf(limits::values)});
        return false;
    }

    bool open(json value) {
        if (m_open.size() >= limits::depth) {
            m_issues.push_back(
                {IssueCode::tooDeep, Severity::error, {}, {}, countOf(limits::depth)});
            return false;
        }
        if (!count()) {
            return false;
        }
        m_open.push_back({place(std::move(value)), {}});
        return true;
    }

    bool close() {
        m_open.pop_back();
        return true;
    }

    Issues& m_issues;
    const std::stop_token& m_stop;
    std::vector<Open> m_open;
    std::size_t m_values = 0;
};

/// The place at which the text ceases to be JSON, in lines and columns from 1.
Issue notJson(std::string_view text, std::size_t position) {
    std::size_t line = 1;
    std::size_t column = 1;
    for (std::size_t i = 0; i + 1 < position && i < text.size(); ++i) {
        const bool inCharacter = (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
        column = text[i] == '\n' ? 1 : column + (inCharacter ? 0 : 1);
        line += text[i] == '\n' ? 1 : 0;
    }
    return {IssueCode::notJson, Severity::error, {}, countOf(line), countOf(column)};
}

/// Shortest digits; numbers that JSON cannot represent are null, and −0 is 0 as in the reader.
std::string printNumber(double value) {
    return std::isfinite(value) ? numberText(value + 0.0) : "null";
}

std::string printFlat(const nlohmann::ordered_json& value) {
    std::string out;
    if (value.is_object() || value.is_array()) {
        const char* separator = value.is_object() ? "{ " : "[";
        for (const auto& [key, item] : value.items()) {
            out += separator;
            if (value.is_object()) {
                out += nlohmann::ordered_json(key).dump() + ": ";
            }
            out += printFlat(item);
            separator = ", ";
        }
        if (value.empty()) {
            return value.is_object() ? "{}" : "[]";
        }
        return out + (value.is_object() ? " }" : "]");
    }
    return value.is_number_float() ? printNumber(value.get<double>()) : value.dump();
}

void print(const nlohmann::ordered_json& value, std::size_t indent, std::string& out) {
    constexpr std::size_t lineLength = 100;
    const bool structured = value.is_object() || value.is_array();
    // Numbers always share a line; other values only inside the file and if they fit.
    const bool numbers = value.is_array() && !value.empty() && value.front().is_number();
    const bool whole = indent == 0 && structured && !numbers && !value.empty();
    std::string flat = whole ? std::string() : printFlat(value);
    if (!structured || numbers || value.empty() || (!whole && indent + flat.size() <= lineLength)) {
        out += flat;
        return;
    }
    const std::string padding(indent + 2, ' ');
    const char* separator = value.is_object() ? "{\n" : "[\n";
    for (const auto& [key, item] : value.items()) {
        out += separator + padding;
        if (value.is_object()) {
            out += nlohmann::ordered_json(key).dump() + ": ";
        }
        print(item, indent + 2, out);
        separator = ",\n";
    }
    out += '\n' + std::string(indent, ' ') + (value.is_object() ? '}' : ']');
}

std::string shortened(std::string text) {
    constexpr std::size_t longest = 60;
    if (text.size() > longest) {
        std::size_t end = longest;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) {
            --end; // inside a character
        }
        text = text.substr(0, end) + "…";
    }
    return text;
}

} // namespace

std::optional<json> parseStrictly(std::string_view text, Issues& issues,
                                  const std::stop_token& stop) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        issues.push_back({IssueCode::empty, Severity::error, {}, {}, {}});
        return std::nullopt;
    }
    if (text.size() > limits::fileBytes) {
        issues.push_back({IssueCode::tooLarge,
                          Severity::error,
                          {},
                          countOf(text.size(), "bytes"),
                          countOf(limits::fileBytes, "bytes")});
        return std::nullopt;
    }
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
        // the parser would take it for the end of the text
        issues.push_back(notJson(text, nul + 1));
        return std::nullopt;
    }
    Builder builder(issues, stop);
    const bool parsed = json::sax_parse(text.begin(), text.end(), &builder);
    if (builder.syntaxError) {
        issues.push_back(notJson(text, builder.errorPosition));
    }
    if (!parsed) {
        return std::nullopt;
    }
    return std::move(builder.root);
}

std::string printJson(const nlohmann::ordered_json& value) {
    std::string out;
    print(value, 0, out);
    out += '\n';
    return out;
}

Detail quoted(const json& value) {
    if (value.is_number_float()) {
        return Amount{value.get<double>()};
    }
    if (value.is_number()) {
        return Numeral{value.dump()};
    }
    if (value.is_structured()) {
        return Quoted{value.is_object() ? (value.empty() ? "{}" : "{…}")
                                        : (value.empty() ? "[]" : "[…]")};
    }
    return Quoted{printable(shortened(value.dump(-1, ' ', false, json::error_handler_t::replace)))};
}

std::string pathStep(const std::string& key) {
    std::string step;
    for (const char character : shortened(key)) {
        character == '~' ? step += "~0" : character == '/' ? step += "~1" : step += character;
    }
    return printable(step);
}

} // namespace sparkout
