// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/dialogs/copy_table.h"
#include "ui/views/requirements/verdict_panel.h"

#include <QLabel>
#include <QTableView>

#include <clocale>

namespace sparkout::test_views {

using namespace fixtures;

void settle(VerdictPanel& panel, const OutcomePtr& outcome) {
    panel.setOutcome(outcome);
    QTest::qWait(20);
}

ConstraintResult requirement(ConstraintKind kind, double margin, double relative) {
    ConstraintResult c{};
    c.kind = kind;
    c.zone = Zone::nz;
    c.section = 1;
    c.limit = -16;
    c.value = -16 + margin;
    c.margin = margin;
    c.relativeMargin = relative;
    c.holds = margin >= 0;
    return c;
}

class TestViews : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        setlocale(LC_NUMERIC, "C");
        QLocale::setDefault(QLocale::c());
        m_traverse = run(traverseProject());
        QVERIFY(m_traverse->ran() && m_traverse->result.status == RunStatus::completed);
    }

    // --- verdict --------------------------------------------------------------------------------

    void theLightsSayHoldsCloseAndFails_data() {
        addColumns<double, double, QString>("margin", "relative", "word");
        QTest::newRow("holds") << 6.4 << 0.4 << QString();
        QTest::newRow("just holds") << 1.6 << 0.1 << QString();
        QTest::newRow("close") << 1.59 << 0.0994 << QStringLiteral("close to the limit");
        QTest::newRow("on the limit") << 0.0 << 0.0 << QStringLiteral("close to the limit");
        QTest::newRow("not met") << -3.2 << -0.2 << QStringLiteral("not met");
    }

    void theLightsSayHoldsCloseAndFails() {
        QFETCH(double, margin);
        QFETCH(double, relative);
        QFETCH(QString, word);
        auto outcome = std::make_shared<Outcome>(*m_traverse);
        outcome->constraints = {requirement(ConstraintKind::diameterMin, margin, relative)};
        VerdictPanel panel;
        settle(panel, outcome);
        QCOMPARE(panel.model()->rowCount(), 2);
        const QString cell = panel.model()->index(1, 0).data().toString();
        QCOMPARE(cell.section(u'\n', 1), word);
        QVERIFY(!panel.model()->index(1, 0).data(Qt::DecorationRole).value<QIcon>().isNull());
    }

    void theVerdictNamesTheWorstRequirement() {
        auto outcome = std::make_shared<Outcome>(*m_traverse);
        VerdictPanel panel;
        auto* overall = panel.findChild<QLabel*>(QStringLiteral("overall"));
        outcome->constraints = {requirement(ConstraintKind::diameterMax, 6.4, 0.4)};
        outcome->result.project.part->tolerance.radial_runout_um.reset(); // machine not known
        settle(panel, outcome);
        QCOMPARE(overall->text(), QStringLiteral("Nominal part only"));
        outcome = std::make_shared<Outcome>(*outcome);
        outcome->constraints = {requirement(ConstraintKind::diameterMax, 1, 0.05),
                                requirement(ConstraintKind::diameterMin, -3.2, -0.2)};
        settle(panel, outcome);
        QCOMPARE(overall->text(), QStringLiteral("Not met: minimum diameter by 3.20\u00a0µm"));
        outcome = std::make_shared<Outcome>(*outcome);
        outcome->constraints.pop_back();
        settle(panel, outcome);
        QVERIFY(overall->text().startsWith(QStringLiteral("Met, close to the limit: ")));
    }

    void aCycleThatCannotReachSizeSaysWhatRemains() {
        auto outcome = std::make_shared<Outcome>(*m_traverse);
        outcome->result.status = RunStatus::cannotReachSize;
        outcome->result.gaugeReading_mm = 30.0124;
        outcome->result.remainingStock_mm = 0.0102;
        VerdictPanel panel;
        settle(panel, outcome);
        const QString text = panel.findChild<QLabel*>(QStringLiteral("status"))->text();
        QVERIFY(text.contains(QStringLiteral("30.0124 mm")));
        QVERIFY(text.contains(QStringLiteral("10.20 µm")));
        QVERIFY(panel.findChild<QLabel*>(QStringLiteral("overall"))
                    ->text()
                    .startsWith(QStringLiteral("Not met")));
    }

    void refusedInputsGreyTheVerdict() {
        VerdictPanel panel;
        panel.show();
        auto* notice = panel.findChild<QLabel*>(QStringLiteral("notice"));
        auto* time = panel.findChild<QLabel*>(QStringLiteral("time"));
        QCOMPARE(notice->text(), QStringLiteral("No result yet."));
        settle(panel, m_traverse);
        QVERIFY(!notice->isVisible());
        const QString before = time->text();
        const QColor colour = time->palette().color(QPalette::WindowText);
        settle(panel, refused());
        QVERIFY(notice->isVisible() && notice->text().contains(QStringLiteral("5000")));
        QCOMPARE(time->text(), before);
        QVERIFY(time->palette().color(QPalette::WindowText) != colour);
        QVERIFY(panel.model()->index(1, 1).data(Qt::ForegroundRole).isValid());
        settle(panel, m_traverse);
        QCOMPARE(time->palette().color(QPalette::WindowText), colour);
        QVERIFY(!panel.model()->index(1, 1).data(Qt::ForegroundRole).isValid());
    }

    void nothingIsClippedAt300Pixels() {
        VerdictPanel panel;
        panel.resize(300, 640);
        panel.show();
        settle(panel, m_traverse);
        QCOMPARE(panel.width(), 300);
        auto* table = panel.findChild<QTableView*>(QStringLiteral("requirements"));
        QVERIFY(table->width() <= 300);
        for (int row = 0; row < panel.model()->rowCount(); ++row) {
            for (int column = 1; column < panel.model()->columnCount(); ++column) {
                const QString text = panel.model()->index(row, column).data().toString();
                QVERIFY(table->fontMetrics().horizontalAdvance(text) <= table->columnWidth(column));
            }
            const int lines = 1 + int(panel.model()->index(row, 0).data().toString().count(u'\n'));
            QVERIFY(table->rowHeight(row) >= lines * table->fontMetrics().height());
        }
        for (const QLabel* label : panel.findChildren<QLabel*>()) {
            if (label->isVisible() && !label->text().isEmpty()) {
                QTRY_VERIFY(label->height() >= label->heightForWidth(label->width()));
            }
        }
    }

private:
    OutcomePtr m_traverse;
};

} // namespace sparkout::test_views

SPARKOUT_TEST(test_views, TestViews)
#include "test_views.moc"
