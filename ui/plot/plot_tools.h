// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/table_file.h"
#include "ui/plot/legend_drawing.h"
#include "ui/plot/plot_export.h"
#include "ui/plot/plot_navigation.h"
#include "ui/tables/csv_table.h"

#include <QAction>
#include <QObject>
#include <QPointer>

#include <functional>
#include <vector>

class QMenu;
class QToolButton;

namespace sparkout {

class Settings;

/// What the tools need to know of a view's plot; only `heading` must be given.
struct PlotSubject {
    std::function<QStringList()> heading; ///< over an exported picture: the view, then the project
    std::function<QString()> name; ///< where a view has several plots: of its export button …
    QStringView icon = u"export";  ///< … and its icon
    std::function<LegendEntries()> legend;
    std::function<CsvTable()> table;  ///< the visible curves within the visible range
    PlotNavigation::Hooks navigation; ///< how wheel, drag and keys move it
    QList<QAction*> own = {};         ///< the view's own, first in the context menu
};

/// The tools every plot has: fit, back and forward; copy as picture or data; PNG, SVG, PDF, XLSX
/// and CSV files; all in the plot's context menu and as actions and buttons for the view's tool
/// row. Pictures show what is on the screen, in the light look.
class PlotTools : public QObject {
    Q_OBJECT
public:
    PlotTools(QCustomPlot& plot, PlotSubject subject);

    void setSettings(Settings* settings) { m_settings = settings; } ///< for the last folder
    void setEnabled(bool enabled); ///< false: nothing is shown that could be exported
    void retranslate();
    void addTool(QAction* action); ///< a further one of the plot, to the context menu

    [[nodiscard]] PlotNavigation& navigation() { return m_navigation; }
    /// A button for one of the actions, and one that opens the menu of the exports.
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
    void follow(); ///< enables what can be done now
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
    void nameSizes();              ///< of the pictures, as they would be now
    void say(const QString& text); ///< in the status bar, for a while

    QCustomPlot& m_plot;
    PlotSubject m_subject;
    PlotNavigation m_navigation;
    Settings* m_settings = nullptr;
    QMenu* m_export = nullptr;
    QMenu* m_png = nullptr;
    QMenu* m_csv = nullptr;
    QList<QAction*> m_more; ///< tools of the view's own
    std::vector<QPointer<QToolButton>> m_exportButtons;
    bool m_enabled = true;
};

} // namespace sparkout
