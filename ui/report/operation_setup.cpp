// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/operation_setup.h"

#include "core/file/project_file.h"
#include "core/measured/calibrated_inputs.h"
#include "core/process/force.h"
#include "core/process/system_compliance.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/measured.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/units.h"
#include "core/version.h"
#include "ui/report/cell_text.h"
#include "ui/text/calibration_text.h"
#include "ui/text/example_texts.h"
#include "ui/text/field_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QFileInfo>
#include <QLocale>

#include <cmath>
#include <numbers>

namespace sparkout::report {

QString OperationSetup::operation(const Project& project) {
    const bool bore = project.part->surface == Surface::internal;
    return project.operation.match(
        [bore](Traverse) {
            return bore ? tr("Internal traverse grinding") : tr("Cylindrical traverse grinding");
        },
        [bore](Plunge) {
            return bore ? tr("Internal plunge grinding") : tr("Cylindrical plunge grinding");
        });
}

Facts OperationSetup::header(const Project& project, const QDate& date) {
    const Part& part = *project.part;
    return {{{tr("Name of the operation"), operation(project)},
             {tr("Kind of grinding"), inputFact(project, "/operation").second},
             {tr("Part"), cell(oneLine(part.name))},
             {tr("Equipment"), cell(oneLine(project.machine->name))},
             {tr("Size by the drawing"), drawnSize(part)},
             {tr("Material"), cell(oneLine(project.material->grade))},
             {tr("Hardness"), inputFact(project, "/material/hardness_hrc").second},
             inputFact(project, "/part/length_mm"),
             inputFact(project, "/part/stock_mm"),
             {tr("Prepared by"), cell(oneLine(project.author))},
             {tr("Date"), dateText(date)}}};
}

Facts OperationSetup::settings(const Outcome& outcome) {
    const Project& project = outcome.result.project;
    const Wheel& wheel = *project.wheel;
    Facts facts{{{tr("Grinding wheel, marking"), cell(oneLine(wheel.marking))},
                 {tr("Wheel diameter × width"),
                  withUnit(printedNumber(wheel.diameter_mm, 6) + QStringLiteral(" × ")
                               + printedNumber(wheel.width_mm),
                           "mm")},
                 inputFact(project, dullnessPath(wheel)),
                 inputFact(project, "/machine/wheel_speed_m_s"),
                 {tr("Wheel rotation"),
                  withUnit(Names::significant(outcome.shop.wheelSpeed_rpm, 4), "rev/min")},
                 inputFact(project, "/machine/work_speed_rpm"),
                 {tr("Work surface speed"),
                  tr("%1 m/min")
                      .arg(Names::significant(std::numbers::pi * project.part->diameter_mm
                                              * project.machine->work_speed_rpm / units::mmPerM))},
                 inputFact(project, "/part/initial_runout_mm")}};
    if (const auto& varied = project.machine->work_speed_variation) {
        facts.facts.emplace_back(
            tr("Work speed varied"),
            tr("±%1 % in %2 s")
                .arg(Names::significant(varied->percent), Names::significant(varied->period_s)));
    }
    if (const double engaged = engagedShare(*project.part); engaged < 1) {
        facts.facts.emplace_back(tr("Interrupted surface"),
                                 tr("%n gap(s), %1 % of the turn is ground", nullptr,
                                    static_cast<int>(project.part->gaps.size()))
                                     .arg(Names::significant(engaged * 100, 3)));
    }
    if (project.operation->travels) {
        for (const char* path :
             {"/machine/overrun_entry_mm", "/machine/overrun_exit_mm", "/machine/dwell_entry_s",
              "/machine/dwell_exit_s", "/machine/plunge_feed_mm_min"}) {
            facts.facts.push_back(inputFact(project, path));
        }
        if (project.machine->reversal_infeed != ReversalInfeed::entry) {
            facts.facts.push_back(inputFact(project, "/machine/reversal_infeed"));
        }
    }
    if (zoneSectionCount(project) > 0) {
        facts.facts.push_back(inputFact(project, "/zone_sections"));
    }
    QString control = tr("by the position of the wheel head");
    if (project.gauge->control == Control::gauge) {
        const auto section = static_cast<std::size_t>(gaugeSection(project));
        const SectionResult& at = outcome.result.sections.at(section);
        const double place = project.gauge->position_mm.value_or(at.position_mm);
        control = tr("in-process gauge: %1, %2 from the headstock end of the ground length")
                      .arg(Names::zone(at.zone, static_cast<int>(section)),
                           withUnit(project.gauge->position_mm ? printedNumber(place)
                                                               : Names::significant(place),
                                    "mm"));
    }
    facts.facts.emplace_back(tr("Size control"), control);
    if (!project.coolant.empty()) {
        facts.facts.emplace_back(tr("Coolant"), cell(oneLine(project.coolant)));
    }
    if (!wheel.dressing.empty()) {
        facts.facts.emplace_back(tr("Dressing"), cell(oneLine(wheel.dressing)));
    }
    return facts;
}

Table OperationSetup::stages(const Outcome& outcome, bool results) {
    const Project& project = outcome.result.project;
    const StageFeed& radial = project.operation->radial();
    const StageFeed* const axial = project.operation->axial();
    Table table;
    table.head = {tr("Stage"), !project.operation->travels ? tr("Radial feed, mm/min")
                                                           : tr("Radial feed, mm/dbl stroke")};
    if (axial) {
        table.head << tr("Axial feed, mm/min");
    }
    const bool continuous = feedsContinuously(project);
    const TimeUnit unit(outcome.shop.cycle.time_s);
    if (continuous) {
        table.head << tr("Continuous infeed, mm/min");
    }
    table.head << tr("Stock per side, mm")
               << (project.operation->travels ? tr("Double strokes") : tr("Revolutions"))
               << unit.titled(tr("Machining time")) << tr("Spark-out") << tr("Maximum power, kW")
               << tr("Maximum force Py, N");
    double stock = 0;
    const auto count = project.cycle->stages.size();
    const auto rest = [&](QStringList row, const ShopColumn& shop, const QString& sparkOut) {
        const auto out = [results](const QString& text) {
            return results ? text : QString(6, u'_');
        };
        row << out(QString::number(shop.count)) << out(threeDigits(unit.of(shop.time_s)))
            << sparkOut << out(threeDigits(shop.power_w.value / units::wPerKw))
            << out(threeDigits(shop.normalForce_n.value));
        table.rows.push_back(row);
    };
    const auto feed = [](const std::optional<double>& value) {
        return value ? printedNumber(*value) : cell({});
    };
    for (std::size_t z = 0; z < count; ++z) {
        const Stage& stage = project.cycle->stages[z];
        const auto steps = stage.sparkOutSteps();
        QStringList row{QString::number(z + 1),
                        stage.feeds() ? feed(stage.*radial.value) : printedNumber(0)};
        if (axial) {
            row << feed(stage.*axial->value);
        }
        if (continuous) {
            row << printedNumber(stage.continuousFeed_mm_min());
        }
        row << printedNumber(stage.stock_mm); // a spark-out removes stock, too
        stock += stage.stock_mm;
        rest(row, outcome.shop.stages.at(z),
             stage.feeds() ? cell({})
             : steps       ? printedNumber(*steps)
                           : tr("until size"));
    }
    QStringList sum{tr("Cycle"), cell({})};
    if (axial) {
        sum << cell({});
    }
    if (continuous) {
        sum << cell({});
    }
    sum << printedNumber(std::round(stock * 1e6) / 1e6); // as exact as the rows
    rest(sum, outcome.shop.cycle, cell({}));
    table.lastIsSum = true;
    table.texts = {true};
    return table;
}

Report begunReport(const QString& title, const Project& project, const QString& file,
                   const QDate& date) {
    Report report;
    report.title = title;
    QStringList subject{manyLines(exampleTitle(project.title)).simplified(),
                        manyLines(exampleTitle(project.part->name)).simplified()};
    subject.removeAll(QString());
    subject.removeDuplicates();
    report.subject = subject.join(QStringLiteral(" · "));
    report.author = oneLine(project.author);
    report.file = manyLines(QFileInfo(file).fileName()).simplified();
    report.program = QStringLiteral("Sparkout %1").arg(QString::fromUtf8(version));
    report.language = QLocale().bcp47Name().section(u'-', 0, 0);
    report.date = date;
    Project inputs = project; // kept runs are not inputs of this paper
    inputs.runs = {};
    report.inputs = QByteArray::fromStdString(writeProject(inputs));
    return report;
}

Table CalibratedTable::of(const Project& project) {
    Table table;
    table.head = {tr("Input"), tr("Value found"), tr("95 % interval"), tr("Unit"),
                  tr("Data"),  tr("n"),           tr("Date"),          tr("In use")};
    table.texts = {true, false, false, true, true, false, true, true};
    if (!project.measured) {
        return table;
    }
    for (const Calibration& record : project.measured->calibrations) {
        table.rows.push_back(
            {locationText(record.input), CalibrationText::number(record.value),
             cell(CalibrationText::interval(record)), cell(CalibrationText::unit(project, record)),
             cell(oneLine(record.data)), QString::number(record.count),
             cell(CalibrationText::date(record)),
             hasCalibratedValue(project, record) ? tr("yes") : tr("no, changed since")});
    }
    return table;
}

} // namespace sparkout::report
