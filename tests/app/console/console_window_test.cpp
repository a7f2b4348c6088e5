// SPDX-License-Identifier: Apache-2.0
// The Python console in the window, by real keys; the interpreter is a real one.
#include <QDir>
#include <QFile>

#include "tests/app/pages/console_page.h"
#include "workcell/format/document_io.h"

namespace hapticell::app {
namespace {

TEST(PythonConsole, ChangesTheCellInOneStepOfUndoAStatement) {
  ConsolePage page;
  page.addPart("box:0.1,0.1,0.1", "part");
  page.addPart("box:1,1,0.1", "table");
  ASSERT_TRUE(page.start()) << page.printed().toStdString();
  ASSERT_TRUE(page.run("cell.names, selection", "(['part', 'table'], ['table'])")) << page.printed().toStdString();
  ASSERT_EQ(page.steps(), 2u);  // It only looked.
  page.type("cell.move('part', [0.1, 0.2, 0.3, 1, 0, 0, 0]); cell.set('part', color=[1, 0, 0]); cell.rename('table', 'desk')");
  page.key(Qt::Key_Return);
  ASSERT_TRUE(page.hasSteps(3)) << page.printed().toStdString();
  EXPECT_NEAR(page.placeOf("part").p.y, 0.2, 1e-12);
  ASSERT_NE(page.document().document().findByName("desk"), nullptr);
  EXPECT_EQ(page.document().document().findByName("part")->color[0], 1.0f);
  EXPECT_TRUE(page.document().document().undoText().starts_with("Python: ")) << page.document().document().undoText();
  page.trigger("actionUndo");
  EXPECT_EQ(page.steps(), 2u);
  EXPECT_EQ(page.placeOf("part").p.y, 0.0);
  EXPECT_NE(page.document().document().findByName("table"), nullptr);
  // The interpreter's cell follows the window's.
  ASSERT_TRUE(page.run("float(cell['part'].pose[1]), 'table' in cell", "(0.0, True)"));
}

TEST(PythonConsole, AddsRobotsAndTakesPartsAway) {
  ConsolePage page;
  page.addPart("box:0.1,0.1,0.1", "part");
  ASSERT_TRUE(page.start());
  page.type("cell.remove('part'); cell.add('library:abb_irb120_3_58', name='arm'); cell.set_joints('arm', [0.1, 0.2, 0.05, 0.3, 0.4, 0.5])");
  page.key(Qt::Key_Return);
  ASSERT_TRUE(page.isReady());
  ASSERT_TRUE(page.hasSteps(2)) << page.printed().toStdString();
  const auto* arm = page.document().document().findByName("arm");
  ASSERT_NE(arm, nullptr);
  EXPECT_NEAR(arm->joints()[1], 0.2, 1e-12);
  EXPECT_EQ(page.entities(), 1u);
}

TEST(PythonConsole, CompletesAndRemembersAcrossWindows) {
  ConsolePage page;
  page.addPart("box:0.1,0.1,0.1", "Fixture A");
  ASSERT_TRUE(page.start());
  ASSERT_TRUE(page.run("1 + 1", "\n2"));  // From here on it has the cell.
  ASSERT_TRUE(page.isReady());
  page.type("cell.set_j");
  page.key(Qt::Key_Tab);
  ASSERT_TRUE(page.until([&] { return page.field().toPlainText() == "cell.set_joints("; }, ConsolePage::kPython))
      << page.field().toPlainText().toStdString();
  page.field().clear();
  page.type("cell['Fix");
  page.key(Qt::Key_Tab);
  ASSERT_TRUE(page.until([&] { return page.field().toPlainText() == "cell['Fixture A"; }, ConsolePage::kPython));
  page.field().clear();
  // Several: what they begin with is put in, and all are shown.
  page.type("cell.re");
  page.key(Qt::Key_Tab);
  ASSERT_TRUE(page.prints("remove_check"));
  page.field().clear();
  page.type("half");
  page.key(Qt::Key_Up);
  EXPECT_EQ(page.field().toPlainText(), "1 + 1");
  page.key(Qt::Key_Up);
  EXPECT_EQ(page.field().toPlainText(), "1 + 1");
  page.key(Qt::Key_Down);
  EXPECT_EQ(page.field().toPlainText(), "half");
  const ConsoleHistory kept(ConsoleHistory::usualFile());
  EXPECT_EQ(kept.entries(), QStringList{"1 + 1"});
  EXPECT_TRUE(ConsoleHistory::usualFile().startsWith(page.OwnUserFolders::path()));
}

TEST(PythonConsole, TakesBlocksOfSeveralLines) {
  ConsolePage page;
  ASSERT_TRUE(page.start());
  page.type("for i in range(2):");
  page.key(Qt::Key_Return);
  ASSERT_TRUE(page.until([&] { return page.field().blockCount() == 2; }, ConsolePage::kPython));
  page.type("print('row', i)");  // The field has indented.
  page.key(Qt::Key_Return);
  ASSERT_TRUE(page.until([&] { return page.field().blockCount() == 3; }, ConsolePage::kPython));
  page.key(Qt::Key_Return);
  ASSERT_TRUE(page.prints("row 0\nrow 1")) << page.printed().toStdString();
  EXPECT_TRUE(page.printed().contains(">>> for i in range(2):\n...     print('row', i)\n"));
}

TEST(PythonConsole, ErrorsHaveAColourOfTheirOwn) {
  ConsolePage page;
  ASSERT_TRUE(page.start());
  ASSERT_TRUE(page.run("print('fine')", "\nfine"));
  ASSERT_TRUE(page.run("1 / 0", "ZeroDivisionError: division by zero"));
  EXPECT_EQ(page.colorOf("division by zero"), themeOf(page.output().palette()).contact);
  EXPECT_NE(page.colorOf("division by zero"), page.colorOf("fine"));
  ASSERT_TRUE(page.run("cell.move('none', None)", "no entity is named 'none'"));
  EXPECT_EQ(page.steps(), 0u);
}

TEST(PythonConsole, AnEndlessLoopIsInterruptedAndTheWindowWorksMeanwhile) {
  ConsolePage page;
  page.addPart("box:0.1,0.1,0.1", "part");
  ASSERT_TRUE(page.start());
  page.type("while True: pass");
  page.key(Qt::Key_Return);
  page.key(Qt::Key_Return);
  ASSERT_TRUE(page.until([&] { return page.state().contains("Running"); }, ConsolePage::kPython));
  page.window().selection().set(page.document().document().findByName("part")->id);
  page.key(Qt::Key_C, Qt::ControlModifier);
  ASSERT_TRUE(page.prints("KeyboardInterrupt"));
  ASSERT_TRUE(page.isReady());
  // By the button, while it prints as fast as it can.
  page.type("while True: print('endless')");
  page.key(Qt::Key_Return);
  page.key(Qt::Key_Return);
  ASSERT_TRUE(page.prints("endless\nendless"));
  page.click("buttonConsoleInterrupt");
  ASSERT_TRUE(page.isReady());
  ASSERT_TRUE(page.run("'after' + 'wards'", "'afterwards'"));
}

TEST(PythonConsole, WhatDoesNotHeedTheInterruptIsEndedByTheSecond) {
  ConsolePage page;
  ASSERT_TRUE(page.start());
  page.type("exec('import time\\nwhile True:\\n try:\\n  time.sleep(9)\\n except KeyboardInterrupt: print(\"no\", flush=True)')");
  page.key(Qt::Key_Return);
  ASSERT_TRUE(page.until([&] { return page.state().contains("Running"); }, ConsolePage::kPython));
  ConsolePage::rest(300);
  page.click("buttonConsoleInterrupt");
  ASSERT_TRUE(page.prints("\nno"));
  page.click("buttonConsoleInterrupt");
  ASSERT_TRUE(page.prints("did not heed the interrupt"));
  ASSERT_TRUE(page.isReady());
}

TEST(PythonConsole, ACrashOfAScriptTakesNothingOfTheCell) {
  ConsolePage page;
  page.addPart("box:0.1,0.1,0.1", "part");
  const std::string before = workcell::documentText(page.document().document().state(), "/");
  ConsolePage::writeFile(scriptFolder() + "/bad.py", "cell.remove('part')\nimport os\nos._exit(1)\n");
  ConsolePage::writeFile(scriptFolder() + "/worse.py", "import ctypes\ncell.remove('part')\nctypes.string_at(0)\n");
  ASSERT_TRUE(page.start());
  page.choose("bad.py");
  ASSERT_TRUE(page.prints("The interpreter ended (exit status 1)")) << page.printed().toStdString();
  ASSERT_TRUE(page.isReady());
  page.choose("worse.py");
  ASSERT_TRUE(page.prints("The interpreter crashed")) << page.printed().toStdString();
  ASSERT_TRUE(page.isReady());
  EXPECT_EQ(workcell::documentText(page.document().document().state(), "/"), before);
  EXPECT_EQ(page.steps(), 1u);
  ASSERT_TRUE(page.run("cell.names", "['part']"));
}

TEST(PythonConsole, RunsScriptsOfTheFolderAsOneStep) {
  ConsolePage page;
  ConsolePage::writeFile(scriptFolder() + "/row.py",
                         "for i in range(5):\n    cell.add('box:0.1,0.1,0.1', name=f'box {i}', pose=[0.2 * i, 0, 0, 1, 0, 0, 0])\n");
  ASSERT_TRUE(page.start());
  page.choose("row.py");
  ASSERT_TRUE(page.hasSteps(1)) << page.printed().toStdString();
  EXPECT_EQ(page.entities(), 5u);
  EXPECT_EQ(page.document().document().undoText(), "Python: row.py");
  // One that others can write to is not run.
  QFile::setPermissions(scriptFolder() + "/row.py", QFile::permissions(scriptFolder() + "/row.py") | QFile::WriteOther);
  page.choose("row.py");
  ASSERT_TRUE(page.prints("row.py")) << page.printed().toStdString();
  ConsolePage::rest(500);
  EXPECT_EQ(page.steps(), 1u);
}

TEST(PythonConsole, WhatWasRecordedDoesTheSameAgain) {
  ConsolePage page;
  page.addPart("box:0.1,0.1,0.1", "part");
  const workcell::DocumentState before = page.document().document().state();
  ASSERT_TRUE(page.start());
  page.click("buttonConsoleRecord");
  page.addPart("box:1,1,0.1", "ta\"ble");
  auto id = [&](const char* name) { return page.document().document().findByName(name)->id; };
  ASSERT_TRUE(page.document().execute(
      workcell::SetPlacement{id("part"), {{0.1, -0.2, 0.3}, dquat(0.5, 0.5, 0.5, 0.5)}}));
  workcell::SetProperties properties;
  properties.id = id("part");
  properties.color = {0.25f, 0.5f, 0.75f};
  properties.mass = 2.5;
  ASSERT_TRUE(page.document().execute(properties));
  ASSERT_TRUE(page.document().execute(workcell::Attach{id("part"), id("ta\"ble"), ""}));
  workcell::PairSet set;
  set.name = "all";
  set.first = {"part"};
  ASSERT_TRUE(page.document().execute(workcell::AddPairSet{set}));
  ASSERT_TRUE(page.document().execute(workcell::RenameEntity{id("part"), "piece"}));
  ASSERT_TRUE(page.document().execute(workcell::RenameEntity{id("piece"), "undone"}));
  page.trigger("actionUndo");  // Does not count.
  page.click("buttonConsoleRecord");
  ASSERT_TRUE(page.prints("6 action")) << page.printed().toStdString();
  const std::string wanted = workcell::documentText(page.document().document().state(), "/");
  const QStringList scripts = scriptNames();
  ASSERT_EQ(scripts.size(), 1);
  for (int i = 0; i < 6; ++i) page.trigger("actionUndo");
  ASSERT_EQ(workcell::documentText(page.document().document().state(), "/"), workcell::documentText(before, "/"));
  page.choose(scripts.front());
  ASSERT_TRUE(page.hasSteps(2)) << page.printed().toStdString();
  EXPECT_EQ(workcell::documentText(page.document().document().state(), "/"), wanted);
}

TEST(PythonConsole, ActionsWithoutAMethodAreCommentsInTheScript) {
  ConsolePage page;
  page.addPart("box:0.1,0.1,0.1", "part");
  page.show();
  const auto id = page.document().document().findByName("part")->id;
  ASSERT_TRUE(page.document().execute(workcell::SetFrames{id, {{"grip", {}}}}));
  page.choose("Last actions as a script");
  ASSERT_TRUE(page.prints("2 action"));
  ASSERT_EQ(scriptNames().size(), 1);
  QFile file(QDir(scriptFolder()).filePath(scriptNames().front()));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString script = QString::fromUtf8(file.readAll());
  EXPECT_TRUE(script.contains("cell.add(\"box:0.1,0.1,0.1\", name=\"part\")")) << script.toStdString();
  EXPECT_TRUE(script.contains("# Not written, because Python has no method for it: Change frames of part\n    pass\n"))
      << script.toStdString();
}

TEST(PythonConsole, AChangeInTheWindowMeanwhileIsNotOverwritten) {
  ConsolePage page;
  page.addPart("box:0.1,0.1,0.1", "part");
  ASSERT_TRUE(page.start());
  page.type("import time; print('now'); time.sleep(1); cell.move('part', [1, 0, 0, 1, 0, 0, 0])");
  page.key(Qt::Key_Return);
  ASSERT_TRUE(page.prints("\nnow"));
  const auto id = page.document().document().findByName("part")->id;
  ASSERT_TRUE(page.document().execute(workcell::SetPlacement{id, {{0, 2, 0}, dquat(1, 0, 0, 0)}}));
  ASSERT_TRUE(page.prints("changed in the window while Python ran"));
  EXPECT_EQ(page.placeOf("part").p, dvec3(0, 2, 0));
  ASSERT_TRUE(page.run("float(cell['part'].pose[1])", "\n2.0"));
}

TEST(PythonConsole, WithoutPythonOrItsPackageASentenceSaysWhatToInstall) {
  qputenv("HAPTICELL_PYTHON", "/nowhere/python3");
  ConsolePage page;
  page.show();
  EXPECT_TRUE(page.prints("Install the packages python3 and python3-hapticell")) << page.printed().toStdString();
  EXPECT_EQ(page.state(), "No Python");
  page.addPart("box:0.1,0.1,0.1", "part");  // The window works on.
  EXPECT_EQ(page.entities(), 1u);
  // A program that knows no such package: what Python says is in the sentence.
  const QString other = page.OwnUserFolders::path() + "/python3";
  ConsolePage::writeFile(other, "#!/bin/sh\necho 'No module named hapticell' >&2\nexit 1\n");
  QFile::setPermissions(other, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  qputenv("HAPTICELL_PYTHON", other.toUtf8());
  page.type("1 + 1");
  page.key(Qt::Key_Return);
  EXPECT_TRUE(page.prints("No module named hapticell. Install the package python3-hapticell"))
      << page.printed().toStdString();
  // Installed meanwhile: the next statement finds it.
  qunsetenv("HAPTICELL_PYTHON");
  EXPECT_TRUE(page.run("20 + 22", "\n42")) << page.printed().toStdString();
}

}  // namespace
}  // namespace hapticell::app
