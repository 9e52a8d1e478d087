// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot_tools.h"
#include "ui/plot/view.h"

#include <QComboBox>

#include <functional>
#include <initializer_list>
#include <vector>

class QAbstractButton;
class QAbstractItemModel;
class QLabel;
class QLayout;
class QScrollArea;
class QSplitter;
class QStackedWidget;
class QVBoxLayout;

namespace sparkout {

class CopyTable;
class CursorStrip;
class LegendStrip;
class PlotCursors;
class Settings;
class ValueModel;
class ViewPlot;
struct Project;

/// A view of plots: it keeps the last outcome that could be drawn, faint while a newer one is
/// refused, and owns what stands about its plots: notice, legend, cursors' strip, the values under
/// the mouse and the tools of each plot. What a view draws and says of an outcome is its own.
class PlotView : public View {
    Q_OBJECT
public:
    [[nodiscard]] PlotTools* tools() const;     ///< of the plot in front
    [[nodiscard]] PlotCursors* cursors() const; ///< null: the view has none
    [[nodiscard]] LegendStrip* legend() const { return m_legend; }
    [[nodiscard]] double lastUpdate_ms() const { return m_lastUpdate_ms; } ///< processor time
    [[nodiscard]] QSize sizeHint() const override { return {700, 620}; }
    void retranslate() override;

protected:
    /// The name is that of the view, and the beginning of those of its parts.
    PlotView(const QString& name, QWidget* parent, Settings* settings);

    // Building.
    /// A plot that is always shown; its legend is the view's.
    void addPlot(ViewPlot& plot, PlotSubject subject = {});
    void addCursors(ViewPlot& plot); ///< after addPlot()
    /// One of several of which one is in front; with buttons to fit and export it.
    void addPage(ViewPlot& plot, PlotSubject subject = {});
    void addPageButtons(QLayout& row) const;
    [[nodiscard]] QComboBox* content(); ///< a box to choose the page in, made after all pages
    void showPage(std::size_t index);
    [[nodiscard]] QStackedWidget* pages() const { return m_pages; }
    /// Boxes as wide as what is chosen in them.
    static void addBoxes(QLayout& row, std::initializer_list<QComboBox*> boxes);
    /// A plot, or several, scrolled where they have no room to be legible: for minimumSizeHint().
    QScrollArea* scrolled(QWidget& plots);
    /// Buttons for actions of the front plot, and the one of its exports.
    void addButtons(QLayout& row, const QList<QAction*>& actions) const;
    /// A row of tools that fills a widget.
    template <typename Row>
    static Row* rowIn(QWidget* bar) {
        auto* row = new Row(bar);
        closeUp(*row);
        return row;
    }
    /// The first above the second, with their shares of the height.
    static void share(QSplitter& splitter, std::initializer_list<std::pair<QWidget*, int>> parts);
    /// The view's column of parts, with the usual margins; the main part takes what room is left.
    QVBoxLayout* addColumn(std::initializer_list<QWidget*> parts, QWidget* main);
    /// A row of tools for the pages: the box to choose one in, the boxes, the buttons of the page.
    template <typename Row>
    QWidget* pageTools(std::initializer_list<QComboBox*> boxes) {
        auto* bar = new QWidget(this);
        auto* row = rowIn<Row>(bar);
        addBoxes(*row, {content()});
        addBoxes(*row, boxes);
        setTabOrder((*boxes.begin())->previousInFocusChain(), content()); // made after it
        row->addStretch(1);
        addPageButtons(*row);
        return bar;
    }
    /// A table beside the plots, with scroll bars, to copy and to save.
    /// @param text what is copied of it, with tabs [the table itself]
    CopyTable* addTable(QAbstractItemModel& model, std::function<CsvTable()> table,
                        std::function<QString()> text = {});
    /// The same of a table as a value.
    /// @param saved what is saved of it, and copied of the whole [the table itself]
    CopyTable* addTable(ValueModel& model, std::function<CsvTable()> saved = {});
    /// Texts in the present language; what was chosen stays.
    static void fillChoice(QComboBox& box, const QStringList& texts);
    void hideUntilDrawn(std::initializer_list<QWidget*> parts);
    void disableUntilDrawn(std::initializer_list<QWidget*> parts);
    static void nameObjects(std::initializer_list<std::pair<QWidget*, const char*>> names);
    /// What a control is for, for a screen reader and as its tool tip.
    static void tell(QWidget& widget, const QString& text);
    /// The same of one whose name is short.
    static void tell(QWidget& widget, const QString& name, const QString& tip);
    static void tellButton(QAbstractButton& button, const QString& text, const QString& tip);

    [[nodiscard]] Settings* settings() const { return m_settings; }
    [[nodiscard]] QLabel* notice() const { return m_notice; }
    [[nodiscard]] QLabel* values() const { return m_values; }
    [[nodiscard]] CursorStrip* strip() const { return m_strip; }
    [[nodiscard]] const std::vector<ViewPlot*>& plots() const { return m_plots; }
    [[nodiscard]] ViewPlot& front() const { return *m_front; } ///< whose legend and tools are meant

    // What is drawn.
    [[nodiscard]] const OutcomePtr& good() const { return m_good; } ///< null: nothing yet
    [[nodiscard]] bool refused() const;                             ///< the newest one
    /// Whether good() is of another operation, or of other zones or sections, than that one.
    [[nodiscard]] bool hasOtherPlaces(const OutcomePtr& before) const;
    [[nodiscard]] virtual bool draws(const Outcome& outcome) const; ///< here: of zones or sections
    /// good() is another; before it was that one, maybe null.
    virtual void takeOutcome(const OutcomePtr& before) = 0;
    virtual void dropOutcome() {} ///< good() is null: it was of another document
    [[nodiscard]] virtual bool drawn() const { return m_good != nullptr; } ///< there are curves
    [[nodiscard]] virtual bool faint() const; ///< they are not of the newest outcome
    [[nodiscard]] virtual bool isFaint(const ViewPlot&) const { return faint(); }
    void showOutcome() override;
    void showPlots();         ///< all of them anew, in their ranges
    void replotAll();         ///< the same, soon
    void replotFront();       ///< the front one, soon, as it is
    virtual void showState(); ///< notice, what is hidden or disabled, faintness
    virtual void showLegend();
    virtual void toggleCurve(int key); ///< of the legend
    virtual void showOnly(int key);

    // Words.
    virtual void nameParts() = 0; ///< in the present language; fills boxes too
    void nameAround(const QString& legend, const QString& notice, const QString& values);
    [[nodiscard]] virtual QString noticeText() const;
    /// What is drawn while the inputs are refused, once there was an accepted run.
    [[nodiscard]] virtual QString keptText() const;
    [[nodiscard]] QString refusedText() const;                  ///< the same where nothing is
    [[nodiscard]] virtual QString remark() const { return {}; } ///< on what is drawn
    [[nodiscard]] virtual QStringList heading() const;          ///< over exported pictures
    [[nodiscard]] virtual const Project* shownProject() const;  ///< it is of; null: none yet
    [[nodiscard]] QString projectTitle() const;                 ///< of that one
    [[nodiscard]] virtual QStringList subheading() const {
        return {};
    } ///< below the project's name
    void recolour() override { showLegend(); }

private:
    void setUpTable(CopyTable& table, std::function<CsvTable()> saved);
    QWidget* pageButtons(PlotTools& tools);
    [[nodiscard]] bool isShown(const ViewPlot& plot) const; ///< not a page behind the front one
    static void closeUp(QLayout& row);

    Settings* m_settings;
    QLabel* m_notice;
    LegendStrip* m_legend;
    QLabel* m_values;
    CursorStrip* m_strip = nullptr;
    QStackedWidget* m_pages = nullptr;
    QComboBox* m_content = nullptr;
    std::vector<ViewPlot*> m_plots;
    std::vector<QWidget*> m_buttons; ///< of the pages
    ViewPlot* m_front = nullptr;
    std::vector<QWidget*> m_hidden, m_disabled; ///< until there are curves
    OutcomePtr m_good;
    double m_lastUpdate_ms = 0;
};

} // namespace sparkout
