// SPDX-License-Identifier: GPL-3.0-or-later
// The themes: enough contrast everywhere, icons and pictures that follow, no colour beside the
// table.
#include "tests/registry.h"
#include "tests/ui/window_bench.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/mark.h"
#include "ui/inputs/number_field.h"
#include "ui/view_tabs.h"
#include "ui/views/feeds_plot.h"
#include "ui/views/light_icon.h"
#include "ui/views/plot_style.h"

#include <QAction>
#include <QApplication>
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QRegularExpression>
#include <QTest>

#include <cmath>

namespace test_theme {

using namespace sparkout;

namespace {

/// Relative luminance, WCAG 2.1.
double luminance(const QColor& colour) {
    const auto linear = [](double c) {
        return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF())
           + 0.0722 * linear(colour.blueF());
}

/// Contrast ratio, WCAG 2.1: 1 to 21.
double contrast(const QColor& one, const QColor& other) {
    const double a = luminance(one);
    const double b = luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

/// What a translucent colour looks like on a ground.
QColor over(const QColor& colour, const QColor& ground) {
    const auto mix = [a = colour.alphaF()](double top, double below) {
        return static_cast<float>(a * top + (1 - a) * below);
    };
    return QColor::fromRgbF(mix(colour.redF(), ground.redF()),
                            mix(colour.greenF(), ground.greenF()),
                            mix(colour.blueF(), ground.blueF()));
}

void verifyContrast(const char* what, const QColor& colour, const QColor& ground, double least) {
    const double is = contrast(colour, ground);
    QVERIFY2(is >= least, qPrintable(QStringLiteral("%1: %2 on %3 has %4, needs %5")
                                         .arg(QString::fromUtf8(what), colour.name(), ground.name())
                                         .arg(is, 0, 'f', 2)
                                         .arg(least)));
}

constexpr double textContrast = 4.5;  ///< WCAG 2.1, 1.4.3
constexpr double graphContrast = 3.0; ///< WCAG 2.1, 1.4.11

QStringList sources() {
    QStringList list;
    for (const char* folder : {"/ui", "/app"}) {
        QDirIterator it(QStringLiteral(SPARKOUT_SOURCE_DIR) + QString::fromUtf8(folder),
                        {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext()) {
            list += it.next();
        }
    }
    return list;
}

QString textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The share of light pixels of a picture.
double lightShare(const QImage& image) {
    int light = 0;
    int all = 0;
    for (int y = 0; y < image.height(); y += 3) {
        for (int x = 0; x < image.width(); x += 3) {
            light += image.pixelColor(x, y).lightness() > 127;
            ++all;
        }
    }
    return double(light) / all;
}

QColor mostCommonSolid(const QImage& image) {
    QHash<QRgb, int> counts;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (qAlpha(image.pixel(x, y)) == 255) {
                ++counts[image.pixel(x, y)];
            }
        }
    }
    QRgb best = 0;
    for (auto it = counts.cbegin(); it != counts.cend(); ++it) {
        best = it.value() > counts.value(best) ? it.key() : best;
    }
    return QColor(best);
}

} // namespace

class TestTheme : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { applyTheme(Theme::light); }

    void everyPairOfATheme_data() {
        QTest::addColumn<int>("theme");
        for (const Theme theme : {Theme::light, Theme::dark, Theme::contrast}) {
            QTest::addRow("%s", qPrintable(themeCode(theme))) << int(theme);
        }
    }

    void everyPairOfATheme() {
        QFETCH(int, theme);
        const QPalette p = paletteOf(Theme(theme));
        const auto role = [&p](QPalette::ColorRole r) { return p.color(QPalette::Active, r); };
        const QColor window = role(QPalette::Window);
        const QColor base = role(QPalette::Base);
        const QColor alternate = role(QPalette::AlternateBase);
        verifyContrast("text of labels", role(QPalette::WindowText), window, textContrast);
        for (const QColor& ground : {base, alternate}) {
            verifyContrast("text", role(QPalette::Text), ground, textContrast);
        }
        verifyContrast("text of buttons", role(QPalette::ButtonText), role(QPalette::Button),
                       textContrast);
        verifyContrast("selected text", role(QPalette::HighlightedText), role(QPalette::Highlight),
                       textContrast);
        verifyContrast("tooltips", role(QPalette::ToolTipText), role(QPalette::ToolTipBase),
                       textContrast);
        for (const QColor& ground : {window, base, alternate}) {
            verifyContrast("links", role(QPalette::Link), ground, textContrast);
            verifyContrast("captions", role(QPalette::PlaceholderText), ground, textContrast);
            verifyContrast("refused", markColor(Mark::error, p), ground, textContrast);
            verifyContrast("unusual", markColor(Mark::warning, p), ground, textContrast);
            verifyContrast("outlines", tone(Tone::outline, p), ground, graphContrast);
            verifyContrast("focus", role(QPalette::Highlight), ground, graphContrast);
            verifyContrast("disabled", p.color(QPalette::Disabled, QPalette::Text), ground,
                           graphContrast);
            for (const Tone icon : {Tone::ink, Tone::accent, Tone::add, Tone::remove}) {
                verifyContrast("icons", tone(icon, p), ground, graphContrast);
            }
        }
    }

    void curvesAndLightsStandOut_data() { everyPairOfATheme_data(); }

    void curvesAndLightsStandOut() {
        QFETCH(int, theme);
        const QPalette p = paletteOf(Theme(theme));
        using style::Hue;
        for (const QColor& ground : {p.color(QPalette::Base), p.color(QPalette::AlternateBase),
                                     p.color(QPalette::Window)}) {
            // Sky and yellow only fill bands, which have names.
            for (const Hue hue :
                 {Hue::blue, Hue::vermilion, Hue::orange, Hue::green, Hue::purple}) {
                verifyContrast("curves and lights", style::colour(hue, p), ground, graphContrast);
            }
        }
        QCustomPlot plot;
        style::applyPalette(plot, p);
        const QColor base = p.color(QPalette::Base);
        verifyContrast("axes", over(plot.xAxis->basePen().color(), base), base, graphContrast);
        verifyContrast("ticks", over(plot.xAxis->tickPen().color(), base), base, graphContrast);
        verifyContrast("numbers", plot.xAxis->tickLabelColor(), base, textContrast);
    }

    void aThemeIsKnownByItsPaletteAndItsName() {
        for (const Theme theme : {Theme::light, Theme::dark, Theme::contrast}) {
            applyTheme(theme);
            QCOMPARE(appliedTheme(), theme);
            QCOMPARE(tone(Tone::ink, QApplication::palette()), tone(Tone::ink, paletteOf(theme)));
            QCOMPARE(themeFrom(themeCode(theme)), theme);
        }
        QCOMPARE(themeFrom(QStringLiteral("no such")), Theme::system);
        QVERIFY(!isThemeCode(QStringLiteral("no such")));
    }

    void asTheSystemFollowsThePaletteQtStartsWith() {
        applyTheme(Theme::dark); // must not be taken for the system's
        applyTheme(Theme::system);
        QVERIFY(!isDark(QApplication::palette())); // of the offscreen platform
        QCOMPARE(appliedTheme(), Theme::system);
    }

    void noSourceHasAColourOfItsOwn() {
        // Black, white and transparent as such are no theme's business when they are no surface.
        static const QRegularExpression own(QStringLiteral(
            "QColor\\((0x|\"#|\\d)|Qt::(dark|light)?(red|green|blue|cyan|magenta|yellow|gray)\\b"
            "|Qt::(black|white)\\b|setStyleSheet|:/icons/(?!sparkout\\.svg|%1)"));
        QStringList offenders;
        for (const QString& path : sources()) {
            const bool table = path.contains(QStringLiteral("/ui/theme"));
            int number = 0;
            for (const QString& line : textOf(path).split(u'\n')) {
                ++number;
                if (!table && own.match(line).hasMatch()) {
                    offenders += QStringLiteral("%1:%2: %3").arg(path).arg(number).arg(line);
                }
            }
        }
        QVERIFY2(offenders.isEmpty(), qPrintable(offenders.join(u'\n')));
    }

    void everyIconIsDrawnInTheThemesColours() {
        static const QRegularExpression colour(QStringLiteral("#[0-9a-fA-F]{3,8}\\b"));
        QDirIterator it(QStringLiteral(":/icons"), QDir::Files);
        int icons = 0;
        while (it.hasNext()) {
            const QString path = it.next();
            if (path.endsWith(QStringLiteral("sparkout.svg"))) {
                continue; // the program's own, on a ground of its own
            }
            ++icons;
            for (auto found = colour.globalMatch(textOf(path)); found.hasNext();) {
                const QByteArray written = found.next().captured().toLatin1();
                const auto& known = iconColours();
                QVERIFY2(std::ranges::any_of(
                             known, [&](const IconColour& c) { return written == c.written; }),
                         qPrintable(path + QStringLiteral(": ") + QString::fromLatin1(written)));
            }
        }
        QVERIFY(icons > 10);
    }

    void anIconChangesWithTheThemeAndIsSharpOnDenseScreens() {
        const QIcon icon = themeIcon(u"cycle");
        applyTheme(Theme::light);
        const QImage light = icon.pixmap(QSize(22, 22), 1.0).toImage();
        applyTheme(Theme::dark);
        const QImage dark = icon.pixmap(QSize(22, 22), 1.0).toImage();
        QCOMPARE(light.size(), QSize(22, 22));
        QVERIFY(light != dark);
        const QPixmap dense = icon.pixmap(QSize(22, 22), 2.0);
        QCOMPARE(dense.size(), QSize(44, 44));
        QCOMPARE(dense.devicePixelRatio(), 2.0);
        QVERIFY(dense.toImage().copy() != light.scaled(44, 44)); // drawn anew, not stretched
        const QImage grey = icon.pixmap(QSize(22, 22), 1.0, QIcon::Disabled).toImage();
        QVERIFY(grey != dark);
        QVERIFY(themeIcon(u"no such").pixmap(22, 22).isNull());
    }

    void theLightsAreOfTheTheme() {
        for (const Theme theme : {Theme::light, Theme::dark, Theme::contrast}) {
            applyTheme(theme);
            const QPalette p = QApplication::palette();
            QCOMPARE(mostCommonSolid(lightPixmap(Light::holds, 16, 1, false).toImage()),
                     style::colour(style::Hue::green, p));
            QCOMPARE(mostCommonSolid(lightPixmap(Light::fails, 16, 1, false).toImage()),
                     style::colour(style::Hue::vermilion, p));
        }
    }

    void theMenuSwitchesTheWholeWindowWithoutARestart() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(examplePaths().front()));
        bench.window->inputs().showPage(0);
        auto* field = bench.window->findChild<NumberField*>(QStringLiteral("/part/diameter_mm"));
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("thirty")); // a marked text must be marked anew
        QTest::keyClick(field, Qt::Key_Return);
        bench.settle();
        QVERIFY(lightShare(bench.window->grab().toImage()) > 0.8);
        for (const Theme theme : {Theme::dark, Theme::contrast, Theme::light}) {
            const QByteArray name = "theme-" + themeCode(theme).toLatin1();
            QAction* action = bench.action(name.constData());
            QVERIFY(action);
            action->trigger();
            bench.settle();
            QVERIFY(action->isChecked());
            QCOMPARE(bench.settings.theme(), themeCode(theme));
            const double light = lightShare(bench.window->grab().toImage());
            QVERIFY2(theme == Theme::light ? light > 0.8 : light < 0.15,
                     qPrintable(QString::number(light)));
            const QColor wanted = tone(Tone::error, QApplication::palette());
            int marked = 0;
            for (const auto* label : bench.window->findChildren<QLabel*>()) {
                const bool reason =
                    label->isVisible() && label->text().contains(QStringLiteral("is not a number"));
                if (reason && label->window() == bench.window.get()) {
                    QCOMPARE(label->palette().color(QPalette::WindowText), wanted);
                    ++marked;
                }
            }
            QVERIFY(marked > 0);
        }
    }

    void aPlotInAWindowOfItsOwnFollowsToo() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(examplePaths().front()));
        bench.action("theme-dark")->trigger();
        bench.settle();
        for (auto* plot : bench.window->findChildren<QCustomPlot*>()) {
            QVERIFY(lightShare(plot->toPixmap(300, 300).toImage()) < 0.3);
        }
    }
};

} // namespace test_theme

SPARKOUT_TEST(test_theme, TestTheme)
#include "test_theme.moc"
