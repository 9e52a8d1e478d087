// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pdf/pdf_structure.h"

#include <QPainter>

#include <cmath>

namespace sparkout {

namespace {
constexpr double markPlace = -30'000; ///< in dots of the device, beyond any paper
}

void PdfStructure::placeBoxes(double scale, const QPointF& origin_pt) {
    for (Element& element : m_elements) {
        if (element.box) {
            element.box =
                QRectF(element.box->topLeft() * scale + origin_pt, element.box->size() * scale);
        }
    }
}

/// Without a transform and a clip, so that the following content begins with its own state.
void PdfStructure::mark(QPainter& painter, Id id) {
    painter.save();
    painter.resetTransform();
    painter.setClipping(false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::SolidPattern);
    painter.drawRect(QRectF(markPlace, markPlace - static_cast<double>(id), 1, 1));
    painter.restore();
}

std::optional<PdfStructure::Id> PdfStructure::marked(double x, double y) {
    if (x != markPlace || y > markPlace) {
        return std::nullopt;
    }
    return static_cast<Id>(std::llround(markPlace - y));
}

} // namespace sparkout
