// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/state_seal.h"

#include "core/file/project_file.h"

#include <nlohmann/json.hpp>

#include <boost/crc.hpp>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <streambuf>
#include <utility>

namespace sparkout {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* checksumKey = "checksum";

/// Computes the checksum of the text written to it without keeping the text, since a state may be
/// large.
class Checksum : public std::streambuf {
public:
    [[nodiscard]] std::string text() const;

protected:
    std::streamsize xsputn(const char* text, std::streamsize size) override {
        m_crc.process_bytes(text, static_cast<std::size_t>(size));
        return size;
    }
    int_type overflow(int_type c) override {
        m_crc.process_byte(static_cast<unsigned char>(c));
        return c;
    }

private:
    static constexpr std::uint64_t all = ~std::uint64_t{0};
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693, all, all, true, true> m_crc;
};

std::string hexOf(std::uint64_t number) {
    constexpr int digits = 16;
    std::string text(digits, '0');
    for (int i = digits; i-- > 0; number >>= 4) {
        text[static_cast<std::size_t>(i)] = "0123456789abcdef"[number & 15];
    }
    return text;
}

std::string Checksum::text() const {
    return hexOf(m_crc.checksum());
}

/// The checksum of the state's text, dump().
std::string checksumOf(const Json& state) {
    Checksum checksum;
    std::ostream(&checksum) << state;
    return checksum.text();
}

} // namespace

std::string checksumOf(std::string_view text) {
    Checksum checksum;
    checksum.sputn(text.data(), static_cast<std::streamsize>(text.size()));
    return checksum.text();
}

std::size_t nestingOf(std::string_view text) {
    std::size_t open = 0, most = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            i += c == '\\' ? 1 : 0;
            quoted = c != '"';
        } else if (c == '"') {
            quoted = true;
        } else if (c == '[' || c == '{') {
            most = std::max(most, ++open);
        } else if ((c == ']' || c == '}') && open > 0) {
            --open;
        }
    }
    return most;
}

std::optional<Json> parseState(std::string_view text) {
    if (nestingOf(text) > limits::depth) {
        return std::nullopt;
    }
    Json state = Json::parse(text, nullptr, false);
    return state.is_object() ? std::optional(std::move(state)) : std::nullopt;
}

std::string sealed(Json state) {
    state.erase(checksumKey);
    std::string checksum = checksumOf(state);
    state[checksumKey] = std::move(checksum);
    return state.dump() + '\n';
}

bool unseal(Json& state) {
    const auto given = state.find(checksumKey);
    if (given == state.end()) {
        return false;
    }
    const Json checksum = std::move(*given);
    state.erase(checksumKey);
    return checksum == checksumOf(state);
}

} // namespace sparkout
