#include "product/qgis_symbol.h"

#include <fmt/format.h>

#include "base/visible_text.h"

namespace lsos {

namespace {

std::string options_xml(const QgisOptions& options) {
  std::string xml = "<Option type=\"Map\">";
  for (const auto& [name, value] : options) {
    xml +=
        fmt::format(R"(<Option type="QString" name="{}" value="{}"/>)", name, xml_escaped(value));
  }
  return xml + "</Option>";
}

std::string properties_xml(const QgisOptions& properties) {
  constexpr int is_expression = 3;
  if (properties.empty()) return "";
  std::string all;
  for (const auto& [name, expression] : properties) {
    all += fmt::format(
        R"(<Option type="Map" name="{}"><Option type="bool" name="active" value="true"/>)"
        R"(<Option type="QString" name="expression" value="{}"/>)"
        R"(<Option type="int" name="type" value="{}"/></Option>)",
        name, xml_escaped(expression), is_expression);
  }
  return fmt::format(
      R"(<data_defined_properties><Option type="Map"><Option type="QString" name="name" value=""/>)"
      R"(<Option type="Map" name="properties">{}</Option>)"
      R"(<Option type="QString" name="type" value="collection"/></Option></data_defined_properties>)",
      all);
}

std::string placement_xml(QgisPlacement placement) {
  constexpr int of_lines = 2, ordered_about_points = 6, horizontal = 4;
  switch (placement) {
    case QgisPlacement::along_lines:
      return fmt::format(R"(<placement placement="{}" dist="0.8" distUnits="MM" )"
                         R"(placementFlags="10"/>)",
                         of_lines);
    case QgisPlacement::inside:
      return fmt::format(R"(<placement placement="{}"/>)", horizontal);
    case QgisPlacement::about_points:
      break;
  }
  return fmt::format(R"(<placement placement="{}" dist="3" distUnits="MM" maxCharAngleIn="25" )"
                     R"(predefinedPositionOrder="TR,TL,BR,BL,R,L,TSR,BSR"/>)",
                     ordered_about_points);
}

}  // namespace

std::string qgis_symbol(std::string_view type, std::string_view name,
                        const std::vector<QgisSymbolLayer>& layers) {
  std::string drawn;
  for (const QgisSymbolLayer& layer : layers) {
    drawn += fmt::format(R"(<layer class="{}" enabled="1" locked="0" pass="0">{}{}{}</layer>)",
                         layer.kind, options_xml(layer.options), properties_xml(layer.properties),
                         layer.marker);
  }
  return fmt::format(
      R"(<symbol type="{}" name="{}" alpha="1" clip_to_extent="1" force_rhr="0">{}</symbol>)", type,
      name, drawn);
}

std::string qgis_single_symbol(const std::string& symbol) {
  return fmt::format(
      R"(<renderer-v2 type="singleSymbol" symbollevels="0" enableorderby="0" forceraster="0">)"
      "<symbols>{}</symbols></renderer-v2>",
      symbol);
}

std::string qgis_labeling(const std::string& expression, QgisPlacement placement) {
  return fmt::format(
      R"(<labeling type="simple"><settings calloutType="simple"><text-style fieldName="{}" )"
      R"(fontSize="9" fontSizeUnit="Point" textColor="20,20,20,255" isExpression="1">)"
      R"(<text-buffer bufferDraw="1" bufferSize="1.2" bufferSizeUnits="MM" bufferOpacity="1" )"
      R"(bufferColor="255,255,255,255"/></text-style>{})"
      R"(<rendering obstacle="0" displayAll="0" scaleVisibility="0" mergeLines="0"/></settings>)"
      "</labeling>",
      xml_escaped(expression), placement_xml(placement));
}

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : xml_text(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace lsos
