#include "plan/layer_writer.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "base/error.h"
#include "terrain/gdal_call.h"

namespace lsos {

namespace {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

std::string xml_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '&'   ? "&amp;"
               : c == '<' ? "&lt;"
               : c == '>' ? "&gt;"
               : c == '"' ? "&quot;"
                          : std::string(1, c);
  }
  return escaped;
}

std::string sql_text(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

OGRwkbGeometryType geometry_type(GeometryKind kind) {
  switch (kind) {
    case GeometryKind::point:
      return wkbPoint;
    case GeometryKind::line:
      return wkbLineString;
    case GeometryKind::polygon:
      return wkbPolygon;
    case GeometryKind::none:
      break;
  }
  return wkbNone;
}

// Numbers with units stay texts; see the contract of a plan's Schemas.
bool add_column(OGRLayer& layer, const FieldDeclaration& field) {
  OGRFieldDefn column(field.name.c_str(), field.kind == FieldKind::integer   ? OFTInteger64
                                          : field.kind == FieldKind::boolean ? OFTInteger
                                                                             : OFTString);
  if (field.kind == FieldKind::boolean) column.SetSubType(OFSTBoolean);
  return layer.CreateField(&column) == OGRERR_NONE;
}

std::string widget_xml(const FormField& field) {
  const auto option = [](const std::string& value) {
    return fmt::format(
        R"(<Option type="Map"><Option type="QString" name="{0}" value="{0}"/></Option>)",
        xml_text(value));
  };
  std::string type = "TextEdit", config;
  if (field.declaration.kind == FieldKind::boolean) type = "CheckBox";
  if (field.declaration.kind == FieldKind::integer) type = "TextEdit";
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
                     field.declaration.name, type, config);
}

// Ten more than the highest of all layers that QGIS has open. It calls them "mission - Route" or
// "Route", by how the file was opened: so each is looked up by the name of the one that asks.
std::string next_sequence(const FormLayer& own, const std::vector<FormLayer>& layers) {
  std::string highest = "0";
  for (const FormLayer& layer : layers) {
    const auto has_sequence = [](const FormField& field) {
      return field.declaration.name == "Sequence";
    };
    if (std::ranges::none_of(layer.fields, has_sequence)) continue;
    highest +=
        fmt::format(R"(, coalesce(try(aggregate(regexp_replace(@layer_name, '{}$', '{}'), 'max', )"
                    R"("Sequence"), 0), 0))",
                    own.name, layer.name);
  }
  return fmt::format("max({}) + 10", highest);
}

// The expression of what a new feature has.
std::string initial_expression(const FormField& field, const FormLayer& own,
                               const std::vector<FormLayer>& layers) {
  if (field.declaration.name == "Sequence") return next_sequence(own, layers);
  if (field.initial.empty()) return "";
  const bool is_text =
      field.declaration.kind != FieldKind::integer && field.declaration.kind != FieldKind::boolean;
  return is_text ? sql_text(field.initial) : field.initial;
}

// "Speed (m/s): Driving speed": what a form calls a field, and what its numbers are in.
std::string alias_of(const FieldDeclaration& field) {
  constexpr std::size_t longest = 46;  // letters beside which a box has room
  const bool is_duration = field.kind == FieldKind::duration;
  std::string alias = field.name;
  if (is_duration || (field.unit != nullptr && field.unit->kind != "fraction")) {
    alias += fmt::format(" ({})", is_duration ? "s" : field.unit->symbol);
  }
  alias += ": " + field.doc.substr(0, field.doc.find_first_of(".;"));
  if (alias.size() <= longest) return alias;
  return alias.substr(0, alias.rfind(' ', longest)) + " ...";
}

// What is asked of every event stands on a second page, and fid on none.
std::string tabs_of(const FormLayer& layer) {
  std::string what = R"(<attributeEditorField name="name" index="1" showLabel="1"/>)", when;
  int index = 2;
  const bool is_event = std::ranges::any_of(
      layer.fields, [](const FormField& field) { return field.declaration.name == "Sequence"; });
  for (const FormField& field : layer.fields) {
    const auto& common = common_event_fields();
    const bool is_common = is_event && std::ranges::find(common, field.declaration.name,
                                                         &FieldDeclaration::name) != common.end();
    (is_common ? when : what) +=
        fmt::format(R"(<attributeEditorField name="{}" index="{}" showLabel="1"/>)",
                    field.declaration.name, index++);
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

std::string style_of(const FormLayer& layer, const std::vector<FormLayer>& layers) {
  std::string widgets, initials, constraints;
  std::string aliases = R"(<alias index="1" field="name" name="Name: its label in the plan"/>)";
  int index = 2;  // after fid and name
  for (const FormField& field : layer.fields) {
    const FieldDeclaration& declaration = field.declaration;
    widgets += widget_xml(field);
    aliases += fmt::format(R"(<alias index="{}" field="{}" name="{}"/>)", index++, declaration.name,
                           xml_text(alias_of(declaration)));
    initials += fmt::format(R"(<default field="{}" expression="{}" applyOnUpdate="0"/>)",
                            declaration.name, xml_text(initial_expression(field, layer, layers)));
    constraints += fmt::format(
        R"(<constraint field="{}" constraints="{}" notnull_strength="{}" exp_strength="0" )"
        R"(unique_strength="0"/>)",
        declaration.name, declaration.is_required ? 1 : 0, declaration.is_required ? 2 : 0);
  }
  return fmt::format(
      "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
      R"(<qgis version="3.22" styleCategories="Fields|Forms"><fieldConfiguration>{}</fieldConfiguration>)"
      "<aliases>{}</aliases><defaults>{}</defaults><constraints>{}</constraints>"
      "<editorlayout>tablayout</editorlayout>{}</qgis>\n",
      widgets, aliases, initials, constraints, tabs_of(layer));
}

void run_sql(GDALDataset& dataset, const std::string& statement) {
  OGRLayer* answer = dataset.ExecuteSQL(statement.c_str(), nullptr, nullptr);
  if (answer != nullptr) dataset.ReleaseResultSet(answer);
}

void add_style(GDALDataset& dataset, const FormLayer& layer, const std::vector<FormLayer>& layers) {
  run_sql(dataset,
          "CREATE TABLE IF NOT EXISTS layer_styles (id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, "
          "f_table_catalog TEXT(256), f_table_schema TEXT(256), f_table_name TEXT(256), "
          "f_geometry_column TEXT(256), styleName TEXT(30), styleQML TEXT, styleSLD TEXT, "
          "useAsDefault BOOLEAN, description TEXT(256), owner TEXT(30), ui TEXT(30), "
          "update_time DATETIME)");
  run_sql(dataset,
          "INSERT OR IGNORE INTO gpkg_contents (table_name, data_type, identifier) "
          "VALUES ('layer_styles', 'attributes', 'layer_styles')");
  const bool is_spatial = layer.geometry != GeometryKind::none;
  run_sql(dataset,
          fmt::format("INSERT INTO layer_styles (f_table_catalog, f_table_schema, "
                      "f_table_name, f_geometry_column, styleName, styleQML, "
                      "useAsDefault) VALUES ('', '', {}, {}, {}, {}, 1)",
                      sql_text(layer.name), is_spatial ? "'geom'" : "''",
                      sql_text("form of " + layer.name), sql_text(style_of(layer, layers))));
}

bool add_layer(GDALDataset& dataset, OGRSpatialReference& crs, const FormLayer& form) {
  CPLStringList options;
  options.SetNameValue("FID", "fid");
  options.SetNameValue("GEOMETRY_NAME", "geom");
  options.SetNameValue("DESCRIPTION", form.doc.c_str());
  const bool is_spatial = form.geometry != GeometryKind::none;
  OGRLayer* layer = dataset.CreateLayer(form.name.c_str(), is_spatial ? &crs : nullptr,
                                        geometry_type(form.geometry), options.List());
  if (layer == nullptr) return false;
  OGRFieldDefn name("name", OFTString);
  if (layer->CreateField(&name) != OGRERR_NONE) return false;
  for (const FormField& field : form.fields) {
    if (!add_column(*layer, field.declaration)) return false;
  }
  if (form.has_first_row) {
    const std::unique_ptr<OGRFeature> feature(OGRFeature::CreateFeature(layer->GetLayerDefn()));
    feature->SetField("name", form.name.c_str());
    for (const FormField& field : form.fields) {
      if (!field.initial.empty()) {
        feature->SetField(field.declaration.name.c_str(), field.initial.c_str());
      }
    }
    if (layer->CreateFeature(feature.get()) != OGRERR_NONE) return false;
  }
  return true;
}

}  // namespace

void write_form_layers(const std::string& file, const Body& body,
                       const std::vector<FormLayer>& layers) {
  const GdalSilence silence;
  const auto refuse = [&](const std::string& why) { throw InputError({file, 0}, why); };
  if (std::filesystem::exists(file)) refuse("is there already; it is not replaced");
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (driver == nullptr || crs.SetFromUserInput(std::string(body.crs).c_str()) != OGRERR_NONE) {
    refuse("cannot be made: GDAL has no GeoPackages, or PROJ does not know " +
           std::string(body.crs));
  }
  const Dataset dataset(driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (dataset == nullptr) refuse("cannot be made: " + GdalSilence::message());
  for (const FormLayer& layer : layers) {
    if (!add_layer(*dataset, crs, layer)) refuse("cannot be written: " + GdalSilence::message());
  }
  dataset->FlushCache(false);
  for (const FormLayer& layer : layers) add_style(*dataset, layer, layers);
  // The name under which GIS tools look it up: PROJ's, with the year.
  run_sql(*dataset,
          "UPDATE gpkg_spatial_ref_sys SET definition = replace(definition, "
          "'AUTHORITY[\"IAU\"', 'AUTHORITY[\"IAU_2015\"')");
}

}  // namespace lsos
