// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of every document of every example, box by box: what stands where, and whether it has
// the room that it needs. The texts of the figures, too.
#include "tests/registry.h"
#include "tests/ui/report/handout_bench.h"
#include "tests/ui/support/ink.h"
#include "tests/ui/support/passport_bench.h"
#include "ui/report/cell_text.h"
#include "ui/report/format/pages.h"
#include "ui/report/report_kinds.h"
#include "ui/report/run_figures.h"
#include "ui/text/number_text.h"

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QRegularExpression>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace sparkout::test_report_layout {

using report::Pages;
using report::Table;
using report::TextBox;
using Box = Pages::Box;

constexpr QSizeF area(5100, 7740); ///< A4 within the margins [tenths of a point]
constexpr double step = 120;       ///< about as fine as widths are shared out

double longestLine(const TextBox& box) {
    const QFontMetricsF metrics(box.font());
    double longest = 0;
    for (const QString& text : box.texts()) {
        longest = std::max(longest, metrics.horizontalAdvance(text));
    }
    return longest;
}

/// The words of a text; one that was cut is none of them.
QStringList wordsOf(const QStringList& lines) {
    return lines.join(u' ').split(QRegularExpression(QStringLiteral("[ \\n]+")),
                                  Qt::SkipEmptyParts);
}

/// Rows, with their heads, by page: of a table or of facts.
std::map<int, std::vector<const Box*>> pagesOf(const std::vector<Box>& boxes, std::size_t block) {
    std::map<int, std::vector<const Box*>> pages;
    for (const Box& box : boxes) {
        if (box.block == block && box.kind != Box::Kind::title) {
            pages[box.page].push_back(&box);
        }
    }
    return pages;
}

void checkParting(const std::map<int, std::vector<const Box*>>& pages, const QString& what) {
    if (pages.size() == 1) {
        return;
    }
    double height = 0;
    for (const auto& [page, boxes] : pages) {
        const auto rows = std::ranges::count_if(
            boxes, [](const Box* box) { return box->kind != Box::Kind::head; });
        QVERIFY2(rows >= 3, qPrintable(what + QStringLiteral(", page %1").arg(page + 1)));
        for (const Box* box : boxes) {
            height += box->height;
        }
    }
    QVERIFY2(height > area.height() * 0.4, qPrintable(what)); // what is smaller stays whole
}

void checkCells(const Table& table, const std::map<int, std::vector<const Box*>>& pages,
                const QString& what) {
    std::vector<const Box*> rows;
    for (const auto& [page, boxes] : pages) {
        QCOMPARE(boxes.front()->kind, Box::Kind::head); // repeated on every page
        rows.insert(rows.end(), boxes.begin() + 1, boxes.end());
    }
    QCOMPARE(rows.size(), table.rows.size());
    const auto columns = static_cast<std::size_t>(table.head.size());
    std::vector<double> spare(columns, 1e9);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t c = 0; c < columns; ++c) {
            const TextBox& cell = rows[r]->cells[c];
            const QString& text = table.rows[r][static_cast<qsizetype>(c)];
            const QString where = what + QStringLiteral(": ") + text;
            QVERIFY2(longestLine(cell) <= cell.width() + 1, qPrintable(where));
            QVERIFY2(wordsOf(cell.texts()) == wordsOf({text}), qPrintable(where));
            const bool isText = c < table.texts.size() && table.texts[c];
            QVERIFY2(isText || cell.lines() == text.count(u'\n') + 1, qPrintable(where));
            spare[c] = std::min(spare[c], cell.width() - longestLine(cell));
        }
    }
    for (std::size_t c = 0; c < columns; ++c) {
        const TextBox& head = pages.begin()->second.front()->cells[c];
        const QString& text = table.head[static_cast<qsizetype>(c)];
        QVERIFY2(wordsOf(head.texts()) == wordsOf({text}), qPrintable(what + u':' + text));
        spare[c] = std::min(spare[c], head.width() - TextBox::widestWord(text, head.font()));
    }
    for (std::size_t r = 0; r < rows.size(); ++r) {
        double missing = 0;
        int wrapped = 0;
        double room = 0;
        for (std::size_t c = 0; c < columns; ++c) {
            const TextBox& cell = rows[r]->cells[c];
            const QString& text = table.rows[r][static_cast<qsizetype>(c)];
            if (cell.lines() > text.count(u'\n') + 1) {
                missing += TextBox::widestLine(text, cell.font()) - cell.width();
                ++wrapped;
            } else {
                room += spare[c];
            }
        }
        QVERIFY2(wrapped == 0 || room < missing + step,
                 qPrintable(what + QStringLiteral(": %1 left for %2 in: ").arg(room).arg(missing)
                            + table.rows[r].join(u'|')));
    }
}

void checkFigure(const report::Figure& figure, const QString& what) {
    inks::Ink ink;
    inks::InkDevice device(ink, figure.size.toSize());
    QPainter painter(&device);
    figure.paint(painter);
    painter.end();
    static const QRegularExpression number(QStringLiteral("^[−+-]?[0-9]+([.,][0-9]+)?$"));
    const QRectF whole = QRectF(QPointF(), figure.size).adjusted(-1, -1, 1, 1);
    const auto& texts = ink.texts;
    QVERIFY(!texts.empty());
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const QString where = what + QStringLiteral(": ") + texts[i].text;
        QVERIFY2(whole.contains(texts[i].caps), qPrintable(where));
        for (std::size_t k = i + 1; k < texts.size(); ++k) {
            const bool ticks = texts[i].text.contains(number) && texts[k].text.contains(number);
            QVERIFY2(!ticks || !texts[i].caps.adjusted(-2, 0, 2, 0).intersects(texts[k].caps),
                     qPrintable(where + QStringLiteral(" meets ") + texts[k].text));
        }
    }
}

/// Keeps the texts and the lines that are drawn.
class DrawnThings : public QPaintEngine {
public:
    DrawnThings() : QPaintEngine(QPaintEngine::AllFeatures) {}
    using QPaintEngine::drawLines;
    using QPaintEngine::drawPolygon;
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState&) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawPath(const QPainterPath&) override {}
    void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
    void drawLines(const QLineF* drawn, int count) override {
        lines.insert(lines.end(), drawn, drawn + count);
    }
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        const QFontMetricsF metrics(item.font());
        texts.emplace_back(item.text(), metrics.tightBoundingRect(item.text()).translated(at));
    }
    [[nodiscard]] Type type() const override { return QPaintEngine::User; }

    std::vector<QLineF> lines;
    std::vector<std::pair<QString, QRectF>> texts;
};

class DrawnPaper : public QPaintDevice {
public:
    explicit DrawnPaper(const QSizeF& size) : m_size(size.toSize()) {}
    [[nodiscard]] QPaintEngine* paintEngine() const override { return &things; }

    mutable DrawnThings things;

protected:
    [[nodiscard]] int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
        case PdmWidth: return m_size.width();
        case PdmHeight: return m_size.height();
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY: return 96;
        default: return QPaintDevice::metric(metric);
        }
    }

private:
    QSize m_size;
};

bool meets(const QLineF& line, const QRectF& box) {
    if (box.contains(line.p1()) || box.contains(line.p2())) {
        return true;
    }
    const QLineF sides[] = {{box.topLeft(), box.topRight()},
                            {box.bottomLeft(), box.bottomRight()},
                            {box.topLeft(), box.bottomLeft()},
                            {box.topRight(), box.bottomRight()}};
    return std::ranges::any_of(sides, [&line](const QLineF& side) {
        return line.intersects(side, nullptr) == QLineF::BoundedIntersection;
    });
}

/// No text stands on another one, out of the figure or on a line.
void checkTexts(const report::Figure& figure) {
    DrawnPaper paper(figure.size);
    QPainter painter(&paper);
    figure.paint(painter);
    painter.end();
    const auto& texts = paper.things.texts;
    QVERIFY(texts.size() > 2 && paper.things.lines.size() > 4);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const auto& [text, box] = texts[i];
        QVERIFY2(QRectF(QPointF(), figure.size).contains(box), qPrintable(text));
        for (std::size_t j = 0; j < i; ++j) {
            QVERIFY2(!box.intersects(texts[j].second), qPrintable(text + u'|' + texts[j].first));
        }
        for (const QLineF& line : paper.things.lines) {
            QVERIFY2(!meets(line, box), qPrintable(text));
        }
    }
}

class TestReportLayout : public QObject {
    Q_OBJECT

private slots:
    void everyBoxOfEveryDocumentHasItsRoom_data() { handout_bench::addCases(); }
    void everyBoxOfEveryDocumentHasItsRoom() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const report::Subject subject = subjectOf(path);
        for (const report::KindRow& kind : report::kinds()) {
            const report::Report made = kind.make(subject);
            const Pages pages(made, area);
            const std::vector<Box>& boxes = pages.boxes();
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                QVERIFY(boxes[i].y + boxes[i].height <= area.height());
                if (boxes[i].kind == Box::Kind::heading) {
                    const QString text = QString::fromLatin1(kind.key) + QStringLiteral(": ")
                                         + boxes[i].cells.front().texts().join(u' ');
                    QVERIFY2(i + 1 < boxes.size() && boxes[i + 1].page == boxes[i].page,
                             qPrintable(text));
                }
            }
            std::map<int, double> ends; // of the pages
            for (const Box& box : boxes) {
                ends[box.page] = std::max(ends[box.page], box.y + box.height);
            }
            for (const auto& [page, end] : ends) {
                QVERIFY2(page + 1 == pages.count() || end > area.height() / 3,
                         qPrintable(QStringLiteral("%1: page %2 is nearly empty")
                                        .arg(QLatin1StringView(kind.key))
                                        .arg(page + 1)));
            }
            QString heading;
            for (std::size_t block = 0; block < made.blocks.size(); ++block) {
                if (const auto* of = std::get_if<report::Heading>(&made.blocks[block])) {
                    heading = of->text;
                }
                const QString what =
                    QStringLiteral("%1, %2").arg(QLatin1StringView(kind.key), heading);
                const auto* table = std::get_if<Table>(&made.blocks[block]);
                const bool isForm = !made.sheets.empty(); // its sheets: test_card_sheets
                if (table && !isForm) {
                    checkParting(pagesOf(boxes, block), what);
                    checkCells(*table, pagesOf(boxes, block), what);
                } else if (std::holds_alternative<report::Facts>(made.blocks[block]) && !isForm) {
                    checkParting(pagesOf(boxes, block), what);
                } else if (const auto* figure = std::get_if<report::Figure>(&made.blocks[block])) {
                    checkFigure(*figure, what);
                }
                if (QTest::currentTestFailed()) {
                    return;
                }
            }
        }
    }
    void theSketchOfThePartIsLegible_data() { addLanguages(); }
    void theSketchOfThePartIsLegible() {
        QFETCH(QString, language);
        m_language.apply(language);
        std::vector<OutcomePtr> outcomes{fixtures::run(fixtures::plungeProject(60))};
        for (const QString& path : ExamplesDialog::paths()) {
            outcomes.push_back(handout_bench::exampleOutcome(path));
        }
        for (const OutcomePtr& outcome : outcomes) {
            checkTexts(report::partSketch(outcome));
            if (QTest::currentTestFailed()) {
                qWarning("%s", outcome->result.project.title.c_str());
                return;
            }
        }
    }

    void aSizeIsWrittenAsOnADrawing_data() {
        addColumns<QString, double, double, QString>("name", "upper", "lower", "russian");
        QTest::newRow("its own field") << "Вал 30h6" << 0.0 << -16.0 << "⌀30h6(−0,016)";
        QTest::newRow("of the standard") << "Вал" << 0.0 << -13.0 << "⌀30h6(−0,013)";
        QTest::newRow("not so named") << "Вал 40k6" << 0.0 << -16.0 << "⌀30 (−0,016)";
        QTest::newRow("a hole's") << "Втулка 30H7" << 0.0 << -16.0 << "⌀30 (−0,016)";
        QTest::newRow("both") << "Вал" << 15.0 << 2.0 << "⌀30k6(+0,015; +0,002)";
        QTest::newRow("symmetric") << "" << 7.0 << -7.0 << "⌀30 (±0,007)";
    }
    void aSizeIsWrittenAsOnADrawing() {
        QFETCH(QString, name);
        QFETCH(double, upper);
        QFETCH(double, lower);
        QFETCH(QString, russian);
        m_language.apply(QStringLiteral("ru"));
        Part part;
        part.name = name.toStdString();
        part.diameter_mm = 30;
        part.upper_deviation_um = upper;
        part.lower_deviation_um = lower;
        QCOMPARE(report::drawnSize(part), russian);
        m_language.apply(QStringLiteral("en"));
        QCOMPARE(report::drawnSize(part), QString(russian).replace(u',', u'.'));
    }

    void datesAreOfTheLanguage() {
        const QDateTime moment(QDate(2026, 11, 23), QTime(8, 5));
        m_language.apply(QStringLiteral("ru"));
        QCOMPARE(dateText(moment.date()), QStringLiteral("23.11.2026"));
        QCOMPARE(momentText(moment), QStringLiteral("23.11.2026, 08:05"));
        m_language.apply(QStringLiteral("en"));
        QCOMPARE(dateText(moment.date()), QStringLiteral("23 November 2026"));
    }

    /// What one quantity is measured in, over all tables of the documents of the examples.
    void oneQuantityHasOneUnit_data() { handout_bench::addCases({"ru"}); }
    void oneQuantityHasOneUnit() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const report::Subject subject = subjectOf(path);
        const QString notes = QString::fromStdString(subject.outcome->result.project.notes);
        int remarks = 0;
        std::map<QString, QString> unitsOf;
        for (const report::KindRow& kind : report::kinds()) {
            const report::Report made = kind.make(subject);
            remarks = 0;
            for (const report::Block& block : made.blocks) {
                if (const auto* paragraph = std::get_if<report::Paragraph>(&block)) {
                    constexpr qsizetype beginning = 60; // of what the file says itself
                    remarks += paragraph->text.contains(QStringLiteral("калибровк"))
                                       && !notes.contains(paragraph->text.left(beginning))
                                   ? 1
                                   : 0;
                }
                const auto* table = std::get_if<Table>(&block);
                const qsizetype at = table ? table->head.indexOf(QStringLiteral("Единица")) : -1;
                for (const QStringList& row :
                     table&& at >= 0 ? table->rows : std::vector<QStringList>()) {
                    const QString feed = QStringLiteral("радиальная подача");
                    if (row.join(u' ').contains(feed, Qt::CaseInsensitive)
                        && subject.outcome->result.project.operation == Operation::traverse) {
                        const bool goesOn = row.join(u' ').contains(QStringLiteral("Непрерывная"));
                        QVERIFY2(row[at]
                                         == (goesOn ? QStringLiteral("мм/мин")
                                                    : QStringLiteral("мм/дв. ход"))
                                     || row.join(u' ').contains(QStringLiteral("Диапазон")),
                                 qPrintable(row.join(u'|')));
                    }
                    QVERIFY2(!row.contains(QStringLiteral("kW")), qPrintable(row.join(u'|')));
                }
                if (table) {
                    QVERIFY(!table->head.contains(QStringLiteral("с"))); // s, not seconds
                    QVERIFY(!table->head.contains(QStringLiteral("Прижог, мкм")));
                }
            }
            QVERIFY2(remarks <= (kind.kind == report::Kind::handout ? 0 : 1), kind.key);
        }
    }

    void aWebPageKeepsItsHeadingsWhenPrinted() {
        m_language.apply(QStringLiteral("en"));
        const QByteArray html =
            bytesOf(handout_bench::handout(fixtures::run(fixtures::traverseProject())),
                    report::Format::html);
        for (const char* rule :
             {"@page{size:A4", "h1,h2{break-after:avoid}", "thead{display:table-header-group}",
              "tr,figure,dl div,div.formula{break-inside:avoid}"}) {
            QVERIFY2(html.contains(rule), rule);
        }
        QVERIFY(html.count("<thead>") == html.count("<table>") && html.count("<thead>") > 3);
    }

    void markdownHasItsPictures() {
        m_language.apply(QStringLiteral("en"));
        const report::Report made =
            handout_bench::handout(fixtures::run(fixtures::traverseProject()));
        const QString text = QString::fromUtf8(bytesOf(made, report::Format::markdown));
        int figures = 0;
        for (const report::Block& block : made.blocks) {
            if (std::holds_alternative<report::Figure>(block)) {
                const QString name = QStringLiteral("figure-%1").arg(++figures);
                QVERIFY(text.contains(QStringLiteral("](%1)").arg(name))
                        || text.contains(QStringLiteral("][%1]\n").arg(name)));
                const QString mark = QStringLiteral("\n[%1]: data:image/svg+xml;base64,").arg(name);
                const qsizetype at = text.indexOf(mark);
                QVERIFY2(at > 0, qPrintable(name));
                const QString data = text.mid(at + mark.size()).section(u'\n', 0, 0);
                QXmlStreamReader svg(QByteArray::fromBase64(data.toLatin1()));
                int paths = 0;
                while (!svg.atEnd()) {
                    paths += svg.readNext() == QXmlStreamReader::StartElement ? 1 : 0;
                }
                QVERIFY2(!svg.hasError() && paths > 10, qPrintable(svg.errorString()));
            }
        }
        QCOMPARE(figures, 4);
    }

private:
    report::Subject subjectOf(const QString& path) {
        Document document;
        (void)document.openCopy(ExamplesDialog::textOf(path));
        Project project = document.project();
        auto found = m_batches.find(path);
        if (found == m_batches.end()) { // the same in both languages
            found = m_batches.emplace(path, passport_bench::subjectOf(project)).first;
        }
        report::Subject subject = found->second;
        subject.outcome = handout_bench::exampleOutcome(path);
        return subject;
    }

    Language m_language;
    std::map<QString, report::Subject> m_batches;
};

} // namespace sparkout::test_report_layout

SPARKOUT_TEST(test_report_layout, TestReportLayout)
#include "test_report_layout.moc"
