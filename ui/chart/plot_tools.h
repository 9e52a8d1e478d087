// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/legend.h"
#include "ui/chart/plot_navigation.h"
#include "ui/dialogs/table_file.h"
#include "ui/kit/pdf_details.h"
#include "ui/table/csv_table.h"

#include <QAction>
#include <QByteArray>
#include <QImage>
#include <QObject>
#include <QPointer>
#include <QStringList>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QCustomPlot;
class QMenu;
class QToolButton;

/// Exports a plot as a picture: title lines, legend and the plot as on the screen, on the plot's
/// background. The caller sets the look of the plot first.
namespace sparkout {

struct PlotPicture {
    QCustomPlot* plot = nullptr;
    QStringList heading;                       ///< the first line is the title
    LegendEntries legend;                      ///< without hidden entries
    std::optional<PdfAttachment> project = {}; ///< attached to a PDF
};

inline constexpr int largestPictureScale = 4;

/// Size at scale 1, in pixels of the plot's screen.
[[nodiscard]] QSize pictureSize(const PlotPicture& picture);

/// `scale` 1…4; the resolution is stored in the image, so that its size on paper is constant.
[[nodiscard]] QImage pictureImage(const PlotPicture& picture, int scale);

/// Makes the bytes of a file, on any thread; may take a second. Empty on failure.
using PictureWork = std::function<QByteArray()>;

/// The drawing is recorded at once; the plot may change afterwards.
[[nodiscard]] PictureWork pngWork(const PlotPicture& picture, int scale);
[[nodiscard]] PictureWork svgWork(const PlotPicture& picture);
[[nodiscard]] PictureWork pdfWork(const PlotPicture& picture); ///< vectors, fonts embedded

class Settings;

/// The properties of a plot that its tools need; only `heading` is required.
struct PlotSubject {
    std::function<QStringList()> heading; ///< for an exported picture: view, then project
    std::function<QString()> name; ///< name in the export button, for a view with several plots …
    QStringView icon = u"export";  ///< … and its icon
    std::function<LegendEntries()> legend;
    std::function<CsvTable()> table;  ///< the visible curves within the visible range
    PlotNavigation::Hooks navigation; ///< behaviour of wheel, drag and keys
    QList<QAction*> own = {};         ///< own actions of the view, first in the context menu
};

/// The tools common to all plots: fit, back and forward; copy as picture or data; PNG, SVG, PDF,
/// XLSX and CSV files; in the plot's context menu and as actions and buttons for the view's tool
/// row. Pictures show the current content in the light theme.
class PlotTools : public QObject {
    Q_OBJECT
public:
    PlotTools(QCustomPlot& plot, PlotSubject subject);

    void setSettings(Settings* settings) { m_settings = settings; } ///< for the last used folder
    /// The project that a PDF drawing carries; none by default, or if the source gives none.
    void setProject(std::function<std::optional<PdfAttachment>()> source) {
        m_project = std::move(source);
    }
    void setEnabled(bool enabled); ///< false: there is nothing to export
    void retranslate();
    void addTool(QAction* action); ///< adds an action to the context menu

    [[nodiscard]] PlotNavigation& navigation() { return m_navigation; }
    /// A button for one of the actions, and one for the export menu.
    [[nodiscard]] static QToolButton* button(QAction* action, QWidget* parent);
    [[nodiscard]] QToolButton* exportButton(QWidget* parent);

    QAction* fit;
    QAction* back;
    QAction* forward;
    QAction* copyPicture;
    QAction* copyData;
    std::vector<QAction*> png; ///< scales 1…4
    QAction* svg;
    QAction* pdf;
    QAction* xlsx;
    QAction* csvRussian;
    QAction* csvEnglish;

private:
    QAction* make(const char16_t* icon, const QList<QKeySequence>& keys = {});
    void buildMenus();
    void connectActions();
    void follow(); ///< enables the actions possible now
    void showContextMenu(const QPoint& at);
    [[nodiscard]] QString fileName() const;
    [[nodiscard]] PlotPicture picture() const;
    /// Draws with the plot in the light look, without hair line.
    template <typename Draw>
    auto inLightLook(Draw draw) const;
    void copyPictureNow();
    void copyDataNow();
    void savePicture(const QString& suffix, const QString& filter,
                     const std::function<PictureWork(const PlotPicture&)>& draw);
    void saveData(TableFormat format);
    void nameSizes();              ///< shows the current sizes of the pictures
    void say(const QString& text); ///< shows a temporary message in the status bar

    QCustomPlot& m_plot;
    PlotSubject m_subject;
    PlotNavigation m_navigation;
    std::function<std::optional<PdfAttachment>()> m_project;
    Settings* m_settings = nullptr;
    QMenu* m_export = nullptr;
    QMenu* m_png = nullptr;
    QMenu* m_csv = nullptr;
    QList<QAction*> m_more; ///< additional tools of the view
    std::vector<QPointer<QToolButton>> m_exportButtons;
    bool m_enabled = true;
};

} // namespace sparkout
