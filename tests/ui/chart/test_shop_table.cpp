// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: own_language
// The table of the shop's numbers has a row for every output that people read: it is printed, for
// tests/one_place.
#include "core/quality/shop_numbers.h"
#include "core/study/outcome.h"
#include "tests/core/support/project_samples.h"
#include "ui/results/result_tables.h"
#include "ui/text/field_text.h"

#include <QLocale>
#include <QTest>

#include <algorithm>
#include <cstdio>

using namespace sparkout;

class TestShopTable : public QObject {
    Q_OBJECT

private slots:
    void everyOutputThatPeopleReadHasARow() {
        for (const char* name : {"shaft-30h6-factory", "plunge-shaft-two-stage"}) {
            const auto path =
                samples::sourcePath(std::string("resources/examples/") + name + ".sparkout");
            const auto project = readProject(samples::readText(path)).project;
            QVERIFY(project.has_value());
            const OutcomePtr outcome = evaluate(*project, {});
            const ValueTable table = shopTable(*outcome);
            std::fputs(qPrintable(tabSeparated(table.asTable(), QLocale())), stdout);
            QCOMPARE(table.columns.size(), outcome->shop.stages.size() + 1);
            for (const Output<ShopColumn>& row : shopColumnOutputs()) {
                const bool isGiven =
                    row.of(outcome->shop.cycle).index() != 0
                    || std::ranges::any_of(outcome->shop.stages, [&row](const ShopColumn& stage) {
                           return row.of(stage).index() != 0;
                       });
                const bool shows = !row.detail && *row.label && (isGiven || !row.sparse);
                const auto head = std::ranges::find_if(table.rows, [&row](const ValueHead& each) {
                    return std::string_view(each.key) == row.key;
                });
                QVERIFY2(!shows || !*row.key || head != table.rows.end(), row.key);
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestShopTable)
#include "test_shop_table.moc"
