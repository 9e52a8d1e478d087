// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pdf/pdf_tags.h"

#include "ui/pdf/pdf_structure.h"

#define POINTERHOLDER_TRANSITION 4 // libqpdf with std::shared_ptr only
#include <qpdf/Pl_Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFTokenizer.hh>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace sparkout {

namespace {

using Token = QPDFTokenizer::Token;
using Id = PdfStructure::Id;

/// The elements on one page; the number of each is its index.
using MarkedContent = std::vector<Id>;

/// Replaces the marks of one page by marked content. Qt writes a page as "q … q … Q q … Q Q": the
/// outer level has the clip, which a mark does not have, the inner one everything else. A sequence
/// begins and ends outside both, so that it contains whole levels.
class MarksToContent : public QPDFObjectHandle::TokenFilter {
public:
    explicit MarksToContent(const PdfStructure& structure) : m_structure(structure) {}
    [[nodiscard]] const MarkedContent& content() const { return m_content; }

    void handleToken(const Token& token) override {
        m_operation.push_back(token);
        switch (token.getType()) {
        case QPDFTokenizer::tt_integer:
        case QPDFTokenizer::tt_real:
            m_numbers.push_back(std::atof(token.getValue().c_str()));
            break;
        case QPDFTokenizer::tt_inline_image: m_numbers.clear(); break;
        case QPDFTokenizer::tt_word: handleOperation(token.getValue()); break;
        default: break; // operands of other kinds, spaces
        }
    }
    void handleEOF() override {
        writeOperation();
        if (m_isOpen) {
            write("\nEMC\n");
        }
    }

private:
    void handleOperation(const std::string& name) {
        if (m_isMark) { // its rectangle is filled: "f", or "f*"
            m_isMark = false;
            m_operation.clear();
        } else if (name == "re" && m_numbers.size() == 4) {
            if (const auto id = PdfStructure::marked(m_numbers[0], m_numbers[1])) {
                m_isMark = true;
                m_pending = id;
                m_operation.clear();
            }
        }
        writeOperation();
        m_numbers.clear();
        if (name == "q") {
            ++m_depth;
        } else if (name == "Q") {
            --m_depth;
            begin();
        }
    }
    void writeOperation() {
        for (const Token& token : m_operation) {
            writeToken(token);
        }
        m_operation.clear();
    }
    /// Begins the element of the last mark, if it has changed.
    void begin() {
        if (!m_pending) {
            return;
        }
        const Id id = *m_pending;
        m_pending.reset();
        if (m_isOpen && id == m_current) {
            return;
        }
        if (m_depth != 1) {
            throw std::runtime_error("a mark of the structure in an unknown place");
        }
        write(m_isOpen ? "\nQ\nEMC\n" : "\nQ\n");
        if (id == PdfStructure::artifact) {
            write("/Artifact <</Type /Layout>> BDC\nq\n");
        } else if (id == PdfStructure::pagination) {
            write("/Artifact <</Type /Pagination>> BDC\nq\n");
        } else {
            write("/" + m_structure.at(id).type.toStdString() + " <</MCID "
                  + std::to_string(m_content.size()) + ">> BDC\nq\n");
            m_content.push_back(id);
        }
        m_isOpen = true;
        m_current = id;
    }

    const PdfStructure& m_structure;
    std::vector<Token> m_operation; ///< up to its name
    std::vector<double> m_numbers;  ///< numbers among its operands
    int m_depth = 0;
    bool m_isMark = false; ///< the rectangle was removed, its fill operator follows
    bool m_isOpen = false;
    std::optional<Id> m_pending;
    Id m_current = 0;
    MarkedContent m_content;
};

/// The tree of a document: an object for each element.
class Tree {
public:
    Tree(QPDF& document, const PdfStructure& structure)
        : m_structure(structure), m_objects(structure.end()), m_shown(structure.end(), false) {
        for (Id id = PdfStructure::document; id < structure.end(); ++id) {
            m_objects[id] = document.makeIndirectObject(QPDFObjectHandle::newDictionary());
        }
    }

    /// Adds a page's parts of the elements, in their order.
    void addContent(QPDFObjectHandle& page, const MarkedContent& content) {
        for (std::size_t number = 0; number < content.size(); ++number) {
            QPDFObjectHandle& element = m_objects[content[number]];
            if (!element.hasKey("/Pg")) {
                element.replaceKey("/Pg", page);
            }
            const auto mcid = QPDFObjectHandle::newInteger(static_cast<long long>(number));
            if (element.getKey("/Pg").getObjGen() == page.getObjGen()) {
                addKid(content[number], mcid);
            } else {
                QPDFObjectHandle reference = QPDFObjectHandle::parse("<< /Type /MCR >>");
                reference.replaceKey("/Pg", page);
                reference.replaceKey("/MCID", mcid);
                addKid(content[number], reference);
            }
            for (Id id = content[number]; !m_shown[id]; id = m_structure.at(id).parent) {
                m_shown[id] = true;
                if (id == PdfStructure::document) {
                    break;
                }
            }
        }
    }

    /// The root; without elements that no page shows, but with empty cells.
    QPDFObjectHandle finished(QPDF& document) {
        QPDFObjectHandle root =
            document.makeIndirectObject(QPDFObjectHandle::parse("<< /Type /StructTreeRoot >>"));
        root.replaceKey("/K", m_objects[PdfStructure::document]);
        QPDFObjectHandle& top = m_objects[PdfStructure::document];
        top.replaceKey("/Type", QPDFObjectHandle::newName("/StructElem"));
        top.replaceKey("/S", QPDFObjectHandle::newName("/Document"));
        top.replaceKey("/P", root);
        for (Id id = PdfStructure::document + 1; id < m_structure.end(); ++id) {
            const PdfStructure::Element& element = m_structure.at(id);
            const bool isCell = element.type == "TD" || element.type == "TH";
            if (m_shown[id] || (isCell && m_shown[element.parent])) {
                describe(m_objects[id], element);
                addKid(element.parent, m_objects[id]);
            }
        }
        return root;
    }

    [[nodiscard]] const QPDFObjectHandle& object(Id id) const { return m_objects[id]; }

private:
    void addKid(Id id, const QPDFObjectHandle& kid) {
        if (!m_objects[id].hasKey("/K")) {
            m_objects[id].replaceKey("/K", QPDFObjectHandle::newArray());
        }
        m_objects[id].getKey("/K").appendItem(kid);
    }

    void describe(QPDFObjectHandle& object, const PdfStructure::Element& element) {
        object.replaceKey("/Type", QPDFObjectHandle::newName("/StructElem"));
        object.replaceKey("/S", QPDFObjectHandle::newName("/" + element.type.toStdString()));
        object.replaceKey("/P", m_objects[element.parent]);
        if (!element.alt.isEmpty()) {
            object.replaceKey("/Alt",
                              QPDFObjectHandle::newUnicodeString(element.alt.toStdString()));
        }
        if (element.type == "TH") {
            object.replaceKey("/A", QPDFObjectHandle::parse("<< /O /Table /Scope /Column >>"));
        } else if (element.span > 1) {
            object.replaceKey("/A",
                              QPDFObjectHandle::parse("<< /O /Table /ColSpan "
                                                      + std::to_string(element.span) + " >>"));
        } else if (element.box && object.hasKey("/Pg")) {
            // Converts points from the upper left corner to the lower left one.
            const double height =
                object.getKey("/Pg").getKey("/MediaBox").getArrayItem(3).getNumericValue();
            QPDFObjectHandle attributes = QPDFObjectHandle::parse("<< /O /Layout >>");
            attributes.replaceKey("/BBox", QPDFObjectHandle::newArray(QPDFObjectHandle::Rectangle(
                                               element.box->left(), height - element.box->bottom(),
                                               element.box->right(), height - element.box->top())));
            object.replaceKey("/A", attributes);
        }
    }

    const PdfStructure& m_structure;
    std::vector<QPDFObjectHandle> m_objects; ///< by number; the first ones, of artifacts, are empty
    std::vector<bool> m_shown;
};

} // namespace

void putTags(QPDF& document, const PdfStructure& structure,
             const std::function<void()>& afterPage) {
    Tree tree(document, structure);
    QPDFObjectHandle numbers = QPDFObjectHandle::newArray();
    long long number = 0;
    for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(document).getAllPages()) {
        MarksToContent filter(structure);
        Pl_Buffer buffer("page");
        page.filterContents(&filter, &buffer);
        QPDFObjectHandle object = page.getObjectHandle();
        object.replaceKey("/Contents", document.newStream(buffer.getBufferSharedPointer()));
        object.replaceKey("/StructParents", QPDFObjectHandle::newInteger(number));
        object.replaceKey("/Tabs", QPDFObjectHandle::newName("/S"));
        tree.addContent(object, filter.content());
        QPDFObjectHandle parents = QPDFObjectHandle::newArray();
        for (const Id id : filter.content()) {
            parents.appendItem(tree.object(id));
        }
        numbers.appendItem(QPDFObjectHandle::newInteger(number));
        numbers.appendItem(document.makeIndirectObject(parents));
        ++number;
        afterPage();
    }
    QPDFObjectHandle root = tree.finished(document);
    QPDFObjectHandle parentTree = QPDFObjectHandle::newDictionary();
    parentTree.replaceKey("/Nums", numbers);
    root.replaceKey("/ParentTree", document.makeIndirectObject(parentTree));
    root.replaceKey("/ParentTreeNextKey", QPDFObjectHandle::newInteger(number));
    document.getRoot().replaceKey("/StructTreeRoot", root);
    document.getRoot().replaceKey("/MarkInfo", QPDFObjectHandle::parse("<< /Marked true >>"));
}

} // namespace sparkout
