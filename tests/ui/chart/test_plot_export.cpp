// SPDX-License-Identifier: GPL-3.0-or-later
// The tables that the plot tools write, read back, and the way there: the dialog, its refusals, the
// time it takes.
#include "tests/registry.h"
#include "tests/tries.h"
#include "tests/ui/chart/plot_export_bench.h"
#include "tests/ui/views/cycle/feeds_bench.h"

#include <QElapsedTimer>
#include <QImage>

namespace sparkout::test_plot_export {

using namespace plot_export_bench;

/// Cells of a line of numbers and plain texts.
QStringList cells(const QByteArray& line, char separator) {
    return QString::fromUtf8(line.trimmed()).split(QLatin1Char(separator));
}

class TestPlotExport : public PlotExportTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }
    void init() { showView(); }
    void cleanup() { m_view.reset(); }

    void csvHoldsTheNumbersOfTheCurves_data() {
        QTest::addColumn<bool>("russian");
        QTest::newRow("Russian Excel") << true;
        QTest::newRow("English") << false;
    }

    void csvHoldsTheNumbersOfTheCurves() {
        QFETCH(bool, russian);
        const PlotTools* tools = m_view->tools();
        QByteArray bytes = saved(russian ? tools->csvRussian : tools->csvEnglish, "data.csv");
        QVERIFY(bytes.startsWith("\xEF\xBB\xBF"));
        bytes.replace("\xEF\xBB\xBF", "");
        QList<QByteArray> lines = bytes.split('\n');
        QVERIFY(lines.takeLast().isEmpty());
        const char separator = russian ? ';' : ',';
        // Names hold commas: in the English dialect they stand between quotation marks.
        QVERIFY(lines[0].contains(russian ? "actual feed, µm" : "\"actual feed, µm\""));
        const CsvTable table = m_view->plot()->table();
        QCOMPARE(lines.size(), qsizetype(table.rows.size()) + 1);
        int compared = 0;
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            const QStringList read = cells(lines[qsizetype(row) + 1], separator);
            QCOMPARE(read.size(), qsizetype(table.rows[row].size()));
            for (std::size_t column = 0; column < table.rows[row].size(); ++column) {
                if (const auto* number = std::get_if<double>(&table.rows[row][column])) {
                    QString text = read[qsizetype(column)];
                    QVERIFY(!text.contains(russian ? u'.' : u','));
                    QCOMPARE(text.replace(u',', u'.').toDouble(), *number);
                    ++compared;
                }
            }
        }
        QVERIFY(compared > 1000);
        // And the curve on the screen is this one: the last actual feed of the last zone.
        const auto column = table.header.indexOf(QStringLiteral("actual feed, µm"));
        const auto& points = feeds_bench::curve(*m_view->plot(), 2, Quantity::actual)->points;
        QString last = cells(lines.back(), separator)[column];
        QCOMPARE(last.replace(u',', u'.').toDouble(), points.back().y);
    }

    void csvHoldsTheVisibleRangeOnly() {
        const auto whole = saved(m_view->tools()->csvEnglish, "whole.csv").count('\n');
        const FeedSeries& series = m_view->plot()->series();
        m_view->plot()->showTimes(series.strokeStart_s[19], series.strokeEnd_s(40)); // 20…40
        const QByteArray part = saved(m_view->tools()->csvEnglish, "part.csv");
        QCOMPARE(part.count('\n'), 1 + 3 * 21);
        QVERIFY(part.count('\n') < whole);
    }

    void theDialogProposesFolderAndName() {
        User user;
        m_view->tools()->pdf->trigger();
        QCOMPARE(user.folders.value(0), m_folder->path());
        // Without the characters that some file systems refuse.
        QCOMPARE(user.proposed.value(0),
                 QStringLiteral("Shaft 30h6_ rough_fine – Feeds by stage.pdf"));
        // The folder of the last file is where the next dialog starts.
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("deeper")));
        user.paths << path("deeper/one.csv");
        m_view->tools()->csvRussian->trigger();
        m_view->tools()->csvEnglish->trigger();
        QCOMPARE(user.folders.value(2), path("deeper"));
        QCOMPARE(m_settings->lastFolder(), path("deeper"));
        QVERIFY(user.proposed.value(2).endsWith(QStringLiteral(".csv")));
    }

    void aFailureSaysWhyAndOffersAnotherPlace() {
        User user;
        // The folder is gone, a thing not even root can write into; then the suffix comes by
        // itself.
        user.paths << path("gone/first.png") << path("second");
        m_view->tools()->png[0]->trigger();
        QCOMPARE(user.messages.size(), 1);
        QVERIFY2(user.messages[0].contains(path("gone/first.png"))
                     && user.messages[0].contains(QStringLiteral("was not saved")),
                 qPrintable(user.messages[0]));
        QVERIFY(!QImage::fromData(on_disk::bytesOf(path("second.png"))).isNull());
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
        // Whoever gives up is left alone.
        user.tryAgain = false;
        user.paths << path("gone/third.svg") << path("third.svg");
        m_view->tools()->svg->trigger();
        QCOMPARE(user.messages.size(), 2);
        QVERIFY(!QFile::exists(path("third.svg")));
    }

    void cancelWritesNothing() {
        User user;
        for (QAction* action : {m_view->tools()->png[1], m_view->tools()->svg, m_view->tools()->pdf,
                                m_view->tools()->csvRussian}) {
            action->trigger();
        }
        QCOMPARE(user.proposed.size(), 4);
        QVERIFY(QDir(m_folder->path()).isEmpty());
    }

    /// The largest picture of a large view: its pixels are made beside the window.
    void savingDoesNotStallTheWindow() {
        constexpr double target_ms = 50;
        m_view->resize(1600, 1000);
        m_view->grab();
        for (QAction* action : {m_view->tools()->png[3], m_view->tools()->svg, m_view->tools()->pdf,
                                m_view->tools()->csvRussian, m_view->tools()->xlsx}) {
            const double longest_ms = leastOfTries_ms(4 * target_ms, [&] {
                User user;
                user.paths << path("large");
                QElapsedTimer clock, whole;
                double worst_ms = 0;
                QTimer heart;
                heart.callOnTimeout([&] {
                    if (user.paths.isEmpty()) { // the dialog is answered
                        worst_ms = std::max(worst_ms, double(clock.nsecsElapsed()) * 1e-6);
                    }
                    clock.start();
                });
                heart.start(2);
                whole.start();
                action->trigger();
                qInfo("saving %s: worst gap %.0f ms of %lld ms in all, target %g ms",
                      qPrintable(action->text()), worst_ms, static_cast<long long>(whole.elapsed()),
                      target_ms);
                return worst_ms;
            });
            QVERIFY(longest_ms <= 4 * target_ms);
        }
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).size(), 5);
    }
};

} // namespace sparkout::test_plot_export

SPARKOUT_TEST(test_plot_export, TestPlotExport)
#include "test_plot_export.moc"
