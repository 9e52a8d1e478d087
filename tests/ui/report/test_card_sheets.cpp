// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Operation card and sketch sheet: what stands on the sheets, and that all of it has its room.
#include "core/file/safe_file.h"
#include "core/setup/setup_file.h"
#include "core/units.h"
#include "tests/registry.h"
#include "tests/ui/report/handout_bench.h"
#include "tests/ui/support/logo_samples.h"
#include "tests/ui/support/report_reading.h"
#include "ui/report/card_sheets.h"
#include "ui/report/format/pages.h"
#include "ui/report/operation_card_report.h"
#include "ui/report/report_kinds.h"
#include "ui/report/sketch_callout.h"
#include "ui/report/sketch_sheet.h"
#include "ui/text/number_text.h"

#include <QFontMetricsF>
#include <QRegularExpression>

#include <algorithm>
#include <optional>

namespace sparkout::test_card_sheets {

using namespace handout_bench;
using report::CardRow;
using report::CardRows;
using report::FormSheet;
using report::SheetText;

constexpr double slack_mm = 0.05;

Setup setupOf(const char* name) {
    const auto content =
        readFile(std::string(SPARKOUT_SOURCE_DIR "/tests/data/setups/") + name + ".sparkout",
                 std::size_t{1} << 20);
    return *readSetup(std::get<std::string>(content)).setup;
}

/// All that the head of the card has.
Setup filledSetup() {
    Setup setup = setupOf("spindle");
    setup.times.approach_s = 3;
    setup.times.handling_s = 40;
    setup.times.preparation_min = 12;
    for (GroundSurface& surface : setup.surfaces) {
        surface.project.coolant = "Укринол-1, 3 %";
        surface.project.material->hardness_hrc = 50;
        CardEntries& entries = *surface.project.card;
        entries.part_number = "7716-03.021";
        entries.operation_number = "045";
        entries.letter = "А";
        entries.program = "O1204";
        entries.mass_kg = 2.25;
        entries.blank = "Круг 50 ГОСТ 2590";
        entries.blank_mass_kg = 4.9;
    }
    return setup;
}

Company filledCompany() {
    Company company;
    company.name = "АО «Станкомаш»";
    company.developed = "Иванов";
    company.checked = "Петров";
    company.agreed = "Сидоров";
    company.standards = "Кузнецов";
    company.approved = "Громов";
    company.designation = "60141.00012";
    company.part = "of another project";
    company.logo = samples::picture({160, 40}, "PNG");
    return company;
}

/// So many surfaces beside each other on one shaft, with long names.
Setup manySurfaces(std::size_t count) {
    Setup setup = setupOf("spindle");
    const GroundSurface plunge = setup.surfaces[1];
    setup.surfaces.clear();
    for (std::size_t i = 0; i < count; ++i) {
        GroundSurface surface = plunge;
        surface.name = std::to_string(i + 1) + " шейка под радиально-упорный подшипник качения "
                       + std::string(60, 'w');
        surface.project.part->length_mm = 14;
        surface.project.part->diameter_mm = 30 + static_cast<double>(i);
        surface.project.part->shaft.ground_from_mm = 15 * static_cast<double>(i);
        surface.project.part->shaft.segments = {{static_cast<double>(count) * 15, 60}};
        setup.surfaces.push_back(surface);
    }
    return setup;
}

report::Report cardOf(const Setup& setup, const Company& company = {}) {
    return report::OperationCardReport::write(setup, runSetup(setup), company,
                                              QStringLiteral("/tmp/part.sparkout"), today);
}

/// What is written on a sheet, in the order in which it was put there.
QString textOf(const FormSheet& sheet) {
    QStringList all;
    for (const SheetText& text : sheet.texts) {
        all << text.text;
    }
    return all.join(u'\n');
}

QString textOf(const report::Report& report) {
    QString all;
    for (const FormSheet& sheet : report.sheets) {
        all += textOf(sheet) + u'\n';
    }
    return all;
}

/// Where a text is printed: its widest line, all of its lines.
QRectF printed(const SheetText& text) {
    const report::TextBox box = text.box();
    double wide = 0;
    for (const QString& line : box.texts()) {
        wide = std::max(wide, QFontMetricsF(box.font()).horizontalAdvance(line));
    }
    wide /= report::unitsPerMm;
    const double high = box.height() / report::unitsPerMm;
    const QRectF cell = text.cell;
    const double left = text.align & Qt::AlignRight     ? cell.right() - wide
                        : text.align & Qt::AlignHCenter ? cell.center().x() - wide / 2
                                                        : cell.left();
    return {left, cell.center().y() - high / 2, wide, high};
}

void verifyRoom(const FormSheet& sheet) {
    const QRectF paper(0, 0, report::form::paperWidth, report::form::paperHeight);
    std::vector<QRectF> boxes;
    for (const SheetText& text : sheet.texts) {
        const QRectF box = printed(text);
        const QRectF cell = text.cell.adjusted(-slack_mm, -slack_mm, slack_mm, slack_mm);
        QVERIFY2(box.left() >= cell.left() && box.right() <= cell.right(), qPrintable(text.text));
        QVERIFY2(box.top() >= cell.top() - 0.6 && box.bottom() <= cell.bottom() + 0.6,
                 qPrintable(text.text)); // the leading is no ink
        QVERIFY2(paper.contains(box), qPrintable(text.text));
        boxes.push_back(box);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const QRectF both = boxes[i].intersected(boxes[j]);
            QVERIFY2(both.width() < 0.2 || both.height() < 1,
                     qPrintable(sheet.texts[i].text + u'|' + sheet.texts[j].text));
        }
    }
}

void addSetups() {
    addColumns<QString, QString>("name", "language");
    for (const char* name : {"spindle", "sleeve", "many", "six", "examples"}) {
        for (const char* language : {"en", "ru"}) {
            QTest::addRow("%s %s", name, language)
                << QString::fromLatin1(name) << QString::fromLatin1(language);
        }
    }
}

std::vector<Setup> setupsOf(const QString& name) {
    if (name == u"many") {
        return {manySurfaces(20)};
    }
    if (name == u"six") {
        return {manySurfaces(6), manySurfaces(11)};
    }
    if (name != u"examples") {
        return {setupOf(name.toLatin1())};
    }
    std::vector<Setup> all;
    for (const QString& path : ExamplesDialog::paths()) {
        Setup setup;
        setup.surfaces = {GroundSurface{{}, exampleOutcome(path)->result.project}};
        all.push_back(setup);
    }
    return all;
}

/// The service symbol of the first line of a sheet; empty where it goes on from the one before.
QString firstSymbol(const FormSheet& sheet) {
    constexpr double narrow = 7, whole = 13;
    const auto isNumbered = [](const SheetText& text) {
        static const QRegularExpression number(QStringLiteral("^\\d\\d\\d?$"));
        return text.cell.right() < report::form::left + whole && number.match(text.text).hasMatch();
    };
    const auto first = std::ranges::find_if(sheet.texts, isNumbered);
    const auto symbol = std::ranges::find_if(sheet.texts, [&](const SheetText& text) {
        return first != sheet.texts.end() && text.cell.top() == first->cell.top()
               && text.cell.right() < report::form::left + narrow;
    });
    return symbol == sheet.texts.end() ? QString() : symbol->text;
}

/// The rows of the tables of an OpenDocument text, cell by cell, and the texts between them.
struct OdtText {
    explicit OdtText(const QByteArray& content) {
        QXmlStreamReader reader(content);
        bool inCell = false;
        while (!reader.atEnd()) {
            reader.readNext();
            const auto name = reader.qualifiedName();
            if (reader.isStartElement() && name == u"table:table") {
                tables.emplace_back();
            } else if (reader.isStartElement() && name == u"table:table-row") {
                tables.back().emplace_back();
            } else if (name == u"table:table-cell") {
                inCell = reader.isStartElement();
                if (inCell) {
                    tables.back().back() << QString();
                }
            } else if (reader.isCharacters()) {
                (inCell ? tables.back().back().last() : rest) += reader.text();
            }
        }
        fault = reader.hasError() ? reader.errorString() : QString();
    }
    QString fault, rest;
    std::vector<std::vector<QStringList>> tables;
};

/// A time as it is printed, in hundredths.
int hundredths(const QString& text) {
    return qRound(parseNumber(text).value_or(0) * 100);
}

class TestCardSheets : public QObject {
    Q_OBJECT

private slots:
    void init() { m_language.apply(QStringLiteral("ru")); }

    void everyTextHasItsRoom_data() { addSetups(); }
    void everyTextHasItsRoom() {
        QFETCH(QString, name);
        QFETCH(QString, language);
        m_language.apply(language);
        Company company;
        company.name = "Научно-производственное объединение точного "
                       "машиностроения и станкостроения имени двадцатилетия";
        company.department = "Отдел главного технолога";
        company.developed = "Константинопольский-Задунайский А. А.";
        company.designation = "АБВГ.10140.00001.000.000.000";
        for (const Setup& setup : setupsOf(name)) {
            for (const Company& of : {Company(), company}) {
                for (const FormSheet& sheet : cardOf(setup, of).sheets) {
                    verifyRoom(sheet);
                    if (QTest::currentTestFailed()) {
                        return;
                    }
                }
            }
        }
    }

    void everyRowIsOnTheSheets_data() { addSetups(); }
    void everyRowIsOnTheSheets() {
        QFETCH(QString, name);
        QFETCH(QString, language);
        m_language.apply(language);
        for (const Setup& setup : setupsOf(name)) {
            const SetupRun run = runSetup(setup);
            QString all = textOf(cardOf(setup)).remove(QRegularExpression(QStringLiteral("\\s")));
            qsizetype from = 0;
            for (const CardRow& row : CardRows::of(operationCard(setup, run), setup, run)) {
                // Between its lines stand their numbers, those of the row after the first line: the
                // words are looked for one by one, the cells from where the row begins.
                std::optional<qsizetype> begin;
                for (const QString& word : row.text.split(u' ', Qt::SkipEmptyParts)) {
                    const qsizetype at = all.indexOf(
                        QString(word).remove(QRegularExpression(QStringLiteral("\\s"))), from);
                    QVERIFY2(at >= 0, qPrintable(row.text));
                    from = at;
                    begin = begin.value_or(at);
                }
                for (const QString& cell : row.cells) {
                    QVERIFY2(all.indexOf(QString(cell).remove(u' '), begin.value_or(from)) >= 0,
                             qPrintable(cell));
                }
            }
        }
    }

    /// Nothing that belongs together is parted: a transition stands with its first line of
    /// regimes, and no sheet has less than three lines.
    void sheetsHaveNoOrphans_data() { addSetups(); }
    void sheetsHaveNoOrphans() {
        QFETCH(QString, name);
        QFETCH(QString, language);
        m_language.apply(language);
        for (const Setup& setup : setupsOf(name)) {
            const auto report = cardOf(setup);
            static const QRegularExpression number(QStringLiteral("^\\d\\d\\d?$"));
            int last = 0;
            for (std::size_t s = 0; s + 1 < report.sheets.size(); ++s) { // the last is the sketch
                const int before = last;
                for (const SheetText& text : report.sheets[s].texts) {
                    if (text.cell.top() > report::form::top + 3 * report::form::pitch
                        && text.cell.right() < report::form::left + 13
                        && number.match(text.text).hasMatch()) {
                        QCOMPARE(text.text.toInt(), last + 1);
                        ++last;
                    }
                }
                QVERIFY(last - before >= 3);
                const QString first = firstSymbol(report.sheets[s]);
                QVERIFY2(first == CardRows::tr("O", "service symbol of a transition")
                             || first == CardRows::tr("R", "service symbol of regimes"),
                         qPrintable(first));
            }
        }
    }

    void sheetsAreCountedThrough() {
        m_language.apply(QStringLiteral("en"));
        for (const std::size_t surfaces : {1U, 6U}) {
            const auto sheets = cardOf(manySurfaces(surfaces)).sheets;
            QVERIFY(sheets.size() >= 2);
            for (std::size_t i = 0; i < sheets.size(); ++i) {
                QStringList numbers; // behind the captions of both cells
                const auto& texts = sheets[i].texts;
                for (std::size_t k = 0; k + 1 < texts.size() && numbers.size() < 2; ++k) {
                    if (texts[k].text == u"Sheets"
                        || (texts[k].text == u"Sheet" && !numbers.isEmpty())) {
                        numbers << texts[k + 1].text;
                    }
                }
                QCOMPARE(numbers,
                         (QStringList{QString::number(sheets.size()), QString::number(i + 1)}));
            }
        }
    }

    /// T_шт stands on the card where a time beside the cycles was entered.
    void aPieceTimeThatNobodyEnteredIsNotPrinted() {
        Setup setup = setupOf("spindle");
        setup.times = {};
        const auto piece = [&setup] {
            const auto head = report::OperationCardReport::head(
                setup, operationCard(setup, runSetup(setup)), {}, today);
            return head.equipment.at(5);
        };
        QCOMPARE(piece(), QString());
        setup.times.handling_s = 60;
        QVERIFY(parseNumber(piece()).value_or(0) > 1);
        setup.times = {};
        setup.times.piece_min = 9;
        QCOMPARE(parseNumber(piece()), std::optional(9.0));
    }

    /// A marking that begins with the wheel's size says it for both.
    void theSizeOfTheWheelIsWrittenOnce() {
        Setup setup = setupOf("spindle");
        const auto toolingWith = [&setup](const char* marking) {
            for (GroundSurface& surface : setup.surfaces) {
                surface.project.wheel->marking = marking;
                surface.project.wheel->diameter_mm = 500;
                surface.project.wheel->width_mm = 40;
            }
            const auto rows = CardRows::of(operationCard(setup, {}), setup, {});
            const auto row = std::ranges::find_if(
                rows, [](const CardRow& r) { return r.text.startsWith(u"Круг"); });
            return row == rows.end() ? QString() : row->text.section(u';', 0, 0);
        };
        QCOMPARE(toolingWith("500×40×203 25А F60 L 6 V"),
                 QStringLiteral("Круг 500×40×203 25А F60 L 6 V"));
        QCOMPARE(toolingWith("25А F60 L 6 V"), QStringLiteral("Круг 500×40, 25А F60 L 6 V"));
        QCOMPARE(toolingWith(""), QStringLiteral("Круг 500×40"));
    }

    void numbersAreThoseOfTheRun() {
        for (const char* name : {"spindle", "sleeve"}) {
            const Setup setup = setupOf(name);
            const SetupRun run = runSetup(setup);
            QVERIFY(run.isCompleted(setup));
            const auto rows = CardRows::of(operationCard(setup, run), setup, run);
            int sum = 0;
            std::size_t regimes = 0, surfaces = 0;
            for (const CardRow& row : rows) {
                sum += hundredths(row.main);
                regimes += row.cells.isEmpty() ? 0 : 1;
            }
            QCOMPARE(sum, hundredths(CardRows::minutes(run.time.main_min)));
            std::size_t row = 0;
            for (const SurfaceRun& surface : run.surfaces) {
                const Project& project = surface.result.project;
                surfaces += project.cycle->stages.size();
                for (std::size_t z = 0; z < project.cycle->stages.size(); ++z) {
                    while (rows.at(row).cells.isEmpty()) {
                        ++row;
                    }
                    const QStringList& cells = rows.at(row++).cells;
                    QCOMPARE(cells.at(1), printedNumber(project.part->diameter_mm));
                    QCOMPARE(cells.at(2), printedNumber(project.part->length_mm));
                    QCOMPARE(cells.at(3), printedNumber(project.cycle->stages[z].stock_mm));
                    QCOMPARE(cells.at(4), QString::number(surface.result.countsByStage.at(z)));
                }
            }
            QCOMPARE(regimes, surfaces);
        }
    }

    void thePdfHoldsTheForm() {
        const Setup setup = setupOf("spindle");
        const QByteArray pdf = bytesOf(cardOf(setup), Format::pdf);
        const QString text = reading::textOf(pdf);
        for (const char* word : {"Разраб.", "Н. контр.", "Операционная карта", "Карта эскизов",
                                 "То, мин", "ОК", "КЭ", "сверьте с действующей редакцией",
                                 "Шпиндель 7716-03.021", "3М151Ф2", "0,005 / 2000", "7,76"}) {
            QVERIFY2(text.contains(QString::fromUtf8(word)),
                     qPrintable(QString::fromUtf8(word) + u'\n' + text));
        }
        const QString info = reading::told(QStringLiteral("pdfinfo"), {}, pdf);
        QVERIFY2(info.contains(QStringLiteral("842 x 595")), qPrintable(info));
        m_language.apply(QStringLiteral("en"));
        const QString english = reading::textOf(bytesOf(cardOf(setup), Format::pdf));
        QVERIFY(english.contains(QStringLiteral("Prepared")));
        static const QRegularExpression cyrillic(QStringLiteral("Разраб|Контролировать|Ступень"));
        QVERIFY(!english.contains(cyrillic));
    }

    void theOdtHasTheRowsInTables() {
        for (const char* language : {"en", "ru"}) {
            m_language.apply(QString::fromLatin1(language));
            const Setup setup = setupOf("spindle");
            const QByteArray odt = bytesOf(cardOf(setup), Format::odt);
            QVERIFY(odt.mid(30).startsWith("mimetypeapplication/vnd.oasis.opendocument.text"));
            const OdtText text(reading::unzipped(odt, "content.xml"));
            QVERIFY2(text.fault.isEmpty() && !text.tables.empty(), qPrintable(text.fault));
            const SetupRun run = runSetup(setup);
            const auto rows = CardRows::of(operationCard(setup, run), setup, run);
            const auto found = std::ranges::find_if(
                text.tables, [&](const auto& each) { return each.size() == rows.size() + 1; });
            QVERIFY(found != text.tables.end());
            const auto& table = *found;
            for (std::size_t i = 0; i < rows.size(); ++i) {
                // A text without cells goes on over theirs, as on the sheets.
                const auto spread =
                    qsizetype(report::form::mainColumn - report::form::contentColumn - 1);
                QCOMPARE(table[i + 1].size(), qsizetype(report::form::columns.size())
                                                  - (rows[i].cells.isEmpty() ? spread : 0));
                QCOMPARE(table[i + 1].at(1), rows[i].text);
                for (qsizetype c = 0; c < rows[i].cells.size(); ++c) {
                    QCOMPARE(table[i + 1].at(c + 2), rows[i].cells.at(c));
                }
            }
            const QByteArray styles = reading::unzipped(odt, "styles.xml");
            QVERIFY(styles.contains("fo:page-width=\"297mm\""));
            QVERIFY(styles.contains("fo:language=\"" + QByteArray(language) + '"'));
            for (const char* part : {"styles.xml", "meta.xml", "META-INF/manifest.xml"}) {
                const OdtText other(reading::unzipped(odt, part));
                QVERIFY2(other.fault.isEmpty(), part);
            }
            QVERIFY(reading::unzipped(odt, "Pictures/figure1.png").startsWith("\x89PNG"));
            QVERIFY(text.rest.contains(report::SketchSheet::description(setup)));
        }
    }

    void theHeadOfTheOdtIsThatOfTheSheets() {
        for (const char* language : {"en", "ru"}) {
            m_language.apply(QString::fromLatin1(language));
            const QByteArray odt = bytesOf(cardOf(filledSetup(), filledCompany()), Format::odt);
            const OdtText text(reading::unzipped(odt, "content.xml"));
            QVERIFY2(text.fault.isEmpty(), qPrintable(text.fault));
            QCOMPARE(text.tables.size(), 7U); // four of the head, the rows, two of the sketch's
            const auto& inventory = text.tables.at(0);
            QCOMPARE(inventory.size(), std::size_t(3));
            QCOMPARE(inventory.front().size(), qsizetype(4 + 10 + 2));
            const auto& signers = text.tables.at(1);
            QCOMPARE(signers.size(), report::form::signers.size());
            const Company company = filledCompany();
            const std::string names[] = {company.developed, company.checked, company.agreed,
                                         company.standards, company.approved};
            for (std::size_t row = 0; row < signers.size(); ++row) {
                QCOMPARE(signers[row].at(0), report::form::text(report::form::signers.at(row)));
                QCOMPARE(signers[row].at(1), QString::fromStdString(names[row]));
                QCOMPARE(signers[row].at(2), QString()); // signed by hand
            }
            QCOMPARE(signers.front().at(3),
                     QLocale().toString(today, report::form::text(report::form::dateFormat)));
            const auto caption = [](const char* of) { return report::form::text(of); };
            const QString all = signers[0].join(u'|') + u'|' + signers[2].join(u'|');
            for (const QString& cell :
                 {caption("Part designation") + QStringLiteral("7716-03.021"),
                  caption("Document number") + QStringLiteral("60141.00012"),
                  caption("Letter") + u'А', caption("Oper.") + QStringLiteral("045")}) {
                QVERIFY2(all.contains(cell), qPrintable(cell + u'\n' + all));
            }
            QCOMPARE(text.tables.at(2).front().size(),
                     qsizetype(report::form::operationRow.size()));
            QCOMPARE(text.tables.at(3).front().size(),
                     qsizetype(report::form::equipmentRow.size()));
            const QByteArray content = reading::unzipped(odt, "content.xml");
            QCOMPARE(content.count("<text:page-count"), 2);
            QVERIFY(content.contains("table:number-rows-spanned=\"3\""));
            QVERIFY(reading::unzipped(odt, "Pictures/logo1.png").startsWith("\x89PNG"));
            const QByteArray styles = reading::unzipped(odt, "styles.xml");
            for (const char* page : {"Form1", "Form1_Next", "Form2", "Form2_Next"}) {
                QVERIFY2(
                    styles.contains(QByteArray("<style:master-page style:name=\"") + page + '"'),
                    page);
            }
        }
    }

    void everyCellOfTheHeadHasItsInput() {
        m_language.apply(QStringLiteral("ru"));
        const report::Report card = cardOf(filledSetup(), filledCompany());
        const QString sheet = textOf(card.sheets.front());
        const QString page = reading::textOfHtml(bytesOf(card, Format::html));
        for (const char* cell :
             {"7716-03.021", "60141.00012", "045", "O1204", "2,25", "4,9", "Круг 50 ГОСТ 2590"}) {
            QVERIFY2(sheet.contains(QString::fromUtf8(cell)), cell);
            QVERIFY2(page.contains(QString::fromUtf8(cell)), cell);
        }
        const auto head = report::OperationCardReport::head(
            filledSetup(), operationCard(filledSetup(), runSetup(filledSetup())), filledCompany(),
            today);
        for (const QStringList& row : {head.operation, head.equipment}) {
            QVERIFY2(!row.contains(QString()), qPrintable(row.join(u'|')));
        }
        QCOMPARE(head.letter, QStringLiteral("А"));
    }

    void operationIsNamedByTheFormAndItsKindStandsInTheContent() {
        const auto transitionsOf = [](const Setup& setup) {
            const SetupRun run = runSetup(setup);
            QStringList texts;
            for (const CardRow& row : CardRows::of(operationCard(setup, run), setup, run)) {
                texts << row.text;
            }
            return texts.join(u'\n');
        };
        const Setup shaft = setupOf("spindle"), bore = setupOf("sleeve");
        QCOMPARE(CardRows::operation(shaft), QStringLiteral("Круглошлифовальная"));
        QCOMPARE(CardRows::operation(bore), QStringLiteral("Внутришлифовальная"));
        QVERIFY(transitionsOf(shaft).contains(QStringLiteral("Шлифовать поверхность 1")));
        const QString kind = bore.surfaces.front().project.operation->travels
                                 ? QStringLiteral(" с продольной подачей в размер ")
                                 : QStringLiteral(" с врезной подачей в размер ");
        const QString content = transitionsOf(bore);
        QVERIFY2(content.contains(QStringLiteral("Шлифовать отверстие 1"))
                     && content.contains(kind),
                 qPrintable(content));
    }

    void theWebPageHasTheRows() {
        const Setup setup = setupOf("sleeve");
        const SetupRun run = runSetup(setup);
        const QByteArray html = bytesOf(cardOf(setup), Format::html);
        const QString text = reading::textOfHtml(html);
        for (const CardRow& row : CardRows::of(operationCard(setup, run), setup, run)) {
            QVERIFY2(text.contains(QString(row.text).replace(QChar(0xa0), u' ')),
                     qPrintable(row.text));
        }
        QCOMPARE(html.count("<svg"), 1);
        QVERIFY(!html.contains("<td></td>") && !html.contains("<dd></dd>"));
    }

    void everyReportIsWrittenAsOdt() {
        const OutcomePtr outcome = exampleOutcome(ExamplesDialog::paths().front());
        for (const report::KindRow& kind : report::kinds()) {
            report::Subject subject;
            subject.outcome = outcome;
            subject.date = today;
            const OdtText text(
                reading::unzipped(bytesOf(kind.make(subject), Format::odt), "content.xml"));
            QVERIFY2(text.fault.isEmpty() && !text.tables.empty(), kind.key);
        }
    }

    void theHeadsHaveTheCompany() {
        Company company;
        company.name = "АО «Станкомаш»";
        company.approved = "Громов";
        company.logo = "no picture";
        report::Subject subject;
        subject.outcome = exampleOutcome(ExamplesDialog::paths().front());
        subject.date = today;
        subject.company = company;
        for (const report::KindRow& kind : report::kinds()) {
            if (kind.kind == report::Kind::handout) { // for a course, not for a shop
                continue;
            }
            const QString text = reading::textOf(bytesOf(kind.make(subject), Format::pdf));
            for (const std::string& given : {company.name, company.approved}) {
                QVERIFY2(text.contains(QString::fromStdString(given)), kind.key);
            }
        }
        QVERIFY(cardOf(setupOf("sleeve"), company).sheets.front().pictures.empty());
        QFile icon(QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/icons/sparkout.svg"));
        QVERIFY(icon.open(QIODevice::ReadOnly));
        company.logo = icon.readAll(); // of settings that an earlier version wrote
        QVERIFY(cardOf(setupOf("sleeve"), company).sheets.front().pictures.empty());
        for (const char* format : {"PNG", "JPG"}) {
            company.logo = samples::picture({160, 40}, format);
            QCOMPARE(cardOf(setupOf("sleeve"), company).sheets.front().pictures.size(), 1U);
        }
    }

    void theDateIsThatOfTheLanguage() {
        for (const auto& [language, date] :
             {std::pair("ru", "22.11.26"), std::pair("en", "22 Nov 26")}) {
            m_language.apply(QString::fromLatin1(language));
            QVERIFY(textOf(cardOf(setupOf("sleeve")).sheets.front())
                        .contains(QString::fromLatin1(date)));
        }
    }

    /// Deviations stand in millimetres with as many decimals; a zero is not written.
    void deviationsAreWrittenAsOnADrawing() {
        Part part;
        part.diameter_mm = 30;
        const auto written = [&](double upper, double lower) {
            part.upper_deviation_um = upper;
            part.lower_deviation_um = lower;
            const auto drawn = report::DrawnDimension::of(part);
            return QString(drawn.nominal + u' ' + drawn.upper + u' ' + drawn.lower);
        };
        QCOMPARE(written(0, -13), QStringLiteral("⌀30h6  −0,013"));
        QCOMPARE(written(0, -16), QStringLiteral("⌀30  −0,016"));
        QCOMPARE(written(15, 2), QStringLiteral("⌀30k6 +0,015 +0,002"));
        QCOMPARE(written(12.5, 2), QStringLiteral("⌀30 +0,0125 +0,0020"));
        QCOMPARE(written(10, -10), QStringLiteral("⌀30 ±0,010 "));
    }

    /// Surfaces cut their length out of the shaft; bores go through from end to end.
    void theOutlineIsThatOfThePart() {
        const report::PartOutline spindle(setupOf("spindle"));
        QCOMPARE(spindle.length_mm(), 320.0);
        QCOMPARE(spindle.largest_mm(), 48.0);
        QVERIFY(spindle.bores().empty());
        double at = 0;
        for (const report::OutlineStep& step : spindle.outer()) {
            QCOMPARE(step.from_mm, at);
            at = step.to_mm;
        }
        QCOMPARE(at, 320.0);
        const report::PartOutline sleeve(setupOf("sleeve"));
        QVERIFY(sleeve.isOuterKnown());
        at = 0;
        for (const report::OutlineStep& bore : sleeve.bores()) {
            QCOMPARE(bore.from_mm, at);
            at = bore.to_mm;
        }
        QCOMPARE(at, sleeve.length_mm());
        QCOMPARE(sleeve.ground().size(), 3U);
        QVERIFY(std::ranges::all_of(sleeve.ground(), &report::GroundStep::isBore));
    }

private:
    Language m_language;
};

} // namespace sparkout::test_card_sheets

SPARKOUT_TEST(test_card_sheets, TestCardSheets)
#include "test_card_sheets.moc"
