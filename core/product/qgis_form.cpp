#include "product/qgis_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "base/qgis_style_table.h"
#include "picture/rover_colors.h"
#include "product/qgis_style.h"
#include "product/qgis_symbol.h"

namespace lsos {

namespace {

// Expression for the layer of that name. QGIS calls layers "mission - Route" or "Route", depending
// on how the file was opened, so the name is derived from that of the own layer.
std::string layer_expression(const FormLayer& own, std::string_view name) {
  return fmt::format("regexp_replace(@layer_name, {}, {})", sql_text(own.name + "$"),
                     sql_text(std::string(name)));
}

bool has_field(const FormLayer& layer, std::string_view name) {
  return std::ranges::any_of(
      layer.fields, [&](const FormField& field) { return field.declaration.name == name; });
}

std::string widget_xml(const FormField& field) {
  const auto option = [](const std::string& value) {
    return fmt::format(
        R"(<Option type="Map"><Option type="QString" name="{0}" value="{0}"/></Option>)",
        xml_escaped(value));
  };
  std::string type = "TextEdit", config;
  if (field.declaration.kind == FieldKind::boolean) type = "CheckBox";
  if (!field.choices.empty()) {
    type = "ValueMap";
    std::string options;
    if (!field.declaration.is_required) {
      options += R"(<Option type="Map"><Option type="QString" name="" )"
                 R"(value="{2839923C-8B7D-419E-B84B-CA2FE9B80EC7}"/></Option>)";
    }
    for (const std::string& choice : field.choices) options += option(choice);
    config = fmt::format(R"(<Option type="List" name="map">{}</Option>)", options);
  }
  return fmt::format(R"(<field name="{}"><editWidget type="{}"><config><Option type="Map">{})"
                     R"(</Option></config></editWidget></field>)",
                     xml_escaped(field.declaration.name), type, config);
}

// Ten more than the highest Sequence of all layers that QGIS has open.
std::string next_sequence(const FormLayer& own, const std::vector<FormLayer>& layers) {
  std::string highest = "0";
  for (const FormLayer& layer : layers) {
    if (!has_field(layer, "Sequence")) continue;
    highest += fmt::format(R"(, coalesce(try(aggregate({}, 'max', "Sequence"), 0), 0))",
                           layer_expression(own, layer.name));
  }
  return fmt::format("max({}) + 10", highest);
}

// The expression for the initial value of a new feature.
std::string initial_expression(const FormField& field, const FormLayer& own,
                               const std::vector<FormLayer>& layers) {
  if (field.declaration.name == "Sequence") return next_sequence(own, layers);
  if (field.initial.empty()) return "";
  const bool is_text =
      field.declaration.kind != FieldKind::integer && field.declaration.kind != FieldKind::boolean;
  return is_text ? sql_text(field.initial) : field.initial;  // QGIS quotes as SQL does
}

// The label of a field in a form: name and unit, and below them the meaning in lines that fit the
// form. A table of features shows the first line only.
std::string alias_of(const std::string& name, const std::string& doc, const Unit* unit) {
  constexpr std::size_t widest = 46;  // letters that leave room for the input box
  std::string alias = name, line;
  if (unit != nullptr && unit->kind != "fraction") alias += fmt::format(" ({})", unit->symbol);
  std::istringstream words(doc);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > widest) {
      alias += "\n" + std::exchange(line, "");
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return alias + "\n" + line;
}

// The pages of a form: fields common to all events are on a second page, and fid is on none.
std::string tabs_of(const FormLayer& layer) {
  std::string what = R"(<attributeEditorField name="name" index="1" showLabel="1"/>)", when;
  int index = 2;
  const bool is_event = has_field(layer, "Sequence");
  for (const FormField& field : layer.fields) {
    const auto& common = common_event_fields();
    const bool is_common = is_event && std::ranges::find(common, field.declaration.name,
                                                         &FieldDeclaration::name) != common.end();
    (is_common ? when : what) +=
        fmt::format(R"(<attributeEditorField name="{}" index="{}" showLabel="1"/>)",
                    xml_escaped(field.declaration.name), index++);
  }
  const auto page = [](const char* title, const std::string& fields) {
    if (fields.empty()) return std::string();
    return fmt::format(R"(<attributeEditorContainer name="{}" columnCount="1" groupBox="0" )"
                       R"(showLabel="1" visibilityExpressionEnabled="0" )"
                       R"(visibilityExpression="">{}</attributeEditorContainer>)",
                       title, fields);
  };
  return fmt::format("<attributeEditorForm>{}{}</attributeEditorForm>", page("What", what),
                     page("When, and if it fails", when));
}

// The table's columns, wide enough for the lines of a title.
std::string table_of(const FormLayer& layer) {
  constexpr int width_px = 290;
  const auto column = [&](const std::string& name, int is_hidden) {
    return fmt::format(R"(<column type="field" name="{}" width="{}" hidden="{}"/>)",
                       xml_escaped(name), width_px, is_hidden);
  };
  std::string columns = column("fid", 1) + column("name", 0);
  for (const FormField& field : layer.fields) columns += column(field.declaration.name, 0);
  return fmt::format("<attributetableconfig><columns>{}</columns></attributetableconfig>", columns);
}

// Expression for the colour that the feature's rover has on all maps: by the order of the ids drawn
// so far. QGIS sorts them as words, so ids that mix upper and lower case may be ordered otherwise.
std::string rover_color(const FormLayer& layer) {
  std::string colors;
  for (std::size_t k = 0; k < rover_colors.size(); ++k) {
    colors += (k == 0 ? "'" : ", '") + rover_qgis_color(k, 255) + "'";
  }
  constexpr std::string_view of_none = "'110,110,110,255'";
  return fmt::format(
      R"(with_variable('at', array_find(array_sort(string_to_array(try(aggregate({}, )"
      R"('concatenate_unique', "RoverId", concatenator:=','), ''))), "RoverId"), )"
      R"(if(coalesce(@at, -1) < 0, {}, array_get(array({}), @at % {}))))",
      layer_expression(layer, "Rover"), of_none, colors, rover_colors.size());
}

std::string point_symbol(const FormLayer& layer) {
  // An arrow where the plan gives a heading, parsed from its number and unit.
  if (layer.name == "Rover") {
    const std::string number = R"(to_real(regexp_substr("Heading", '(-?[0-9.]+)')))";
    return qgis_symbol(
        "marker", "0",
        {{"SimpleMarker",
          {{"size", "6"}, {"outline_color", "255,255,255,255"}, {"outline_width", "0.4"}},
          {{"fillColor", rover_color(layer)},
           {"name", R"(if(coalesce("Heading", '') = '', 'circle', 'arrow'))"},
           {"angle", fmt::format(R"(coalesce(if("Heading" like '%rad', degrees({0}), {0}), 0))",
                                 number)}}}});
  }
  QgisSymbolLayer marker{"SimpleMarker",
                         {{"name", "circle"},
                          {"size", "3.2"},
                          {"color", "90,90,90,255"},
                          {"outline_color", "255,255,255,255"},
                          {"outline_width", "0.4"}}};
  if (layer.name == "Asset") marker.options[0].second = "square";
  if (has_field(layer, "RoverId")) marker.properties = {{"fillColor", rover_color(layer)}};
  return qgis_symbol("marker", "0", {marker});
}

// A line with an arrow at its end.
std::string line_symbol(const FormLayer& layer) {
  const std::string color = rover_color(layer);
  const std::string arrow =
      qgis_symbol("marker", "@0@1",
                  {{"SimpleMarker",
                    {{"name", "filled_arrowhead"}, {"size", "4"}, {"outline_style", "no"}},
                    {{"fillColor", color}}}});
  return qgis_symbol("line", "0",
                     {{"SimpleLine",
                       {{"line_width", "0.8"}, {"line_width_unit", "MM"}},
                       {{"outlineColor", color}}},
                      {"MarkerLine", {{"placement", "lastvertex"}, {"rotate", "1"}}, {}, arrow}});
}

std::string area_symbol(const FormLayer& layer) {
  return qgis_symbol("fill", "0",
                     {{"SimpleFill",
                       {{"style", "no"}, {"outline_width", "0.8"}, {"outline_width_unit", "MM"}},
                       {{"outlineColor", rover_color(layer)}}}});
}

// Expression for a feature's label on the map: "SEV1", "20 To the ridge".
std::string label_of(const FormLayer& layer) {
  if (layer.name == "Asset") return R"("AssetId")";
  if (!has_field(layer, "Sequence")) return R"("RoverId")";
  return fmt::format(R"(concat("Sequence", ' ', coalesce(nullif("name", ''), {})))",
                     sql_text(layer.name));
}

// <renderer-v2> and <labeling>; "" where there is nothing to draw.
std::string drawing_of(const FormLayer& layer) {
  const auto drawn = [&](const std::string& symbol, QgisPlacement placement) {
    return qgis_single_symbol(symbol) + qgis_labeling(label_of(layer), placement);
  };
  switch (layer.geometry) {
    case GeometryKind::point:
      return drawn(point_symbol(layer), QgisPlacement::about_points);
    case GeometryKind::line:
      return drawn(line_symbol(layer), QgisPlacement::along_lines);
    case GeometryKind::polygon:
      return drawn(area_symbol(layer), QgisPlacement::inside);
    case GeometryKind::none:
      break;
  }
  return "";
}

std::string style_of(const FormLayer& layer, const std::vector<FormLayer>& layers) {
  std::string widgets, initials, constraints;
  std::string aliases =
      fmt::format(R"(<alias index="1" field="name" name="{}"/>)",
                  xml_escaped(alias_of("Name", "its label in the plan", nullptr)));
  int index = 2;  // after fid and name
  for (const FormField& field : layer.fields) {
    const FieldDeclaration& declaration = field.declaration;
    const std::string name = xml_escaped(declaration.name);
    widgets += widget_xml(field);
    // Durations without a unit are seconds, whatever unit they are shown in.
    const Unit* unit = declaration.kind == FieldKind::duration ? find_unit("s") : declaration.unit;
    aliases += fmt::format(R"(<alias index="{}" field="{}" name="{}"/>)", index++, name,
                           xml_escaped(alias_of(declaration.name, declaration.doc, unit)));
    initials += fmt::format(R"(<default field="{}" expression="{}" applyOnUpdate="0"/>)", name,
                            xml_escaped(initial_expression(field, layer, layers)));
    constraints += fmt::format(
        R"(<constraint field="{}" constraints="{}" notnull_strength="{}" exp_strength="0" )"
        R"(unique_strength="0"/>)",
        name, declaration.is_required ? 1 : 0, declaration.is_required ? 2 : 0);
  }
  return fmt::format(
      "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
      R"(<qgis version="3.22" styleCategories="Fields|Forms|AttributeTable|Symbology|Labeling" labelsEnabled="1">)"
      "{}<fieldConfiguration>{}</fieldConfiguration>"
      "<aliases>{}</aliases><defaults>{}</defaults><constraints>{}</constraints>"
      "<editorlayout>tablayout</editorlayout>{}{}</qgis>\n",
      drawing_of(layer), widgets, aliases, initials, constraints, tabs_of(layer), table_of(layer));
}

}  // namespace

void add_qgis_forms(std::vector<FormLayer>& layers) {
  for (FormLayer& layer : layers) layer.style = style_of(layer, layers);
}

}  // namespace lsos
