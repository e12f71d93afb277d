#!/usr/bin/env python3
"""Check a software bill of materials against the required fields of SPDX 2.3 JSON.

Usage: check_sbom.py FILE                                  check a document
       check_sbom.py --generate SBOM PROGRAM [EXPECTED]... run scripts/sbom for a program, check the document, that it
                                                           names the EXPECTED packages, and that damaged copies are rejected
"""

import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ID = re.compile(r"SPDXRef-[A-Za-z0-9.-]+")
DATE = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ")
DIGITS = {"SHA1": 40, "SHA256": 64, "SHA512": 128}
DOCUMENT = {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT"}
RELATIONSHIPS = {"DESCRIBES", "CONTAINS", "DYNAMIC_LINK", "STATIC_LINK", "BUILD_TOOL_OF"}
# Identifiers of the SPDX licence list that the packages of Jostle use.
LICENCES = set("""0BSD Apache-2.0 Artistic-1.0-Perl BSD-2-Clause BSD-3-Clause BSL-1.0 CC0-1.0 GFDL-1.2-or-later
    GFDL-1.3-only GPL-1.0-or-later GPL-2.0-only GPL-2.0-or-later GPL-3.0-only GPL-3.0-or-later ISC LGPL-2.0-only
    LGPL-2.0-or-later LGPL-2.1-only LGPL-2.1-or-later LGPL-3.0-only LGPL-3.0-or-later MIT MPL-2.0 OpenSSL Unlicense X11
    Zlib""".split())
DOWNLOAD = re.compile(r"NOASSERTION|NONE|https://\S+")


def licence_faults(where, expression, extracted):
    if expression in ("NOASSERTION", "NONE"):
        return []
    return [f"{where}: licence {term!r} is neither on the SPDX list nor in hasExtractedLicensingInfos"
            for term in re.split(r" AND | OR ", expression.replace("(", "").replace(")", ""))
            if term not in LICENCES and term not in extracted]


def package_faults(package, extracted):
    where = package.get("name") or package.get("SPDXID", "a package")
    found = [f"{where}: no {field}" for field in ("name", "SPDXID", "versionInfo", "downloadLocation", "licenseConcluded",
                                                  "licenseDeclared", "copyrightText") if not package.get(field)]
    if found:
        return found
    if not ID.fullmatch(package["SPDXID"]):
        found.append(f"{where}: SPDXID {package['SPDXID']!r} has other characters than letters, digits, '.' and '-'")
    if not DOWNLOAD.fullmatch(package["downloadLocation"]):
        found.append(f"{where}: downloadLocation {package['downloadLocation']!r} is not a URL, NONE or NOASSERTION")
    # Without it, the files must be listed with a verification code.
    if package.get("filesAnalyzed") is not False:
        found.append(f"{where}: filesAnalyzed must be false")
    for checksum in package.get("checksums", []):
        if not re.fullmatch(r"[0-9a-f]{%d}" % DIGITS.get(checksum["algorithm"], 0), checksum["checksumValue"]):
            found.append(f"{where}: checksum is no {checksum['algorithm']}")
    for reference in package.get("externalRefs", []):
        if not re.fullmatch(r"pkg:(deb|npm)/\S+@\S+", reference["referenceLocator"]):
            found.append(f"{where}: {reference['referenceLocator']!r} is no package URL")
    for field in ("licenseConcluded", "licenseDeclared"):
        found += licence_faults(where, package[field], extracted)
    return found


def faults(document):
    found = [f"{field} must be {value!r}" for field, value in DOCUMENT.items() if document.get(field) != value]
    if not document.get("name"):
        found.append("the document has no name")
    if not re.fullmatch(r"https://[^#\s]+", document.get("documentNamespace", "")):
        found.append("documentNamespace must be a URI without '#'")
    creation = document.get("creationInfo", {})
    if not DATE.fullmatch(creation.get("created", "")):
        found.append("creationInfo.created must look like 2026-01-31T12:00:00Z")
    if not creation.get("creators") or not all(
            re.match(r"(Person|Organization|Tool): ", creator) for creator in creation["creators"]):
        found.append("creationInfo.creators must name persons, organizations or tools")
    infos = document.get("hasExtractedLicensingInfos", [])
    extracted = {info.get("licenseId") for info in infos}
    for info in infos:
        if not re.fullmatch(r"LicenseRef-[A-Za-z0-9.-]+", info.get("licenseId", "")) or not info.get("extractedText"):
            found.append(f"hasExtractedLicensingInfos: {info.get('licenseId')!r} has no valid id or no text")
    packages = document.get("packages", [])
    if not packages:
        found.append("there are no packages")
    for package in packages:
        found += package_faults(package, extracted)
    known = [package.get("SPDXID") for package in packages]
    found += [f"SPDXID {each} occurs twice" for each in sorted({i for i in known if i and known.count(i) > 1})]
    elements, related = {"SPDXRef-DOCUMENT", *known}, set()
    for relationship in document.get("relationships", []):
        if relationship.get("relationshipType") not in RELATIONSHIPS:
            found.append(f"unknown relationship {relationship.get('relationshipType')!r}")
        for end in ("spdxElementId", "relatedSpdxElement"):
            related.add(relationship.get(end))
            if relationship.get(end) not in elements:
                found.append(f"a relationship names {relationship.get(end)!r}, which does not exist")
    if not any(r.get("relationshipType") == "DESCRIBES" for r in document.get("relationships", [])):
        found.append("no relationship DESCRIBES")
    found += [f"{each} is in no relationship" for each in known if each not in related]
    return found


def damaged(document):
    """(what was damaged, a word of the fault, the copy)"""
    def copies(word, change):
        other = copy.deepcopy(document)
        change(other)
        return word, other

    for field in ("spdxVersion", "dataLicense", "SPDXID", "name", "documentNamespace", "creationInfo"):
        yield copies(field if field != "creationInfo" else "creationInfo.created", lambda d, f=field: d.pop(f))
    for field in ("name", "SPDXID", "downloadLocation", "licenseDeclared", "versionInfo"):
        yield copies(f"no {field}", lambda d, f=field: d["packages"][0].pop(f))
    yield copies("occurs twice", lambda d: d["packages"].append(d["packages"][0]))
    yield copies("in no relationship", lambda d: d["packages"].append({**d["packages"][0], "SPDXID": "SPDXRef-lost"}))
    yield copies("does not exist", lambda d: d["packages"].pop())
    yield copies("DESCRIBES", lambda d: d["relationships"].pop(0))
    yield copies("neither on the SPDX list", lambda d: d["packages"][0].update(licenseDeclared="Expat"))
    yield copies("filesAnalyzed", lambda d: d["packages"][0].pop("filesAnalyzed"))


def generate(sbom, program, expected):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "sbom.spdx.json")
        subprocess.run([sbom, "-o", path, program], check=True, stdout=subprocess.DEVNULL)
        document = json.loads(path.read_text())
    found = faults(document)
    names = {package["name"] for package in document["packages"]}
    found += [f"{name} is missing" for name in expected if name not in names]
    if not found:
        for word, copied in damaged(document):
            if not any(word in fault for fault in faults(copied)):
                found.append(f"a damaged copy has no fault that says {word!r}")
    return found, document


def main(arguments):
    if len(arguments) >= 3 and arguments[0] == "--generate":
        found, document = generate(arguments[1], arguments[2], arguments[3:])
    elif len(arguments) == 1 and not arguments[0].startswith("-"):
        try:
            document = json.loads(pathlib.Path(arguments[0]).read_text())
        except (OSError, ValueError) as error:
            print(f"{arguments[0]}: {error}")
            return 1
        found = faults(document)
    else:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    print("\n".join(found) or f"{len(document['packages'])} packages, {len(document['relationships'])} relationships")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
