// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/plot_tools.h"

#include "core/units.h"
#include "core/version.h"
#include "ui/chart/painted_layer.h"
#include "ui/chart/svg_device.h"
#include "ui/chart/view_plot.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/kit/keyboard.h"
#include "ui/kit/pdf_details.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/table/pasted_cells.h"
#include "ui/text/number_text.h"

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QLocale>
#include <QMenu>
#include <QPdfWriter>
#include <QPicture>
#include <QStatusTipEvent>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <qcustomplot.h>

namespace sparkout {

namespace {

constexpr double mmPerInch = 25.4;
constexpr int margin = 8;

QFont titleFont(const QCustomPlot& plot) {
    QFont font = plot.font();
    font.setBold(true);
    return font;
}

/// A heading's lines wrapped to the width; the user's texts may be long.
std::vector<QRect> headingRects(const PlotPicture& picture, int width) {
    std::vector<QRect> rects;
    int y = margin;
    for (qsizetype i = 0; i < picture.heading.size(); ++i) {
        const QFontMetrics metrics(i == 0 ? titleFont(*picture.plot) : picture.plot->font());
        const QRect room(margin, y, width - 2 * margin, 10 * metrics.height());
        const int height =
            metrics.boundingRect(room, Qt::TextWrapAnywhere, picture.heading[i]).height();
        rects.emplace_back(margin, y, room.width(), std::min(height, 3 * metrics.height()));
        y += rects.back().height();
    }
    return rects;
}

/// The layout of a picture.
struct PictureSheet {
    std::vector<QRect> heading;
    LegendEntries entries;
    std::vector<QRect> legend; ///< rectangles from (0, 0)
    QPoint legendAt;
    QRect plot;
    QSize size;
};

PictureSheet layOut(const PlotPicture& picture) {
    PictureSheet sheet;
    const int width = picture.plot->width();
    sheet.heading = headingRects(picture, width);
    int y = sheet.heading.empty() ? margin : sheet.heading.back().bottom() + 1 + margin / 2;
    std::ranges::copy_if(picture.legend, std::back_inserter(sheet.entries), &LegendEntry::shown);
    sheet.legend =
        legendRects(sheet.entries, QFontMetrics(picture.plot->font()), width - 2 * margin);
    sheet.legendAt = {margin, y};
    y += legendHeight(sheet.legend) + margin / 2;
    sheet.plot = {0, y, width, picture.plot->height()};
    sheet.size = {width, y + picture.plot->height() + margin};
    return sheet;
}

struct PlotWords {
    Q_DECLARE_TR_FUNCTIONS(PlotWords)
public:
    /// The alternative text: the axes and the curves.
    static QString of(const PlotPicture& picture, const LegendEntries& entries) {
        QStringList axes, curves, all = picture.heading.mid(0, 1);
        for (const QCPAxisRect* rect : picture.plot->axisRects()) {
            for (const QCPAxis* axis : style::axesOf(*rect)) {
                if (axis->visible() && !axis->label().isEmpty()) {
                    axes << axis->label();
                }
            }
        }
        for (const LegendEntry& entry : entries) {
            curves << entry.text;
        }
        axes.removeDuplicates();
        if (!axes.isEmpty()) {
            all << tr("axes: %1").arg(axes.join(QStringLiteral("; ")));
        }
        if (!curves.isEmpty()) {
            all << tr("shown: %1").arg(curves.join(QStringLiteral("; ")));
        }
        return all.join(QStringLiteral(". "));
    }
};

void paintHeading(QCPPainter& painter, const PlotPicture& picture, const PictureSheet& sheet,
                  std::size_t line) {
    const QCustomPlot& plot = *picture.plot;
    painter.setPen(plot.palette().color(QPalette::Text));
    painter.setFont(line == 0 ? titleFont(plot) : plot.font());
    painter.drawText(sheet.heading[line], Qt::AlignLeft | Qt::AlignTop | Qt::TextWrapAnywhere,
                     picture.heading[static_cast<qsizetype>(line)]);
}

void paintPlot(QCPPainter& painter, const PlotPicture& picture, const PictureSheet& sheet) {
    QCustomPlot& plot = *picture.plot;
    painter.setFont(plot.font());
    for (std::size_t i = 0; i < sheet.legend.size(); ++i) {
        drawLegendEntry(painter, sheet.entries[i], sheet.legend[i].translated(sheet.legendAt),
                        plot.palette().color(QPalette::Text));
    }
    painter.save();
    painter.translate(sheet.plot.topLeft());
    plot.toPainter(&painter, sheet.plot.width(), sheet.plot.height());
    painter.restore();
}

/// A recorded drawing, independent of the plot, so that another thread may replay it.
struct Recording {
    struct Piece {
        QPicture drawing;
        PdfStructure::Id element;
    };
    std::vector<Piece> pieces;
    PdfStructure structure;
    QSize size;
    int dotsPerInch;
    QString title;
    QString language;
};

Recording record(const PlotPicture& picture, bool vectors) {
    const PictureSheet sheet = layOut(picture);
    Recording recording{{},
                        {},
                        sheet.size,
                        picture.plot->logicalDpiX(),
                        picture.heading.join(QStringLiteral(" — ")),
                        QLocale().bcp47Name().section(u'-', 0, 0)};
    const auto add = [&](PdfStructure::Id element, const std::function<void(QCPPainter&)>& paint) {
        recording.pieces.push_back({QPicture(), element});
        QCPPainter painter(&recording.pieces.back().drawing);
        painter.setModes(QCPPainter::pmNoCaching | QCPPainter::pmNonCosmetic);
        painter.setMode(QCPPainter::pmVectorized, vectors);
        paint(painter);
        painter.end();
    };
    PdfStructure& structure = recording.structure;
    add(PdfStructure::artifact, [&](QCPPainter& painter) {
        painter.fillRect(QRect(QPoint(), sheet.size),
                         picture.plot->palette().color(QPalette::Base));
    });
    for (std::size_t i = 0; i < sheet.heading.size(); ++i) {
        add(structure.add({i == 0 ? "H1" : "P"}),
            [&](QCPPainter& painter) { paintHeading(painter, picture, sheet, i); });
    }
    const QRectF box(0, sheet.legendAt.y(), sheet.size.width(),
                     sheet.size.height() - sheet.legendAt.y());
    add(structure.add(
            {"Figure", PdfStructure::document, PlotWords::of(picture, sheet.entries), 1, box}),
        [&](QCPPainter& painter) { paintPlot(painter, picture, sheet); });
    return recording;
}

bool replay(const Recording& recording, QPaintDevice& device, int scale, bool marks = false) {
    QPainter painter;
    if (!painter.begin(&device)) {
        return false;
    }
    painter.scale(scale, scale);
    for (const Recording::Piece& piece : recording.pieces) {
        if (marks) {
            PdfStructure::mark(painter, piece.element);
        }
        painter.drawPicture(0, 0, piece.drawing);
    }
    return painter.end();
}

QImage rendered(const Recording& recording, int scale) {
    scale = std::clamp(scale, 1, largestPictureScale);
    QImage image(recording.size * scale, QImage::Format_RGB32);
    if (image.isNull() || !replay(recording, image, scale)) {
        return {};
    }
    // Set last, since it would enlarge the fonts.
    const int dotsPerMetre = qRound(recording.dotsPerInch * scale * units::mmPerM / mmPerInch);
    image.setDotsPerMeterX(dotsPerMetre);
    image.setDotsPerMeterY(dotsPerMetre);
    return image;
}

QByteArray pdf(const Recording& recording, const std::optional<PdfAttachment>& project) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly)) {
        return {};
    }
    bool drawn = false;
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(recording.dotsPerInch);
        const QSizeF inches = QSizeF(recording.size) / recording.dotsPerInch;
        writer.setPageSize(QPageSize(inches, QPageSize::Inch, {}, QPageSize::ExactMatch));
        writer.setPageMargins(QMarginsF());
        drawn = replay(recording, writer, 1, true);
    }
    PdfDetails details{recording.title,
                       {},
                       {},
                       QStringLiteral("Sparkout %1").arg(QString::fromUtf8(version)),
                       recording.language,
                       documentDay(),
                       {},
                       recording.structure,
                       project};
    constexpr double pointsPerInch = 72;
    details.structure.placeBoxes(pointsPerInch / recording.dotsPerInch, {});
    return drawn ? withDetails(bytes, details) : QByteArray();
}

} // namespace

QSize pictureSize(const PlotPicture& picture) {
    return layOut(picture).size;
}

QImage pictureImage(const PlotPicture& picture, int scale) {
    return rendered(record(picture, false), scale);
}

PictureWork pngWork(const PlotPicture& picture, int scale) {
    return [recording = record(picture, false), scale] {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        const QImage image = rendered(recording, scale);
        const bool written = buffer.open(QIODevice::WriteOnly) && image.save(&buffer, "PNG");
        return written ? bytes : QByteArray();
    };
}

PictureWork svgWork(const PlotPicture& picture) {
    return [recording = record(picture, true)] {
        SvgDevice device(recording.size, recording.dotsPerInch, recording.title);
        return replay(recording, device, 1) ? device.document() : QByteArray();
    };
}

PictureWork pdfWork(const PlotPicture& picture) {
    return [recording = record(picture, true), project = picture.project] {
        return pdf(recording, project);
    };
}

namespace {

constexpr int clipboardScale = 2;
constexpr int message_ms = 6000;

} // namespace

PlotTools::PlotTools(QCustomPlot& plot, PlotSubject subject)
    : QObject(&plot)
    , fit(make(u"fit", {Qt::Key_Home}))
    , back(make(u"back", {Qt::Key_Backspace, Qt::ALT | Qt::Key_Left}))
    , forward(make(u"forward", {Qt::ALT | Qt::Key_Right}))
    , copyPicture(make(u"copy", {QKeySequence::Copy}))
    , copyData(make(u"", {Qt::CTRL | Qt::SHIFT | Qt::Key_C}))
    , svg(make(u""))
    , pdf(make(u""))
    , xlsx(make(u""))
    , csvRussian(make(u""))
    , csvEnglish(make(u""))
    , m_plot(plot)
    , m_subject(std::move(subject))
    , m_navigation(plot, m_subject.navigation) {
    for (int scale = 1; scale <= largestPictureScale; ++scale) {
        png.push_back(make(u""));
    }
    buildMenus();
    connectActions();
    retranslate();
    follow();
}

QAction* PlotTools::make(const char16_t* icon, const QList<QKeySequence>& keys) {
    auto* action = new QAction(this);
    const QStringView name(icon);
    if (!name.isEmpty()) {
        action->setIcon(themeIcon(name));
    }
    action->setShortcuts(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    return action;
}

void PlotTools::buildMenus() {
    m_export = new QMenu(&m_plot);
    m_export->setObjectName(QStringLiteral("exportMenu"));
    m_png = new QMenu(m_export);
    m_csv = new QMenu(m_export);
    m_csv->setToolTipsVisible(true);
    m_export->addActions({copyPicture, copyData});
    m_export->addSeparator();
    m_export->addMenu(m_png);
    m_export->addActions({svg, pdf});
    m_export->addSeparator();
    m_export->addAction(xlsx);
    m_export->addMenu(m_csv);
    for (QAction* action : png) {
        m_png->addAction(action);
    }
    m_csv->addActions({csvRussian, csvEnglish});
    m_plot.addActions({fit, back, forward, copyPicture, copyData});
    m_plot.setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_png, &QMenu::aboutToShow, this, &PlotTools::nameSizes);
    connect(&m_plot, &QWidget::customContextMenuRequested, this, &PlotTools::showContextMenu);
}

void PlotTools::connectActions() {
    connect(fit, &QAction::triggered, &m_navigation, &PlotNavigation::fit);
    connect(back, &QAction::triggered, &m_navigation, &PlotNavigation::back);
    connect(forward, &QAction::triggered, &m_navigation, &PlotNavigation::forward);
    connect(&m_navigation, &PlotNavigation::historyChanged, this, &PlotTools::follow);
    connect(copyPicture, &QAction::triggered, this, &PlotTools::copyPictureNow);
    connect(copyData, &QAction::triggered, this, &PlotTools::copyDataNow);
    for (int scale = 1; scale <= largestPictureScale; ++scale) {
        connect(png[static_cast<std::size_t>(scale - 1)], &QAction::triggered, this, [this, scale] {
            savePicture(QStringLiteral("png"), tr("PNG pictures (*.png)"),
                        [scale](const PlotPicture& p) { return pngWork(p, scale); });
        });
    }
    connect(svg, &QAction::triggered, this,
            [this] { savePicture(QStringLiteral("svg"), tr("SVG drawings (*.svg)"), svgWork); });
    connect(pdf, &QAction::triggered, this, [this] {
        savePicture(QStringLiteral("pdf"), tr("PDF documents (*.pdf)"), [this](PlotPicture drawn) {
            drawn.project = m_project ? m_project() : std::nullopt;
            return pdfWork(drawn);
        });
    });
    connect(xlsx, &QAction::triggered, this, [this] { saveData(TableFormat::xlsx); });
    connect(csvRussian, &QAction::triggered, this, [this] { saveData(TableFormat::csvRussian); });
    connect(csvEnglish, &QAction::triggered, this, [this] { saveData(TableFormat::csvEnglish); });
}

void PlotTools::setEnabled(bool enabled) {
    m_enabled = enabled;
    follow();
}

void PlotTools::addTool(QAction* action) {
    m_more << action;
    follow();
}

void PlotTools::follow() {
    back->setEnabled(m_enabled && m_navigation.canGoBack());
    forward->setEnabled(m_enabled && m_navigation.canGoForward());
    const bool table = m_enabled && m_subject.table;
    for (QAction* action : {copyData, xlsx, csvRussian, csvEnglish, m_csv->menuAction()}) {
        action->setEnabled(table);
    }
    for (QAction* action :
         QList<QAction*>{fit, copyPicture, svg, pdf, m_png->menuAction()} + m_more) {
        action->setEnabled(m_enabled);
    }
    for (const auto& button : m_exportButtons) {
        if (button) {
            button->setEnabled(m_enabled);
        }
    }
}

QToolButton* PlotTools::button(QAction* action, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QToolButton* PlotTools::exportButton(QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setIcon(themeIcon(m_subject.icon));
    button->setMenu(m_export);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setObjectName(QStringLiteral("export"));
    m_exportButtons.emplace_back(button);
    retranslate();
    follow();
    return button;
}

void PlotTools::showContextMenu(const QPoint& at) {
    QMenu menu(&m_plot);
    menu.setObjectName(QStringLiteral("plotMenu"));
    if (!m_subject.own.isEmpty()) {
        menu.addActions(m_subject.own);
        menu.addSeparator();
    }
    menu.addActions({fit, back, forward});
    menu.addActions(m_more);
    menu.addSeparator();
    menu.addActions(m_export->actions());
    menu.exec(m_plot.mapToGlobal(at));
}

// --- copies and files ---------------------------------------------------------------------------

QString PlotTools::fileName() const {
    const QStringList heading = m_subject.heading();
    return fileNameOf({heading.value(1), heading.value(0)});
}

PlotPicture PlotTools::picture() const {
    return {&m_plot, m_subject.heading(), m_subject.legend ? m_subject.legend() : LegendEntries()};
}

template <typename Draw>
auto PlotTools::inLightLook(Draw draw) const {
    const QPalette own = m_plot.testAttribute(Qt::WA_SetPalette) ? m_plot.palette() : QPalette();
    QCPLayer* hairLine = m_plot.layer(HairLine::layerName());
    const auto look = [this, hairLine](const QPalette& palette, bool line) {
        m_plot.setPalette(palette);
        if (hairLine) {
            hairLine->setVisible(line);
        }
    };
    look(paletteOf(Theme::light), false);
    auto drawn = draw(picture());
    look(own, true);
    return drawn;
}

void PlotTools::copyPictureNow() {
    QApplication::clipboard()->setImage(
        inLightLook([](const PlotPicture& p) { return pictureImage(p, clipboardScale); }));
    say(tr("The picture is on the clipboard."));
}

void PlotTools::copyDataNow() {
    CopiedCells::toClipboard(tabSeparated(m_subject.table(), QLocale()));
    say(tr("The data are on the clipboard."));
}

void PlotTools::savePicture(const QString& suffix, const QString& filter,
                            const std::function<PictureWork(const PlotPicture&)>& draw) {
    SaveRequest request{tr("Save the picture"), fileName(), suffix, filter,
                        [&] { return inLightLook(draw); }};
    (void)saveWithDialog(m_plot.window(), m_settings, request);
}

void PlotTools::saveData(TableFormat format) {
    (void)saveTable(m_plot.window(), m_settings, {m_subject.heading(), m_subject.table()}, format);
}

void PlotTools::say(const QString& text) {
    const auto send = [this](const QString& tip) {
        QStatusTipEvent event(tip);
        QApplication::sendEvent(&m_plot, &event); // the window shows it in its status bar
    };
    send(text);
    QTimer::singleShot(message_ms, &m_plot, [send] { send({}); });
}

void PlotTools::nameSizes() {
    const QSize size = pictureSize(picture());
    for (std::size_t i = 0; i < png.size(); ++i) {
        const int scale = static_cast<int>(i) + 1;
        png[i]->setText(tr("&%1×: %2 × %3 pixels…")
                            .arg(scale)
                            .arg(size.width() * scale)
                            .arg(size.height() * scale));
    }
}

void PlotTools::retranslate() {
    fit->setText(tr("Show all"));
    back->setText(tr("Back"));
    forward->setText(tr("Forward"));
    fit->setToolTip(
        tr("Show all; a double click in the plot does it too. Wheel: zoom, over an axis that axis "
           "only, with Shift move. Drag: move. Keys: + − and arrows."));
    back->setToolTip(tr("Back to the previous visible range"));
    forward->setToolTip(tr("Forward again"));
    copyPicture->setText(tr("&Copy the picture"));
    copyData->setText(tr("Copy the &data"));
    for (QAction* action : {fit, back, forward, copyPicture, copyData}) {
        nameShortcut(*action);
    }
    m_png->setTitle(tr("P&NG picture"));
    m_csv->setTitle(tr("CSV &table"));
    svg->setText(tr("&SVG drawing…"));
    pdf->setText(tr("&PDF drawing…"));
    const std::pair<QAction*, TableFormat> tables[] = {{xlsx, TableFormat::xlsx},
                                                       {csvRussian, TableFormat::csvRussian},
                                                       {csvEnglish, TableFormat::csvEnglish}};
    for (const auto& [action, format] : tables) {
        action->setText(tableFormatText(format));
        action->setToolTip(tableFormatHint(format));
    }
    for (const auto& button : m_exportButtons) {
        if (button) {
            const QString plot = m_subject.name ? m_subject.name() : QString();
            button->setAccessibleName(plot.isEmpty() ? tr("Export") : tr("Export: %1").arg(plot));
            button->setToolTip(plot.isEmpty() ? tr("Copy or save the contents of the plot")
                                              : tr("Copy or save: %1").arg(plot));
        }
    }
}

} // namespace sparkout
