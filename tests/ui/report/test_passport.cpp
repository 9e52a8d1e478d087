// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The accuracy passport: its numbers and verdict are those of the engine's own batch, and what it
// prints is enough to compute them again.
#include "core/batch/batch_statistics.h"
#include "core/batch/scenario_source.h"
#include "core/measured/adequacy.h"
#include "core/measured/hold_out.h"
#include "core/project/member.h"
#include "core/setup/setup_file.h"
#include "core/study/batch_edits.h"
#include "core/study/whole_batch.h"
#include "tests/registry.h"
#include "tests/ui/support/passport_bench.h"
#include "tests/ui/support/traced_project.h"
#include "ui/kit/pdf_details.h"
#include "ui/measured/measured_text.h"
#include "ui/report/cycle_card.h"
#include "ui/session/project_io.h"
#include "ui/text/dressing_text.h"
#include "ui/text/field_text.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/views/study/batch_text.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace sparkout::test_passport {

using namespace passport_bench;

/// What the prediction says, in the present language.
Fitness fitness(const Project& project) {
    const QString text = textOfHtml(made(project, Format::html)).simplified();
    for (const Fitness found : {Fitness::unfit, Fitness::conditional, Fitness::fit}) {
        if (text.contains(QStringLiteral(" %1 Deciding result ").arg(BatchText::fitness(found)))) {
            return found;
        }
    }
    throw std::runtime_error("no verdict");
}

/// The row of a web page whose first cells are these.
QStringList rowOf(const QList<QStringList>& rows, const QStringList& first) {
    for (const QStringList& row : rows) {
        if (row.mid(0, first.size()) == first) {
            return row;
        }
    }
    return {};
}

/// A printed number, or NaN.
double numberOf(const QString& text) {
    return parseNumber(text).value_or(std::nan(""));
}

/// As printed, to half of its last digit; a little as less than the last digit, an estimate with
/// one digit.
bool isRounded(QString printed, double value) {
    printed.replace(QChar(0x00a0), u' ');
    if (printed.startsWith(QStringLiteral("< "))) {
        return value > 0 && value < 0.5 * numberOf(printed.mid(2));
    }
    if (printed.startsWith(QStringLiteral("≈ "))) {
        const double stated = numberOf(printed.mid(2));
        return std::abs(stated - value) <= 0.5 * std::pow(10.0, std::floor(std::log10(value)));
    }
    const qsizetype at = printed.indexOf(QLocale().decimalPoint());
    const auto decimals = at < 0 ? 0 : double(printed.size() - at - 1);
    return std::abs(numberOf(printed) - value) <= 0.5 * std::pow(10.0, -decimals) + 1e-9;
}

class TestPassport : public QObject {
    Q_OBJECT

private slots:
    void init() { m_language.apply(QStringLiteral("en")); }
    void itsNumbersAreThoseOfTheEnginesBatch_data() { addLanguages(); }
    void itsNumbersAreThoseOfTheEnginesBatch() {
        QFETCH(QString, language);
        m_language.apply(language);
        const Project project = example("30h6-factory");
        const BatchResult result = runBatch(project, {}); // apart from the window's road
        const BatchSummary summary = summarise(result);
        QCOMPARE(summary.parts, std::int64_t{50});
        const QList<QStringList> rows = rowsOfHtml(made(project, Format::html));
        for (const CharacteristicSummary& of : summary.characteristics) {
            const QStringList row =
                rowOf(rows, {BatchText::full(of.characteristic), unitText(of.characteristic.unit)});
            QCOMPARE(row.size(), 9);
            const std::array expected{of.least.value, of.moments.mean, of.most.value,
                                      of.moments.deviation};
            for (std::size_t i = 0; i < expected.size(); ++i) {
                const QString& cell = row[4 + qsizetype(i)];
                QVERIFY2(isRounded(cell.section(u'…', 0, 0), expected[i]),
                         qPrintable(row.join(u' ')));
                QCOMPARE(cell, i + 1 < expected.size()
                                   ? BatchText::value(expected[i], of.characteristic)
                                   : BatchText::scatter(expected[i], of.characteristic));
                QCOMPARE(cell.contains(u'…'), of.characteristic.isEstimate); // a range
                const bool isSize =
                    !of.characteristic.requirement || of.characteristic.requirement->isDeviation;
                QVERIFY2(isSize || expected[i] < 1e-9 || numberOf(cell) != 0,
                         qPrintable(row.join(u' ')));
            }
            const bool limited = of.characteristic.low || of.characteristic.high;
            QCOMPARE(row[2] == u"–", !limited);
        }
        QVERIFY(textOf(made(project, Format::pdf))
                    .contains(BatchText::share(summary.bad).replace(QChar(0x00a0), u' ')));
    }

    /// Every number of the appendix reads back to that of the project, and a number that is not
    /// there makes no other batch.
    void whatItPrintsIsEnoughToComputeItAgain() {
        Project project = smallBatch();
        project.batch->parts = 3;
        const QList<QStringList> rows = rowsOfHtml(made(project, Format::html));
        const BatchResult before = runBatch(project, {});
        int printed = 0, silent = 0;
        for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
            const std::optional<double> number = singleNumberIn(*leaf.field, leaf.owner);
            const QStringList row = rowOf(rows, {locationText(leaf.path)});
            if (number && !row.isEmpty()) {
                QCOMPARE(numberOf(row[1]), *number);
                ++printed;
                continue;
            }
            Project other = project;
            const Member member = findMember(other, leaf.path);
            if (!row.isEmpty() || !number || !member
                || leaf.field->kind == sparkout::Kind::objectList) {
                continue;
            }
            setNumberIn(*member.field, member.owner, *number + 1);
            const BatchOutcomePtr again = runWholeBatch(other, {});
            if (again->ran()) {
                QVERIFY2(again->result.statistics == before.statistics, leaf.path.c_str());
                ++silent;
            }
        }
        QVERIFY2(printed > 30 && silent > 0, qPrintable(QString::number(printed)));
        Project other = project;
        other.batch->seed += 1;
        QVERIFY(!(runBatch(other, {}).statistics == before.statistics));
        QVERIFY(!rowOf(rows, {locationText("/batch/seed"), QStringLiteral("1")}).isEmpty());
    }

    void theVerdictTurnsWithATolerance_data() {
        addColumns<double, bool>("tolerance_um", "good");
        QTest::newRow("wide") << 20.0 << true;
        QTest::newRow("narrow") << 0.5 << false;
    }
    void theVerdictTurnsWithATolerance() {
        QFETCH(double, tolerance_um);
        QFETCH(bool, good);
        Project project = smallBatch();
        project.part->upper_deviation_um = 40;
        project.part->lower_deviation_um = -40;
        project.machine->geometric_runout_um = 1;
        project.part->tolerance.radial_runout_um = tolerance_um;
        QVERIFY(fitness(project) == (good ? Fitness::fit : Fitness::unfit));
        project.batch.reset(); // nothing is known of the scatter
        QVERIFY(fitness(project) == (good ? Fitness::conditional : Fitness::unfit));
    }

    void aLowBoundOfPpkMakesItConditional_data() { addLanguages(); }
    void aLowBoundOfPpkMakesItConditional() {
        QFETCH(QString, language);
        m_language.apply(language);
        Project project = smallBatch();
        project.part->upper_deviation_um = 40;
        project.part->lower_deviation_um = -40;
        const BatchSummary summary = summarise(runBatch(project, {}));
        QCOMPARE(summary.bad.count, std::int64_t{0});
        const BatchVerdict verdict = weigh(summary, runBatch(project, {}));
        QVERIFY(verdict.fitness == Fitness::fit && verdict.characteristic);
        project.batch->least_ppk = verdict.value + 0.01;
        const QString text = textOfHtml(made(project, Format::html));
        QVERIFY(text.contains(language == u"ru" ? QStringLiteral(" условно годен ")
                                                : QStringLiteral("is conditionally fit")));
        const CharacteristicSummary& of = summary.characteristics[*verdict.characteristic];
        QVERIFY(text.contains(BatchText::full(of.characteristic)));
        QVERIFY(text.contains(BatchText::capability(of.ppk)));
        QVERIFY(text.contains(Names::significant(project.batch->least_ppk)));
    }

    /// Of a part of several surfaces: the one that is meant, and a command that runs.
    void theSurfaceIsNamed() {
        Setup setup = plainSetup(smallBatch());
        setup.surfaces.push_back(setup.surfaces.front());
        setup.surfaces[0].name = "journal";
        setup.surfaces[1].name = "bearing seat";
        report::Subject subject = subjectOf(smallBatch());
        report::nameSurface(subject, setup, 1);
        for (const report::Kind kind : {report::Kind::passport, report::Kind::card}) {
            const report::Report made = report::rowOf(kind).make(subject);
            QVERIFY2(made.subject.contains(QStringLiteral("2 (bearing seat)")),
                     qPrintable(made.subject));
            const QString text = textOfHtml(bytesOf(made, Format::html));
            QVERIFY(text.contains(QStringLiteral("2 (bearing seat)")));
            QCOMPARE(text.contains(QStringLiteral("part.sparkout\" --surface 2 -o")),
                     kind == report::Kind::passport);
            const auto attached =
                attachmentOf(bytesOf(made, Format::pdf), QStringLiteral(".sparkout"), 1'000'000);
            QVERIFY(attached.has_value());
            QCOMPARE(attached->name, QStringLiteral("part.sparkout"));
            const LoadedProject part = parseProject(attached->data.toStdString());
            QVERIFY(part.setup && sameSetup(*part.setup, setup)); // all of the part
        }
        setup.surfaces[0].name = "2"; // the number is a name: the surface's own has to do
        report::nameSurface(subject, setup, 1);
        QCOMPARE(subject.surfaceOption, QStringLiteral("\"bearing seat\""));
        report::Subject alone = subjectOf(smallBatch());
        report::nameSurface(alone, plainSetup(smallBatch()), 0);
        QVERIFY(alone.surface.isEmpty() && alone.surfaceOption.isEmpty());
    }

    /// What the papers and the window say of a cycle is one sentence.
    void theHeadlineIsThatOfTheWindow_data() { addLanguages(); }
    void theHeadlineIsThatOfTheWindow() {
        QFETCH(QString, language);
        m_language.apply(language);
        const Project project = smallBatch();
        const report::Subject subject = subjectOf(project);
        const auto plain = [](QString text) {
            return text.replace(QChar(0x00a0), u' ').simplified();
        };
        const QString headline =
            plain(JudgementText::headline(judgementOf(*subject.outcome, subject.batch.get())));
        QVERIFY(plain(textOfHtml(made(project, Format::html))).contains(headline));
        const report::Report card =
            report::CycleCard::write(subject.outcome, subject.file, day, subject.batch);
        QVERIFY(plain(textOfHtml(bytesOf(card, Format::html))).contains(headline));
    }

    void theWorstPartIsTheOneOfItsFactors_data() {
        QTest::addColumn<int>("parts");
        QTest::newRow("many") << 24;
        QTest::newRow("one") << 1;
    }
    void theWorstPartIsTheOneOfItsFactors() {
        QFETCH(int, parts);
        Project project = smallBatch();
        project.batch->parts = parts;
        project.batch->factors.compliance.emplace().uniform = {0.8, 1.2};
        const BatchResult result = runBatch(project, {});
        const std::int64_t worst = summarise(result).worstPart;
        QVERIFY(worst >= 0 && worst < parts);
        const ScenarioSource source(project);
        if (parts > 1) { // else the test would not tell it from the first part
            QVERIFY(worst > 0);
        }
        const QString text = textOfHtml(made(project, Format::html));
        const qsizetype at =
            text.indexOf(QStringLiteral("number %1 has the minimum").arg(worst + 1));
        QVERIFY(at >= 0);
        const QString there = text.mid(at, 800);
        const std::vector<double> values = source.values(worst);
        QCOMPARE(values.size(), std::size_t{3});
        for (const double value : values) {
            QVERIFY2(there.contains(Names::significant(value, 6)), qPrintable(there));
        }
    }

    void withoutABatchItSaysSoAndTellsTheNominalPart_data() { addLanguages(); }
    void withoutABatchItSaysSoAndTellsTheNominalPart() {
        QFETCH(QString, language);
        m_language.apply(language);
        Project project = smallBatch();
        project.batch.reset();
        const QByteArray html = made(project, Format::html);
        QVERIFY(textOfHtml(html).contains(language == u"ru"
                                              ? QStringLiteral("не описана партия")
                                              : QStringLiteral("describes no batch")));
        QVERIFY(!textOfHtml(html).contains(QStringLiteral("Ppk (")));
        PartOutcome part;
        const std::vector<Characteristic> all = characteristicsOf(project);
        measure(fixtures::run(project)->result, all, part);
        const QList<QStringList> rows = rowsOfHtml(html);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const QStringList row = rowOf(rows, {BatchText::full(all[i]), unitText(all[i].unit)});
            QVERIFY2(row.size() == 4 && isRounded(row[3], part.values[i]), all[i].name);
        }
    }

    void measuredPartsAreHeldAgainstTheBatch_data() { addLanguages(); }
    void measuredPartsAreHeldAgainstTheBatch() {
        QFETCH(QString, language);
        m_language.apply(language);
        Project project = smallBatch();
        Measured& measured = project.measured.emplace();
        for (int i = 0; i < 10; ++i) {
            MeasuredPart part;
            part.part = std::to_string(i + 1);
            part.place = 1;
            part.diameters_mm = {project.part->diameter_mm + 0.2 + i * 0.001};
            measured.parts.push_back(std::move(part));
        }
        report::Subject subject = subjectOf(project);
        subject.predicting = runWholeBatch(predictingProject(project), {});
        const QByteArray html = bytesOf(report::passport(subject), Format::html);
        QVERIFY(textOfHtml(html).contains(language == u"ru"
                                              ? QStringLiteral("Измеренные детали и прогноз")
                                              : QStringLiteral("Measured parts against")));
        const std::vector<AdequacyRow> rows = judgeAdequacy(project, subject.predicting->result);
        QCOMPARE(rows.size(), 1U);
        const QStringList row =
            rowOf(rowsOfHtml(html), {MeasuredText::name(project, rows.front().measured)});
        QCOMPARE(row.value(1), MeasuredText::briefVerdict(rows.front().verdict));
        QCOMPARE(row.value(2), QStringLiteral("10"));
        QCOMPARE(row.value(3), MeasuredText::mean(rows.front()));
        subject.predicting.reset(); // nothing was predicted: nothing is said
        QVERIFY(rowOf(rowsOfHtml(bytesOf(report::passport(subject), Format::html)),
                      {MeasuredText::name(project, rows.front().measured)})
                    .isEmpty());
    }

    void aCycleThatTheCalibrationHasNotUsedIsPredicted_data() { addLanguages(); }
    void aCycleThatTheCalibrationHasNotUsedIsPredicted() {
        QFETCH(QString, language);
        m_language.apply(language);
        const Project project = traced::heldOut();
        const QStringList sentences = MeasuredText::holdOut(project, holdOut(project));
        QCOMPARE(sentences.size(), 1);
        QVERIFY2(sentences.front().contains(QStringLiteral("second.csv")),
                 qPrintable(sentences.front()));
        const auto says = [&](const Project& of) {
            report::Subject subject;
            subject.outcome = fixtures::run(of);
            subject.date = day;
            const std::vector<report::Block> blocks = report::passport(subject).blocks;
            return std::ranges::any_of(blocks, [&sentences](const report::Block& block) {
                const auto* paragraph = std::get_if<report::Paragraph>(&block);
                return paragraph && paragraph->text == sentences.front();
            });
        };
        QVERIFY(says(project));
        Project used = project;
        used.measured->calibrations.front().data = "second.csv";
        QVERIFY(!says(used));
    }

    void theIntervalBetweenDressingsIsStated_data() { addLanguages(); }
    void theIntervalBetweenDressingsIsStated() {
        QFETCH(QString, language);
        m_language.apply(language);
        const Project project = smallBatch();
        report::Subject subject = subjectOf(project);
        Setup setup = plainSetup(project);
        QVERIFY(!report::dressingOf(setup));
        setup.wear.dulling_per_mm2 = 1e-5;
        subject.dressing = report::dressingOf(setup);
        const QByteArray html = bytesOf(report::passport(subject), Format::html);
        const QString text = textOfHtml(html).simplified();
        for (const auto& [name, value] : DressingText::facts(setup, dressingInterval(setup))) {
            QVERIFY2(text.contains(name) && text.contains(value.simplified()), qPrintable(value));
        }
        subject.dressing.reset();
        QVERIFY(!bytesOf(report::passport(subject), Format::html)
                     .contains(DressingText::tr("Parts per dressing").toUtf8()));
    }

private:
    Language m_language;
};

} // namespace sparkout::test_passport

SPARKOUT_TEST(test_passport, TestPassport)
#include "test_passport.moc"
