#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tools/release on a clone of the project: the archive, the list of components against the rules of SPDX 2.3, and the checksums.

usage: release_test.py PROJECT_ROOT [PROGRAM_OR_LIBRARY...]
What the given programs link must be in packaging/third-party.txt. Skipped (77) without git, a commit, or the packages of the list.
"""
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

ROOT, BUILT = pathlib.Path(sys.argv[1]), sys.argv[2:]
# Those of https://spdx.org/licenses that the project's libraries have.
LICENCES = {"Apache-2.0", "BSD-2-Clause", "BSD-3-Clause", "BSL-1.0", "CC0-1.0", "GPL-2.0-only", "GPL-2.0-or-later", "GPL-3.0-only",
            "GPL-3.0-or-later", "ISC", "LGPL-2.0-only", "LGPL-2.0-or-later", "LGPL-2.1-only", "LGPL-2.1-or-later", "LGPL-3.0-only",
            "LGPL-3.0-or-later", "MIT", "MPL-1.1", "MPL-2.0", "Zlib", "blessing"}
EXCEPTIONS = {"GCC-exception-3.1", "OCCT-exception-1.0", "Qt-GPL-exception-1.0"}
RELATIONS = {"DESCRIBES", "DYNAMIC_LINK", "STATIC_LINK", "RUNTIME_DEPENDENCY_OF", "BUILD_TOOL_OF", "GENERATED_FROM"}


def call(*words, status=0, cwd=None):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, timeout=250, cwd=cwd, check=False)
    if done.returncode == 2 and "missing" in done.stderr and status == 0:
        print(f"skipped: {done.stderr.strip()}")
        sys.exit(77)
    assert done.returncode == status, (words, done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


def rows():
    lines = (ROOT / "packaging" / "third-party.txt").read_text(encoding="utf-8").splitlines()
    found = [[part.strip() for part in line.split("|")] for line in lines if line.strip() and not line.startswith("#")]
    assert all(len(row) == 4 for row in found), [row for row in found if len(row) != 4]
    return found


def is_expression(text, references):
    """licence [WITH exception] {(AND | OR) licence [WITH exception]}, or that there is no statement."""
    if text == "NOASSERTION":
        return True
    for part in re.split(r" (?:AND|OR) ", text):
        licence, _, exception = part.partition(" WITH ")
        if (licence not in LICENCES and licence not in references) or (exception and exception not in EXCEPTIONS):
            return False
    return True


def check_document(document, tarball):
    assert document["spdxVersion"] == "SPDX-2.3" and document["dataLicense"] == "CC0-1.0" and document["SPDXID"] == "SPDXRef-DOCUMENT"
    assert document["name"] and re.fullmatch(r"[a-z]+:[^#\s]+", document["documentNamespace"])
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", document["creationInfo"]["created"])
    assert all(re.match(r"(Person|Organization|Tool): \S", maker) for maker in document["creationInfo"]["creators"])
    references = {text["licenseId"] for text in document["hasExtractedLicensingInfos"]}
    assert len(references) == len(document["hasExtractedLicensingInfos"])
    assert all(re.fullmatch(r"LicenseRef-[A-Za-z0-9.-]+", name) for name in references), references
    assert all(text["extractedText"].strip() for text in document["hasExtractedLicensingInfos"])
    names = ["SPDXRef-DOCUMENT"] + [package["SPDXID"] for package in document["packages"]]
    assert len(set(names)) == len(names) and all(re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", name) for name in names)
    used = set()
    for package in document["packages"]:
        assert package["name"] and package["downloadLocation"] and package["filesAnalyzed"] is False, package
        for key in ("licenseConcluded", "licenseDeclared"):
            assert is_expression(package[key], references), (package["name"], package[key])
            used |= set(re.findall(r"LicenseRef-[A-Za-z0-9.-]+", package[key]))
        for reference in package.get("externalRefs", []):
            assert re.fullmatch(r"pkg:deb/debian/[A-Za-z0-9.%-]+@[A-Za-z0-9.~%-]+\?arch=\w+&distro=debian-12", reference["referenceLocator"])
    assert used == references, used ^ references
    for relation in document["relationships"]:
        assert relation["relationshipType"] in RELATIONS, relation
        assert {relation["spdxElementId"], relation["relatedSpdxElement"]} <= set(names), relation
    assert {name for one in document["relationships"] for name in (one["spdxElementId"], one["relatedSpdxElement"])} == set(names)
    project = document["packages"][0]
    assert project["checksums"][0]["checksumValue"] == hashlib.sha256(tarball.read_bytes()).hexdigest()
    assert {package["name"] for package in document["packages"][1:]} == {row[0] for row in rows()}


def test_release_makes_the_same_files_twice(clone, folder):
    for name in ("one", "two"):
        call("python3", clone / "tools" / "release", "--out", folder / name)
        call("sha256sum", "--check", "--strict", "SHA256SUMS", cwd=folder / name)
    names = sorted(file.name for file in (folder / "one").iterdir())
    assert len(names) == 3 and len((folder / "one" / "SHA256SUMS").read_text().splitlines()) == 2, names
    for name in names:
        assert (folder / "one" / name).read_bytes() == (folder / "two" / name).read_bytes(), name
    tarball = next((folder / "one").glob("*.tar.gz"))
    prefix = tarball.name.removesuffix(".tar.gz")
    with tarfile.open(tarball) as archive:
        members = {member.name for member in archive if not member.isdir()}
    assert members == {f"{prefix}/{name}" for name in call("git", "ls-files", cwd=clone).split("\n") if name}
    check_document(json.loads((folder / "one" / f"{prefix}.spdx.json").read_text(encoding="utf-8")), tarball)


def test_only_a_whole_commit_is_released(clone, folder):
    (clone / "new.txt").write_text("new\n")
    assert "changes without a commit" in call("python3", clone / "tools" / "release", "--out", folder / "dirty", status=1)
    assert not (folder / "dirty").exists()
    (folder / "more.deb").write_text("a package\n")
    call("python3", clone / "tools" / "release", "--dirty", "--out", folder / "dirty", folder / "more.deb")
    assert "  more.deb\n" in (folder / "dirty" / "SHA256SUMS").read_text()
    (clone / "new.txt").unlink()


def test_one_version_everywhere(clone, folder):
    changes = clone / "CHANGELOG.md"
    changes.write_text(re.sub(r"^## \[[\d.]+\]", "## [9.8.7]", changes.read_text(encoding="utf-8"), count=1, flags=re.MULTILINE))
    call("git", "-c", "user.name=A", "-c", "user.email=a@b.invalid", "commit", "-qam", "Other version", cwd=clone)
    assert "CHANGELOG.md has 9.8.7" in call("python3", clone / "tools" / "release", "--out", folder / "other", status=1)


def test_the_page_of_licences_has_what_is_used(_clone, _folder):
    page = (ROOT / "docs" / "user" / "licences.md").read_text(encoding="utf-8")
    listed = {re.sub(r" \(.*", "", line.split("|")[1].strip()) for line in page.splitlines() if line.startswith("| ")} - {"Library", "---"}
    named = {row[3] for row in rows() if row[2] in ("dynamic", "headers", "run") and row[3]}
    assert listed == named, listed ^ named


def test_nothing_is_linked_under_the_gpl_alone(_clone, _folder):
    for package, licence, use, _ in rows():
        for choice in licence.split(" OR ") if use != "tool" else []:
            assert not choice.startswith("GPL") or " WITH GCC-exception" in choice, (package, licence)


def test_all_that_is_linked_is_in_the_list(_clone, _folder):
    named = {row[0] for row in rows() if row[2] == "dynamic"}
    linked = {}  # Real file names by the names that the programs ask for.
    for file in BUILT:
        places = dict(re.findall(r"^\t(\S+) => (/\S+)", call("ldd", file), re.MULTILINE))
        for name in re.findall(r"NEEDED.*\[(.*)\]", call("readelf", "-d", file)):
            if name in places and not name.startswith(("libhapticell", "ld-linux")):
                linked[pathlib.Path(places[name]).resolve().name] = name
    # The package has a file under /usr/lib; the loader may find it under /lib.
    said = call("dpkg-query", "-S", *[f"*/{real}" for real in linked]) if linked else ""
    owners = [line.rpartition(": ") for line in said.splitlines()]
    for real, name in linked.items():
        packages = {part.strip().split(":")[0] for owner, _, file in owners if file.endswith("/" + real) for part in owner.split(",")}
        assert packages & named, f"{name} of {packages} is linked: add it to packaging/third-party.txt"


def main():
    for tool in ("git", "dpkg-query", "readelf", "ldd"):
        if not shutil.which(tool):
            print(f"skipped: {tool} is not installed")
            return 77
    with tempfile.TemporaryDirectory() as place:
        clone = pathlib.Path(place) / "clone"
        done = subprocess.run(["git", "clone", "-q", "--shared", str(ROOT), str(clone)], capture_output=True, text=True, check=False)
        if done.returncode:
            print(f"skipped: this is not a clone of the repository: {done.stderr.strip()}")
            return 77
        for name, test in list(globals().items()):
            if name.startswith("test_"):
                folder = pathlib.Path(place) / name
                folder.mkdir()
                test(clone, folder)
                print(f"passed: {name}")
    return 0


sys.exit(main())
