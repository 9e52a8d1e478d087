// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/result.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

/// What can have left the waves that were counted on a part [MODEL-16]. A source that moves with
/// time at the frequency f leaves m waves where m = q·60·f/n, q whole turns of the work after which
/// its waves meet; one that is fixed to the work leaves the same number at every speed.
namespace sparkout {

enum class WaveSource {
    wheel,     ///< L waves of the wheel, which turns with n_k
    frequency, ///< one that is known: a motor, a belt, the floor
    wheelHead, ///< its natural frequency: chatter
    work       ///< centres, headstock, blank
};
[[nodiscard]] const char* keyOf(WaveSource source); ///< "wheel_head"

struct WaveCause {
    WaveSource source = WaveSource::wheel;
    double frequency_hz = 0; ///< 0: fixed to the work
    int lobes = 1;           ///< L of the wheel
    int turns = 1;           ///< q
    double waves = 0;        ///< that it would leave
    /// Waves that it would leave at the work speed of the test, and with the wheel of the test.
    double atOtherWork = 0, atOtherWheel = 0;
};

struct WaveInquiry {
    int counted = 0;                    ///< waves around the part
    std::vector<double> frequencies_hz; ///< known in the machine and around it
};

/// The test that distinguishes the causes: a higher work speed, at which what moves with time
/// leaves a whole number of waves fewer, two and 3 % at least, and a lower wheel speed, at which
/// the wheel does.
struct WaveTest {
    double workSpeed_rpm = 0, wheelSpeed_rpm = 0;
};
[[nodiscard]] WaveTest waveTest(const Project& project, int counted);

/// A count is right to 3 %, and to one wave.
[[nodiscard]] bool isCounted(int counted, double waves);

/// The causes whose waves agree with the count, the fewest lobes and turns first; what is fixed to
/// the work is always one. Project and inquiry must be valid: n > 0, counted ≥ fewestWaves.
[[nodiscard]] std::vector<WaveCause> waveCauses(const Project& project, const WaveInquiry& asked);
/// Test and causes, as `sparkout-cli waves --json` states them.
[[nodiscard]] std::string wavesJson(const Project& project, const WaveInquiry& asked);
/// How many waves may have been counted, and known frequencies be [Hz].
inline constexpr int fewestWaves = 4, mostWaves = 100'000;
inline constexpr double lowestFrequency_hz = 0.1, highestFrequency_hz = 1e5;

[[nodiscard]] std::span<const Output<WaveCause>> waveCauseOutputs();
[[nodiscard]] std::span<const Output<WaveTest>> waveTestOutputs();

} // namespace sparkout
