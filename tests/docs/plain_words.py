#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the English of documents and texts: spelling, words that the project avoids, length of sentences, width of lines.

What is read: Markdown; the texts of the window (the sources of app/translations/hapticell_fr.ts); the sentences of the command
line (string literals of cli/ with four words or more); what public headers say (comments of three slashes). Spelling is by
hunspell's British English and words/project.txt; words/avoided.txt has what the project does not say, and what it says instead.
Code in documents (`...`, blocks of ```), links, names and file names are left out.

usage: plain_words.py PROJECT_ROOT [--unknown] | --self-test
  --unknown  prints the misspelt words only, the most frequent first: for adding real ones to words/project.txt
"""
import collections
import html
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
MAX_COLUMNS = 100
MAX_WORDS = 45  # In a sentence. Twice what style guides advise: an error names file, place, cause and remedy in one.
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"(?:\s*"((?:[^"\\\n]|\\.)*)")*')
PIECE = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
WORD = re.compile(r"[A-Za-zÀ-ÿ]+(?:['’][A-Za-z]+)?")
# Not words: code, paths, addresses, names with a capital, digit or underscore inside, formulas of frames (p_WQ).
NOT_WORDS = re.compile(r"`[^`]*`|<[^>]*>|https?://\S+|\S*[/\\_=@#{}|*^]\S*|%\w+|&\w*;|\b\w*\d\w*\b|\b\w*[a-z][A-Z]\w*|--?[a-z][\w-]*"
                       r"|\b\w+\.(?:[a-z]\w*)\b(?![.!?]\s)|\b[A-Z]{2,}s?\b|\b[A-Z]\b")
SENTENCE_END = re.compile(r"(?<=[.!?:;])[\"')\]]*\s+|\n\s*\n")


class Text:
    """A piece of English: where it is, what it says, and whether it is a line of Markdown."""

    def __init__(self, place, words, markdown=False):
        self.place, self.words, self.markdown = place, words, markdown


def markdown_texts(name, content):
    """Paragraphs without code, tables cell by cell."""
    paragraph, first, fenced = [], 0, False
    for number, line in enumerate([*content.splitlines(), ""], 1):
        if line.lstrip().startswith(("```", "~~~")):
            fenced = not fenced
            line = ""
        elif fenced:
            continue
        table = line.lstrip().startswith("|")
        begins = re.match(r"\s*([-*+]|\d+\.)\s|\s*#", line)
        if (not line.strip() or table or begins) and paragraph:
            yield Text(f"{name}:{first}", " ".join(paragraph))
            paragraph = []
        if table:
            for cell in line.strip().strip("|").split("|"):
                yield Text(f"{name}:{number}", cell)
        elif line.strip():
            if not paragraph:
                first = number
            paragraph.append(re.sub(r"^\s*([-*+]|\d+\.|#+|>)\s+", "", line).strip())


def wide_lines(name, content):
    fenced = False
    for number, line in enumerate(content.splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        # A row of a table, a link and an output of a program cannot be broken.
        if len(line) > MAX_COLUMNS and not fenced and not line.lstrip().startswith("|") and not re.search(r"\]\([^)]*\)|https?:", line):
            yield f"{name}:{number}: {len(line)} columns, at most {MAX_COLUMNS}"


def window_texts(name, content):
    for message in re.finditer(r"<message[^>]*>(.*?)</message>", content, re.DOTALL):
        if 'type="vanished"' in message[1] or 'type="obsolete"' in message[1]:
            continue
        source = re.search(r"<source>(.*?)</source>", message[1], re.DOTALL)
        place = re.search(r'<location filename="([^"]+)" line="(\d+)"', message[1])
        if source:
            where = f"{place[1]}:{place[2]}" if place else name
            yield Text(where, html.unescape(source[1]).replace("&", ""))


def command_texts(name, content):
    for literal in LITERAL.finditer(content):
        words = "".join(PIECE.findall(literal[0])).replace("\\n", "\n").replace("\\", "")
        if len(words.split()) >= 4 and "#include" not in content[content.rfind("\n", 0, literal.start()) + 1:literal.start()]:
            yield Text(f"{name}:{content.count(chr(10), 0, literal.start()) + 1}", words)


def header_texts(name, content):
    said, first = [], 0
    for number, line in enumerate([*content.splitlines(), ""], 1):
        comment = re.search(r"///<?\s?(.*)", line)
        if comment and line.lstrip().startswith("///"):
            if not said:
                first = number
            said.append(comment[1])
            continue
        if said:
            yield Text(f"{name}:{first}", " ".join(said))
            said = []
        if comment:
            yield Text(f"{name}:{number}", comment[1])


def all_texts(root, files):
    for name in files:
        content = (root / name).read_text(encoding="utf-8")
        if name.endswith(".md"):
            yield from markdown_texts(name, content)
        elif name.endswith(".ts"):
            yield from window_texts(name, content)
        elif name.endswith(".cpp"):
            yield from command_texts(name, content)
        else:
            yield from header_texts(name, content)


def avoided_words():
    """Pairs of a pattern and what to say instead, from lines of `words -> instead`; * stands for any end of the word."""
    pairs = []
    for line in (HERE / "words" / "avoided.txt").read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            words, instead = (part.strip() for part in line.split("->"))
            pattern = re.escape(words).replace(r"\*", r"\w*").replace(r"\ ", r"\s+")
            pairs.append((re.compile(rf"(?<![\w-]){pattern}(?![\w-])", re.IGNORECASE), words, instead))
    return pairs


def plain(words):
    return NOT_WORDS.sub(" ", words)


def misspelt(texts):
    """The words that neither hunspell nor the project knows, each with its places."""
    known = {word.strip().lower() for word in (HERE / "words" / "project.txt").read_text(encoding="utf-8").splitlines()}
    places = collections.defaultdict(list)
    for text in texts:
        for word in WORD.findall(plain(text.words)):
            places[re.sub(r"['’]s$", "", word)].append(text.place)
    said = subprocess.run(["hunspell", "-d", "en_GB", "-i", "utf-8", "-l"], input="\n".join(places), capture_output=True, text=True,
                          check=True)
    return {word: places[word] for word in said.stdout.split() if word in places and word.lower() not in known}


def long_sentences(text):
    for sentence in SENTENCE_END.split(text.words):
        count = len(WORD.findall(plain(sentence)))
        if count > MAX_WORDS:
            yield f"{text.place}: a sentence of {count} words, at most {MAX_WORDS}: {sentence.strip()[:80]}..."


def self_test():
    texts = list(markdown_texts("a.md", "# Title\n\nIt `mends` a\nfile.\n\n```\ncode\n```\n| cell | other |\n"))
    assert [text.words for text in texts] == ["Title", "It `mends` a file.", " cell ", " other "], texts
    assert not re.search("mends", plain(texts[1].words))
    assert list(wide_lines("a.md", "x " * 60)) and not list(wide_lines("a.md", "| " + "x " * 60))
    assert [t.words for t in command_texts("a.cpp", 'f("one two "\n  "three four");')] == ["one two three four"]
    assert [t.words for t in header_texts("a.h", "/// One\n/// two.\nint a;  ///< Three.\n")] == ["One two.", "Three."]
    assert [t.words for t in window_texts("a.ts", "<message><source>A &amp;amp; b</source></message>")] == ["A amp; b"]
    assert list(long_sentences(Text("a", "word " * 50))) and not list(long_sentences(Text("a", "word. " * 50)))
    pattern = next(found for found, words, _ in avoided_words() if words == "mend*")
    assert pattern.search("It mends the file") and not pattern.search("We recommend it")
    print("1 passed, 0 failed")


def main():
    if sys.argv[1] == "--self-test":
        return self_test()
    if not shutil.which("hunspell"):
        print("SKIPPED: hunspell is not installed")
        return 0
    root = pathlib.Path(sys.argv[1])
    listed = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard", "*.md", "app/translations/hapticell_fr.ts", "cli/*.cpp", "*.h"],
                            capture_output=True, text=True, check=False)
    files = [name for name in listed.stdout.split() if not name.startswith(("tests/", "bench/", "app/help/fr/")) and (root / name).exists()]
    if not files:
        print("SKIPPED: this is not a clone of the repository")
        return 0
    texts = list(all_texts(root, files))
    unknown = misspelt(texts)
    if "--unknown" in sys.argv:
        for word, places in sorted(unknown.items(), key=lambda item: -len(item[1])):
            print(f"{len(places):5} {word}  {places[0]}")
        return 0
    bad = [f"{places[0]}: '{word}': misspelt? If it is right, add it to tests/docs/words/project.txt"
           for word, places in sorted(unknown.items())]
    for text in texts:
        spoken = re.sub(r"`[^`]*`", " ", text.words)
        bad += [f"{text.place}: '{words}': say {instead}" for found, words, instead in avoided_words_ if found.search(spoken)]
        bad += long_sentences(text)
    for name in files:
        if name.endswith(".md"):
            bad += wide_lines(name, (root / name).read_text(encoding="utf-8"))
    print("\n".join(bad) if bad else f"{len(texts)} texts in {len(files)} files are in plain words")
    return 1 if bad else 0


avoided_words_ = avoided_words()

if __name__ == "__main__":
    sys.exit(main())
