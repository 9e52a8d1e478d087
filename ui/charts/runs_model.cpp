// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/runs_model.h"

#include "ui/charts/light_icon.h"
#include "ui/kit/metrics.h"
#include "ui/plot/run_dash.h"

#include <QGuiApplication>
#include <QIcon>
#include <QPainter>
#include <QPalette>

#include <algorithm>
#include <utility>

namespace sparkout {

/// An unchanged row keeps a name being typed.
void RunsModel::setRuns(std::vector<Run> runs) {
    const std::vector<Run> before = m_runs;
    const int had = rowCount(), has = static_cast<int>(runs.size());
    if (has > had) {
        beginInsertRows({}, had, has - 1);
        m_runs = std::move(runs);
        endInsertRows();
    } else if (has < had) {
        beginRemoveRows({}, has, had - 1);
        m_runs = std::move(runs);
        endRemoveRows();
    } else {
        m_runs = std::move(runs);
    }
    for (int row = 0; row < std::min(had, has); ++row) {
        const auto i = static_cast<std::size_t>(row);
        if (m_runs[i] != before[i]) {
            emit dataChanged(index(row), index(row));
        }
    }
}

void RunsModel::setPresent(Run run) {
    if (!m_runs.empty() && m_runs.front() != run) {
        m_runs.front() = std::move(run);
        emit dataChanged(index(0), index(0));
    }
}

int RunsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_runs.size());
}

QPixmap RunsModel::markOf(const Run& run, const QColor& text, const QColor& behindLight) {
    const qreal ratio = qApp->devicePixelRatio();
    QPixmap mark =
        runSample(std::max(run.number, 0), run.number < 0 ? Qt::transparent : text, sample, ratio);
    const int side = sample.height();
    QPainter painter(&mark);
    painter.setCompositionMode(QPainter::CompositionMode_Clear);
    painter.fillRect(sample.width() - side - metrics::tight, 0, side + metrics::tight, side,
                     Qt::transparent);
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    if (run.judged || run.light) {
        constexpr int rim = 2, round = 4;
        const QRect box(sample.width() - side, 0, side, side);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(behindLight);
        painter.drawRoundedRect(box, round, round);
        const int inside = behindLight.alpha() > 0 ? rim : 0;
        const int size = side - 2 * inside;
        painter.drawPixmap(box.topLeft() + QPoint(inside, inside),
                           run.judged ? judgedPixmap(*run.judged, size, ratio, false)
                                      : lightPixmap(*run.light, size, ratio, false));
    }
    return mark;
}

QVariant RunsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    const Run& run = m_runs.at(static_cast<std::size_t>(index.row()));
    switch (role) {
    case Qt::DisplayRole: return run.name + u'\n' + run.detail;
    case Qt::EditRole: return run.name;
    case Qt::ToolTipRole: return run.description;
    case Qt::AccessibleTextRole: return run.description;
    case Qt::DecorationRole: {
        const QPalette palette = QGuiApplication::palette();
        QIcon marks(markOf(run, palette.color(QPalette::Text), Qt::transparent));
        marks.addPixmap(
            markOf(run, palette.color(QPalette::HighlightedText), palette.color(QPalette::Base)),
            QIcon::Selected);
        return marks;
    }
    case Qt::CheckStateRole: return run.chosen ? Qt::Checked : Qt::Unchecked;
    default: return {};
    }
}

bool RunsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.row() == 0) {
        return false;
    }
    if (role == Qt::CheckStateRole) {
        emit chosen(index.row() - 1, value.toInt() == Qt::Checked);
        return true;
    }
    if (role == Qt::EditRole) {
        if (value.toString() == m_runs[static_cast<std::size_t>(index.row())].name) {
            return false; // unchanged as displayed, possibly in another language than the file
        }
        emit renamed(index.row() - 1, value.toString());
        return true;
    }
    return false;
}

Qt::ItemFlags RunsModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) {
        return Qt::NoItemFlags;
    }
    const Qt::ItemFlags all = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.row() == 0) {
        return all;
    }
    const bool isOwn = m_runs.at(static_cast<std::size_t>(index.row())).isOwn;
    return isOwn ? all | Qt::ItemIsUserCheckable | Qt::ItemIsEditable
                 : all | Qt::ItemIsUserCheckable;
}

} // namespace sparkout
