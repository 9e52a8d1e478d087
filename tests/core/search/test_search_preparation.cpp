// SPDX-License-Identifier: GPL-3.0-or-later
// What comes before and after a search: it is short, and a stop ends it.
#include "core/search/limit.h"
#include "core/search/refine.h"
#include "tests/core/search/search_cases.h"
#include "tests/processor_time.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <QElapsedTimer>

#include <chrono>
#include <stop_token>
#include <thread>

namespace sparkout::test_search_preparation {

using namespace std::chrono_literals;

std::vector<double> evenly(double from, double to, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        values.push_back(from + (to - from) * i / (count - 1));
    }
    return values;
}

/// 500 work speeds, 70 × 70 feeds, up to five stages.
Project large() {
    Project p = fixtures::traverse();
    Optimisation grid;
    grid.stages = {1, 2, 3, 4, 5};
    grid.radial_feed_mm = evenly(0.001, 0.02, 70);
    grid.axial_feed_mm_min = evenly(200, 4000, 70);
    grid.work_speed_rpm = evenly(60, 400, 500);
    grid.stock_step_mm = 0.001;
    grid.non_increasing = true;
    p.optimisation = grid;
    return p;
}

/// Time [ms] until the work ends that is stopped so long after its begin.
template <class Work>
qint64 stoppedAfter(std::chrono::milliseconds delay, Work work) {
    std::stop_source stop;
    QElapsedTimer since;
    std::jthread stopper([&](const std::stop_token&) {
        std::this_thread::sleep_for(delay);
        since.start();
        stop.request_stop();
    });
    work(stop.get_token());
    stopper.join();
    return since.elapsed();
}

constexpr double most_ms = 100 * under_sanitizers;

class TestSearchPreparation : public QObject {
    Q_OBJECT

private slots:
    void itIsStoppedWithinATenthOfASecond_data() {
        addColumns<int, bool>("delay_ms", "robust");
        for (const int delay_ms : {0, 20, 300, 1000}) {
            QTest::addRow("%d ms", delay_ms) << delay_ms << false;
        }
        QTest::newRow("robust") << 100 << true;
    }
    void itIsStoppedWithinATenthOfASecond() {
        QFETCH(int, delay_ms);
        QFETCH(bool, robust);
        const Project p = large();
        SearchSummary found;
        const qint64 took_ms =
            stoppedAfter(std::chrono::milliseconds(delay_ms), [&](const std::stop_token& stop) {
                SearchOptions options;
                options.stop = stop;
                found = robust ? optimiseRobustly(p, freshStockPhases, {.search = options}).search
                               : optimise(p, options);
            });
        qInfo("%lld ms", took_ms);
        QVERIFY(found.status == SearchStatus::stopped);
        QVERIFY2(took_ms < busy * most_ms, QByteArray::number(took_ms));
    }

    // Before its first cycle a search has bounds for each of the 500 work speeds.
    void itTakesLittleOfTheSearch() {
        const Project p = large();
        const double start_ms = processorTime_ms();
        std::stop_source stop;
        SearchOptions options;
        options.threads = 1;
        options.stop = stop.get_token();
        double first_ms = 0;
        options.onProgress = [&](const SearchProgress&) {
            first_ms = first_ms > 0 ? first_ms : processorTime_ms() - start_ms;
            stop.request_stop();
        };
        const SearchSummary found = optimise(p, options);
        qInfo("%.0f ms", first_ms);
        QVERIFY(found.bound_s > 0);
        QVERIFY2(first_ms < under_sanitizers * 4000, QByteArray::number(first_ms)); // it was 41 s
    }

    void theSizeOfTheGridIsCountedInNoTime() {
        Project p = large();
        p.optimisation->least_ratio_distance = 1e-6; // all speeds
        RunningTimer took;
        const std::int64_t size = gridSize(p);
        const qint64 took_ms = took.elapsed();
        qInfo("%lld ms", took_ms);
        QVERIFY2(took_ms < busy * 50, QByteArray::number(took_ms));
        QCOMPARE(size, std::numeric_limits<std::int64_t>::max());
        // Settings that never rise, C(70 + z − 1, z) of each feed for z stages, times shares of the
        // 149 whole steps below the stock, C(149, z − 1): for one and two stages, 500 speeds.
        p.optimisation->stages = {1, 2};
        const std::int64_t two = 70 * 71 / 2;
        QCOMPARE(gridSize(p), 500 * (70 * 70 + two * two * 149));
        p.optimisation->non_increasing = false;
        QCOMPARE(gridSize(p), 500 * (4900LL + 4900LL * 4900 * 149));
        p.optimisation->unfed_steps = std::vector<double>{0, 2, 3};
        QCOMPARE(gridSize(p), Variants(p).size());
    }

    // Of 500 work speeds it takes seconds; stopped, it is a lower one.
    void theLimitIsStopped() {
        Project p = large();
        double stopped_s = 0;
        const qint64 took_ms = stoppedAfter(
            50ms, [&](const std::stop_token& stop) { stopped_s = steplessLimit_s(p, stop); });
        qInfo("%lld ms", took_ms);
        QVERIFY2(took_ms < busy * most_ms, QByteArray::number(took_ms));
        p.optimisation->work_speed_rpm = std::vector<double>{400};
        QVERIFY(stopped_s >= 0 && stopped_s <= steplessLimit_s(p) * (1 + 1e-9));
    }
};

} // namespace sparkout::test_search_preparation

SPARKOUT_TEST(test_search_preparation, TestSearchPreparation)
#include "test_search_preparation.moc"
