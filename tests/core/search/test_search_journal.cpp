// SPDX-License-Identifier: GPL-3.0-or-later
// A full search that is stopped anywhere, its record written and read back, goes on to the answer
// of one that is not; a record of something else is refused.
#include "core/search/search_journal.h"

#include "core/batch/state_seal.h"
#include "core/search/search_record_text.h"
#include "core/study/search.h"
#include "tests/core/search/search_checks.h"
#include "tests/registry.h"

#include <algorithm>
#include <string>

namespace sparkout::test_search_journal {

using namespace search_checks;

const SearchQuestion asked{"engine 1", "project 1", "--method full"};

SearchRecord written(const SearchRecord& record) {
    const std::string text = writeSearchState(asked, record);
    ReadSearchState read = readSearchState(text, asked);
    if (read.fault != SearchStateFault::none || writeSearchState(asked, read.record) != text) {
        qFatal("a record is not read back as it was written");
    }
    return read.record;
}

SearchWish full(SearchJournal& journal, unsigned threads) {
    SearchWish options;
    options.method = SearchMethod::full;
    options.threads = threads;
    options.journal = &journal;
    return options;
}

/// Stopped after so many further steps of the record, again and again until it comes to its end.
SearchOutcome inPieces(const Project& p, unsigned threads, int steps, bool robust, int& pieces) {
    SearchRecord record;
    for (pieces = 1;; ++pieces) {
        SearchJournal journal(written(record));
        std::stop_source stop;
        int left = steps;
        journal.onStep = [&](const SearchRecord& now) {
            record = now;
            if (--left == 0) {
                stop.request_stop();
            }
        };
        SearchWish options = full(journal, threads);
        options.phases = robust;
        SearchOutcome report = *sparkout::search(p, options, stop.get_token());
        record = journal.record();
        if (!stop.stop_requested()) {
            return report;
        }
    }
}

bool isSame(const SearchOutcome& a, const SearchOutcome& b) {
    const auto &one = a.search, &other = b.search;
    return one.status == other.status && one.evaluations == other.evaluations
           && one.gridSize == other.gridSize && one.bound_s == other.bound_s
           && one.best.has_value() == other.best.has_value() && a.rounds == b.rounds
           && a.binding == b.binding && a.robust.has_value() == b.robust.has_value()
           && (!a.robust || a.robust->evaluations == b.robust->evaluations)
           && (!one.best
               || (one.best->cycle == other.best->cycle && one.best->variant == other.best->variant
                   && one.best->time_s == other.best->time_s
                   && one.best->leastRelativeMargin == other.best->leastRelativeMargin
                   && one.machine == other.machine));
}

class TestSearchJournal : public QObject {
    Q_OBJECT

private slots:
    void stoppedAnywhereItGoesOnToTheSameAnswer() {
        int cut = 0, found = 0;
        for (unsigned seed = 0; seed < static_cast<unsigned>(samples::sized(20, 6, 80)); ++seed) {
            Project p = smallCase(seed);
            // Several searches behind each other; of some later seeds the levels grow to grids of
            // which it takes minutes to run every cycle.
            p.optimisation->adaptive = seed % 3 == 0 && seed < 21;
            SearchJournal none;
            const SearchOutcome whole = *sparkout::search(p, full(none, 1));
            int pieces = 0;
            const SearchOutcome again = inPieces(p, 1 + seed % 3, 1, false, pieces);
            QVERIFY2(isSame(whole, again), std::to_string(seed).c_str());
            cut += pieces > 1 ? 1 : 0;
            found += whole.search.best ? 1 : 0;
        }
        QVERIFY2(cut > 2 && found > samples::sized(2, 0, 8),
                 qPrintable(QString("%1 %2").arg(cut).arg(found)));
    }

    void theShareOfTheGridGoesOnFromWhereItWas() {
        int cut = 0;
        for (unsigned seed = 0; seed < static_cast<unsigned>(samples::sized(20, 6, 20)); ++seed) {
            Project p = smallCase(seed);
            p.optimisation->adaptive = false;
            SearchJournal first;
            std::stop_source stop;
            first.onStep = [&stop](const SearchRecord&) { stop.request_stop(); };
            (void)sparkout::search(p, full(first, 1), stop.get_token());
            if (!first.record().begun || !first.record().finished.empty()) {
                continue;
            }
            ++cut;
            const double done =
                double(first.record().begun->evaluations) / double(sparkout::gridSize(p));
            SearchJournal second(first.record());
            double least = 1, most = 0;
            (void)sparkout::search(p, full(second, 1), {}, {.note = [&](const SearchState& state) {
                                       least = std::min(least, state.share);
                                       most = std::max(most, state.share);
                                   }});
            QVERIFY2(done > 0 && least >= done && most <= 1, std::to_string(seed).c_str());
        }
        QVERIFY(cut > 0);
    }

    void aRobustSearchGoesOnToo() {
        int cut = 0, rounds = 0;
        for (unsigned seed = 0; seed < static_cast<unsigned>(samples::sized(16, 6, 24)); ++seed) {
            const Project p = smallCase(seed);
            SearchJournal none;
            SearchWish options = full(none, 1);
            options.phases = true;
            const SearchOutcome whole = *sparkout::search(p, options);
            int pieces = 0;
            const SearchOutcome again = inPieces(p, 2, 1, true, pieces);
            QVERIFY2(isSame(whole, again), std::to_string(seed).c_str());
            cut += pieces > 1 ? 1 : 0;
            rounds += whole.robust && whole.robust->rounds > 1 ? 1 : 0;
        }
        qInfo("%d were cut, %d have several rounds", cut, rounds);
        QVERIFY(cut > 1);
    }

    void whatIsFinishedIsKnown() {
        Project p = smallCase(3);
        SearchJournal first;
        const SearchOutcome whole = *sparkout::search(p, full(first, 1));
        QVERIFY(!first.record().begun && !first.record().finished.empty());
        SearchJournal second(written(first.record()));
        int steps = 0;
        second.onStep = [&steps](const SearchRecord&) { ++steps; };
        QVERIFY(isSame(whole, *sparkout::search(p, full(second, 1))));
        QCOMPARE(steps, 0);
    }

    void whatIsOfNoCycleIsSearchedAnew() {
        const Project p = smallCase(3);
        SearchJournal none;
        const SearchOutcome whole = *sparkout::search(p, full(none, 1));
        SearchCheckpoint foreign;
        foreign.last = {{4'999, 3}};
        foreign.variant = 77;
        foreign.evaluations = 5;
        FeasibleCycle best;
        best.cycle = {{4'998, 9}};
        best.time_us = 1;
        SearchCheckpoint wrong;
        wrong.best = best;
        for (const SearchRecord& record : {SearchRecord{{}, foreign}, SearchRecord{{wrong}, {}},
                                           SearchRecord{{foreign}, wrong}}) {
            SearchJournal journal(written(record));
            QVERIFY(isSame(whole, *sparkout::search(p, full(journal, 1))));
        }
    }

    // The best cycle of a record is run before it counts: one that holds, but with a time or a
    // margin that it has not, would keep all others out.
    void timesOfARecordAreRunBeforeTheyCount() {
        Project p = smallCase(3);
        for (unsigned seed = 3; !search(p).best; ++seed) {
            p = smallCase(seed);
        }
        SearchJournal none;
        const SearchOutcome whole = *sparkout::search(p, full(none, 1));
        QVERIFY(whole.search.best && !none.record().finished.empty());
        const SearchCheckpoint true_ = none.record().finished.front();
        for (const int what : {0, 1, 2, 3}) {
            SearchCheckpoint forged = true_;
            forged.best->time_us = what == 0 ? 1000 : forged.best->time_us;
            forged.best->time_s = what == 0 ? 0.001 : what == 1 ? 0.5 : forged.best->time_s;
            forged.best->leastRelativeMargin += what == 2 ? 0.5 : 0;
            if (what == 3) { // of the grid, but it does not hold
                const Grid grid(p);
                for (GridCycle cycle; grid.next(cycle);) {
                    Project other = p;
                    *other.cycle = grid.cycle(cycle);
                    if (!holds(simulateUnchecked(other))) {
                        forged.best->cycle = cycle;
                        break;
                    }
                }
            }
            for (const SearchRecord& record :
                 {SearchRecord{{}, forged}, SearchRecord{{forged}, {}}}) {
                SearchJournal journal(written(record));
                QVERIFY(isSame(whole, *sparkout::search(p, full(journal, 1))));
                QVERIFY(journal.hasRefused());
            }
        }
        SearchJournal honest(written({{true_}, {}}));
        QVERIFY(isSame(whole, *sparkout::search(p, full(honest, 1))));
        QVERIFY(!honest.hasRefused());
    }

    void aValueOutOfItsRangeIsNamed() {
        SearchCheckpoint at;
        at.last = {{1, 2}, {0, 3}};
        at.evaluations = 17;
        at.best = FeasibleCycle{{{1, 2}, {0, 3}}, 1'234'567, 0.25, 1, 1.2345671};
        const samples::json good = samples::json::parse(writeSearchState(asked, {{at}, at}));
        using Pointer = samples::json::json_pointer;
        const auto refused = [&](const char* path, const samples::json& value) {
            nlohmann::ordered_json forged = nlohmann::ordered_json::parse(good.dump());
            forged[nlohmann::ordered_json::json_pointer(path)] = value;
            const ReadSearchState read = readSearchState(sealed(forged), asked);
            return read.fault == SearchStateFault::badValue && read.record.finished.empty()
                           && !read.record.begun
                       ? read.value.path
                       : std::string("taken");
        };
        for (const char* path :
             {"/begun/evaluations", "/finished/0/visits", "/begun/cuts/4", "/finished/0/variant",
              "/begun/best/time_us", "/finished/0/last/1/0", "/begun/best/cycle/0/1"}) {
            QCOMPARE(refused(path, -1), std::string(path));
            QCOMPARE(refused(path, 9.3e18), std::string(path));
            QCOMPARE(refused(path, 18'446'744'073'709'551'615U), std::string(path));
            QCOMPARE(refused(path, "1"), std::string(path));
        }
        QCOMPARE(refused("/begun/evaluations", 9'223'372'036'854'775'807LL),
                 std::string("/begun/evaluations")); // their sum would be beyond all numbers
        for (const char* path : {"/begun/best/time_s", "/finished/0/best/margin"}) {
            for (const char* digits : {"nan", "inf", "-5", "", "1e400", "2x"}) {
                QCOMPARE(refused(path, digits), std::string(path));
            }
            QCOMPARE(refused(path, 2), std::string(path));
        }
        QCOMPARE(refused("/begun/cuts", samples::json::array({1, 2})),
                 std::string("/begun/cuts/length"));
        QVERIFY(good.contains(Pointer("/begun/best/time_s")));
    }

    void aRecordOfSomethingElseIsNamed() {
        SearchCheckpoint at;
        at.last = {{1, 2}, {0, 3}};
        at.evaluations = 17;
        at.best = FeasibleCycle{{{1, 2}, {0, 3}}, 1'234'567, 0.25, 1, 1.2345671};
        const std::string text = writeSearchState(asked, {{at}, at});
        const auto fault = [&](const std::string& of, const SearchQuestion& question) {
            const ReadSearchState read = readSearchState(of, question);
            return read.record.finished.empty() ? read.fault : SearchStateFault::none;
        };
        QVERIFY(fault(text, asked) == SearchStateFault::none);
        QVERIFY(fault(text, {"engine 2", asked.project, asked.options})
                == SearchStateFault::otherEngine);
        QVERIFY(fault(text, {asked.engine, "project 2", asked.options})
                == SearchStateFault::otherProject);
        QVERIFY(fault(text, {asked.engine, asked.project, "--method full --robust"})
                == SearchStateFault::otherOptions);
        QVERIFY(fault("{}", asked) == SearchStateFault::otherFormat);
        QVERIFY(fault("", asked) == SearchStateFault::otherFormat);
        QVERIFY(fault("# notes", asked) == SearchStateFault::otherFormat);
        std::string newer = text;
        newer.replace(newer.find("\"version\":1"), 11, "\"version\":2");
        QVERIFY(fault(newer, asked) == SearchStateFault::otherVersion);
        // Whatever byte changes, and wherever it is cut off.
        for (std::size_t i = 0; i + 1 < text.size(); ++i) {
            std::string flipped = text;
            flipped[i] = static_cast<char>(flipped[i] ^ 0x01);
            QVERIFY2(fault(flipped, asked) != SearchStateFault::none, flipped.c_str());
            QVERIFY(fault(text.substr(0, i), asked) != SearchStateFault::none);
        }
    }
};

} // namespace sparkout::test_search_journal

SPARKOUT_TEST(test_search_journal, TestSearchJournal)
#include "test_search_journal.moc"
