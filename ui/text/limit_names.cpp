// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/limit_names.h"

#include "core/project/machine.h"
#include "core/project/member.h"
#include "core/project/part.h"
#include "core/quality/roughness.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace sparkout {

namespace {

constexpr double mostPercent = 999;

} // namespace

QString LimitNames::limit(ConstraintKind kind) {
    const char* const name = requirementOf(kind).limitName;
    return name ? requirementText(name) : Names::inSentence(Names::constraint(kind));
}

QString LimitNames::group(const LimitGroup& group) {
    const QString zone = Names::zone(group.zone, group.section);
    if (group.zone == Zone::section || group.zone == Zone::nz) {
        return zone;
    }
    return group.standing ? tr("%1, wheel standing").arg(zone) : tr("%1, strokes").arg(zone);
}

QString LimitNames::percent(double share) {
    QLocale numbers;
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    const double percent = 100 * share;
    if (percent > mostPercent || std::isnan(percent)) {
        return tr(">%1 %").arg(numbers.toString(mostPercent, 'f', 0));
    }
    if (percent > 100 && percent < 101) { // shows no exceeded limit as just reached
        return tr("%1 %").arg(numbers.toString(std::max(percent, 100.1), 'f', 1));
    }
    return tr("%1 %").arg(numbers.toString(percent, 'f', percent < 10 ? 1 : 0));
}

std::vector<OffLimit> LimitNames::off(const Project& project) {
    std::vector<OffLimit> off;
    for (const Requirement& row : requirementRows) {
        std::string path = missingInput(row, project);
        if (!path.empty() && row.scope != ConstraintScope::setting) {
            off.push_back({row.kind, std::move(path)});
        }
    }
    std::ranges::sort(off, {}, [&project](const OffLimit& each) {
        const Requirement& row = requirementOf(each.kind);
        const int group = row.bindsEveryPass() ? 0 : row.depthLimit ? 1 : 2;
        return std::tuple(group, group > 0 ? findMember(project, each.path).field : nullptr,
                          each.kind);
    });
    return off;
}

QString LimitNames::notChecked(const QStringList& names) {
    return names.isEmpty()
               ? QString()
               : tr("Not checked, input missing: %1").arg(names.join(QLatin1String(", ")));
}

QString LimitNames::notChecked(const Project& project) {
    QStringList names;
    for (const OffLimit& each : off(project)) {
        names << limit(each.kind);
    }
    return notChecked(names);
}

bool LimitNames::isGuess(ConstraintKind kind, const Project& project) {
    return kind == ConstraintKind::roughness && !isRoughnessCalibrated(project);
}

QString LimitNames::guessed() {
    return tr("Roughness is not limiting while it is not calibrated: the computed Ra is a range, "
              "and no depth of cut can be derived from it.");
}

QString LimitNames::missingLinks(const Project& project) {
    QStringList lines{notCheckedLinks(project)};
    if (project.part->tolerance.roughness_ra_um && isGuess(ConstraintKind::roughness, project)) {
        static const std::string path = "/wheel/roughness_factor";
        lines << tr("Roughness is not limiting while it is not calibrated: %1")
                     .arg(QStringLiteral("<a href=\"%1\">%2</a>")
                              .arg(QString::fromStdString(path),
                                   locationText(path).toHtmlEscaped()));
    }
    return joined(lines, QStringLiteral("<br>"));
}

QString LimitNames::notCheckedLinks(const Project& project) {
    QStringList links;
    for (const OffLimit& each : off(project)) {
        links << QStringLiteral("<a href=\"%1\">%2</a>")
                     .arg(QString::fromStdString(each.path), limit(each.kind).toHtmlEscaped());
    }
    QStringList lines{notChecked(links)};
    const auto& asked = project.part->tolerance;
    QStringList ofMachine;
    if (!isRoundnessKnown(*project.machine) && asked.roundness_um) {
        ofMachine << limit(ConstraintKind::roundness);
    }
    if (!isRunoutKnown(*project.machine) && asked.radial_runout_um) {
        ofMachine << limit(ConstraintKind::radialRunout);
    }
    if (!ofMachine.isEmpty()) {
        lines << tr("Machine not known, the process alone: %1")
                     .arg(QStringLiteral("<a href=\"/machine/form\">%1</a>")
                              .arg(ofMachine.join(QStringLiteral(", ")).toHtmlEscaped()));
    }
    return joined(lines, QStringLiteral("<br>"));
}

} // namespace sparkout
