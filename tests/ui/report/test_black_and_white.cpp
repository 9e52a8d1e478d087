// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of document as a printer without colours has it: what its figures draw is told apart
// by dash, weight, lightness or hatch, and every text stands out from its ground.
#include "core/setup/setup_run.h"
#include "tests/registry.h"
#include "tests/ui/support/ink.h"
#include "tests/ui/support/passport_bench.h"
#include "tests/ui/support/setup_fixtures.h"
#include "ui/report/format/pages.h"
#include "ui/report/report_kinds.h"

#include <QImage>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace sparkout::test_black_and_white {

using inks::Ink;
using inks::InkDevice;
using passport_bench::day;

constexpr double apart = 0.8; ///< of weights [px of the figure]
constexpr double textContrast = 4.5;
// Of A4 within its margins, and of a whole sheet that lies [units of the page].
constexpr QSizeF area(5'100, 7'700), sheetArea(8'419, 5'953);

/// What the eye takes of a grey [WCAG 2, relative luminance].
double luminance(int grey) {
    const double value = grey / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double contrast(int a, int b) {
    const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
    return (light + 0.05) / (dark + 0.05);
}

/// The grey that most of a place has.
int groundOf(const QImage& image, const QRectF& box) {
    std::array<int, 256> counts{};
    const QRect place = box.toAlignedRect().intersected(image.rect());
    for (int y = place.top(); y <= place.bottom(); ++y) {
        for (int x = place.left(); x <= place.right(); ++x) {
            ++counts.at(static_cast<std::size_t>(qGray(image.pixel(x, y))));
        }
    }
    return static_cast<int>(std::ranges::max_element(counts) - counts.begin());
}

/// Curves of two colours that are drawn alike.
QStringList alike(const report::Figure& figure) {
    Ink ink;
    InkDevice device(ink, figure.size.toSize());
    QPainter painter(&device);
    figure.paint(painter);
    painter.end();
    struct Look {
        double width;
        QVector<qreal> dash;
    };
    std::map<QRgb, std::vector<Look>> looks; // of what has a hue: grids and axes have none
    for (const Ink::Line& line : ink.lines) {
        if (QColor(line.colour).hsvSaturation() > 40) {
            looks[line.colour].push_back({line.width, line.dash});
        }
    }
    QStringList found;
    for (const auto& look : looks) {
        const QRgb colour = look.first;
        const std::vector<Look>& own = look.second;
        for (const auto& second : looks) {
            const QRgb other = second.first;
            const std::vector<Look>& others = second.second;
            const bool isSame =
                other < colour && std::ranges::any_of(own, [&others](const Look& a) {
                    return std::ranges::any_of(others, [&a](const Look& b) {
                        return a.dash == b.dash && std::abs(a.width - b.width) < apart;
                    });
                });
            if (isSame) {
                found << QStringLiteral("%1: %2 and %3 of weights near %4")
                             .arg(figure.caption, QColor(colour).name(), QColor(other).name())
                             .arg(own.front().width);
            }
        }
    }
    return found;
}

/// Texts of a page that do not stand out, as it is printed in greys.
QStringList faint(const report::Pages& pages, int page, const QSizeF& paper) {
    constexpr double scale = 0.2; // pixels a unit: 144 an inch
    QImage image((paper * scale).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(scale, scale);
    pages.paint(painter, page);
    painter.end();
    Ink ink;
    InkDevice device(ink, image.size());
    QPainter taker(&device);
    taker.scale(scale, scale);
    pages.paint(taker, page);
    taker.end();
    QStringList found;
    for (const Ink::Text& text : ink.texts) {
        const int ground = groundOf(image, text.box);
        const QRgb colour = text.colour.rgb();
        if (!text.text.trimmed().isEmpty() && contrast(qGray(colour), ground) < textContrast) {
            found << QStringLiteral("page %1: \"%2\" of grey %3 on %4")
                         .arg(page + 1)
                         .arg(text.text)
                         .arg(qGray(colour))
                         .arg(ground);
        }
    }
    return found;
}

class TestBlackAndWhite : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_subject = passport_bench::subjectOf(passport_bench::smallBatch());
        QVERIFY(m_subject.outcome && m_subject.outcome->ran() && m_subject.batch);
        const Setup setup = setup_fixtures::steppedShaft();
        m_subject.setup = std::make_shared<const report::SetupSubject>(
            report::SetupSubject{setup, runSetup(setup)});
    }

    void whatIsDrawnStaysApart_data() { addKinds(); }
    void whatIsDrawnStaysApart() {
        QFETCH(int, row);
        const report::Report made = report::kinds()[static_cast<std::size_t>(row)].make(m_subject);
        int figures = 0;
        for (const report::Block& block : made.blocks) {
            if (const auto* figure = std::get_if<report::Figure>(&block)) {
                ++figures;
                const QStringList found = alike(*figure);
                QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
            }
        }
        QVERIFY(figures > 0);
    }

    void everyTextStandsOut_data() { addKinds(); }
    void everyTextStandsOut() {
        QFETCH(int, row);
        const report::Report made = report::kinds()[static_cast<std::size_t>(row)].make(m_subject);
        const QSizeF paper = made.sheets.empty() ? area : sheetArea;
        const report::Pages pages(made, paper);
        QStringList found;
        for (int page = 0; page < pages.count(); ++page) {
            found += faint(pages, page, paper);
        }
        QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
    }

    /// Both checks see what they are to see.
    void whatIsAlikeOrFaintIsFound() {
        report::Figure figure;
        figure.size = {100, 100};
        figure.paint = [](QPainter& painter) {
            painter.setPen(QPen(Qt::red, 1.5));
            painter.drawPolyline(QPolygonF{{0, 0}, {50, 50}, {60, 50}});
            painter.setPen(QPen(Qt::blue, 1.5));
            painter.drawPolyline(QPolygonF{{0, 50}, {50, 0}, {60, 0}});
        };
        QCOMPARE(alike(figure).size(), 1);
        figure.paint = [](QPainter& painter) {
            painter.setPen(QPen(Qt::red, 1.5));
            painter.drawPolyline(QPolygonF{{0, 0}, {50, 50}, {60, 50}});
            painter.setPen(QPen(Qt::blue, 1.5, Qt::DashLine));
            painter.drawPolyline(QPolygonF{{0, 50}, {50, 0}, {60, 0}});
        };
        QVERIFY(alike(figure).isEmpty());
        figure.paint = [](QPainter& painter) {
            painter.fillRect(QRectF(0, 0, 100, 100), QColor(120, 120, 120));
            painter.setPen(Qt::red);
            painter.drawText(QRectF(0, 0, 100, 100), Qt::AlignCenter, QStringLiteral("text"));
        };
        report::Report made;
        made.title = QStringLiteral("Title");
        made.date = day;
        made.blocks = {figure};
        const report::Pages pages(made, area);
        QCOMPARE(faint(pages, 0, area).size(), 1);
    }

private:
    static void addKinds() {
        QTest::addColumn<int>("row");
        for (std::size_t row = 0; row < report::kinds().size(); ++row) {
            QTest::newRow(report::kinds()[row].key) << static_cast<int>(row);
        }
    }

    Language m_language;
    report::Subject m_subject;
};

} // namespace sparkout::test_black_and_white

SPARKOUT_TEST(test_black_and_white, TestBlackAndWhite)
#include "test_black_and_white.moc"
