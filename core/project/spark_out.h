// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <cstddef>
#include <optional>
#include <span>

namespace sparkout {

/// The last stage's spark-out: none, a number of strokes or revolutions, or until size. As an input
/// it is a CountOrWord.
struct SparkOut {
    enum class Mode { none, count, untilSize };
    Mode mode = Mode::none;
    int count = 0; ///< double strokes (traverse) or revolutions (plunge), with Mode::count
    friend bool operator==(const SparkOut&, const SparkOut&) = default;

    [[nodiscard]] static std::span<const Choice> words();
    [[nodiscard]] static Phrase expected();
    [[nodiscard]] static SparkOut ofNumber(int number) { return {Mode::count, number}; }
    [[nodiscard]] static SparkOut ofWord(std::size_t) { return {Mode::untilSize, 0}; }
    [[nodiscard]] int* number() { return mode == Mode::count ? &count : nullptr; }
    [[nodiscard]] std::optional<std::size_t> word() const {
        return mode == Mode::untilSize ? std::optional<std::size_t>(0) : std::nullopt;
    }
};

} // namespace sparkout
