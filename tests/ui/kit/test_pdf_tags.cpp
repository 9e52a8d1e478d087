// SPDX-License-Identifier: GPL-3.0-or-later
// Tagged PDFs of every kind, read back by libqpdf: the rules of marked content, the tree and its
// texts; one of them by poppler, too.
#include "core/setup/setup_run.h"
#include "tests/registry.h"
#include "tests/ui/report/handout_bench.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/pdf_tree.h"
#include "tests/ui/support/report_reading.h"
#include "tests/ui/support/setup_fixtures.h"
#include "ui/chart/plot_tools.h"
#include "ui/kit/pdf_details.h"
#include "ui/report/report_kinds.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>

#include <qcustomplot.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace sparkout::test_pdf_tags {

using handout_bench::exampleOutcome;
using handout_bench::today;
using reading::PdfElement;
using reading::PdfTree;
using report::Format;

QByteArray bytesOf(const report::Report& made) {
    return report::bytesOf(made, Format::pdf);
}

std::vector<std::size_t> ofType(const PdfTree& tree, const char* type) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < tree.elements.size(); ++i) {
        if (tree.elements[i].type == type) {
            places.push_back(i);
        }
    }
    return places;
}

/// Without soft hyphens, and with plain spaces.
QString plain(const QString& text) {
    return text.normalized(QString::NormalizationForm_KC).remove(QChar::SoftHyphen).simplified();
}

QStringList textsOf(const PdfTree& tree, const char* type) {
    QStringList texts;
    for (const std::size_t place : ofType(tree, type)) {
        texts << plain(tree.elements[place].text);
    }
    return texts;
}

/// What is wrong with the elements: cells in rows of one width, names with values, words for what
/// is drawn.
QStringList faultsOf(const PdfTree& tree) {
    QStringList faults = tree.faults;
    const auto check = [&faults](bool holds, const QString& fault) {
        if (!holds) {
            faults << fault;
        }
    };
    check(tree.isMarked, QStringLiteral("not marked"));
    check(tree.showsTitle, QStringLiteral("no title shown"));
    check(!tree.elements.empty() && tree.elements.front().type == "Document",
          QStringLiteral("no document"));
    check(ofType(tree, "H1").size() >= 1, QStringLiteral("no heading"));
    for (const PdfElement& element : tree.elements) {
        const QString type = QString::fromLatin1(element.type);
        const auto kidsAre = [&](const QList<QByteArray>& types) {
            return std::ranges::all_of(element.kids, [&](std::size_t kid) {
                return types.contains(tree.elements[kid].type);
            });
        };
        if (element.type == "Table") {
            std::set<int> widths;
            for (const std::size_t row : element.kids) {
                const std::vector<std::size_t>& cells = tree.elements[row].kids;
                widths.insert(
                    std::accumulate(cells.begin(), cells.end(), 0, [&](int sum, std::size_t cell) {
                        return sum + tree.elements[cell].span;
                    }));
            }
            check(kidsAre({"TR"}) && widths.size() == 1 && *widths.begin() > 0,
                  QStringLiteral("a table that is not rectangular"));
            check(element.kids.size() > 1
                      && std::ranges::all_of(
                          tree.elements[element.kids.front()].kids,
                          [&](std::size_t cell) { return tree.elements[cell].isColumnHead; }),
                  QStringLiteral("a table without its head"));
        } else if (element.type == "TR") {
            check(kidsAre({"TH", "TD"}), QStringLiteral("no cell in a row"));
        } else if (element.type == "L") {
            check(kidsAre({"LI"}) && !element.kids.empty(), QStringLiteral("a list of no items"));
        } else if (element.type == "LI") {
            check(element.kids.size() == 2 && kidsAre({"Lbl", "LBody"}),
                  QStringLiteral("an item without name or value"));
        } else if (element.type == "Figure") {
            check(element.hasContent && !element.alt.isEmpty() && element.box
                      && element.box->isValid(),
                  QStringLiteral("a figure without words or place"));
        } else if (element.type == "Formula") {
            check(element.hasContent && element.alt.contains(u'='),
                  QStringLiteral("an equation without words"));
        } else if (element.type != "Document" && element.type != "Sect" && element.type != "TD"
                   && element.type != "TH") {
            check(element.hasContent, QStringLiteral("nothing in ") + type);
        }
    }
    return faults;
}

class TestPdfTags : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_subject.outcome = exampleOutcome(
            QStringLiteral(SPARKOUT_SOURCE_DIR "/tests/data/projects/everything.sparkout"));
        m_subject.date = today;
        const Setup setup = setup_fixtures::steppedShaft();
        m_subject.setup = std::make_shared<const report::SetupSubject>(
            report::SetupSubject{setup, runSetup(setup)});
    }
    void init() { m_language.apply(QStringLiteral("en")); }

    void everyReportIsTagged_data() {
        addColumns<QString, int>("language", "row");
        for (const char* language : {"en", "ru"}) {
            for (std::size_t row = 0; row < report::kinds().size(); ++row) {
                QTest::addRow("%s %s", report::kinds()[row].key, language)
                    << QString::fromLatin1(language) << static_cast<int>(row);
            }
        }
    }
    void everyReportIsTagged() {
        QFETCH(QString, language);
        QFETCH(int, row);
        m_language.apply(language);
        const report::Report made = report::kinds()[static_cast<std::size_t>(row)].make(m_subject);
        const QByteArray pdf = bytesOf(made);
        const PdfTree tree = reading::treeOf(pdf);
        const QStringList faults = faultsOf(tree);
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(u'\n')));
        QCOMPARE(tree.language, language);
        static const QRegularExpression tagged(QStringLiteral("Tagged: +yes"));
        QVERIFY(reading::told(QStringLiteral("pdfinfo"), {}, pdf).contains(tagged));
        if (made.sheets.empty()) {
            checkBlocks(made, tree);
        } else {
            checkSheets(made, tree);
        }
    }

    /// A text that goes on over pages is one element, a head that is repeated is none.
    void whatGoesOnOverPagesIsOneElement() {
        report::Report made;
        made.title = QStringLiteral("Title");
        made.language = QStringLiteral("en");
        made.date = today;
        const QString words = QStringLiteral("word ").repeated(3'000).trimmed();
        report::Table table{{QStringLiteral("Head"), QStringLiteral("Value")}, {}, {true}};
        for (int i = 0; i < 150; ++i) {
            table.rows.push_back({QString::number(i), QStringLiteral("1")});
        }
        table.rows.push_back({words, QStringLiteral("long")}); // longer than a page
        made.blocks = {report::Heading{QStringLiteral("Text")}, report::Paragraph{words}, table};
        const QByteArray pdf = bytesOf(made);
        const PdfTree tree = reading::treeOf(pdf);
        QVERIFY2(faultsOf(tree).isEmpty(), qPrintable(faultsOf(tree).join(u'\n')));
        QVERIFY(tree.pages > 5);
        QCOMPARE(textsOf(tree, "P"), QStringList{words});
        QCOMPARE(ofType(tree, "TR").size(), std::size_t{152});
        QCOMPARE(textsOf(tree, "TH"), table.head);
        QCOMPARE(textsOf(tree, "TD").at(300), words);
    }

    /// Another reader finds the same.
    void popplerFindsTheHeadings() {
        const QByteArray pdf = bytesOf(report::rowOf(report::Kind::card).make(m_subject));
        QStringList found;
        bool isHeading = false;
        for (const QString& line :
             reading::told(QStringLiteral("pdfinfo"), {QStringLiteral("-struct-text")}, pdf)
                 .split(u'\n')) {
            const QString content = line.trimmed();
            if (isHeading && content.startsWith(u'"')) {
                found << plain(content.mid(1, content.size() - 2));
            }
            isHeading = content.startsWith(u'H');
        }
        const PdfTree tree = reading::treeOf(pdf);
        QVERIFY(found.size() > 3);
        QCOMPARE(found, textsOf(tree, "H1") + textsOf(tree, "H2"));
    }

    void picturesOfPlotsAreTagged_data() { addLanguages(); }
    void picturesOfPlotsAreTagged() {
        QFETCH(QString, language);
        m_language.apply(language);
        QCustomPlot plot;
        plot.resize(400, 300);
        plot.addGraph()->setData({0, 1, 2}, {1, 3, 2});
        plot.xAxis->setLabel(QStringLiteral("Time, min"));
        plot.yAxis->setLabel(QStringLiteral("Feed, mm/min"));
        plot.rescaleAxes();
        LegendEntry curve;
        curve.colour = Qt::blue;
        curve.text = QStringLiteral("actual feed");
        const QByteArray pdf =
            pdfWork({&plot, {QStringLiteral("Feeds"), QStringLiteral("Shaft")}, {curve}})();
        const PdfTree tree = reading::treeOf(pdf);
        QVERIFY2(faultsOf(tree).isEmpty(), qPrintable(faultsOf(tree).join(u'\n')));
        QCOMPARE(tree.language, language);
        QCOMPARE(textsOf(tree, "H1"), QStringList{QStringLiteral("Feeds")});
        QCOMPARE(textsOf(tree, "P"), QStringList{QStringLiteral("Shaft")});
        const auto figures = ofType(tree, "Figure");
        QCOMPARE(figures.size(), std::size_t{1});
        const QString words = tree.elements[figures.front()].alt;
        for (const char* part : {"Feeds", "Time, min", "Feed, mm/min", "actual feed"}) {
            QVERIFY2(words.contains(QString::fromUtf8(part)), qPrintable(words));
        }
        QCOMPARE(words.contains(QStringLiteral("оси: ")), language == u"ru");
    }

    /// A mark where its painter has a clip, or at the end, is no fault; without marks nothing is
    /// in the tree.
    void marksStandAnywhere() {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        QVERIFY(buffer.open(QIODevice::WriteOnly));
        PdfStructure structure;
        const auto first = structure.add({"H1"}), second = structure.add({"P"}),
                   third = structure.add({"P"});
        {
            QPdfWriter writer(&buffer);
            QPainter painter(&writer);
            painter.setClipRect(QRectF(0, 0, 5'000, 5'000));
            for (const auto id : {first, PdfStructure::artifact, second, second, third}) {
                PdfStructure::mark(painter, id);
                if (id != third) { // of which nothing is seen
                    painter.translate(10, 10);
                    painter.drawText(100, 300, QStringLiteral("text"));
                    painter.drawRect(0, 0, 100, 100);
                }
            }
        }
        PdfDetails details{};
        details.structure = structure;
        const PdfTree tree = reading::treeOf(withDetails(bytes, details));
        QVERIFY2(tree.faults.isEmpty(), qPrintable(tree.faults.join(u'\n')));
        QCOMPARE(ofType(tree, "P").size(), std::size_t{2});
        details.structure = {};
        QVERIFY(!reading::treeOf(withDetails(bytes, details)).faults.isEmpty());
    }

private:
    void checkBlocks(const report::Report& made, const PdfTree& tree) {
        QCOMPARE(textsOf(tree, "H1"), QStringList{plain(made.title)});
        QStringList headings;
        std::size_t figures = 0, formulas = 0, tables = 0;
        for (const report::Block& block : made.blocks) {
            if (const auto* heading = std::get_if<report::Heading>(&block)) {
                headings << plain(heading->text);
            }
            figures += std::holds_alternative<report::Figure>(block) ? 1 : 0;
            formulas += std::holds_alternative<report::Formula>(block) ? 1 : 0;
            tables += std::holds_alternative<report::Table>(block) ? 1 : 0;
        }
        QVERIFY(headings.size() > 2);
        QCOMPARE(textsOf(tree, "H2"), headings);
        QCOMPARE(ofType(tree, "Figure").size(), figures);
        QCOMPARE(ofType(tree, "Caption").size(), figures);
        QCOMPARE(ofType(tree, "Formula").size(), formulas);
        QCOMPARE(ofType(tree, "Table").size(), tables);
        const QStringList cells = textsOf(tree, "TD");
        qsizetype next = 0;
        for (const report::Block& block : made.blocks) { // every cell, in its order
            const auto* table = std::get_if<report::Table>(&block);
            for (std::size_t r = 0; table && r < table->rows.size(); ++r) {
                for (const QString& cell : table->rows[r]) {
                    const QString text = plain(cell);
                    if (!table->symbols) { // whose underscores stand for indices
                        QCOMPARE(cells.value(next), text);
                    }
                    ++next;
                }
            }
        }
        QCOMPARE(cells.size(), next);
    }

    void checkSheets(const report::Report& made, const PdfTree& tree) {
        QCOMPARE(ofType(tree, "Sect").size(), made.sheets.size());
        QCOMPARE(ofType(tree, "H1").size(), made.sheets.size());
        QStringList headings;
        std::size_t tables = 0, drawings = 0;
        for (const report::FormSheet& sheet : made.sheets) {
            tables += sheet.columns > 0 ? 1 : 0;
            drawings += sheet.drawing.description.isEmpty() ? 0 : 1;
            for (const report::SheetText& text : sheet.texts) {
                if (text.isHeading) {
                    headings << plain(text.text);
                }
            }
        }
        QCOMPARE(textsOf(tree, "H1"), headings);
        QCOMPARE(ofType(tree, "Table").size(), tables);
        QCOMPARE(ofType(tree, "Figure").size(), drawings);
        QCOMPARE(drawings, std::size_t{1});
    }

    Language m_language;
    report::Subject m_subject;
};

} // namespace sparkout::test_pdf_tags

SPARKOUT_TEST(test_pdf_tags, TestPdfTags)
#include "test_pdf_tags.moc"
