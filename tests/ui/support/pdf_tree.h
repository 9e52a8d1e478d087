// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

/// The structure of a tagged PDF, read back by libqpdf.
namespace sparkout::reading {

struct PdfElement {
    QByteArray type;
    QString alt;
    QString text = {}; ///< of its own content, as one copies it
    int depth = 0;     ///< below the root
    int span = 1;      ///< columns of a cell
    bool isColumnHead = false;
    bool hasContent = false; ///< of its own, on some page
    std::optional<QRectF> box = {};
    std::vector<std::size_t> kids = {}; ///< their places in the tree
};

struct PdfTree {
    QString language;
    bool isMarked = false, showsTitle = false;
    int pages = 0;
    std::vector<PdfElement> elements; ///< in the order of reading; the first one is the root's kid
    QStringList faults; ///< what breaks the rules of marked content: painted outside of it, …
};

[[nodiscard]] PdfTree treeOf(const QByteArray& pdf);

} // namespace sparkout::reading
