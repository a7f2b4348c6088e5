// SPDX-License-Identifier: Apache-2.0
#include <cctype>

#include "tests/trajectory/programs/writing/grammar_cursor.h"
#include "tests/trajectory/programs/writing/program_grammar.h"

namespace hapticell::test {

namespace {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
};

/// Elements of a small XML text in order; Wrong where tags do not close.
std::vector<Element> xmlElements(const std::string& whole, std::string* code = nullptr) {
  if (!whole.starts_with("\xEF\xBB\xBF<?xml ")) throw Wrong("no byte order mark and declaration");
  std::vector<Element> elements;
  std::vector<std::string> open;
  for (std::size_t at = whole.find("?>") + 2; at < whole.size();) {
    if (whole[at] != '<') {
      if (std::isspace(static_cast<unsigned char>(whole[at])) == 0) throw Wrong("text outside of elements");
      ++at;
      continue;
    }
    if (whole.compare(at, 9, "<![CDATA[") == 0) {
      const auto end = whole.find("]]>", at);
      if (end == std::string::npos) throw Wrong("CDATA that does not end");
      if (code) *code = whole.substr(at + 9, end - at - 9);
      at = end + 3;
      continue;
    }
    const auto end = whole.find('>', at);
    if (end == std::string::npos) throw Wrong("a tag that does not end");
    std::string tag = whole.substr(at + 1, end - at - 1);
    at = end + 1;
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) throw Wrong("</" + tag.substr(1) + "> without its begin");
      open.pop_back();
      continue;
    }
    const bool is_empty = tag.back() == '/';
    if (is_empty) tag.pop_back();
    Element element;
    std::size_t i = tag.find_first_of(" \n");
    element.name = tag.substr(0, i);
    while (i < tag.size()) {
      i = tag.find_first_not_of(" \n", i);
      if (i == std::string::npos) break;
      const auto equals = tag.find("=\"", i), close = equals == std::string::npos ? equals : tag.find('"', equals + 2);
      if (close == std::string::npos) throw Wrong("an attribute that does not end in " + tag);
      element.attributes[tag.substr(i, equals - i)] = tag.substr(equals + 2, close - equals - 2);
      i = close + 1;
    }
    if (!is_empty) open.push_back(element.name);
    elements.push_back(element);
  }
  if (!open.empty()) throw Wrong("<" + open.back() + "> does not end");
  return elements;
}

/// A data array of VAL3: its type and values.
struct Val3Data {
  std::string type;
  std::vector<std::map<std::string, std::string>> values;
};

std::map<std::string, Val3Data> val3Database(const std::string& text) {
  std::map<std::string, Val3Data> data;
  std::string current;
  std::size_t size = 0;
  for (const Element& element : xmlElements(text)) {
    if (element.name == "Data") {
      if (!current.empty() && data[current].values.size() != size) throw Wrong("another size of " + current);
      current = element.attributes.at("name");
      needName(current, 15, {});
      data[current].type = element.attributes.at("type");
      size = std::stoul(element.attributes.at("size"));
    } else if (element.name == "Value") {
      if (element.attributes.at("key") != std::to_string(data[current].values.size())) throw Wrong("keys out of order");
      data[current].values.push_back(element.attributes);
    }
  }
  return data;
}

}  // namespace

std::string parseVal3(const std::map<std::string, std::string>& files, ParsedProgram& program) {
  return guarded([&] {
    std::string database;
    std::set<std::string> named;
    for (const auto& [name, text] : files) {
      if (!name.ends_with(".pjx")) continue;
      const auto slash = name.find('/');
      program.name = name.substr(slash + 1, name.size() - slash - 5);
      if (name.substr(0, slash) != program.name) throw Wrong("a folder of another name than its application");
      needName(program.name, 15,
               {"BEGIN", "END", "IF", "FOR", "CALL", "START", "STOP", "NUM", "TOOL", "FRAME", "POINT", "WHILE",
                "RETURN", "DEFAULT"});
      for (const Element& element : xmlElements(text)) {
        if (!element.attributes.contains("file")) continue;
        named.insert(element.attributes.at("file"));
        if (!files.contains(program.name + "/" + element.attributes.at("file")))
          throw Wrong("a file that is not there");
        if (element.name == "Data") database = element.attributes.at("file");
      }
    }
    if (!named.contains("start.pgx") || !named.contains("stop.pgx")) throw Wrong("no programs start and stop");
    auto data = val3Database(files.at(program.name + "/" + database));
    std::string stop;
    xmlElements(files.at(program.name + "/stop.pgx"), &stop);
    std::string code;
    xmlElements(files.at(program.name + "/start.pgx"), &code);
    const auto variable = [&data](GrammarCursor& at,
                                  const std::set<std::string>& types) -> std::map<std::string, std::string> {
      const std::string name = at.word();
      std::size_t index = 0;
      if (at.maybe("[")) {
        index = static_cast<std::size_t>(at.number());
        at.need("]");
      }
      if (!data.contains(name) || !types.contains(data[name].type) || index >= data[name].values.size())
        at.fail("declared data, not " + name);
      return data[name].values[index];
    };
    GrammarCursor at(code);
    at.needWord("begin");
    at.line();
    while (!at.maybeWord("end")) {
      if (at.maybe("//")) {
        at.restOfLine();
      } else if (at.maybeWord("waitEndMove")) {
        at.need("()");
      } else if (at.maybeWord("delay")) {
        at.need("(");
        const double seconds = at.number();
        at.need(")");
        if (!(seconds > 0.0) || program.moves.empty()) at.fail("a time over 0 behind a move");
        program.moves.back().dwell = seconds;
      } else {
        ParsedProgram::Move move;
        move.kind = at.maybeWord("movej") ? 'J' : (at.needWord("movel"), 'L');
        at.need("(");
        const auto target = variable(
            at, move.kind == 'J' ? std::set<std::string>{"jointRx", "pointRx"} : std::set<std::string>{"pointRx"});
        move.is_joints = target.contains("j1");
        for (const char* name : {"x", "y", "z", "rx", "ry", "rz", "j1", "j2", "j3", "j4", "j5", "j6"})
          if (target.contains(name)) move.target.push_back(std::stod(target.at(name)));
        if (move.target.size() != 6) at.fail("six coordinates");
        at.need(",");
        variable(at, {"tool"});
        at.need(",");
        const auto motion = variable(at, {"mdesc"});
        at.need(")");
        program.settings[move.kind == 'J' ? "joint speed" : "lines' joint speed"] = std::stod(motion.at("vel"));
        program.settings["speed"] = std::stod(motion.at("tmax"));
        if (!(program.settings["speed"] > 0.0)) at.fail("a speed over 0");
        move.blend = motion.at("blend") == "off" ? 0.0 : std::stod(motion.at("leave"));
        program.moves.push_back(move);
      }
      at.line();
    }
  });
}

}  // namespace hapticell::test
