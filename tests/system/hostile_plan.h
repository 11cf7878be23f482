// A plan whose every text acts where it is not taken as text: on a terminal, in a page, in XML.
#pragma once

#include <string>

#include "system/plan_text.h"
#include "system/temp_folder.h"

namespace lsos::test {

// Markup that would set a mark on the page, an end of CDATA and of comments, quotes, and characters
// that no one sees: marks of direction, of C1, without width. A RoverId may have all of these.
inline const std::string hostile_markup =
    "<script>hacked=1</script><img src=x "
    "onerror=hacked=1>]]>--><b>\"'&\u202e\u0085\u009b31m\u200b\u2066";
// And what terminals obey: titles, colours, bells, steps back.
inline const std::string hostile_text =
    hostile_markup + "\x1b]0;title\x07\x1b[31m\x1b[2J\b\x7f</title></td>";

// As XML says it, in which no C0 character may stand as it is.
inline std::string in_xml(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool is_plain =
        code >= 0x20 && c != '<' && c != '>' && c != '&' && c != '"' && c != '\x7f';
    xml += is_plain ? std::string(1, c) : "&#" + std::to_string(code) + ";";
  }
  return xml;
}

// As a Lua script says it.
inline std::string in_lua(const std::string& text) {
  std::string lua = "'";
  for (const char c : text) {
    const std::string code = std::to_string(static_cast<unsigned char>(c));
    lua += "\\" + std::string(3 - code.size(), '0') + code;
  }
  return lua + "'";
}

inline const std::string hostile_rover = "R1" + hostile_markup;

// Writes hostile.kml and its script events/Loud.lua, and returns the plan's path. Two rovers drive
// and see each other and an asset; events log, print, warn, fail and break with such texts.
inline std::string write_hostile_plan(const TempFolder& folder) {
  folder.write("events/Loud.lua",
               "local lsos = require 'lsos'\nlocal text = " + in_lua(hostile_text) +
                   R"lua(
return lsos.event {
  api = 1,
  doc = text,
  params = {
    says = lsos.text { kml = 'Says', doc = text, example = text },
    way = lsos.choice { kml = 'Way', doc = text, choices = { 'warns', 'fails', 'breaks' }, required = true },
  },
  start = 'speak',
  phases = {
    speak = function(ev)
      ev:log(text, { [text] = text, said = ev.params.says })
      print(text)
      ev:warn('%s', text)
      ev.state.text = text
      if ev.params.way == 'fails' then return lsos.fail('%s', text) end
      if ev.params.way == 'breaks' then error(text) end
      return lsos.done
    end,
  },
}
)lua");
  const std::string rover = in_xml(hostile_rover), text = in_xml(hostile_text);
  std::vector<Mark> marks{mission(),
                          sev(rover, "0,0"),
                          sev("R2", "0,0.003"),
                          {"Asset",
                           {{"AssetId", "A" + in_xml(hostile_markup)}, {"AssetType", "Habitat"}},
                           point("0.0005,0.0005")}};
  marks[0].name = marks[1].name = marks[2].name = marks[3].name = text;
  const auto add = [&](const std::string& type, const std::string& of, int sequence, Fields fields,
                       const std::string& geometry = "") {
    marks.push_back(event(type, of, sequence, fields, geometry));
    marks.back().name = text + std::to_string(sequence);
  };
  add("Route", rover, 10, {}, line("0,0 0.0005,0"));
  add("Loud", rover, 20, {{"Says", text}, {"Way", "warns"}});
  add("Loud", rover, 30, {{"Says", text}, {"Way", "fails"}, {"OnFailure", "skip"}});
  add("Loud", rover, 40, {{"Says", text}, {"Way", "breaks"}});
  add("PathPlanRoute", "R2", 10, {{"WarnWhen", "speed_mps > 0.1"}}, line("0,0.003 0.0003,0.003"));
  std::string document = kml(marks);
  document.insert(document.find("<Placemark>"), "<name>" + text + "</name><Folder><name>" + text +
                                                    "</name><description>" + text +
                                                    "</description></Folder>");
  return folder.write("hostile.kml", document);
}

}  // namespace lsos::test
