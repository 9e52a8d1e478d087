// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/wave_causes.h"

#include "core/file/output_json.h"
#include "core/file/strict_json.h"
#include "core/project/machine.h"
#include "core/text.h"
#include "core/units.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace sparkout {

namespace {

constexpr int mostLobes = 8, mostTurns = 6;
constexpr double shareOfCount = 0.03; ///< to which a count is right
constexpr int fewestApart = 2;        ///< waves

constexpr Output<WaveCause> causeRows[] = {
    {{.key = "source",
      .label = SPARKOUT_NOOP("Output", "Source of the waves"),
      .hint = "wheel, frequency, wheel_head or work"},
     [](const WaveCause& c) { return std::string(keyOf(c.source)); }},
    {{.key = "frequency_hz",
      .label = SPARKOUT_NOOP("Output", "Frequency"),
      .unit = "Hz",
      .hint = SPARKOUT_NOOP("Output", "Of the source; none where it is fixed to the work.")},
     [](const WaveCause& c) {
         return c.frequency_hz > 0 ? std::optional(c.frequency_hz) : std::nullopt;
     }},
    {{.key = "lobes",
      .label = SPARKOUT_NOOP("Output", "Waves of the wheel"),
      .hint = SPARKOUT_NOOP("Output", "Number of waves around the wheel that this would take.")},
     [](const WaveCause& c) {
         return c.source == WaveSource::wheel ? std::optional(std::int64_t{c.lobes}) : std::nullopt;
     }},
    {{.key = "turns",
      .label = SPARKOUT_NOOP("Output", "Turns of the work"),
      .hint = SPARKOUT_NOOP("Output", "After so many turns the waves meet those before.")},
     [](const WaveCause& c) { return std::int64_t{c.turns}; }},
    {{.key = "waves", .label = SPARKOUT_NOOP("Output", "Waves it would leave")},
     [](const WaveCause& c) { return c.waves; }},
    {{.key = "waves_at_other_work_speed",
      .label = SPARKOUT_NOOP("Output", "At the other work speed")},
     [](const WaveCause& c) { return c.atOtherWork; }},
    {{.key = "waves_at_other_wheel_speed",
      .label = SPARKOUT_NOOP("Output", "At the other wheel speed")},
     [](const WaveCause& c) { return c.atOtherWheel; }},
};

constexpr Output<WaveTest> testRows[] = {
    {{.key = "work_speed_rpm",
      .label = SPARKOUT_NOOP("Output", "Other work speed"),
      .unit = "rev/min"},
     [](const WaveTest& t) { return t.workSpeed_rpm; }},
    {{.key = "wheel_speed_rpm",
      .label = SPARKOUT_NOOP("Output", "Other wheel speed"),
      .unit = "rev/min"},
     [](const WaveTest& t) { return t.wheelSpeed_rpm; }},
};

} // namespace

const char* keyOf(WaveSource source) {
    constexpr std::array keys{"wheel", "frequency", "wheel_head", "work"};
    return keys[static_cast<std::size_t>(source)];
}

bool isCounted(int counted, double waves) {
    return std::abs(counted - waves) <= std::max(1.0, shareOfCount * counted);
}

WaveTest waveTest(const Project& project, int counted) {
    const int fewer = std::max(fewestApart, static_cast<int>(std::ceil(shareOfCount * counted)));
    const double share = 1.0 * (counted - fewer) / counted;
    return {project.machine->work_speed_rpm / share, wheelSpeed_rpm(project) * share};
}

std::vector<WaveCause> waveCauses(const Project& project, const WaveInquiry& asked) {
    const double n_s = project.machine->work_speed_rpm / units::secondsPerMinute;
    const double wheel_s = wheelSpeed_rpm(project) / units::secondsPerMinute;
    const WaveTest test = waveTest(project, asked.counted);
    const double work = project.machine->work_speed_rpm / test.workSpeed_rpm;
    const double wheel = test.wheelSpeed_rpm / wheelSpeed_rpm(project);
    std::vector<WaveCause> found;
    const auto offer = [&](WaveSource source, double frequency_hz, int lobes) {
        for (int q = 1; q <= mostTurns; ++q) {
            const double waves = q * frequency_hz / n_s;
            if (isCounted(asked.counted, waves)) {
                const double other = source == WaveSource::wheel ? wheel : 1;
                found.push_back(
                    {source, frequency_hz, lobes, q, waves, waves * work, waves * other});
                return; // more turns leave as many waves only by chance
            }
            if (std::abs(waves - std::round(waves)) <= nearRatio) {
                return; // further turns meet the waves of these
            }
        }
    };
    for (int lobes = 1; lobes <= mostLobes; ++lobes) {
        offer(WaveSource::wheel, lobes * wheel_s, lobes);
    }
    for (const double frequency_hz : asked.frequencies_hz) {
        offer(WaveSource::frequency, frequency_hz, 1);
    }
    if (const auto& natural = project.machine->wheel_head_frequency_hz) {
        offer(WaveSource::wheelHead, *natural, 1);
    }
    std::ranges::stable_sort(found, {},
                             [](const WaveCause& cause) { return cause.lobes * cause.turns; });
    const double counted = asked.counted;
    found.push_back({WaveSource::work, 0, 1, 1, counted, counted, counted});
    return found;
}

std::string wavesJson(const Project& project, const WaveInquiry& asked) {
    nlohmann::ordered_json json = {{"counted", asked.counted}};
    json["test"] = outputsJson(waveTestOutputs(), waveTest(project, asked.counted));
    json["causes"] = outputsJsonOfEach(waveCauseOutputs(), waveCauses(project, asked));
    return printJson(json);
}

std::span<const Output<WaveCause>> waveCauseOutputs() {
    return causeRows;
}

std::span<const Output<WaveTest>> waveTestOutputs() {
    return testRows;
}

} // namespace sparkout
