// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict/form_model.h"

#include "core/quality/finished_surface.h"
#include "core/units.h"
#include "ui/text/names.h"

#include <QGuiApplication>
#include <QPalette>

#include <cstddef>
#include <utility>

namespace sparkout {

void FormModel::setOutcome(OutcomePtr outcome) {
    beginResetModel();
    m_outcome = std::move(outcome);
    endResetModel();
}

void FormModel::setGreyed(bool grey) {
    if (m_grey != grey) {
        m_grey = grey;
        retranslate();
    }
}

void FormModel::retranslate() {
    beginResetModel();
    endResetModel();
}

int FormModel::columnsShown() const {
    return m_outcome ? static_cast<int>(m_outcome->accuracy.zones.size()) : 0;
}

std::optional<double> FormModel::value_um(int row, int zone) const {
    if (!FinishedSurface(m_outcome->result.project).isWhole()) {
        return std::nullopt;
    }
    const auto i = static_cast<std::size_t>(zone);
    const ZoneForm& form = m_outcome->accuracy.zones.at(i);
    const auto value_mm = [&] {
        switch (row) {
        case roundness: return m_outcome->accuracy.sections.at(i).minimumZone.deviation();
        case cylindricity: return form.cylindricity_mm;
        case totalRunout: return form.totalRunout_mm;
        case taper: return form.profile.taper_mm;
        default: return form.profile.crown_mm;
        }
    };
    return value_mm() * units::umPerMm;
}

QString FormModel::text(int row, int zone) const {
    const std::optional<double> value = value_um(row, zone);
    return !value                         ? QStringLiteral("—")
           : row == taper || row == crown ? Names::signedMicrometres(*value)
                                          : Names::amountFixed(*value, 2);
}

QString FormModel::zoneName(int zone, bool full) const {
    const SectionResult& section = m_outcome->result.sections.at(static_cast<std::size_t>(zone));
    return full ? Names::zoneFull(section.zone, zone) : Names::zone(section.zone, zone);
}

QString FormModel::rowName(int row) {
    switch (row) {
    case roundness: return tr("Roundness");
    case cylindricity: return tr("Cylindricity");
    case totalRunout: return tr("Total runout");
    case taper: return tr("Taper");
    default: return tr("Crown");
    }
}

QString FormModel::rowHint(int row) {
    switch (row) {
    case roundness: return tr("Minimum zone, of the least round section of the zone.");
    case cylindricity: return tr("Minimum zone, over all sections of the zone.");
    case totalRunout:
        return tr("About the centre axis, over all sections, with the machine's own.");
    case taper:
        return tr("Mean radius at the zone's last section less that at its first, of the "
                  "straight line through them.");
    default:
        return tr("Mean radius in the zone's middle less that at its ends: above 0 a barrel, "
                  "below it a saddle.");
    }
}

QVariant FormModel::cell(int row, int column, int role) const {
    switch (role) {
    case Qt::DisplayRole: return text(row, column);
    case Qt::TextAlignmentRole: return aligned(true);
    case Qt::ForegroundRole:
        return m_grey
                   ? QVariant(QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text))
                   : QVariant();
    case Qt::AccessibleTextRole:
        return tr("%1, %2: %3 µm").arg(zoneName(column, true), rowName(row), text(row, column));
    case Qt::ToolTipRole: return QStringLiteral("<p>%1</p>").arg(rowHint(row).toHtmlEscaped());
    default: return {};
    }
}

QVariant FormModel::side(int row, int role) const {
    switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole: return rowName(row);
    case Qt::ToolTipRole: return QStringLiteral("<p>%1</p>").arg(rowHint(row).toHtmlEscaped());
    case Qt::TextAlignmentRole: return aligned(false);
    default: return {};
    }
}

QVariant FormModel::head(int column, int role) const {
    switch (role) {
    case Qt::DisplayRole: return zoneName(column, false);
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole: return zoneName(column, true);
    case Qt::TextAlignmentRole: return aligned(true);
    default: return {};
    }
}

QString FormModel::asTsv() const {
    QStringList heads{tr("Quantity")};
    for (int zone = 0; zone < columnsShown(); ++zone) {
        heads << zoneName(zone, false);
    }
    QStringList lines{heads.join(u'\t')};
    for (int row = 0; row < rowsShown(); ++row) {
        QStringList cells{tr("%1, µm").arg(rowName(row))};
        for (int zone = 0; zone < columnsShown(); ++zone) {
            cells << text(row, zone);
        }
        lines << cells.join(u'\t');
    }
    return lines.join(u'\n') + u'\n';
}

} // namespace sparkout
