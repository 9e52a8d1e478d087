// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/measured.h"
#include "core/project/validate.h"
#include "tests/core/support/project_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace sparkout::samples {

using nlohmann::json;

/// Changes rows of a project at random, within their hard ranges. `pick(n)` gives 0 … n − 1.
template <class Pick>
class Mutator {
public:
    explicit Mutator(Pick pick) : m_pick(pick) {}

    /// Changes about so many rows; a change the rules refuse is taken back.
    void mutate(Project& project, int changes) {
        for (int i = 0; i < changes; ++i) {
            const auto all = spots(project);
            mutateOne(project, all[static_cast<std::size_t>(m_pick(static_cast<int>(all.size())))]);
        }
    }

    /// Whether the row could be changed. `spot` is stale afterwards if it could not.
    bool mutateOne(Project& project, const Spot& spot) {
        Project before = project;
        if (before.measured) {
            (void)*before.measured; // its own: the spot's owner stands in the project's
        }
        change(*spot.field, spot.owner);
        if (hasErrors(validate(project))) {
            project = before;
            return false;
        }
        return true;
    }

private:
    double number(const Range& range) {
        const double width = range.high - range.low;
        double value = range.low + width * m_pick(1'000'001) / 1e6;
        switch (m_pick(7)) {
        case 0: value = range.high; break;
        case 1: value = range.lowOpen ? std::nextafter(range.low, range.high) : range.low; break;
        case 2: value = range.low + width * std::pow(10.0, -m_pick(13)) * m_pick(997) / 997; break;
        case 3: value = std::round(value); break;
        case 4: value = std::nextafter(value, range.high); break;
        default: break;
        }
        value = std::min(value, range.high);
        return range.contains(value) ? value : range.high;
    }

    int whole(const Range& range) {
        const auto width = static_cast<long long>(range.high - range.low) + 1;
        const int most = static_cast<int>(std::min<long long>(width, m_pick(2) ? 12 : 1'000'000));
        return static_cast<int>(static_cast<long long>(range.low) + m_pick(most));
    }

    std::vector<double> numbers(const Field& field) {
        std::vector<double> list(field.count ? field.count
                                             : static_cast<std::size_t>(m_pick(3) ? m_pick(6) : 4));
        for (double& value : list) {
            value = number(field.hard);
        }
        return list;
    }

    std::string text() {
        static const std::vector<std::string> pieces{
            "a",  "Ж", "磨",   "🛠",   " ", "\n",     "\"",     "\\", "/", std::string(1, '\0'),
            "\t", "é", "\x7f", "\u202e", "0", "\u2028", "{limit}"};
        std::string out;
        for (int i = m_pick(9); i > 0; --i) {
            out += pieces[static_cast<std::size_t>(m_pick(static_cast<int>(pieces.size())))];
        }
        return out;
    }

    std::string object(const Field& field) {
        if (std::string(field.key) == "inputs") {
            return samples::text(samples::names()[static_cast<std::size_t>(m_pick(6))]);
        }
        return json{{text(), number({-1e9, 1e9})},
                    {"list", {number({0, 1}), text(), nullptr, true, -0.0, 36.0}},
                    {"z", {{"y", m_pick(2) == 1}}}}
            .dump();
    }

    void changeList(const Field& field, void* owner) {
        const std::size_t size = field.size(owner);
        field.resize(owner, static_cast<std::size_t>(m_pick(4)));
        for (std::size_t i = size; i < field.size(owner); ++i) {
            for (const Field& member : field.nested->fields) {
                if (member.kind != Kind::countOrWord) {
                    change(member, field.at(owner, i));
                }
            }
        }
    }

    void changeLevels(const Field& field, void* owner) {
        auto& levels = field.as<Levels>(owner);
        switch (m_pick(3)) {
        case 0: levels = std::monostate{}; break;
        case 1: levels = numbers(field); break;
        default: levels = SteppedLevels{number(field.hard), number(field.hard), number(field.hard)};
        }
    }

    void changeCompliance(const Field& field, void* owner) {
        auto& given = field.as<GivenCompliance>(owner);
        if (auto* zones = std::get_if<ZoneCompliance>(&given)) {
            *zones = {number(field.hard), number(field.hard), number(field.hard)};
        } else if (auto* list = std::get_if<std::vector<double>>(&given)) {
            for (double& value : *list) {
                value = number(field.hard);
            }
        } else {
            given = ZoneCompliance{number(field.hard), number(field.hard), number(field.hard)};
        }
    }

    void change(const Field& field, void* owner) {
        const bool clear = m_pick(5) == 0;
        switch (field.kind) {
        case Kind::number: field.as<double>(owner) = number(field.hard); break;
        case Kind::optionalNumber:
            field.as<std::optional<double>>(owner) =
                clear ? std::nullopt : std::optional(number(field.hard));
            break;
        case Kind::integer: field.as<int>(owner) = whole(field.hard); break;
        case Kind::optionalInteger:
            field.as<std::optional<int>>(owner) =
                clear ? std::nullopt : std::optional(whole(field.hard));
            break;
        case Kind::boolean: field.as<bool>(owner) = m_pick(2) == 1; break;
        case Kind::text: field.as<std::string>(owner) = text(); break;
        case Kind::choice:
            field.setChoice(owner, m_pick(static_cast<int>(field.choices.size())));
            break;
        case Kind::numberList: {
            auto& list = field.as<std::vector<double>>(owner) = numbers(field);
            for (double& value : list) {
                value = std::round(value); // the only such list counts stages
            }
            break;
        }
        case Kind::optionalNumberList:
            field.as<std::optional<std::vector<double>>>(owner) =
                clear ? std::nullopt : std::optional(numbers(field));
            break;
        case Kind::object: break; // its members are spots of their own
        case Kind::optionalObject:
            if (clear) {
                field.reset(owner);
            } else {
                void* object = field.object(owner, true);
                for (const Field& member : field.nested->fields) {
                    change(member, object);
                }
            }
            break;
        case Kind::objectList: changeList(field, owner); break;
        case Kind::countOrWord:
            m_pick(3) == 0 ? field.setChoice(owner, 0) : field.setNumber(owner, whole(field.hard));
            break;
        case Kind::compliance: changeCompliance(field, owner); break;
        case Kind::levels: changeLevels(field, owner); break;
        case Kind::numberRows:
            field.as<NumberRows>(owner).emplace(static_cast<std::size_t>(m_pick(4)));
            for (auto& row : *field.as<NumberRows>(owner)) {
                row = numbers(field);
            }
            break;
        case Kind::samples: field.as<Samples>(owner) = Samples(numbers(field)); break;
        case Kind::jsonText: field.as<JsonText>(owner).text = object(field); break;
        }
    }

    Pick m_pick;
};

/// Numbers for a Mutator, the same for the same seed.
inline auto fromSeed(std::uint64_t seed) {
    return [state = seed](int n) mutable {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<int>((state >> 33) % static_cast<std::uint64_t>(n));
    };
}

} // namespace sparkout::samples
