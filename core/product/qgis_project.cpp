#include "product/qgis_project.h"

#include <fmt/format.h>

#include "plan/kml_writer.h"
#include "product/qgis_style.h"
#include "product/qgis_symbol.h"

namespace lsos {

namespace {

std::string crs_xml(const std::string& wkt, std::string_view authority = "") {
  return fmt::format("<spatialrefsys><wkt>{}</wkt><authid>{}</authid></spatialrefsys>",
                     xml_escaped(wkt), authority);
}

// QGIS replaces layer ids of ten letters or fewer.
std::string id_of(std::string_view layer) { return fmt::format("lsos_{}_layer", layer); }

std::string source_of(std::string_view layer) {
  return fmt::format("./log.gpkg|layername={}", layer);
}

std::string drawn_id(std::size_t rover) { return fmt::format("lsos_drawn_{}_layer", rover); }
std::string drawn_title(const std::string& rover) { return rover + " drawn"; }
std::string drawn_source(const std::string& rover) {
  return fmt::format("./overlay.kml|layername={} plan", rover);
}

std::string log_layer(const QgisLayer& layer, const QgisMap& map) {
  return fmt::format(
      R"(<maplayer type="vector" geometry="{}" labelsEnabled="{}"><id>{}</id><datasource>{}</datasource>)"
      R"(<layername>{}</layername><provider encoding="UTF-8">ogr</provider><srs>{}</srs>{}{}{})"
      "</maplayer>",
      layer.geometry, layer.labeling.empty() ? 0 : 1, id_of(layer.layer), source_of(layer.layer),
      layer.title, crs_xml(map.log_crs_wkt, map.body->crs), layer.temporal, layer.renderer,
      layer.labeling);
}

std::string hillshade(const QgisMap& map) {
  return fmt::format(
      R"(<maplayer type="raster"><id>{}</id><datasource>./hillshade.tif</datasource>)"
      "<layername>Hillshade</layername><provider>gdal</provider><srs>{}</srs><pipe>"
      R"(<rasterrenderer type="singlebandgray" grayBand="1" opacity="1" alphaBand="-1">)"
      "<contrastEnhancement><minValue>0</minValue><maxValue>255</maxValue>"
      "<algorithm>StretchToMinimumMaximum</algorithm></contrastEnhancement></rasterrenderer>"
      "</pipe></maplayer>",
      id_of("hillshade"), crs_xml(map.map_crs_wkt));
}

// Lines as drawn in the plan: one layer of the overlay per rover.
std::string drawn_layer(std::size_t rover, const QgisMap& map) {
  const QgisSymbolLayer line{"SimpleLine",
                             {{"line_color", rover_qgis_color(rover, 110)},
                              {"line_width", "1.6"},
                              {"line_width_unit", "MM"}}};
  return fmt::format(
      R"(<maplayer type="vector" geometry="Line"><id>{}</id><datasource>{}</datasource>)"
      R"(<layername>{}</layername><provider encoding="UTF-8">ogr</provider><srs>{}</srs>)"
      "{}</maplayer>",
      drawn_id(rover), xml_escaped(drawn_source(map.rovers[rover])),
      xml_escaped(drawn_title(map.rovers[rover])), crs_xml(map.log_crs_wkt, map.body->crs),
      qgis_single_symbol(qgis_symbol("line", "0", {line})));
}

// A round time step of which a run of up to 300 days has at most 300.
double time_step_s(double span_s) {
  constexpr double steps_s[] = {1, 2, 5, 10, 30, 60, 120, 300, 600, 1800, 3600, 7200, 21600};
  constexpr double frames = 300;
  for (const double step_s : steps_s) {
    if (span_s <= frames * step_s) return step_s;
  }
  return 86400;
}

std::string time_settings(const QgisMap& map) {
  return fmt::format(
      R"(<ProjectTimeSettings timeStep="{:g}" cumulativeTemporalRange="0" frameRate="10" )"
      R"(timeStepUnit="s"><TemporalRange><start>{}</start><end>{}</end></TemporalRange>)"
      "</ProjectTimeSettings>",
      time_step_s(seconds(map.end - map.start)), format_utc(map.start), format_utc(map.end));
}

std::string tree_node(const std::string& id, std::string_view title, const std::string& source,
                      std::string_view provider, bool is_on) {
  return fmt::format(
      R"(<layer-tree-layer id="{}" name="{}" source="{}" providerKey="{}" checked="{}" )"
      R"(expanded="0"/>)",
      id, title, source, provider, is_on ? "Qt::Checked" : "Qt::Unchecked");
}

}  // namespace

std::string qgis_project(const QgisMap& map) {
  std::string tree, layers;
  for (const QgisLayer& layer : qgis_layers(map.rovers)) {
    tree += tree_node(id_of(layer.layer), layer.title, source_of(layer.layer), "ogr", layer.is_on);
    layers += log_layer(layer, map);
  }
  for (std::size_t k = 0; k < map.rovers.size(); ++k) {
    if (!map.has_drawn.contains(map.rovers[k])) continue;
    tree += tree_node(drawn_id(k), xml_escaped(drawn_title(map.rovers[k])),
                      xml_escaped(drawn_source(map.rovers[k])), "ogr", true);
    layers += drawn_layer(k, map);
  }
  if (map.has_hillshade) {
    tree += tree_node(id_of("hillshade"), "Hillshade", "./hillshade.tif", "gdal", true);
    layers += hillshade(map);
  }
  const std::string crs = crs_xml(map.map_crs_wkt);
  const std::string project = fmt::format(
      "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
      R"(<qgis projectname="{0}" version="3.22.0"><homePath path=""/><title>{0}</title>)"
      "<projectCrs>{1}</projectCrs><layer-tree-group>{2}</layer-tree-group>"
      R"(<mapcanvas name="theMapCanvas" annotationsVisible="1"><units>meters</units><extent>)"
      "<xmin>{4:.1f}</xmin><ymin>{5:.1f}</ymin><xmax>{6:.1f}</xmax><ymax>{7:.1f}</ymax></extent>"
      "<rotation>0</rotation><destinationsrs>{1}</destinationsrs></mapcanvas>"
      "<projectlayers>{3}</projectlayers><properties>"
      R"(<SpatialRefSys><ProjectionsEnabled type="int">1</ProjectionsEnabled></SpatialRefSys>)"
      R"(<Paths><Absolute type="bool">false</Absolute></Paths></properties>)"
      R"(<ProjectViewSettings UseProjectScales="0"><Scales/><DefaultViewExtent xmin="{4:.1f}" )"
      R"(ymin="{5:.1f}" xmax="{6:.1f}" ymax="{7:.1f}">{1}</DefaultViewExtent></ProjectViewSettings>)"
      "{8}</qgis>\n",
      xml_escaped(map.title), crs, tree, layers, map.west_m, map.south_m, map.east_m, map.north_m,
      time_settings(map));
  return pack_zip({{"mission.qgs", project}});
}

}  // namespace lsos
