// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/theme_icon.h"

#include <QBuffer>
#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QImageReader>
#include <QPainter>
#include <QPixmapCache>
#include <QToolButton>

namespace sparkout {

namespace {

constexpr double disabledIconOpacity = 0.4;

QByteArray coloured(QByteArray svg, const QPalette& palette) {
    // Uses intermediate names that no theme can contain, since one theme's colour may be another's
    // original one.
    int number = 0;
    for (const IconColour& c : iconColours()) {
        svg.replace(c.written, '\x01' + QByteArray::number(++number) + '\x02');
    }
    number = 0;
    for (const IconColour& c : iconColours()) {
        svg.replace('\x01' + QByteArray::number(++number) + '\x02',
                    tone(c.tone, palette).name().toLatin1());
    }
    return svg;
}

QPixmap drawn(const QString& name, const QSize& pixels, const QPalette& palette) {
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QByteArray svg = coloured(file.readAll(), palette);
    QBuffer buffer(&svg);
    QImageReader reader(&buffer, "svg");
    reader.setScaledSize(pixels);
    reader.setBackgroundColor(Qt::transparent);
    return QPixmap::fromImage(reader.read());
}

class ThemeIconEngine : public QIconEngine {
public:
    explicit ThemeIconEngine(QString name) : m_name(std::move(name)) {}

    QString key() const override { return QStringLiteral("sparkout"); }
    QString iconName() override { return m_name; }
    QIconEngine* clone() const override { return new ThemeIconEngine(*this); }
    QSize actualSize(const QSize& size, QIcon::Mode, QIcon::State) override {
        const int side = std::min(size.width(), size.height());
        return {side, side};
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        return scaledPixmap(size, mode, state, 1);
    }

    /// The size is in device pixels.
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state,
                         qreal scale) override {
        const QSize pixels = actualSize(size, mode, state);
        if (pixels.isEmpty()) {
            return {};
        }
        const QPalette palette = QGuiApplication::palette();
        const bool grey = mode == QIcon::Disabled;
        const QString key = QStringLiteral("sparkout-icon %1 %2 %3 %4 %5")
                                .arg(m_name)
                                .arg(pixels.width())
                                .arg(grey)
                                .arg(tone(Tone::ink, palette).rgb())
                                .arg(scale);
        QPixmap pixmap;
        if (!QPixmapCache::find(key, &pixmap)) {
            pixmap = drawn(m_name, pixels, palette);
            pixmap = grey ? faded(pixmap) : pixmap;
            pixmap.setDevicePixelRatio(scale);
            QPixmapCache::insert(key, pixmap);
        }
        return pixmap;
    }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode,
               QIcon::State state) override {
        const qreal ratio = painter->device()->devicePixelRatioF();
        const QPixmap shown = scaledPixmap(rect.size() * ratio, mode, state, ratio);
        QRect place(QPoint(0, 0), actualSize(rect.size(), mode, state));
        place.moveCenter(rect.center());
        painter->drawPixmap(place, shown);
    }

private:
    static QPixmap faded(const QPixmap& full) {
        QPixmap pixmap(full.size());
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setOpacity(disabledIconOpacity);
        painter.drawPixmap(0, 0, full);
        return pixmap;
    }

    QString m_name;
};

} // namespace

const std::vector<IconColour>& iconColours() {
    static const std::vector<IconColour> colours{
        {"#3b4754", Tone::ink},      {"#ffffff", Tone::paper},    {"#cfe0f2", Tone::steel},
        {"#f3d9c2", Tone::abrasive}, {"#c06a1e", Tone::grain},    {"#fbe6b4", Tone::sand},
        {"#2f6fb0", Tone::accent},   {"#3c8f4e", Tone::add},      {"#b31d1d", Tone::remove},
        {"#f2b632", Tone::amber},    {"#4a3200", Tone::amberInk},
    };
    return colours;
}

QIcon themeIcon(QStringView name) {
    return QIcon(new ThemeIconEngine(name.toString()));
}

QToolButton* flatButton(QWidget* parent, const char* name, const char16_t* icon) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setIcon(themeIcon(icon));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

} // namespace sparkout
