// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/svg_device.h"

#include <QBuffer>
#include <QFont>
#include <QFontInfo>
#include <QHash>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

namespace sparkout {

namespace {

constexpr double millimetresPerInch = 25.4;
constexpr double pointsPerInch = 72;

QString number(double value) {
    return QString::number(value, 'g', 7);
}

/// Text between tags, without characters that XML does not allow.
QString xmlText(QString text) {
    text.removeIf([](QChar c) { return c.unicode() < 0x20 && c != u'\t' && c != u'\n'; });
    return text.toHtmlEscaped();
}

QString attribute(const char* name, const QString& value) {
    return QStringLiteral(" %1=\"%2\"").arg(QLatin1String(name), value.toHtmlEscaped());
}

/// Colour and, if it is not opaque, opacity.
QString paint(const char* name, const QColor& colour, double opacity) {
    const QString text = attribute(name, colour.name());
    const double alpha = colour.alphaF() * opacity;
    const QByteArray opacityName = QByteArray(name) + "-opacity";
    return alpha < 1 ? text + attribute(opacityName.constData(), number(alpha)) : text;
}

QString pathData(const QPainterPath& path) {
    QString d;
    for (int i = 0; i < path.elementCount(); ++i) {
        const QPainterPath::Element& e = path.elementAt(i);
        const QString at = number(e.x) + u' ' + number(e.y);
        switch (e.type) {
        case QPainterPath::MoveToElement: d += u'M' + at; break;
        case QPainterPath::LineToElement: d += u'L' + at; break;
        case QPainterPath::CurveToElement: d += u'C' + at; break;
        case QPainterPath::CurveToDataElement: d += u' ' + at; break;
        }
    }
    return d;
}

QString transformText(const QTransform& t) {
    return QStringLiteral("matrix(%1 %2 %3 %4 %5 %6)")
        .arg(number(t.m11()), number(t.m12()), number(t.m21()), number(t.m22()), number(t.dx()),
             number(t.dy()));
}

} // namespace

class SvgEngine : public QPaintEngine {
public:
    explicit SvgEngine(int dotsPerInch)
        : QPaintEngine(AllFeatures
                       & ~PaintEngineFeatures(PatternBrush | LinearGradientFill | RadialGradientFill
                                              | ConicalGradientFill | PerspectiveTransform
                                              | ObjectBoundingModeGradients))
        , m_dotsPerInch(dotsPerInch) {}

    [[nodiscard]] Type type() const override { return User; }
    bool begin(QPaintDevice*) override {
        m_body.clear();
        m_clipPaths.clear();
        m_clipNames.clear();
        m_clipping = false;
        return true;
    }
    bool end() override { return true; }
    void updateState(const QPaintEngineState& now) override;
    void drawPath(const QPainterPath& path) override { put(shape(pathData(path), true, true)); }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override;
    void drawTextItem(const QPointF& at, const QTextItem& item) override;
    void drawPixmap(const QRectF& target, const QPixmap& pixmap, const QRectF& source) override;
    void drawImage(const QRectF& target, const QImage& image, const QRectF& source,
                   Qt::ImageConversionFlags) override {
        drawPixmap(target, QPixmap::fromImage(image), source);
    }

    [[nodiscard]] const QString& body() const { return m_body; }
    [[nodiscard]] const QString& clips() const { return m_clipPaths; }

private:
    [[nodiscard]] QString shape(const QString& data, bool filled, bool nonZero) const;
    [[nodiscard]] QString strokeText() const;
    void put(const QString& element);
    void readClip(const QPaintEngineState& now);

    int m_dotsPerInch;
    QString m_body;
    QString m_clipPaths;                 ///< <clipPath> elements
    QHash<QString, QString> m_clipNames; ///< names by path data, in device coordinates
    QString m_clipName;
    bool m_clipping = false;
    QPainterPath m_clip;
    QPen m_pen;
    QBrush m_brush;
    QTransform m_transform;
    double m_opacity = 1;
};

void SvgEngine::updateState(const QPaintEngineState& now) {
    const DirtyFlags flags = now.state();
    if (flags & DirtyPen) {
        m_pen = now.pen();
    }
    if (flags & DirtyBrush) {
        m_brush = now.brush();
    }
    if (flags & DirtyTransform) {
        m_transform = now.transform();
    }
    if (flags & DirtyOpacity) {
        m_opacity = now.opacity();
    }
    if (flags & (DirtyClipPath | DirtyClipRegion | DirtyClipEnabled)) {
        readClip(now);
    }
}

void SvgEngine::readClip(const QPaintEngineState& now) {
    const DirtyFlags flags = now.state();
    if (flags & (DirtyClipPath | DirtyClipRegion)) {
        QPainterPath path;
        if (flags & DirtyClipPath) {
            path = now.clipPath();
        } else {
            path.addRegion(now.clipRegion());
        }
        path = m_transform.map(path);
        switch (now.clipOperation()) {
        case Qt::NoClip: m_clipping = false; break;
        case Qt::IntersectClip:
            m_clip = m_clipping ? m_clip.intersected(path) : path;
            m_clipping = true;
            break;
        case Qt::ReplaceClip:
            m_clip = path;
            m_clipping = true;
            break;
        }
    } else {
        m_clipping = now.isClipEnabled();
    }
    if (!m_clipping) {
        return;
    }
    const QString data = pathData(m_clip);
    m_clipName = m_clipNames.value(data);
    if (m_clipName.isEmpty()) {
        m_clipName = QStringLiteral("c%1").arg(m_clipNames.size() + 1);
        m_clipNames.insert(data, m_clipName);
        m_clipPaths += QStringLiteral("<clipPath id=\"%1\"><path d=\"%2\"/></clipPath>\n")
                           .arg(m_clipName, data);
    }
}

/// Clip paths are in device coordinates, hence in a group outside the transform.
void SvgEngine::put(const QString& element) {
    QString text = element;
    if (!m_transform.isIdentity()) {
        text = QStringLiteral("<g%1>%2</g>")
                   .arg(attribute("transform", transformText(m_transform)), text);
    }
    if (m_clipping) {
        text = QStringLiteral("<g clip-path=\"url(#%1)\">%2</g>").arg(m_clipName, text);
    }
    m_body += text + u'\n';
}

QString SvgEngine::strokeText() const {
    if (m_pen.style() == Qt::NoPen) {
        return {};
    }
    const double width = m_pen.widthF() > 0 ? m_pen.widthF() : 1;
    QString text =
        paint("stroke", m_pen.color(), m_opacity) + attribute("stroke-width", number(width));
    if (m_pen.isCosmetic()) {
        text += attribute("vector-effect", QStringLiteral("non-scaling-stroke"));
    }
    if (m_pen.style() != Qt::SolidLine) {
        QStringList dashes;
        for (const double dash : m_pen.dashPattern()) {
            dashes << number(dash * width);
        }
        text += attribute("stroke-dasharray", dashes.join(u','));
    }
    const Qt::PenCapStyle cap = m_pen.capStyle();
    if (cap != Qt::FlatCap) {
        text += attribute("stroke-linecap",
                          cap == Qt::RoundCap ? QStringLiteral("round") : QStringLiteral("square"));
    }
    const Qt::PenJoinStyle join = m_pen.joinStyle();
    text += attribute("stroke-linejoin", join == Qt::RoundJoin   ? QStringLiteral("round")
                                         : join == Qt::BevelJoin ? QStringLiteral("bevel")
                                                                 : QStringLiteral("miter"));
    return text;
}

QString SvgEngine::shape(const QString& data, bool filled, bool nonZero) const {
    const bool fills = filled && m_brush.style() != Qt::NoBrush;
    const QString fill =
        fills ? paint("fill", m_brush.color(), m_opacity)
                    + (nonZero ? QString() : attribute("fill-rule", QStringLiteral("evenodd")))
              : attribute("fill", QStringLiteral("none"));
    return QStringLiteral("<path%1%2%3/>").arg(attribute("d", data), fill, strokeText());
}

void SvgEngine::drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) {
    QPainterPath path;
    for (int i = 0; i < count; ++i) {
        i == 0 ? path.moveTo(points[i]) : path.lineTo(points[i]);
    }
    const bool closed = mode != PolylineMode;
    put(shape(pathData(path) + (closed ? QStringLiteral("Z") : QString()), closed,
              mode == WindingMode));
}

void SvgEngine::drawTextItem(const QPointF& at, const QTextItem& item) {
    const QFont font = item.font();
    const QFontInfo info(font);
    QString text = attribute("x", number(at.x())) + attribute("y", number(at.y()));
    text += attribute("font-family", QStringLiteral("'%1', sans-serif").arg(info.family()));
    const double size_px =
        font.pixelSize() > 0 ? font.pixelSize() : font.pointSizeF() * m_dotsPerInch / pointsPerInch;
    text += attribute("font-size", number(size_px));
    if (font.bold()) {
        text += attribute("font-weight", QStringLiteral("bold"));
    }
    if (font.italic()) {
        text += attribute("font-style", QStringLiteral("italic"));
    }
    text += paint("fill", m_pen.color(), m_opacity);
    put(QStringLiteral("<text xml:space=\"preserve\"%1>%2</text>").arg(text, xmlText(item.text())));
}

void SvgEngine::drawPixmap(const QRectF& target, const QPixmap& pixmap, const QRectF& source) {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    pixmap.copy(source.toRect()).save(&buffer, "PNG");
    put(QStringLiteral("<image%1%2%3%4 preserveAspectRatio=\"none\" "
                       "xlink:href=\"data:image/png;base64,%5\"/>")
            .arg(attribute("x", number(target.x())), attribute("y", number(target.y())),
                 attribute("width", number(target.width())),
                 attribute("height", number(target.height())),
                 QString::fromLatin1(png.toBase64())));
}

SvgDevice::SvgDevice(QSize size, int dotsPerInch, QString title)
    : m_size(size)
    , m_dotsPerInch(dotsPerInch)
    , m_title(std::move(title))
    , m_engine(std::make_unique<SvgEngine>(dotsPerInch)) {}

SvgDevice::~SvgDevice() = default;

QPaintEngine* SvgDevice::paintEngine() const {
    return m_engine.get();
}

QByteArray SvgDevice::document() const {
    const auto mm = [this](int dots) { return number(dots * millimetresPerInch / m_dotsPerInch); };
    return QStringLiteral("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                          "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                          "xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\" "
                          "width=\"%1mm\" height=\"%2mm\" viewBox=\"0 0 %3 %4\">\n"
                          "<title>%5</title>\n<defs>\n%6</defs>\n%7</svg>\n")
        .arg(mm(m_size.width()), mm(m_size.height()), QString::number(m_size.width()),
             QString::number(m_size.height()), xmlText(m_title), m_engine->clips(),
             m_engine->body())
        .toUtf8();
}

int SvgDevice::metric(PaintDeviceMetric metric) const {
    const auto mm = [this](int dots) { return qRound(dots * millimetresPerInch / m_dotsPerInch); };
    switch (metric) {
    case PdmWidth: return m_size.width();
    case PdmHeight: return m_size.height();
    case PdmWidthMM: return mm(m_size.width());
    case PdmHeightMM: return mm(m_size.height());
    case PdmNumColors: return 0x7fffffff;
    case PdmDepth: return 32;
    case PdmDevicePixelRatio: return 1;
    case PdmDevicePixelRatioScaled: return static_cast<int>(devicePixelRatioFScale());
    case PdmDpiX:
    case PdmDpiY:
    case PdmPhysicalDpiX:
    case PdmPhysicalDpiY: return m_dotsPerInch;
    }
    return 0;
}

} // namespace sparkout
