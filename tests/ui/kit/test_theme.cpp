// SPDX-License-Identifier: GPL-3.0-or-later
// The themes: enough contrast everywhere, icons and pictures that follow, no colour beside the
// table.
#include "tests/registry.h"
#include "tests/ui/support/typing.h"
#include "tests/ui/support/window_bench.h"
#include "tests/ui/views/cycle/feeds_bench.h"
#include "ui/chart/view.h"
#include "ui/chart/view_plot.h"
#include "ui/form/mark.h"
#include "ui/form/number_field.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/kit/theme_icon.h"
#include "ui/results/verdict_table.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QApplication>
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QRegularExpression>
#include <QTabBar>

#include <algorithm>
#include <array>
#include <cmath>

namespace sparkout::test_theme {

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

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix& m, const Triple& v) {
    Triple made{};
    for (std::size_t i = 0; i < 3; ++i) {
        made[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    }
    return made;
}

/// What eyes see: of everybody, without the long cones, without the middle ones (Machado 2009).
constexpr std::array<Matrix, 3> eyes{{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                      {{{0.152286, 1.052583, -0.204868},
                                        {0.114503, 0.786281, 0.099216},
                                        {-0.003882, -0.048116, 1.051998}}},
                                      {{{0.367322, 0.860646, -0.227968},
                                        {0.280085, 0.672501, 0.047413},
                                        {-0.011820, 0.042940, 0.968881}}}}};

/// CIE L*a*b* of an opaque colour as seen.
Triple labOf(const QColor& colour, const Matrix& eye) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    Triple seen =
        times(eye, {linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())});
    for (double& c : seen) {
        c = std::clamp(c, 0.0, 1.0);
    }
    constexpr Matrix toXyz{
        {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
    const Triple xyz = times(toXyz, seen);
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const Triple of{f(xyz[0] / 0.95047), f(xyz[1]), f(xyz[2] / 1.08883)};
    return {116 * of[1] - 16, 500 * (of[0] - of[1]), 200 * (of[1] - of[2])};
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

class TestTheme : public QObject {
    Q_OBJECT

private slots:
    // A difference of 2.3 is just noticeable side by side.
    void theStepsOfAZoneStayApartForColourBlindReaders() {
        for (const Theme theme : {Theme::light, Theme::dark, Theme::contrast}) {
            const QPalette palette = paletteOf(theme);
            const QColor ground = palette.color(QPalette::Base);
            std::vector<QColor> bands;
            for (const Step step : {Step::e1, Step::e2, Step::e3, Step::e4, Step::e5}) {
                bands.push_back(over(FeedsChart::stepColour(Zone::rz1, step, palette), ground));
            }
            for (std::size_t i = 0; i < bands.size(); ++i) {
                for (std::size_t k = 0; k < i; ++k) {
                    for (const Matrix& eye : eyes) {
                        const Triple a = labOf(bands[i], eye);
                        const Triple b = labOf(bands[k], eye);
                        const double apart = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
                        QVERIFY2(apart > 2 * 2.3, qPrintable(QStringLiteral("%1: E%2, E%3: %4")
                                                                 .arg(themeCode(theme))
                                                                 .arg(k + 1)
                                                                 .arg(i + 1)
                                                                 .arg(apart)));
                    }
                }
            }
        }
    }

    /// By dash and weight: colours are lost in black and white print.
    void theCurvesOfAPlotStayApartWithoutColour() {
        Bench bench(QStringLiteral("en"));
        const QStringList all = examplePaths();
        const auto traverse = std::ranges::find(all, QStringLiteral("shaft-30h6-factory"),
                                                [](const QString& path) { return nameOf(path); });
        QVERIFY(traverse != all.end() && bench.open(*traverse));
        int lines = 0;
        for (const char* name : {"feeds", "profiles", "constraints", "compliance"}) {
            QVERIFY(bench.window->showView(QString::fromLatin1(name)));
            bench.settle();
            for (const auto* plot :
                 bench.window->viewTabs().currentView()->findChildren<ViewPlot*>()) {
                LegendEntries entries = plot->legendEntries();
                std::erase_if(entries, [](const LegendEntry& e) { return e.pen == Qt::NoPen; });
                lines += static_cast<int>(entries.size());
                for (std::size_t i = 0; i < entries.size(); ++i) {
                    for (std::size_t k = 0; k < i; ++k) {
                        const LegendEntry &a = entries[k], &b = entries[i];
                        QVERIFY2(a.pen != b.pen || a.dash != b.dash
                                     || std::abs(a.weight - b.weight) > 0.9,
                                 qPrintable(QStringLiteral("%1: %2, %3")
                                                .arg(QString::fromLatin1(name), a.text, b.text)));
                    }
                }
            }
        }
        QVERIFY(lines > 10);
    }

    void theCurvesOfTheFeedsAreAsInTheirLegend() {
        Bench bench(QStringLiteral("en"));
        const QStringList all = examplePaths();
        const auto traverse = std::ranges::find(all, QStringLiteral("shaft-30h6-factory"),
                                                [](const QString& path) { return nameOf(path); });
        QVERIFY(traverse != all.end() && bench.open(*traverse));
        QVERIFY(bench.window->showView(QStringLiteral("feeds")));
        bench.settle();
        const auto* plot = bench.window->findChild<FeedsPlot*>();
        const LegendEntries entries = plot->legendEntries();
        for (const Quantity quantity : {Quantity::programmed, Quantity::actual, Quantity::came,
                                        Quantity::left, Quantity::axialFeed, Quantity::force}) {
            const ChartSeries& series = *feeds_bench::curve(*plot, 0, quantity);
            QPen pen = series.pen;
            pen.setColor(chartColour(series.colour, plot->palette()));
            QCOMPARE(std::ranges::count_if(entries,
                                           [&pen](const LegendEntry& e) {
                                               return e.colour == pen.color()
                                                      && e.pen == pen.style()
                                                      && e.weight == pen.widthF();
                                           }),
                     1);
        }
    }

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
            verifyContrast("missing", markColor(Mark::missing, p), ground, textContrast);
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
        for (const QColor& ground : {p.color(QPalette::Base), p.color(QPalette::AlternateBase),
                                     p.color(QPalette::Window)}) {
            // Sky and yellow only fill bands, which have names.
            for (const Tone curve :
                 {Tone::blue, Tone::vermilion, Tone::orange, Tone::green, Tone::purple}) {
                verifyContrast("curves and lights", tone(curve, p), ground, graphContrast);
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
            const bool table = path.contains(QStringLiteral("/ui/kit/theme"));
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
                     style::colour(style::Drawn::holds, p));
            QCOMPARE(mostCommonSolid(lightPixmap(Light::fails, 16, 1, false).toImage()),
                     style::colour(style::Drawn::fails, p));
        }
    }

    void theChosenTabIsMarked() {
        for (const Theme theme : {Theme::light, Theme::dark, Theme::contrast}) {
            applyTheme(theme);
            QTabBar tabs;
            for (const char* name : {"one", "two", "three"}) {
                tabs.addTab(QLatin1String(name));
            }
            tabs.setCurrentIndex(1);
            tabs.resize(tabs.sizeHint());
            const QImage drawn = tabs.grab().toImage();
            const QColor wanted = tone(Tone::accent, QApplication::palette());
            for (int tab = 0; tab < tabs.count(); ++tab) {
                const QRect at = tabs.tabRect(tab);
                const bool isMarked = drawn.pixelColor(at.center().x(), at.top()) == wanted;
                QCOMPARE(isMarked, tab == tabs.currentIndex());
            }
            QVERIFY(contrast(wanted, QApplication::palette().color(QPalette::Window)) >= 3);
        }
    }

    void theMenuSwitchesTheWholeWindowWithoutARestart() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        bench.window->inputs().showPage(0);
        auto* field = bench.window->findChild<NumberField*>(QStringLiteral("/part/diameter_mm"));
        typeOver(*field, QStringLiteral("thirty")); // a marked text must be marked anew
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
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        bench.action("theme-dark")->trigger();
        bench.settle();
        for (View* view : bench.window->views()) {
            QVERIFY(bench.window->showView(view->objectName()));
            bench.settle();
            for (auto* plot : view->findChildren<QCustomPlot*>()) {
                QVERIFY2(lightShare(plot->toPixmap(300, 300).toImage()) < 0.3,
                         qPrintable(view->objectName()));
            }
        }
    }
};

} // namespace sparkout::test_theme

SPARKOUT_TEST(test_theme, TestTheme)
#include "test_theme.moc"
