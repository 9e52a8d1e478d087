// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_io.h"
#include "app/cli_report.h"
#include "app/commands.h"
#include "core/study/wave_causes.h"
#include "words/wave_words.h"

#include <cmath>
#include <string>
#include <vector>

namespace sparkout::cli {

namespace {

std::string sourceText(const WaveCause& cause) {
    const double number = numberOf(cause);
    std::string text = textOf(cause);
    const std::size_t at = text.find("%1");
    return at == std::string::npos
               ? text
               : text.replace(at, 2, fixed(number, number == std::floor(number) ? 0 : 1));
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
    return text + waveTestText() + "\n";
}

int stateCauses(const Project& project, const manual::Given& given) {
    const WaveInquiry asked{*given.integer("--count"), given.numbers("--frequencies")};
    print(stdout, given.has("--json")
                      ? wavesJson(project, asked)
                      : causesText(waveCauses(project, asked), waveTest(project, asked.counted)));
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
