// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of Indirect and OptionalIndirect: values that stand apart from their owner.
#include "core/file/project_file.h"
#include "core/indirect.h"
#include "tests/core/support/allocation_counter.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

#include <type_traits>
#include <utility>

namespace sparkout::test_indirect {

struct Later;
/// An owner of what is only declared here: it compiles, is copied and moved by its own members.
struct Owner {
    Indirect<Later> value;
    OptionalIndirect<Later> perhaps;
};
static_assert(std::is_aggregate_v<Owner> && std::is_aggregate_v<Project>);
struct Later {
    int number = 7;
};

// Const with their owner.
static_assert(std::is_same_v<decltype(*std::declval<Indirect<int>&>()), int&>);
static_assert(std::is_same_v<decltype(*std::declval<const Indirect<int>&>()), const int&>);
static_assert(
    std::is_same_v<decltype(std::declval<const Indirect<int>&>().operator->()), const int*>);
static_assert(std::is_same_v<decltype(*std::declval<OptionalIndirect<int>&>()), int&>);
static_assert(std::is_same_v<decltype(*std::declval<const OptionalIndirect<int>&>()), const int&>);
static_assert(std::is_same_v<decltype(std::declval<const OptionalIndirect<int>&>().operator->()),
                             const int*>);
// A vector of projects grows by moving them.
static_assert(std::is_nothrow_move_constructible_v<Indirect<Later>>);
static_assert(std::is_nothrow_move_constructible_v<OptionalIndirect<Later>>);
static_assert(std::is_nothrow_move_constructible_v<Project>);
static_assert(std::is_nothrow_move_assignable_v<Project>);

/// Counts those that live; its copy may be made to fail.
struct Watched {
    Watched() { ++living; }
    Watched(const Watched& other) : number(other.number) {
        if (copyFails) {
            throw std::runtime_error("no copy");
        }
        ++living;
    }
    Watched(Watched&& other) noexcept : number(other.number) { ++living; }
    Watched& operator=(const Watched& other) {
        if (copyFails) {
            throw std::runtime_error("no copy");
        }
        number = other.number;
        return *this;
    }
    Watched& operator=(Watched&&) noexcept = default;
    ~Watched() { --living; }

    int number = 1;
    static inline int living = 0;
    static inline bool copyFails = false;
};

Indirect<Watched> numbered(int number) {
    Indirect<Watched> value;
    value->number = number;
    return value;
}

class TestIndirect : public QObject {
    Q_OBJECT

private slots:
    void cleanup() {
        Watched::copyFails = false;
        QCOMPARE(Watched::living, 0); // whatever happened, nothing is left behind
    }

    void oneIsMadeAsItsInitialisersSay() {
        const Owner owner;
        QCOMPARE(owner.value->number, 7);
        QVERIFY(!owner.perhaps);
        const Project project;
        QCOMPARE(project.gauge->commands, Gauge().commands);
    }

    void aCopyIsItsOwn() {
        Owner a;
        a.perhaps.emplace().number = 3;
        Owner b = a;
        QVERIFY(&*a.value != &*b.value && &*a.perhaps != &*b.perhaps);
        b.value->number = 8;
        b.perhaps->number = 9;
        QCOMPARE(a.value->number, 7);
        QCOMPARE(a.perhaps->number, 3);
        a = b;
        QCOMPARE(a.value->number, 8);
        QCOMPARE(a.perhaps->number, 9);
        a.value->number = 10;
        QCOMPARE(b.value->number, 8);
    }

    void assigningToItselfChangesNothing() {
        Indirect<Watched> value = numbered(5);
        const Indirect<Watched>& same = value;
        value = same;
        QCOMPARE(value->number, 5);
        OptionalIndirect<Watched> perhaps;
        const OptionalIndirect<Watched>& samePerhaps = perhaps;
        perhaps = samePerhaps;
        QVERIFY(!perhaps);
        perhaps.emplace().number = 6;
        perhaps = samePerhaps;
        QCOMPARE(perhaps->number, 6);
    }

    void aMoveTakesTheValueItself() {
        Indirect<Watched> from = numbered(5);
        const Watched* const before = &*from;
        Indirect<Watched> to = std::move(from);
        QVERIFY(&*to == before);
        QCOMPARE(Watched::living, 1);
        Indirect<Watched> other;
        other = std::move(to);
        QVERIFY(&*other == before);
        QCOMPARE(Watched::living, 1);
    }

    void whatWasMovedFromIsDestroyedAssignedAndCopied() {
        Indirect<Watched> from = numbered(5);
        Indirect<Watched> to = std::move(from);
        Indirect<Watched> copied = from; // NOLINT(bugprone-use-after-move): the subject
        copied = to;                     // which it had nothing to hold it in
        QCOMPARE(copied->number, 5);
        from = to;
        QCOMPARE(from->number, 5);
        from->number = 6;
        QCOMPARE(to->number, 5);
        Indirect<Watched> last = std::move(from);
        to = from; // NOLINT(bugprone-use-after-move)
        from = std::move(last);
        QCOMPARE(from->number, 6);
        const Indirect<Watched>& same = from;
        from = same;
        QCOMPARE(from->number, 6);
    } // and `to`, which holds nothing, is destroyed

    void aProjectThatWasMovedFromIsAssigned() {
        Project from = fixtures::traverse();
        from.batch.emplace().parts = 17;
        const Project whole = from;
        const Project to = std::move(from);
        QCOMPARE(firstDifference(to, whole), std::string());
        from = whole; // NOLINT(bugprone-use-after-move): the subject
        QCOMPARE(firstDifference(from, whole), std::string());
        QVERIFY(from.batch && from.batch->parts == 17);
        std::vector<Project> many(3, whole);
        many.erase(many.begin()); // moves each one down
        for (const Project& each : many) {
            QCOMPARE(firstDifference(each, whole), std::string());
        }
    }

    void perhapsIsEmptyUntilItIsGiven() {
        OptionalIndirect<Watched> perhaps;
        QVERIFY(!perhaps.has_value());
        Watched given;
        given.number = 4;
        QCOMPARE(perhaps.value_or(given).number, 4);
        perhaps.emplace().number = 2;
        QVERIFY(perhaps && perhaps->number == 2);
        QCOMPARE(perhaps.value_or(given).number, 2);
        QCOMPARE(perhaps.emplace().number, 1); // anew, not what it held
        perhaps = given;
        QCOMPARE((*perhaps).number, 4);
        perhaps = std::nullopt;
        QVERIFY(!perhaps);
        perhaps = given; // where nothing was
        QCOMPARE(perhaps->number, 4);
        perhaps.reset();
        QVERIFY(!perhaps);
    }

    void anEmptyOneIsCopiedAndMovedAsEmpty() {
        OptionalIndirect<Watched> empty, full;
        full.emplace().number = 3;
        OptionalIndirect<Watched> copy = empty;
        QVERIFY(!copy);
        copy = full;
        QCOMPARE(copy->number, 3);
        copy = empty;
        QVERIFY(!copy);
        copy = std::move(full);
        QVERIFY(copy && !full); // NOLINT(bugprone-use-after-move): the subject
        full = std::move(copy);
        QVERIFY(full && !copy); // NOLINT(bugprone-use-after-move)
    }

    void aCopyThatFailsLeavesBothAsTheyWere() {
        const Indirect<Watched> from = numbered(5);
        Indirect<Watched> to = numbered(6);
        Indirect<Watched> hollow;
        const Indirect<Watched> taken = std::move(hollow);
        OptionalIndirect<Watched> perhaps, none;
        perhaps.emplace();
        Watched::copyFails = true;
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, Indirect<Watched> copy(from));
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, to = from);
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, hollow = from);
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, none = perhaps);
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, OptionalIndirect<Watched> copy(perhaps));
        QCOMPARE(from->number, 5);
        QCOMPARE(to->number, 6);
        QVERIFY(perhaps && !none);
        Watched::copyFails = false;
        hollow = from;
        QCOMPARE(hollow->number, 5);
    }

    void assigningUsesTheMemoryThatIsThere() {
        const Project from = fixtures::traverse();
        Project to = from;
        to.cycle->stages.front().stock_mm = 1;
        const long long before = allocations::count;
        to = from;
        QCOMPARE(allocations::count - before, 0LL);
        QCOMPARE(firstDifference(to, from), std::string());
    }
};

} // namespace sparkout::test_indirect

SPARKOUT_TEST(test_indirect, TestIndirect)
#include "test_indirect.moc"
