// SPDX-License-Identifier: GPL-3.0-or-later
// What a thread keeps for itself goes with it, in the right order (cmake/thread_keys.cpp).
#include "tests/registry.h"

#include <array>
#include <atomic>
#include <thread>

namespace sparkout::test_thread_ends {

std::atomic<int> intact{0};

/// So large that the system takes its memory back as soon as it is freed.
struct Large {
    std::array<int, 1 << 18> numbers{};
    std::unique_ptr<int> last = std::make_unique<int>(7);
    ~Large() { intact += numbers[1000] == 42 && *last == 7; }
};
thread_local Large large;

class TestThreadEnds : public QObject {
    Q_OBJECT

private slots:
    void aThreadsObjectsAreDestroyedBeforeTheirMemoryGoes() {
        constexpr int threads = 5;
        for (int i = 0; i < threads; ++i) {
            std::jthread([] { large.numbers[1000] = 42; }).join();
        }
        QCOMPARE(intact.load(), threads);
    }
};

} // namespace sparkout::test_thread_ends

SPARKOUT_TEST(test_thread_ends, TestThreadEnds)
#include "test_thread_ends.moc"
