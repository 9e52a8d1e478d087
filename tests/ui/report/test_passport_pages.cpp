// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the accuracy passport in its three formats: whole, in one language, whatever the
// batch and the texts.
#include "tests/check_line.h"
#include "tests/processor_time.h"
#include "tests/registry.h"
#include "tests/tries.h"
#include "tests/ui/support/passport_bench.h"
#include "ui/report/report_kinds.h"
#include "ui/views/study/batch_text.h"

#include <QRegularExpression>

namespace sparkout::test_passport_pages {

using namespace passport_bench;

class TestPassportPages : public QObject {
    Q_OBJECT

private slots:
    void init() { m_language.apply(QStringLiteral("en")); }
    void theOutlineLeadsToEveryHeading() {
        const report::Report report = report::passport(subjectOf(example("30h6-factory")));
        const QByteArray pdf = bytesOf(report, Format::pdf);
        const QStringList pages = textOf(pdf).split(u'\f', Qt::SkipEmptyParts);
        QStringList headings;
        for (const report::Block& block : report.blocks) {
            if (const auto* heading = std::get_if<report::Heading>(&block)) {
                headings << heading->text;
            }
        }
        QStringList entries;
        for (const OutlineEntry& entry : outlineOf(pdf)) {
            entries << entry.text;
            const QString page = pages.value(entry.page - 1)
                                     .simplified()
                                     .normalized(QString::NormalizationForm_KC); // no ligatures
            QVERIFY2(page.contains(entry.text), qPrintable(entry.text + u'\n' + page));
        }
        QVERIFY(headings.size() > 10);
        QCOMPARE(entries, headings);
    }

    void whatTheBatchLeavesOutStandsOnPageOne_data() { addLanguages(); }
    void whatTheBatchLeavesOutStandsOnPageOne() {
        QFETCH(QString, language);
        m_language.apply(language);
        const Project project = smallBatch();
        const QString left = BatchText::notCounted(project);
        QVERIFY(!left.isEmpty());
        const QString page = textOf(made(project, Format::pdf)).section(u'\f', 0, 0).simplified();
        QVERIFY2(page.contains(language == u"ru" ? QStringLiteral("Не учтено")
                                                 : QStringLiteral("Not counted")),
                 qPrintable(page));
        static const QRegularExpression between(QStringLiteral("[^\\w-]+"),
                                                QRegularExpression::UseUnicodePropertiesOption);
        for (const QString& word : left.split(between, Qt::SkipEmptyParts)) {
            QVERIFY2(page.contains(word), qPrintable(word));
        }
    }

    void theRussianPassportHasNoEnglishWord_data() {
        QTest::addColumn<bool>("batch");
        QTest::newRow("batch") << true;
        QTest::newRow("no batch") << false;
    }
    void theRussianPassportHasNoEnglishWord() {
        QFETCH(bool, batch);
        m_language.apply(QStringLiteral("ru"));
        Project project = example("30h6-factory");
        project.title = project.notes = project.author = project.part->name = {};
        project.machine->name = project.material->grade = project.wheel->marking = {};
        if (!batch) {
            project.batch.reset();
        }
        static const QRegularExpression pictures( // of the Markdown text, by their names
            QStringLiteral("\\[figure-\\d+\\](: data:\\S+)?"));
        const QString text = textOfHtml(made(project, Format::html))
                             + QString::fromUtf8(made(project, Format::markdown)).remove(pictures);
        QCOMPARE(englishWords(text, {"Ppk", "RONt", "report", "passport", "pdf"}), QStringList());
    }

    /// Corners have no mean; parts that do not reach size have no values; factors may be none.
    void oddBatchesAreReported_data() {
        QTest::addColumn<QString>("what");
        for (const char* name : {"corners", "no factors", "none reaches size", "one part"}) {
            QTest::newRow(name) << QString::fromUtf8(name);
        }
    }
    void oddBatchesAreReported() {
        QFETCH(QString, what);
        Project project = smallBatch();
        if (what == u"corners") {
            project.batch->scenarios = Scenarios::corners;
            project.batch->factors.dullness->grows.reset();
            project.batch->factors.dullness->uniform = {0.01, 0.03};
        } else if (what == u"no factors") {
            project.batch->factors = {};
        } else if (what == u"one part") {
            project.batch->parts = 1;
        } else {
            project.cycle->stages.back().spark_out = {SparkOut::Mode::count, 1};
            project.cycle->stages.back().radial_feed_mm.reset();
        }
        const report::Subject subject = subjectOf(project);
        QVERIFY(subject.outcome->ran() && subject.batch->ran());
        const report::Report report = report::passport(subject);
        for (const report::Block& block : report.blocks) {
            if (const auto* table = std::get_if<report::Table>(&block)) {
                QVERIFY(!table->rows.empty());
                for (const QStringList& row : table->rows) {
                    QCOMPARE(row.size(), table->head.size());
                    QVERIFY2(!row.contains(QString()), qPrintable(row.join(u'|')));
                }
            }
        }
        const QString text = textOf(bytesOf(report, Format::pdf));
        QVERIFY(!text.isEmpty());
        QVERIFY2(!text.contains(QStringLiteral("nan")) && !text.contains(QStringLiteral("inf ")),
                 qPrintable(text));
    }

    void aRowLongerThanAPageGoesOn() {
        Project project = smallBatch();
        project.batch->factors.dullness.reset();
        std::vector<double> values;
        for (int i = 0; i < 3000; ++i) {
            values.push_back((140'000 + i) / 1e6);
        }
        project.batch->factors.stock_mm->uniform.reset();
        project.batch->factors.stock_mm->measured = values;
        QString text = textOf(made(project, Format::pdf));
        text.remove(QRegularExpression(QStringLiteral("\\s")));
        for (const char* value : {"0.14;", "0.1415;", "0.142998;0.142999"}) {
            QVERIFY2(text.contains(QString::fromUtf8(value)), value);
        }
    }

    /// In every report, whatever it prints of them.
    void hostileTextsStayTexts() {
        Project project = smallBatch();
        project.title = "<script>alert(1)</script> | a\nb \x01 & \"q\"";
        project.part->name = "</title><svg onload=x>";
        project.author = "<math><mi>x</mi></math>";
        project.machine->name = "a | b <img src=x>";
        project.notes = "<script>alert(2)</script>";
        const report::Subject subject = subjectOf(project);
        for (const report::KindRow& kind : report::kinds()) {
            const report::Report made = kind.make(subject);
            const QByteArray html = bytesOf(made, Format::html);
            QVERIFY2(!textOfHtml(html).isEmpty(), kind.key);
            const QByteArray markdown = bytesOf(made, Format::markdown);
            for (const char* tag : {"<script", "<img", "<svg onload", "<math>"}) {
                QVERIFY2(!html.contains(tag) && !markdown.contains(tag), kind.key);
            }
        }
        const report::Report passport = report::passport(subject);
        static const QRegularExpression outside(
            QStringLiteral("<(link|[^>]* (src|href)=)|url\\(h"));
        QVERIFY(!QString::fromUtf8(bytesOf(passport, Format::html)).contains(outside));
        const QString markdown = QString::fromUtf8(bytesOf(passport, Format::markdown));
        QCOMPARE(markdown.count(u'<'), markdown.count(QStringLiteral("<br>")));
        QVERIFY(textOf(bytesOf(passport, Format::pdf))
                    .contains(QStringLiteral("<script>alert(2)</script>")));
    }

private:
    Language m_language;
};

} // namespace sparkout::test_passport_pages

SPARKOUT_TEST(test_passport_pages, TestPassportPages)
#include "test_passport_pages.moc"
