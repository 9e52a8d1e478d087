// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The numbers of the reports, straight from their tables and figures: those of the outcome, each at
// its own place.
#include "core/project/machine.h"
#include "core/quality/result_json.h"
#include "core/quality/result_names.h"
#include "core/study/profile_series.h"
#include "tests/registry.h"
#include "tests/ui/support/passport_bench.h"
#include "ui/report/cell_text.h"
#include "ui/report/cycle_card.h"
#include "ui/report/passport.h"
#include "ui/report/passport_sections.h"
#include "ui/results/result_tables.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/views/part/profiles_text.h"
#include "ui/views/study/batch_text.h"

#include <nlohmann/json.hpp>

#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace sparkout::test_report_numbers {

using namespace passport_bench;
using report::CycleCard;
using report::PassportPrediction;
using report::PassportVerdict;

ConstraintResult requirement(ConstraintKind kind, int section, double value) {
    ConstraintResult made{kind};
    made.section = section;
    made.value = value;
    made.limit = 10;
    made.margin = 10 - value;
    made.relativeMargin = made.margin / made.limit;
    made.holds = true;
    return made;
}

/// Every zone with deviations and a roughness of its own.
Outcome unlikeZones() {
    Outcome outcome = *fixtures::run(fixtures::traverseProject());
    outcome.constraints.clear();
    outcome.result.project.wheel->roughness_factor = 2; // calibrated
    auto& sections = outcome.result.sections;
    for (std::size_t i = sections.size(); i-- > 0;) { // the last zone's requirement stands first
        const double own = 1 + double(i);
        sections[i].diameterDeviationMin_mm = -0.001 * own;
        sections[i].diameterDeviationMax_mm = 0.002 * own;
        outcome.constraints.push_back(
            requirement(ConstraintKind::roughness, static_cast<int>(i), 0.1 * own));
    }
    return outcome;
}

/// The first characteristics of a shaft with such Ppk, one number each.
BatchSummary summaryWith(const std::vector<double>& ppk) {
    const std::vector<Characteristic> all = characteristicsOf(fixtures::traverseProject());
    BatchSummary summary;
    summary.parts = 50;
    for (std::size_t i = 0; i < ppk.size(); ++i) {
        CharacteristicSummary of;
        of.characteristic = all.at(i);
        of.count = summary.parts;
        of.ppk = Estimate{ppk[i], {ppk[i] - 0.2, ppk[i] + 0.2}};
        summary.characteristics.push_back(of);
    }
    return summary;
}

class TestReportNumbers : public QObject {
    Q_OBJECT

private slots:
    void init() { m_language.apply(QStringLiteral("en")); }
    void aWheelThatOtherSurfacesWoreIsGivenInAFewDigits() {
        const QLocale before;
        QLocale::setDefault(QLocale::c());
        Project project = fixtures::traverseProject();
        project.wheel->dullness = 0.015010761285053022;
        const QString dullness = report::inputFact(project, "/wheel/dullness").second;
        QStringList all;
        for (const QStringList& row : report::PassportInputs::inputs(project).rows) {
            all += row.at(1);
        }
        QLocale::setDefault(before);
        QCOMPARE(dullness, QStringLiteral("0.0150108"));
        QVERIFY(all.contains(QStringLiteral("0.0150107613")));
    }

    void theCardGivesEachZoneItsOwnDeviationsAndRoughness() {
        const Outcome outcome = unlikeZones();
        const report::Table table = CycleCard::accuracy(outcome);
        QCOMPARE(table.head.value(2), QStringLiteral("Minimum deviation, µm"));
        QCOMPARE(table.head.value(3), QStringLiteral("Maximum deviation, µm"));
        QCOMPARE(table.head.last(), QStringLiteral("Ra, µm"));
        QCOMPARE(table.rows.size(), std::size_t{3});
        for (std::size_t i = 0; i < table.rows.size(); ++i) {
            const double own = 1 + double(i);
            QCOMPARE(table.rows[i].size(), table.head.size());
            QCOMPARE(table.rows[i][2], Names::signedMicrometres(-1 * own));
            QCOMPARE(table.rows[i][3], Names::signedMicrometres(2 * own));
            QCOMPARE(table.rows[i].last(), Names::micrometres(0.1 * own));
        }
    }

    void zonesOfSeveralSectionsStateTheirForm() {
        Project project = fixtures::traverseProject();
        QVERIFY(CycleCard::zoneForms(*fixtures::run(project)).rows.empty());
        QVERIFY(!zoneTable(*fixtures::run(project)).header.contains(QStringLiteral("Taper, µm")));
        project.zone_sections = 5;
        const OutcomePtr outcome = fixtures::run(project);
        const report::Table card = CycleCard::zoneForms(*outcome);
        const CsvTable table = zoneTable(*outcome);
        const qsizetype first =
            table.header.indexOf(QStringLiteral("Cylindricity, minimum zone, µm"));
        QVERIFY(first > 0);
        ProfileSeries series = makeProfileSeries(outcome->result, outcome->trajectory);
        series.zoneForms = outcome->accuracy.zones;
        QCOMPARE(card.rows.size(), std::size_t{3});
        for (std::size_t i = 0; i < card.rows.size(); ++i) {
            const ZoneForm& zone = outcome->accuracy.zones.at(i);
            const double forms_um[] = {zone.cylindricity_mm * 1000, zone.totalRunout_mm * 1000,
                                       zone.profile.taper_mm * 1000, zone.profile.crown_mm * 1000};
            QVERIFY(forms_um[0] > 0);
            QCOMPARE(card.rows[i][1], Names::formAmount(forms_um[0], false)); // no machine's form
            QCOMPARE(card.rows[i][2], Names::formAmount(forms_um[1], false));
            QCOMPARE(card.rows[i][3], Names::signedMicrometres(forms_um[2]));
            QCOMPARE(card.rows[i][4], Names::signedMicrometres(forms_um[3]));
            for (std::size_t k = 0; k < std::size(forms_um); ++k) {
                QCOMPARE(std::get<double>(table.rows[i].at(static_cast<std::size_t>(first) + k)),
                         forms_um[k]);
            }
            const QString words = ProfilesText::stretch(series, series.profiles[i], false);
            QVERIFY2(words.contains(QStringLiteral("cylindricity %1 µm, total runout %2 µm")
                                        .arg(card.rows[i][1], card.rows[i][2])),
                     qPrintable(words));
        }
    }

    /// The table of zones has the numbers of the file, where the number of lobes is not known, too.
    void zonesHaveTheNumbersOfTheFile() {
        Project project = fixtures::traverseProject();
        project.part->tolerance.roughness_ra_um = 2;
        project.machine->geometric_runout_um = 0;
        project.machine->form = MachineForm{std::vector<double>(3, 1.0), {}, {}, {}};
        const OutcomePtr outcome = fixtures::run(project);
        const CsvTable table = zoneTable(*outcome);
        const auto zones = nlohmann::json::parse(resultJson(outcome->result, {})).at("zones");
        const std::vector<std::pair<QString, const char*>> columns{
            {QStringLiteral("From the headstock end, mm"), "/position_mm"},
            {QStringLiteral("Compliance, mm/N"), "/compliance_mm_per_n"},
            {QStringLiteral("Minimum diameter from nominal, µm"), "/diameter_deviation_um/0"},
            {QStringLiteral("Maximum diameter from nominal, µm"), "/diameter_deviation_um/1"},
            {QStringLiteral("Radial runout, µm, machine not known"), "/radial_runout_um"},
            {QStringLiteral("Roundness, minimum zone, µm"), "/roundness_um"},
            {QStringLiteral("Roundness, least squares, µm"), "/roundness_least_squares_um"},
            {QStringLiteral("Maximum normal force, N"), "/peak_normal_force_n"},
            {QStringLiteral("Roughness Ra, µm"), "/roughness_ra_um"},
            {QStringLiteral("Maximum roughness Ra of the estimate, µm"), "/roughness_ra_most_um"},
            {QStringLiteral("Minimum diameter with even lobes, from nominal, µm"),
             "/diameter_deviation_even_lobes_um/0"},
            {QStringLiteral("Maximum diameter with even lobes, from nominal, µm"),
             "/diameter_deviation_even_lobes_um/1"}};
        QCOMPARE(table.header.size(), qsizetype(columns.size()) + 1);
        for (std::size_t i = 0; i < table.rows.size(); ++i) {
            const auto& zone = zones.at(zoneKey(outcome->result.sections.at(i).zone));
            for (std::size_t c = 0; c < columns.size(); ++c) {
                const auto& [head, key] = columns[c];
                QCOMPARE(table.header.at(qsizetype(c) + 1), head);
                QCOMPARE(std::get<double>(table.rows[i].at(c + 1)),
                         zone.at(nlohmann::json::json_pointer(key)).get<double>());
            }
        }
    }

    void aLittleIsNotWrittenAsNothing() {
        const QString space(QChar(0x00a0));
        QCOMPARE(Names::amountFixed(0.00056, 2), u'<' + space + QStringLiteral("0.01"));
        QCOMPARE(Names::amountFixed(0.0051, 2), QStringLiteral("0.01"));
        QCOMPARE(Names::amountFixed(0, 2), QStringLiteral("0.00"));
        QCOMPARE(Names::amountFixed(1e-13, 2), QStringLiteral("0.00")); // rounding of the engine's
        ConstraintResult round = requirement(ConstraintKind::roundness, 0, 0.002);
        round.isWhole = true;
        QCOMPARE(Names::value(round), u'<' + space + QStringLiteral("0.01"));
    }

    /// Below "machine not known" stands at least what the process leaves, or a dash: never 0.00.
    void theCardHasNoBareNumberWhereTheMachineIsNotKnown() {
        Project project = fixtures::traverseProject();
        project.zone_sections = 5;
        Outcome outcome = *fixtures::run(project);
        const double runouts_mm[] = {0, 2e-6, 5.4e-4};
        for (std::size_t i = 0; i < std::size(runouts_mm); ++i) {
            outcome.result.sections.at(i).radialRunout_mm = runouts_mm[i];
            outcome.accuracy.sections.at(i).minimumZone = {};
            outcome.accuracy.sections.at(i).minimumZone.outer_mm = runouts_mm[i];
            outcome.accuracy.zones.at(i).cylindricity_mm = runouts_mm[i];
            outcome.accuracy.zones.at(i).totalRunout_mm = runouts_mm[i];
        }
        const auto column = [](const report::Table& table, qsizetype at) {
            QStringList cells;
            for (const QStringList& row : table.rows) {
                cells << row.at(at);
            }
            return cells;
        };
        const QStringList bounds{QStringLiteral("–"), QStringLiteral("–"),
                                 QStringLiteral("≥ 0.54")};
        const QStringList exact{QStringLiteral("0.00"), QStringLiteral("<\u00a00.01"),
                                QStringLiteral("0.54")};
        QCOMPARE(column(CycleCard::accuracy(outcome), 4), bounds); // runout
        QCOMPARE(column(CycleCard::accuracy(outcome), 5), bounds); // roundness
        QCOMPARE(column(CycleCard::zoneForms(outcome), 1), bounds);
        QCOMPARE(column(CycleCard::zoneForms(outcome), 2), bounds);
        outcome.result.project.machine->geometric_runout_um = 1; // tells the runout alone
        QCOMPARE(column(CycleCard::accuracy(outcome), 4), exact);
        QCOMPARE(column(CycleCard::accuracy(outcome), 5), bounds);
        QCOMPARE(column(CycleCard::zoneForms(outcome), 1), bounds);
        QCOMPARE(column(CycleCard::zoneForms(outcome), 2), exact);
    }

    void theProfilesHaveNoneEither() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        ProfileSeries series = makeProfileSeries(outcome->result, outcome->trajectory);
        Profile& profile = series.profiles.front();
        const auto says = [&](bool brief, const char* text) {
            const QString said = ProfilesText::numbers(series, profile, brief);
            return said.contains(QString::fromUtf8(text));
        };
        profile.radialRunout_mm = 0;
        QVERIFY(says(true, "runout – µm"));
        QVERIFY(says(false, "Radial runout – µm, machine not known"));
        profile.radialRunout_mm = 5.4e-4;
        QVERIFY(says(true, "runout ≥ 0.54 µm"));
        QVERIFY(says(false, "Radial runout ≥ 0.540 µm, machine not known"));
        series.knowsRunout = true;
        QVERIFY(says(true, "runout 0.54 µm"));
    }

    /// An eccentricity is stated as roundness is; a runout without a form gives none.
    void anEccentricityWithoutTheMachinesIsALowerBound() {
        using Text = ProfilesText;
        RoundnessZone circle;
        QCOMPARE(Text::roundness(circle, true, false, false), QStringLiteral("RONt –, e – µm"));
        QCOMPARE(Text::roundness(circle, true, true, true), QStringLiteral("RONt 0.00, e 0.00 µm"));
        circle.outer_mm = 1.2e-3;
        circle.x_mm = 3e-4;
        circle.y_mm = -4e-4;
        QCOMPARE(Text::roundness(circle, true, false, true),
                 QStringLiteral("RONt ≥ 1.20, e 0.50 µm"));
        QCOMPARE(Text::roundness(circle, false, true, false),
                 QStringLiteral("RONt 1.200 µm, eccentricity ≥ 0.500 µm, machine not known"));
        Machine machine;
        machine.geometric_runout_um = 1;
        QVERIFY(!isEccentricityKnown(machine));
        machine.form.emplace().roundness_um = {1, 1, 1};
        QVERIFY(!isEccentricityKnown(machine));
        machine.form->runout_um = {2, 2, 2};
        QVERIFY(isEccentricityKnown(machine));
    }

    void theSpectrumStatesAmplitudesWithoutTheMachinesAsLowerBounds() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        ProfileSeries series = makeProfileSeries(outcome->result, outcome->trajectory);
        series.profiles.front().radii_mm = series.blank_mm; // an ellipse
        QVERIFY(!series.knowsEccentricity && !series.knowsRoundness);
        const auto says = [&series](double undulations, const char* text) {
            const ChartGrid grid = SpectrumCharts::of(series, {0}, false, {});
            const QString said = grid.cells.front().placeText(undulations);
            return said.contains(QStringLiteral("amplitude ") + QString::fromUtf8(text));
        };
        QVERIFY(says(1, "– µm") && says(2, "≥ "));
        series.knowsEccentricity = true;
        QVERIFY(!says(1, "– µm") && says(2, "≥ "));
        series.knowsRoundness = true;
        QVERIFY(!says(2, "≥ "));
    }

    void aZoneWithoutARoughnessHasADash() {
        Outcome outcome = unlikeZones();
        std::erase_if(outcome.constraints,
                      [](const ConstraintResult& c) { return c.section == 1; });
        const report::Table table = CycleCard::accuracy(outcome);
        QCOMPARE(table.rows.at(0).last(), Names::micrometres(0.1));
        QCOMPARE(table.rows.at(1).last(), QStringLiteral("–"));
        QCOMPARE(table.rows.at(2).last(), Names::micrometres(0.3));
    }

    /// A roughness that is not calibrated is a range of one digit that says so: never 0.00.
    void anUncalibratedRoughnessIsAnEstimate() {
        for (const char* language : {"en", "ru"}) {
            m_language.apply(QString::fromLatin1(language));
            const QString said = language == std::string_view("en")
                                     ? QStringLiteral("not calibrated")
                                     : QStringLiteral("не откалибровано");
            Outcome outcome = unlikeZones();
            outcome.constraints = {requirement(ConstraintKind::roughness, 0, 0.0046),
                                   requirement(ConstraintKind::roughness, 1, 0.274)};
            outcome.result.project.wheel->roughness_factor = 1;
            for (ConstraintResult& each : outcome.constraints) {
                each.mostValue = 3 * each.value;
                each.limit = each.value * 2;
            }
            const QString point = QLocale().decimalPoint();
            const QString range = u'0' + point + QStringLiteral("3…0") + point + u'8';
            for (const report::Table& table :
                 {CycleCard::requirements(outcome), PassportPrediction::requirements(outcome)}) {
                QCOMPARE(table.rows.at(0).value(3),
                         u'0' + point + QStringLiteral("005…0") + point + QStringLiteral("014"));
                QCOMPARE(table.rows.at(1).value(3), range);
                for (const QStringList& row : table.rows) {
                    QCOMPARE(row.value(5), QStringLiteral("–"));
                    QVERIFY2(row.last().contains(said), qPrintable(row.last()));
                }
            }
            const report::Table accuracy = CycleCard::accuracy(outcome);
            QVERIFY2(accuracy.head.last().contains(said), qPrintable(accuracy.head.last()));
            QCOMPARE(accuracy.rows.at(1).last(), range);
            outcome.result.project.wheel->roughness_factor = 1.8;
            for (ConstraintResult& each : outcome.constraints) {
                each.mostValue.reset();
            }
            QVERIFY(!CycleCard::accuracy(outcome).head.last().contains(said));
            QCOMPARE(CycleCard::requirements(outcome).rows.at(1).value(3),
                     u'0' + point + QStringLiteral("27"));
        }
    }

    void onlyDeviationsAmongTheRequirementsHaveASign() {
        Outcome outcome = unlikeZones();
        outcome.constraints = {requirement(ConstraintKind::diameterMin, 0, 1.25),
                               requirement(ConstraintKind::diameterMax, 0, 3.5),
                               requirement(ConstraintKind::radialRunout, 0, 2.75)};
        for (const report::Table& table :
             {CycleCard::requirements(outcome), PassportPrediction::requirements(outcome)}) {
            QCOMPARE(table.head.value(2), QStringLiteral("Unit")); // not beside a margin as a ratio
            QCOMPARE(table.head.value(3), QStringLiteral("Value"));
            QCOMPARE(table.rows.at(0).value(3), QStringLiteral("+1.25"));
            QCOMPARE(table.rows.at(1).value(3), QStringLiteral("+3.50"));
            QCOMPARE(table.rows.at(2).value(3), QStringLiteral("2.75"));
        }
    }

    void theLeastPpkIsThatOfTheLeastCapable() {
        BatchSummary summary = summaryWith({1.5, 0.9, 1.2});
        QCOMPARE(PassportVerdict::leastCapable(summary), &summary.characteristics[1]);
        summary.characteristics[1].ppk.reset(); // not limited
        QCOMPARE(PassportVerdict::leastCapable(summary), &summary.characteristics[2]);
        for (CharacteristicSummary& of : summary.characteristics) {
            of.ppk.reset();
        }
        QVERIFY(!PassportVerdict::leastCapable(summary));
    }

    /// What rejects most parts decides; without rejects the least Ppk does.
    void theCharacteristicOfMostRejectsDecides() {
        BatchSummary summary = summaryWith({1.5, 1.4, 0.9});
        QCOMPARE(PassportVerdict::deciding(summary), &summary.characteristics[2]);
        summary.characteristics[0].outside.count = 1;
        summary.characteristics[1].outside.count = 3;
        summary.characteristics[2].outside.count = 2;
        QCOMPARE(PassportVerdict::deciding(summary), &summary.characteristics[1]);
    }

    void theCapabilityChartBeginsWithTheLeastPpk() {
        const BatchSummary summary = summaryWith({1.5, 0.9, 1.2});
        const std::optional<report::Figure> chart = report::CapabilityChart::figure(summary);
        QVERIFY(chart.has_value());
        QStringList expected;
        for (const std::size_t i : {1, 2, 0}) {
            const CharacteristicSummary& of = summary.characteristics[i];
            expected << QStringLiteral("%1: %2").arg(BatchText::full(of.characteristic),
                                                     BatchText::capability(of.ppk));
        }
        QCOMPARE(chart->description, expected.join(QStringLiteral("; ")));
    }

    void aLimitIsShownOnTheSideItStandsOn() {
        Project project = fixtures::traverseProject();
        project.part->tolerance.radial_runout_um = 6;
        const Outcome outcome = *fixtures::run(project);
        const std::vector<Characteristic> all = characteristicsOf(project);
        const report::Table table = PassportPrediction::nominal(outcome);
        QCOMPARE(table.head.value(2), QStringLiteral("Limits"));
        QCOMPARE(table.rows.size(), all.size());
        int above = 0, between = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const QString& shown = table.rows[i][2];
            if (all[i].low && all[i].high) {
                QCOMPARE(shown, printedNumber(*all[i].low) + QStringLiteral("…")
                                    + printedNumber(*all[i].high));
                ++between;
            } else if (all[i].high) {
                QCOMPARE(shown, QStringLiteral("≤ ") + printedNumber(*all[i].high));
                ++above;
            }
        }
        QVERIFY(above > 0 && between > 0);
    }

    /// The settings are those of every part: the worst one is told by what it was measured at.
    void theWorstPartsRequirementsAreWithoutSettings() {
        Project project = smallBatch();
        project.batch->parts = 2;
        report::Subject subject = subjectOf(project);
        auto worst = std::make_shared<Outcome>(*subject.worst);
        std::erase_if(worst->constraints, [](const ConstraintResult& c) {
            return requirementOf(c.kind).scope == ConstraintScope::setting;
        });
        subject.worst = worst;
        const auto tableOf = [&subject] {
            const std::vector<report::Block> blocks = PassportPrediction::worst(subject);
            return std::get<report::Table>(blocks.back());
        };
        const std::vector<QStringList> rows = tableOf().rows;
        QVERIFY(!rows.empty());
        worst->constraints.push_back(requirement(ConstraintKind::rangeWorkSpeed, -1, 5));
        worst->constraints.push_back(requirement(ConstraintKind::gaugeCommands, -1, 3));
        QCOMPARE(tableOf().rows, rows);
    }

private:
    Language m_language;
};

} // namespace sparkout::test_report_numbers

SPARKOUT_TEST(test_report_numbers, TestReportNumbers)
#include "test_report_numbers.moc"
