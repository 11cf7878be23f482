#include "plan/layer_writer.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <memory>

#include "access/gdal_access.h"
#include "access/memory_file.h"
#include "base/error.h"
#include "base/files.h"
#include "base/qgis_style_table.h"
#include "terrain/raster/gdal_call.h"

namespace lsos {

namespace {

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

// Numbers with units are stored as texts, as a plan's Schemas require.
bool add_column(OGRLayer& layer, const FieldDeclaration& field) {
  OGRFieldDefn column(field.name.c_str(), field.kind == FieldKind::integer   ? OFTInteger64
                                          : field.kind == FieldKind::boolean ? OFTInteger
                                                                             : OFTString);
  if (field.kind == FieldKind::boolean) column.SetSubType(OFSTBoolean);
  return layer.CreateField(&column) == OGRERR_NONE;
}

void run_sql(GDALDataset& dataset, const std::string& statement) {
  OGRLayer* answer = dataset.ExecuteSQL(statement.c_str(), nullptr, nullptr);
  if (answer != nullptr) dataset.ReleaseResultSet(answer);
}

void add_style(GDALDataset& dataset, const FormLayer& layer) {
  const bool is_spatial = layer.geometry != GeometryKind::none;
  for (const std::string& statement : qgis_style_sql(
           {layer.name, is_spatial ? "geom" : "", "form of " + layer.name, layer.style})) {
    run_sql(dataset, statement);
  }
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
  register_drivers();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (driver == nullptr || crs.SetFromUserInput(std::string(body.crs).c_str()) != OGRERR_NONE) {
    refuse("cannot be made: GDAL has no GeoPackages, or PROJ does not know " +
           std::string(body.crs));
  }
  const MemoryFile made("plan.gpkg");
  Dataset dataset(driver->Create(made.name().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (dataset == nullptr) refuse("cannot be made: " + GdalSilence::message());
  for (const FormLayer& layer : layers) {
    if (!add_layer(*dataset, crs, layer)) refuse("cannot be written: " + GdalSilence::message());
  }
  dataset->FlushCache(false);
  for (const FormLayer& layer : layers) add_style(*dataset, layer);
  // GIS tools look the CRS up under PROJ's name of the authority, which has the year.
  run_sql(*dataset,
          "UPDATE gpkg_spatial_ref_sys SET definition = replace(definition, "
          "'AUTHORITY[\"IAU\"', 'AUTHORITY[\"IAU_2015\"')");
  dataset.reset();
  if (made.bytes().empty()) refuse("cannot be made: " + GdalSilence::message());
  write_new_file(file, made.bytes());
}

}  // namespace lsos
