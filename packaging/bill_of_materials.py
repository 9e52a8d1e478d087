#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what a file of the release contains besides Sparkout itself, as SPDX 2.3 in JSON, and copies the
licences: of code that is compiled in (resources/licences/components.json), and of the libraries and
fonts of the portable folder, each from the Debian package that it was taken from; for Windows, of the
sources that packaging/windows/build compiled.

  bill_of_materials.py --version V --epoch SECONDS [--compiled-in] [--fonts] [--licences FOLDER]
                       [LIBRARY…] OUT.spdx.json
  bill_of_materials.py --version V --epoch SECONDS --sources FOLDER [--fonts] SOURCE… OUT.spdx.json

A library whose licence LICENCES does not state is an error, so that none is bundled unseen."""
import argparse
import datetime
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMPONENTS = ROOT / "resources/licences/components.json"

# By source package of Debian; read of its copyright file.
LICENCES = {
    "acl": "LGPL-2.1-or-later", "attr": "LGPL-2.1-or-later", "audit": "LGPL-2.1-or-later",
    "avahi": "LGPL-2.1-or-later", "brotli": "MIT", "bzip2": "bzip2-1.0.6",
    "cups": "Apache-2.0 WITH LLVM-exception", "dbus": "AFL-2.1 OR GPL-2.0-or-later",
    "double-conversion": "BSD-3-Clause", "e2fsprogs": "MIT", "expat": "MIT",
    "fontconfig": "HPND-sell-variant", "fonts-dejavu": "Bitstream-Vera",
    "freetype": "FTL OR GPL-2.0-or-later",
    "gcc-12": "GPL-3.0-or-later WITH GCC-exception-3.1",
    "gcc-mingw-w64": "GPL-3.0-or-later WITH GCC-exception-3.1", "glibc": "LGPL-2.1-or-later",
    "glib2.0": "LGPL-2.1-or-later", "gmp": "LGPL-3.0-or-later OR GPL-2.0-or-later",
    "gnutls28": "LGPL-2.1-or-later", "graphite2": "LGPL-2.1-or-later OR MPL-1.1 OR GPL-2.0-or-later",
    "harfbuzz": "MIT", "icu": "ICU", "keyutils": "LGPL-2.1-or-later", "krb5": "MIT",
    "libb2": "CC0-1.0", "libbsd": "BSD-3-Clause", "libcap2": "BSD-3-Clause OR GPL-2.0-only",
    "libffi": "MIT", "libgcrypt20": "LGPL-2.1-or-later", "libglvnd": "MIT",
    "libgpg-error": "LGPL-2.1-or-later", "libidn2": "LGPL-3.0-or-later OR GPL-2.0-or-later",
    "libjpeg-turbo": "IJG AND BSD-3-Clause", "libmd": "BSD-3-Clause", "libpng1.6": "libpng-2.0",
    "libproxy": "LGPL-2.1-or-later", "libtasn1-6": "LGPL-2.1-or-later",
    "libunistring": "LGPL-3.0-or-later OR GPL-2.0-or-later", "libx11": "MIT", "libxau": "MIT",
    "libxcb": "MIT", "libxdmcp": "MIT", "libxext": "MIT", "libxkbcommon": "MIT",
    "libxrender": "MIT", "libxfixes": "MIT", "libice": "MIT", "libsm": "MIT",
    "lz4": "BSD-2-Clause", "md4c": "MIT", "mingw-w64": "ZPL-2.1", "mtdev": "MIT", "nettle":
    "LGPL-3.0-or-later OR GPL-2.0-or-later",
    "nlopt": "MIT AND LGPL-2.1-or-later AND BSD-3-Clause", "p11-kit": "BSD-3-Clause",
    "pcre2": "BSD-3-Clause", "pcre3": "BSD-3-Clause", "qcustomplot": "GPL-3.0-or-later",
    "qpdf": "Apache-2.0", "qt6-base": "LGPL-3.0-only", "qt6-charts": "GPL-3.0-only",
    "qt6-svg": "LGPL-3.0-only", "qt6-translations": "GPL-3.0-only WITH Qt-GPL-exception-1.0",
    "selinux": "libselinux-1.0", "libselinux": "libselinux-1.0", "snowball": "BSD-3-Clause",
    "systemd": "LGPL-2.1-or-later", "util-linux": "BSD-3-Clause", "wayland": "MIT",
    "xcb-util": "MIT", "xcb-util-cursor": "MIT", "xcb-util-image": "MIT",
    "xcb-util-keysyms": "MIT", "xcb-util-renderutil": "MIT", "xcb-util-wm": "MIT",
    "xz-utils": "LicenseRef-public-domain", "zlib": "Zlib",
    "libzstd": "BSD-3-Clause OR GPL-2.0-only", "libgudev": "LGPL-2.1-or-later",
    "tinycbor": "MIT", "blake2": "CC0-1.0 OR Apache-2.0",
    "libevdev": "MIT", "libinput": "MIT", "libwacom": "HPND", "mesa": "MIT", "libdrm": "MIT",
}

# What Qt's own sources bring along and is compiled for Windows: the folder, and its name in LICENCES.
INSIDE_QT = {"blake2": "blake2", "double-conversion": "double-conversion", "freetype": "freetype",
             "harfbuzz-ng": "harfbuzz", "libjpeg": "libjpeg-turbo", "libpng": "libpng1.6",
             "md4c": "md4c", "pcre2": "pcre2", "tinycbor": "tinycbor", "zlib": "zlib"}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def owners(files):
    """The Debian packages of files; /lib is /usr/lib since they were merged."""
    names = {}
    for file in files:
        path = pathlib.Path(file)
        if not path.exists():
            path = pathlib.Path(f"{file}.so")  # a plug-in
        for name in (str(path), str(path.resolve())):
            names[name] = names["/usr" + name] = names[name.removeprefix("/usr")] = file
    found = subprocess.run(["dpkg", "-S", *names], capture_output=True, text=True, check=False).stdout
    owned = {}
    for line in found.splitlines():
        packages, _, name = line.rpartition(": ")
        owned[names[name]] = packages.split(":")[0]
    if len(owned) < len(set(files)):
        sys.exit(f"bill_of_materials: no package has {sorted(set(files) - set(owned))}")
    return set(owned.values())


def package_of(name):
    source, source_version, version = output(
        "dpkg-query", "-W", "-f", "${source:Package} ${source:Version} ${Version}\n",
        name).splitlines()[0].split()
    if source not in LICENCES:
        sys.exit(f"bill_of_materials: the licence of {source} (package {name}) is not stated")
    return {"name": name, "version": version, "source": source, "source_version": source_version,
            "licence": LICENCES[source]}


def entry(name, version, licence, copyright_text, comment):
    digest = hashlib.sha256(f"{name} {version}".encode()).hexdigest()[:12]
    return {"SPDXID": f"SPDXRef-{digest}", "name": name, "versionInfo": version,
            "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
            "licenseConcluded": licence, "licenseDeclared": licence,
            "copyrightText": copyright_text, "comment": comment}


def source_entry(sources, name):
    """A source package that was compiled, as packaging/windows/build keeps it in its cache."""
    folder, fetched = sources / name, sources / f"{name}.fetched"
    if fetched.exists():
        version = re.search(rf"{re.escape(name)}_(\S+)\.dsc", fetched.read_text(encoding="utf-8"))[1]
        return entry(name, version, LICENCES[name], "NOASSERTION",
                     f"compiled in, from Debian's source package {name}")
    version = re.search(r'QT_REPO_MODULE_VERSION "(.*)"',
                        (folder / ".cmake.conf").read_text(encoding="utf-8"))[1]
    return entry(name, version, LICENCES[name], "NOASSERTION",
                 "compiled in, from sources of Qt that were put there by hand")


def inside_qt(sources):
    for folder, name in INSIDE_QT.items():
        found = json.loads((sources / "qt6-base/src/3rdparty" / folder / "qt_attribution.json")
                           .read_text(encoding="utf-8"), strict=False)
        found = found[0] if isinstance(found, list) else found
        yield entry(f"qt6-base/{folder}", found["Version"], LICENCES[name], "NOASSERTION",
                    "compiled in, from the source package qt6-base")


def main():
    reader = argparse.ArgumentParser()
    reader.add_argument("--version", required=True)
    reader.add_argument("--epoch", type=int, required=True)
    reader.add_argument("--compiled-in", action="store_true")
    reader.add_argument("--fonts", action="store_true")
    reader.add_argument("--licences", type=pathlib.Path)
    reader.add_argument("--sources", type=pathlib.Path)
    reader.add_argument("files", nargs="+")
    wanted = reader.parse_args()
    *libraries, target = wanted.files

    itself = entry("sparkout", wanted.version, "GPL-3.0-or-later", "2026 Sparkout maintainers", "")
    packages, relations = [itself], [
        {"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES",
         "relatedSpdxElement": itself["SPDXID"]}]

    def contain(row, kind):
        packages.append(row)
        relations.append({"spdxElementId": itself["SPDXID"], "relationshipType": kind,
                          "relatedSpdxElement": row["SPDXID"]})

    for component in json.loads(COMPONENTS.read_text(encoding="utf-8")):
        # For Windows libqpdf is one of the sources, and there is no module for Python.
        if component["use"] == "compiled in" and not (
                wanted.sources and component["name"] in ("qpdf", "pybind11")):
            version = output("dpkg-query", "-W", "-f", "${Version}", component["package"])
            contain(entry(component["name"], version, component["licence"], component["copyright"],
                          f"compiled in, from Debian's {component['package']}"), "STATIC_LINK")
    names = set()
    if wanted.sources:
        for name in libraries:
            contain(source_entry(wanted.sources, name), "STATIC_LINK")
        for row in inside_qt(wanted.sources) if "qt6-base" in libraries else ():
            contain(row, "STATIC_LINK")
        names = {"gcc-mingw-w64-base", "mingw-w64-common"}  # the compiler's run-time libraries
    elif not wanted.compiled_in:
        names = owners(libraries)
    if wanted.fonts:
        names |= {"fonts-dejavu-core", "fonts-dejavu-extra"}
    if wanted.fonts or names and not wanted.sources:
        names.add("qt6-translations-l10n")
    for name in sorted(names):
        row = package_of(name)
        contain(entry(name, row["version"], row["licence"], "NOASSERTION",
                      f"bundled; source {row['source']} {row['source_version']} of Debian"),
                "CONTAINS")
        if wanted.licences:
            shutil.copy(f"/usr/share/doc/{name}/copyright", wanted.licences / f"{name}.txt")
    when = datetime.datetime.fromtimestamp(wanted.epoch, datetime.timezone.utc)
    name = pathlib.Path(target).name.removesuffix(".spdx.json")
    document = {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
        "name": name,
        "documentNamespace": f"urn:sparkout:{name}:{wanted.version}:{wanted.epoch}",
        "creationInfo": {"created": when.strftime("%Y-%m-%dT%H:%M:%SZ"),
                         "creators": ["Tool: packaging/bill_of_materials.py"]},
        "packages": packages, "relationships": relations,
        "hasExtractedLicensingInfos": [
            {"licenseId": "LicenseRef-public-domain", "name": "Public domain",
             "extractedText": "liblzma is in the public domain; see licences/liblzma5.txt."}]
        if any("LicenseRef-public-domain" in each["licenseDeclared"] for each in packages) else [],
    }
    pathlib.Path(target).write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n",
                                    encoding="utf-8")
    print(f"{target}: {len(packages) - 1} packages")


main()
