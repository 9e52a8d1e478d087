# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a workbook as openpyxl sees it and prints it as JSON; numbers as their bits in hex.

A cell is [type, value, number format, quoted]: type "n" a number, "s" a text, "f" a formula.
"""
import json
import sys

import openpyxl


def cell(c):
    if c.value is None:
        return None
    value = float(c.value).hex() if c.data_type == "n" else str(c.value)
    return [c.data_type, value, c.number_format, bool(c.quotePrefix)]


def area(printed):
    """One range, or a list of them, by openpyxl's version."""
    return ",".join(printed) if isinstance(printed, (list, tuple)) else printed or ""


book = openpyxl.load_workbook(sys.argv[1])
print(json.dumps({
    "title": book.properties.title,
    "author": book.properties.creator,
    "program": book.properties.description,
    "sheets": [{
        "name": sheet.title,
        "frozen": sheet.freeze_panes,
        "print": [sheet.page_setup.orientation, sheet.sheet_properties.pageSetUpPr.fitToPage,
                  sheet.page_setup.fitToWidth, sheet.page_setup.fitToHeight,
                  sheet.page_setup.paperSize, sheet.print_title_rows, area(sheet.print_area)],
        "widths": [sheet.column_dimensions[c].width for c in sheet.column_dimensions],
        "rows": [[cell(c) for c in row] for row in sheet.iter_rows()],
    } for sheet in book.worksheets],
}))
