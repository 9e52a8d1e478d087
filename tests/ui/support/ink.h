// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>

#include <cmath>
#include <vector>

namespace sparkout::inks {

/// What a painter draws, in place of drawing it.
struct Ink {
    struct Line {
        QRgb colour;
        double width;
        QVector<qreal> dash;
    };
    struct Text {
        QString text;
        QRectF box;  ///< on the device
        QRectF caps; ///< of it what capitals fill
        QColor colour;
    };
    std::vector<Line> lines;
    std::vector<Text> texts;
};

class InkEngine : public QPaintEngine {
public:
    explicit InkEngine(Ink& ink) : QPaintEngine(AllFeatures), m_ink(ink) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState& now) override {
        if (now.state() & DirtyPen) {
            m_pen = now.pen();
        }
        if (now.state() & DirtyTransform) {
            m_transform = now.transform();
        }
    }
    void drawPath(const QPainterPath& path) override { addLine(path.elementCount()); }
    void drawPolygon(const QPointF*, int count, PolygonDrawMode) override { addLine(count); }
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        const QRectF box(at.x(), at.y() - item.ascent(), item.width(),
                         item.ascent() + item.descent());
        const double high = item.ascent() * 0.7;
        const QRectF caps(at.x(), at.y() - high, item.width(), high);
        m_ink.texts.push_back({item.text(), m_transform.mapRect(box),
                               painter()->combinedTransform().mapRect(caps), m_pen.color()});
    }

private:
    /// A solid stroke from one point to another is no curve: the edge of a field, a mark, which
    /// are told by their form.
    void addLine(int points) {
        const bool isStroke = points == 2 && m_pen.style() == Qt::SolidLine;
        if (m_pen.style() != Qt::NoPen && m_pen.color().alpha() > 0 && points > 1 && !isStroke) {
            const double scale =
                m_pen.isCosmetic() ? 1 : std::sqrt(std::abs(m_transform.determinant()));
            m_ink.lines.push_back(
                {m_pen.color().rgb(), m_pen.widthF() * scale, m_pen.dashPattern()});
        }
    }

    Ink& m_ink;
    QPen m_pen;
    QTransform m_transform;
};

class InkDevice : public QPaintDevice {
public:
    InkDevice(Ink& ink, const QSize& size) : m_engine(ink), m_size(size) {}
    QPaintEngine* paintEngine() const override { return &m_engine; }

protected:
    int metric(PaintDeviceMetric metric) const override {
        constexpr int dots = 96; // an inch
        switch (metric) {
        case PdmWidth: return m_size.width();
        case PdmHeight: return m_size.height();
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY: return dots;
        case PdmNumColors: return 1 << 24;
        case PdmDepth: return 32;
        case PdmDevicePixelRatio: return 1;
        case PdmDevicePixelRatioScaled: return static_cast<int>(devicePixelRatioFScale());
        default: return 0;
        }
    }

private:
    mutable InkEngine m_engine;
    QSize m_size;
};

} // namespace sparkout::inks
