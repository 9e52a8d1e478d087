// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/worked_step.h"

#include "core/process/coupled_sections.h"
#include "core/process/force.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/member.h"
#include "core/project/part.h"
#include "core/project/project.h"
#include "core/quality/limit_series.h"
#include "core/quality/power.h"
#include "core/quality/roughness.h"
#include "core/quality/visit_sheet.h"
#include "core/simulation/progress.h"
#include "core/simulation/result.h"
#include "core/surface/burn.h"
#include "core/surface/cutting.h"
#include "core/surface/formula.h"
#include "core/units.h"
#include "ui/report/cell_text.h"
#include "ui/report/format/formula_writer.h"
#include "ui/report/operation_setup.h"
#include "ui/results/verdict_table.h"
#include "ui/text/example_texts.h"
#include "ui/text/field_text.h"
#include "ui/text/formula_text.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <utility>

namespace sparkout::report {

namespace {

/// The formulas of one step, each sheet with its sources and the symbols not yet explained.
class StepFormulas {
    Q_DECLARE_TR_FUNCTIONS(StepFormulas)
public:
    StepFormulas(const Project& project, const Place& at, Citations& citations,
                 std::optional<LeftOut> leftOut = {});
    void add(const FormulaSheet& sheet);
    void say(const QString& text) { m_blocks.emplace_back(Paragraph{text}); }
    void add(Block block) { m_blocks.push_back(std::move(block)); }
    [[nodiscard]] StepBlocks take() { return {std::move(m_blocks), std::move(m_symbols)}; }

private:
    void explain(const FormulaSheet& sheet);

    Place m_at;
    Citations& m_citations;
    FormulaWriter m_writer;
    std::set<QString> m_explained; ///< inputs, and symbols with their meanings
    std::set<QString> m_symbols;   ///< already explained symbols
    std::vector<Block> m_blocks;
};

/// The source of a formula: keys of core/SOURCES.md with the equations there.
struct FormulaSource {
    const char* key;
    const char* equations; ///< "25"; may be empty
};

// Sheets are identified by the engine's names.
constexpr const char *balanceName = "Elastic balance of one radius", *normalName = "Normal force",
                     *tangentialName = "Tangential force",
                     *burnName = "Limiting depth of cut, burn",
                     *roughnessName = "Limiting feed, roughness",
                     *sharpeningName = "Limiting depth of cut, self-sharpening";

struct Meaning {
    const char* symbol;
    const char* text;            ///< to be translated in the context "Symbol"
    const char* sheet = nullptr; ///< name of the sheet it applies to; null: all others
};

constexpr Meaning meanings[] = {
    {"D_e", QT_TRANSLATE_NOOP("Symbol", "equivalent diameter of wheel and part")},
    {"V_d", QT_TRANSLATE_NOOP("Symbol", "surface speed of the part")},
    {"n_c", QT_TRANSLATE_NOOP("Symbol", "cutting grains on a square millimetre of the contact")},
    {"b_j", QT_TRANSLATE_NOOP("Symbol", "width of the cut of one grain")},
    {"κ", QT_TRANSLATE_NOOP("Symbol", "chips of the grains over the metal removed")},
    {"η", QT_TRANSLATE_NOOP("Symbol", "dullness: share of wear flats")},
    {"k_s", QT_TRANSLATE_NOOP("Symbol", "normal force of shear, per width and depth")},
    {"k_r", QT_TRANSLATE_NOOP("Symbol", "normal force of the wear flats, per width and root of "
                                        "the depth")},
    {"k_t", QT_TRANSLATE_NOOP("Symbol", "tangential force of shear, per width and depth")},
    {"K", QT_TRANSLATE_NOOP("Symbol", "normal force beyond the threshold, per width and depth")},
    {"K_z0", QT_TRANSLATE_NOOP("Symbol", "tangential force per area of chip")},
    {"K_z", QT_TRANSLATE_NOOP("Symbol", "tangential force beyond friction, per width and depth")},
    {"h_0", QT_TRANSLATE_NOOP("Symbol", "lag up to which the wheel only rubs")},
    {"K_1", QT_TRANSLATE_NOOP("Symbol", "the sources' name of b·k_s with axial feed")},
    {"K_2", QT_TRANSLATE_NOOP("Symbol", "the sources' name of b·k_r with axial feed")},
    {"K_3", QT_TRANSLATE_NOOP("Symbol", "the sources' name of b·k_s in plunge")},
    {"K_4", QT_TRANSLATE_NOOP("Symbol", "the sources' name of b·k_r in plunge")},
    {"P_y", QT_TRANSLATE_NOOP("Symbol", "normal force")},
    {"P_z", QT_TRANSLATE_NOOP("Symbol", "tangential force")},
    {"a", QT_TRANSLATE_NOOP("Symbol", "limiting depth of cut"), burnName},
    {"a", QT_TRANSLATE_NOOP("Symbol", "limiting depth of cut"), roughnessName},
    {"a", QT_TRANSLATE_NOOP("Symbol", "limiting depth of cut"), sharpeningName},
    {"a", QT_TRANSLATE_NOOP("Symbol", "limiting depth of cut"),
     "Limiting depth of cut, wheel drive"},
    {"a", QT_TRANSLATE_NOOP("Symbol", "limiting depth of cut"),
     "Limiting depth of cut, work drive"},
    {"a", QT_TRANSLATE_NOOP("Symbol", "actual feed: the depth of this cut")},
    {"b", QT_TRANSLATE_NOOP("Symbol", "effective width of cut")},
    {"t_П", QT_TRANSLATE_NOOP("Symbol", "accumulated programmed feed, from the first touch on")},
    {"w", QT_TRANSLATE_NOOP("Symbol", "fourth root of the depth of cut")},
    {"R_max0", QT_TRANSLATE_NOOP("Symbol", "maximum radius of the blank")},
    {"R_min0", QT_TRANSLATE_NOOP("Symbol", "minimum radius of the blank")},
    {"R_k", QT_TRANSLATE_NOOP("Symbol", "radius k before the cut")},
    {"R_k′", QT_TRANSLATE_NOOP("Symbol", "radius k after the cut")},
    {"R_t", QT_TRANSLATE_NOOP("Symbol", "target radius")},
    {"Π_k", QT_TRANSLATE_NOOP("Symbol", "stock left at radius k")},
    {"h", QT_TRANSLATE_NOOP("Symbol", "stock left below the cut"), burnName},
    {"h",
     QT_TRANSLATE_NOOP("Symbol", "lag of the radius: the distance of the wheel head ahead of it")},
    {"γ", QT_TRANSLATE_NOOP("Symbol", "compliance of the system")},
    {"A", QT_TRANSLATE_NOOP("Symbol", "lag per depth of cut, without the wear flats")},
    {"C", QT_TRANSLATE_NOOP("Symbol", "deflection by the wear flats, per root of the depth")},
    {"√a", QT_TRANSLATE_NOOP("Symbol", "root of the depth of cut")},
    {"γ·P_y", QT_TRANSLATE_NOOP("Symbol", "deflection of the system")},
    {"y", QT_TRANSLATE_NOOP("Symbol", "total deflection"), balanceName},
    {"T", QT_TRANSLATE_NOOP("Symbol", "allowed temperature rise of the surface")},
    {"√(Ωτ)", QT_TRANSLATE_NOOP("Symbol", "depth that the heat reaches during the contact")},
    {"x", QT_TRANSLATE_NOOP("Symbol", "stock left over twice this depth")},
    {"c", QT_TRANSLATE_NOOP("Symbol", "temperature rise per force, from the heat conduction")},
    {"p", QT_TRANSLATE_NOOP("Symbol", "coefficient of the cubic equation w³ + p·w = Q")},
    {"Q", QT_TRANSLATE_NOOP("Symbol", "right side of that equation")},
    {"S", QT_TRANSLATE_NOOP("Symbol", "Cardano's root on the way to w")},
    {"N_s", QT_TRANSLATE_NOOP("Symbol", "structure number of the wheel")},
    {"G", QT_TRANSLATE_NOOP("Symbol", "profile of the dressed grains")},
    {"y", QT_TRANSLATE_NOOP("Symbol", "opening of the wheel's profile by the cut"), roughnessName},
    {"s", QT_TRANSLATE_NOOP("Symbol", "share of the profile removed by the cut")},
    {"f", QT_TRANSLATE_NOOP("Symbol", "calibration of Ra: measured over computed")},
    {"u", QT_TRANSLATE_NOOP("Symbol", "overlap: revolutions over a point in a stroke")},
    {"S_ф", QT_TRANSLATE_NOOP("Symbol", "limiting actual feed")},
    {"S_b", QT_TRANSLATE_NOOP("Symbol", "section of a bond bridge")},
    {"D_b", QT_TRANSLATE_NOOP("Symbol", "diameter of a bond bridge")},
    {"n_g", QT_TRANSLATE_NOOP("Symbol", "grains on a square millimetre of the wheel")},
    {"f_g", QT_TRANSLATE_NOOP("Symbol", "force that breaks a grain")},
    {"f_b", QT_TRANSLATE_NOOP("Symbol", "force that breaks its bond")},
    {"f_cr", QT_TRANSLATE_NOOP("Symbol", "critical force of one grain")},
    {"F",
     QT_TRANSLATE_NOOP("Symbol",
                       "force that the wheel withstands, per width and root of the depth"),
     sharpeningName},
    {"F", QT_TRANSLATE_NOOP("Symbol", "tangential force that the drive allows, per width")},
};

bool isSheet(const FormulaSheet& sheet, const char* name) {
    return QLatin1StringView(sheet.name) == QLatin1StringView(name);
}

/// The meaning of a symbol in a formula that is not an input; empty if it is not known.
QString symbolMeaning(const FormulaSheet& sheet, const char* symbol) {
    const auto found = std::ranges::find_if(meanings, [&](const Meaning& meaning) {
        return QString::fromUtf8(meaning.symbol) == QString::fromUtf8(symbol)
               && (!meaning.sheet || isSheet(sheet, meaning.sheet));
    });
    return found == std::end(meanings) ? QString()
                                       : QCoreApplication::translate("Symbol", found->text);
}

std::vector<FormulaSource> sourcesOf(const FormulaSheet& sheet, const Place& at) {
    std::vector<FormulaSource> sources{{sheet.source, ""}};
    const bool plunges = at.zone == Zone::section || wheelStands(at);
    if (isSheet(sheet, normalName) || isSheet(sheet, tangentialName)) {
        sources.push_back({"KORCHAK", ""});
        sources.push_back({"ALSIGAR2021", plunges ? "1" : "2"});
    } else if (isSheet(sheet, balanceName)) {
        sources.push_back({"ALSIGAR2021", plunges ? "3" : "4"});
        if (at.zone == Zone::section) {
            sources.push_back({"AKINTSEVA2020", "1"});
        }
    } else if (isSheet(sheet, burnName)) {
        sources.push_back({"PEREVERZEV1999", "25"});
    } else if (isSheet(sheet, sharpeningName)) {
        sources.push_back({"PEREVERZEV1999", "23, 24"});
    } else if (isSheet(sheet, roughnessName)) {
        sources.push_back({"PEREVERZEV1999", ""});
    }
    return sources;
}

StepFormulas::StepFormulas(const Project& project, const Place& at, Citations& citations,
                           std::optional<LeftOut> leftOut)
    : m_at(at), m_citations(citations), m_writer(std::move(leftOut)) {
    m_explained.insert(QStringLiteral("γ")); // among the inputs, too
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        if (*leaf.field->symbol && singleNumberIn(*leaf.field, leaf.owner)) {
            m_explained.insert(QString::fromUtf8(leaf.field->symbol));
        }
    }
}

void StepFormulas::add(const FormulaSheet& sheet) {
    m_blocks.emplace_back(Heading{QCoreApplication::translate("Formula", sheet.name)});
    QStringList sources;
    for (const FormulaSource& source : sourcesOf(sheet, m_at)) {
        const QString key = m_citations.cite(QString::fromLatin1(source.key));
        sources << (*source.equations ? tr("%1, eq. %2", "key of a source, its equation")
                                            .arg(key, QString::fromLatin1(source.equations))
                                      : key);
    }
    say(tr("Source: %1").arg(sources.join(QStringLiteral("; "))));
    for (Block& block : m_writer.write(sheet)) {
        m_blocks.push_back(std::move(block));
    }
    explain(sheet);
}

void StepFormulas::explain(const FormulaSheet& sheet) {
    Table table;
    table.head = {tr("Symbol"), tr("Meaning")};
    table.texts = {true, true};
    table.symbols = true;
    const auto explainTerm = [&](const FormulaTerm& term) {
        const QString symbol = QString::fromUtf8(term.symbol);
        if (!isConstant(term)) {
            m_symbols.insert(symbol);
        }
        const QString meaning = isConstant(term) ? QString() : symbolMeaning(sheet, term.symbol);
        if (!meaning.isEmpty() && !m_explained.contains(symbol)
            && m_explained.insert(symbol + u'=' + meaning).second) {
            table.rows.push_back({symbol, meaning});
        }
    };
    for (const FormulaStep& step : sheet.steps) {
        explainTerm(step.result);
        std::ranges::for_each(step.terms, explainTerm);
    }
    if (!table.rows.empty()) {
        m_blocks.emplace_back(std::move(table));
    }
}

constexpr double milliwattsPerKilowatt = 1e6;
constexpr double fullTurn_deg = 360;
constexpr int percentOf = 100;

/// The numbers for the formulas of a step.
struct StepNumbers {
    const Pass& pass;
    const Visit& visit;
    double stock_mm; ///< left after the cut; negative beyond the target
};

StepNumbers numbersOf(const Outcome& outcome, const HandoutStep& step) {
    const Part& part = *outcome.result.project.part;
    const Visit& visit = *visitAt(outcome.trajectory, step);
    const double side = part.surface == Surface::external ? 1 : -1;
    return {outcome.trajectory.passes[step.pass], visit,
            side * (visit.radius_mm - targetRadius(part))};
}

/// The limits of the depth of cut at the step, each with its formulas.
std::vector<FormulaSheet> limitSheets(const Project& project, double b, double stock) {
    std::vector<FormulaSheet> sheets;
    if (const auto& U = project.material->burn_rise_k) {
        sheets.push_back(burnLimitSheet(project, *U, std::max(0.0, stock)));
    }
    if (const auto& Ra = project.part->tolerance.roughness_ra_um;
        Ra && isRoughnessCalibrated(project)) {
        sheets.push_back(roughnessLimitSheet(project, *Ra / units::umPerMm, b));
    }
    if (auto sheet = selfSharpeningSheet(project)) {
        sheets.push_back(std::move(*sheet));
    }
    if (isCoupled(project)) {
        return sheets; // the sections share the power
    }
    if (const auto& N = project.machine->wheel_drive_kw) {
        sheets.push_back(wheelPowerLimitSheet(project, b, *N * milliwattsPerKilowatt));
    }
    if (const auto& N = project.machine->work_drive_kw) {
        sheets.push_back(workPowerLimitSheet(project, b, *N * milliwattsPerKilowatt));
    }
    return sheets;
}

} // namespace

QString Citations::cite(const QString& key) {
    if (!m_keys.contains(key)) {
        m_keys << key;
    }
    return QStringLiteral("[%1]").arg(key);
}

Table Citations::table() const {
    Table table;
    table.head = {tr("Key"), tr("Source")};
    table.texts = {true, true};
    for (const QString& key : m_keys) {
        table.rows.push_back({key, cell(sourceText(key.toStdString()))});
    }
    return table;
}

Facts WorkedStep::facts(const Outcome& outcome, const HandoutStep& step, bool results) {
    const auto [pass, visit, stock] = numbersOf(outcome, step);
    const Place& at = pass.place;
    const bool strokes = outcome.result.project.operation->travels;
    Facts facts{
        {{tr("Zone or section"), Names::zoneFull(at.zone, at.section)},
         {tr("Stage"), QString::number(at.stage)},
         {strokes ? tr("Double stroke") : tr("Revolution"), QString::number(at.cycleCount)}}};
    if (strokes) {
        facts.facts.emplace_back(
            tr("Step"), QStringLiteral("%1: %2").arg(Names::step(at.step),
                                                     Names::stepMeaning(at.zone, at.step)));
        facts.facts.emplace_back(tr("Revolution of the step"), QString::number(at.revolution));
    }
    const double angle = fullTurn_deg * step.radius / outcome.trajectory.radii;
    facts.facts.emplace_back(
        tr("Radius"),
        QStringLiteral("k = %1, φ = %2°").arg(step.radius).arg(QLocale().toString(angle, 'g', 4)));
    const auto micrometres = [](double mm) {
        return withUnit(Names::significant(mm * units::umPerMm, resultDigits), "µm");
    };
    const auto result = [&](double mm) {
        return results ? micrometres(mm) : withUnit(blankNumber(), "µm");
    };
    facts.facts.emplace_back(tr("Effective width b"),
                             withUnit(Names::significant(pass.effectiveWidth_mm, 4), "mm"));
    facts.facts.emplace_back(tr("Programmed so far, tП"), micrometres(visit.programmed_mm));
    facts.facts.emplace_back(tr("Actual feed a"), result(visit.actual_mm));
    facts.facts.emplace_back(tr("Stock left at this radius"), result(stock));
    return facts;
}

StepBlocks WorkedStep::formulas(const Outcome& outcome, const HandoutStep& step,
                                Citations& citations, const Hidden& hidden) {
    const Project& project = outcome.result.project;
    const auto [pass, visit, stock] = numbersOf(outcome, step);
    const double b = pass.effectiveWidth_mm, a = visit.actual_mm;
    const FormulaSheet balance =
        visitSheet(outcome.result, outcome.trajectory, step.pass, step.radius);
    std::vector<FormulaSheet> forces;
    if (a > 0 || !hasThreshold(project)) { // otherwise the balance alone gives the force
        forces = {normalForceSheet(project, b, a), tangentialForceSheet(project, b, a)};
    }
    forces.push_back(balance);
    const std::vector<FormulaSheet> sheets = limitSheets(project, b, stock);
    std::optional<LeftOut> leftOut;
    if (hidden) {
        leftOut = LeftOut{*hidden};
        for (const FormulaSheet& sheet : forces) {
            leftOut->symbols.unite(computedSymbols(sheet));
        }
        for (const FormulaSheet& sheet : sheets) {
            leftOut->symbols.unite(computedSymbols(sheet));
        }
    }
    StepFormulas formulas(project, pass.place, citations, std::move(leftOut));
    formulas.say(tr("The forces are those at the depth of cut of the elastic balance below."));
    for (const FormulaSheet& sheet : forces) {
        formulas.add(sheet);
    }
    formulas.add(Heading{tr("Limits of the feed at this step")});
    const bool limitsRa = project.part->tolerance.roughness_ra_um.has_value();
    const bool calibrated = isRoughnessCalibrated(project);
    if (limitsRa && !calibrated) {
        formulas.say(LimitNames::guessed());
    }
    if (sheets.empty()) {
        formulas.say(limitsRa ? tr("No other requirement of this project limits the feed.")
                              : tr("No requirement of this project limits the feed."));
        return formulas.take();
    }
    formulas.say(limitsRa && calibrated
                     ? tr("Each requirement allows a maximum depth of cut; the formulas below show "
                          "its origin. Roughness limits only the last cut of the cycle.")
                     : tr("Each requirement allows a maximum depth of cut; the formulas below show "
                          "its origin."));
    formulas.add(limits(outcome, step, !hidden));
    for (const FormulaSheet& sheet : sheets) {
        formulas.add(sheet);
    }
    return formulas.take();
}

Table WorkedStep::limits(const Outcome& outcome, const HandoutStep& step, bool results) {
    const Project& project = outcome.result.project;
    const auto [pass, visit, stock] = numbersOf(outcome, step);
    Table table;
    table.head = {tr("Requirement"), tr("Limiting depth of cut, µm"), tr("As a feed, mm/min"),
                  tr("Depth of cut of the step, µm"), tr("Share of the limit, %")};
    table.texts = {true};
    for (const DepthLimit& limit :
         depthLimits(project, pass.effectiveWidth_mm, std::max(0.0, stock))) {
        const bool shared = isCoupled(project) && requirementOf(limit.kind).sharedBySections;
        if (LimitNames::isGuess(limit.kind, project) || shared) {
            continue;
        }
        if (!results) {
            const QString blank = blankNumber();
            table.rows.push_back({Names::constraint(limit.kind), blank, blank, blank, blank});
            continue;
        }
        const double share = percentOf * visit.actual_mm / limit.depth_mm;
        table.rows.push_back(
            {Names::constraint(limit.kind),
             Names::significant(limit.depth_mm * units::umPerMm, resultDigits),
             Names::significant(limit.depth_mm * project.machine->work_speed_rpm, resultDigits),
             Names::significant(visit.actual_mm * units::umPerMm, resultDigits),
             limit.depth_mm > 0 ? Names::significant(share) : tr("not met at any depth")});
    }
    return table;
}

namespace {

/// Inputs behind the step's feed, width and stock that are not in a formula.
constexpr const char* behindFormulas[] = {"/part/upper_deviation_um", "/part/lower_deviation_um",
                                          "/part/length_mm",          "/part/stock_mm",
                                          "/part/initial_runout_mm",  "/wheel/width_mm"};

bool entersFormulas(const Leaf& leaf, const Project& project, const std::set<QString>& symbols,
                    int stage) {
    const Field& field = *leaf.field;
    const QString path = QString::fromStdString(leaf.path);
    if (!*field.symbol || !*field.source || field.kind == sparkout::Kind::compliance
        || (field.relevant && !field.relevant(project, leaf.owner))) {
        return false;
    }
    const bool input = path.startsWith(u"/part/") || path.startsWith(u"/material/")
                       || path.startsWith(u"/wheel/") || path.startsWith(u"/machine/");
    const bool body = path.startsWith(u"/part/shaft/"); // its d and l are not the part's
    return (input && !body && symbols.contains(QString::fromUtf8(field.symbol)))
           || std::ranges::count(behindFormulas, leaf.path) > 0
           || (stage > 0 && path.startsWith(QStringLiteral("/cycle/stages/%1/").arg(stage - 1)));
}

} // namespace

Facts HandoutTask::header(const Project& project, const QString& file, const QDate& date) {
    Facts facts = OperationSetup::header(project, date);
    facts.facts.insert(
        facts.facts.begin(),
        {{tr("Course"), cell(manyLines(exampleTitle(project.title)).simplified())},
         {tr("Project file"), cell(manyLines(QFileInfo(file).fileName()).simplified())}});
    return facts;
}

QString HandoutTask::part(const Project& project) {
    const Part& part = *project.part;
    const QString ground =
        part.surface == Surface::external
            ? tr("A shaft of %1 is ground over a length of %2 mm. Its blank has at least %3 mm of "
                 "stock per side and a runout of %4 mm.")
            : tr("A bore of %1 is ground over a length of %2 mm. Its blank has at least %3 mm of "
                 "stock per side and a runout of %4 mm.");
    return ground.arg(drawnSize(part), printedNumber(part.length_mm), printedNumber(part.stock_mm),
                      printedNumber(part.initial_runout_mm));
}

QString HandoutTask::task(const Outcome& outcome) {
    return part(outcome.result.project) + u' '
           + tr("By the model the cycle takes %1. Follow one step of it, formula by formula, and "
                "find what limits the feed there.")
                 .arg(verdict::time(outcome.result));
}

Table HandoutTask::inputs(const Outcome& outcome, const std::optional<HandoutStep>& step,
                          const std::set<QString>& symbols, Citations& citations,
                          const std::function<bool(std::string_view path)>& hides) {
    const Project& project = outcome.result.project;
    std::optional<Place> at;
    if (step) {
        at = outcome.trajectory.passes[step->pass].place;
    }
    Table table;
    table.head = {tr("Symbol"), tr("Value"), tr("Unit"), tr("Meaning"), tr("Source")};
    table.texts = {true, false, true, true, true};
    table.symbols = true;
    const auto add = [&](const char* symbol, const QString& value, const char* unit,
                         const QString& meaning, const QString& source) {
        table.rows.push_back({QString::fromUtf8(symbol), value, cell(unitText(unit)), meaning,
                              citations.cite(source)});
    };
    const int stage = at ? at->stage : 0; // 0: none
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        const Field& field = *leaf.field;
        const auto value = entersFormulas(leaf, project, symbols, stage)
                               ? singleNumberIn(field, leaf.owner)
                               : std::nullopt;
        if (value && !(hides && hides(leaf.path))) {
            add(field.symbol, printedNumber(*value), field.unit, inputText(field.label),
                QString::fromLatin1(field.source));
        }
    }
    if (at && !(hides && hides("/machine/compliance_mm_per_n"))) {
        const bool given =
            !std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n);
        const double gamma = compliantPoints(project)[sectionOf(*at)].gamma_mm_n;
        add("γ", formulaNumber({"γ", gamma, "mm/N"}).replace(u'-', QChar(0x2212)), "mm/N",
            tr("Compliance of the system, %1").arg(Names::zone(at->zone, at->section)),
            given ? QStringLiteral("MODEL-3") : QStringLiteral("MODEL-6"));
    }
    return table;
}

} // namespace sparkout::report
