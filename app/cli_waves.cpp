// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_io.h"
#include "app/cli_report.h"
#include "app/commands.h"
#include "core/file/output_json.h"
#include "core/file/strict_json.h"
#include "core/study/wave_causes.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace sparkout::cli {

namespace {

std::string sourceText(const WaveCause& cause) {
    switch (cause.source) {
    case WaveSource::wheel:
        return cause.lobes == 1 ? "the wheel: runout or unbalance"
                                : "the wheel: " + std::to_string(cause.lobes) + " waves around it";
    case WaveSource::frequency: return fixed(cause.frequency_hz, 1) + " Hz";
    case WaveSource::wheelHead:
        return "chatter at the wheel head's " + fixed(cause.frequency_hz, 1) + " Hz";
    case WaveSource::work: break;
    }
    return "fixed to the work: centres, headstock, blank";
}

std::string causesText(const std::vector<WaveCause>& causes, const WaveTest& test) {
    std::string text;
    for (const WaveCause& cause : causes) {
        text += sourceText(cause) + ": " + fixed(cause.waves, 1) + " waves";
        text += cause.turns > 1 ? " in " + std::to_string(cause.turns) + " turns of the work" : "";
        text += "; " + fixed(cause.atOtherWork, 1) + " at " + fixed(test.workSpeed_rpm, 1)
                + " rev/min of the work, " + fixed(cause.atOtherWheel, 1) + " at "
                + fixed(test.wheelSpeed_rpm, 0) + " of the wheel\n";
    }
    return text
           + "Grind with the other speeds, one at a time, and count again: the count of the cause "
             "moves as stated here. Where it is the wheel's, force and power ripple off a whole "
             "ratio of the speeds and not at it.\n";
}

int stateCauses(const Project& project, const manual::Given& given) {
    WaveInquiry asked{.counted = static_cast<double>(*given.integer("--count")),
                      .frequencies_hz = {}};
    for (const int frequency_hz : given.integers("--frequencies")) {
        asked.frequencies_hz.push_back(frequency_hz);
    }
    const std::vector<WaveCause> causes = waveCauses(project, asked);
    const WaveTest test = waveTest(project, asked.counted);
    if (given.has("--json")) {
        nlohmann::ordered_json json = {{"counted", asked.counted}};
        json["test"] = outputsJson(waveTestOutputs(), test);
        json["causes"] = outputsJsonOfEach(waveCauseOutputs(), causes);
        print(stdout, printJson(json));
    } else {
        print(stdout, causesText(causes, test));
    }
    return done;
}

} // namespace

int runWavesCommand(const manual::Given& given) {
    const Surfaces surfaces(given);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    return surfaces.run([&given](const Project& project, std::size_t, const std::string&) {
        return stateCauses(project, given);
    });
}

} // namespace sparkout::cli
