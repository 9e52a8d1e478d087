// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and words of the plot of the limits: mark, values under the mouse, table.
#include "core/units.h"
#include "ui/plot/plot_cursors.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/views/constraints/constraints_plot.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

using units::umPerMm;

/// The limit that binds a cut: the least but roughness, which binds the last one alone.
const DepthLimit* bindingOf(const std::vector<DepthLimit>& limits) {
    const DepthLimit* least = nullptr;
    for (const DepthLimit& limit : limits) {
        if (requirementOf(limit.kind).bindsEveryPass()
            && (!least || limit.depth_mm < least->depth_mm)) {
            least = &limit;
        }
    }
    return least;
}

double ratio(double value, double limit) {
    return limit > 0 ? value / limit : HUGE_VAL;
}

} // namespace

std::vector<DepthLimit> ConstraintsPlot::limitsOf(const LimitedCut& cut) const {
    std::vector<DepthLimit> limits =
        depthLimits(m_outcome->result.project, cut.width_mm, cut.stock_mm);
    std::erase_if(limits, [this](const DepthLimit& l) { return !limit(l.kind); });
    return limits;
}

QString ConstraintsPlot::markText() const {
    if (!m_markedCut) {
        return {};
    }
    if (m_requirement) {
        return QStringLiteral("%1: %2").arg(Names::constraint(m_requirement->kind),
                                            LimitNames::percent(1 - m_requirement->relativeMargin));
    }
    const std::vector<DepthLimit> limits = limitsOf(*m_markedCut);
    const DepthLimit* binding = bindingOf(limits);
    return binding ? tr("nearest to its limit: %1, %2")
                         .arg(LimitNames::limit(binding->kind),
                              LimitNames::percent(ratio(m_markedCut->depth_mm, binding->depth_mm)))
                   : QString();
}

QString ConstraintsPlot::valuesAt(const LimitedCut& cut) const {
    const auto um = [](double value_mm) { return Names::significant(value_mm * umPerMm); };
    std::vector<DepthLimit> limits = limitsOf(cut);
    std::ranges::sort(limits, {}, &DepthLimit::depth_mm);
    const DepthLimit* binding = bindingOf(limits);
    QStringList parts;
    for (const DepthLimit& limit : limits) {
        parts << QStringLiteral("%1 %2").arg(LimitNames::limit(limit.kind), um(limit.depth_mm));
        if (&limit == binding) {
            parts.back() +=
                tr(" (%1 used)").arg(LimitNames::percent(ratio(cut.depth_mm, limit.depth_mm)));
        }
    }
    QString text = tr("%1: stock left %2 µm, actual feed %3 µm, width %4 mm")
                       .arg(Names::place(cut.place, m_outcome->result.project.operation),
                            Names::signedMicrometres(cut.stock_mm * umPerMm), um(cut.depth_mm),
                            Names::significant(cut.width_mm));
    if (!parts.isEmpty()) {
        text += u'\n' + tr("Allowed feed, µm: %1").arg(parts.join(QStringLiteral("; ")));
    }
    return text;
}

/// The cut nearest to the mouse, as it is seen.
void ConstraintsPlot::onMouse(QMouseEvent* event) {
    const LimitGroup* group = shownGroup();
    if (!group || group->cuts.empty() || !m_rect->rect().contains(event->pos())) {
        emit pointed({});
        return;
    }
    const auto away = [&](const LimitedCut& cut) {
        const double x = stockAxis()->coordToPixel(cut.stock_mm * umPerMm);
        const double y = feedAxis()->coordToPixel(std::max(cut.depth_mm * umPerMm, 1e-6));
        return std::hypot(x - event->pos().x(), y - event->pos().y());
    };
    emit pointed(valuesAt(*std::ranges::min_element(group->cuts, {}, away)));
}

ReadCurves ConstraintsPlot::readCurves() const {
    ReadCurves curves;
    const auto add = [&](const auto& drawn, const QString& name) {
        if (drawn->visible() && !drawn->data()->isEmpty()) {
            curves.push_back({QString(), name, Digits::significant,
                              [drawn](double x) { return valueAt(*drawn, x); }});
        }
    };
    add(m_actual, tr("actual feed, µm"));
    add(m_stepless, tr("stepless limit, µm"));
    for (const auto& [kind, graph] : m_limits) {
        add(graph, tr("limit: %1, µm").arg(LimitNames::limit(kind)));
    }
    return curves;
}

CursorSubject ConstraintsPlot::cursorSubject() {
    return {[this] { return stockAxis()->label(); },
            [this] {
                return m_outcome ? QCPRange(m_outcome->limits.least_mm * umPerMm,
                                            m_outcome->limits.deepest_mm * umPerMm)
                                 : QCPRange();
            },
            [this] { return readCurves(); },
            {},
            {}};
}

CsvTable ConstraintsPlot::table() const {
    CsvTable table;
    const LimitGroup* group = shownGroup();
    if (!group) {
        return table;
    }
    const bool strokes = m_outcome->result.project.operation->countsStrokes;
    table.header << tr("stage") << (strokes ? tr("double stroke") : tr("revolution"))
                 << tr("stock left, µm") << tr("actual feed, µm") << tr("width of cut, mm");
    const auto shows = [this](const DepthLimit& limit) {
        return m_choice.shows(static_cast<int>(limit.kind));
    };
    bool named = false;
    for (const LimitedCut& cut : group->cuts) {
        if (!stockAxis()->range().contains(cut.stock_mm * umPerMm)) {
            continue;
        }
        const std::vector<DepthLimit> limits = limitsOf(cut);
        std::vector<CsvCell> row{double(cut.place.stage), double(cut.place.cycleCount),
                                 cut.stock_mm * umPerMm, cut.depth_mm * umPerMm, cut.width_mm};
        for (const DepthLimit& limit : limits) {
            if (shows(limit)) {
                row.emplace_back(limit.depth_mm * umPerMm);
                if (!named) {
                    table.header << tr("limit: %1, µm").arg(LimitNames::limit(limit.kind));
                }
            }
        }
        if (const DepthLimit* binding = bindingOf(limits)) {
            row.insert(row.end(), {binding->depth_mm * umPerMm, LimitNames::limit(binding->kind)});
            if (!named) {
                table.header << tr("stepless limit, µm") << tr("binding");
            }
        }
        named = true;
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace sparkout
