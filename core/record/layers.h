// The layers of a log: all those of the contract, in the order of the digest.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record/columns.h"

namespace lsos {

enum class LayerGeometry { none, point, line };

struct ColumnSpec {
  std::string_view name;
  ColumnType type = ColumnType::real;
  ColumnLimits limits{};
};

struct LayerSpec {
  std::string_view name;
  LayerGeometry geometry = LayerGeometry::none;
  std::vector<ColumnSpec> columns;
};

const std::vector<LayerSpec>& contract_layers();
// Layer `standing_orders`, which the file has besides.
const LayerSpec& order_layer();
// One of them.
const LayerSpec& layer_spec(std::string_view name);

// How QGIS draws a layer.
struct LayerStyle {
  std::string layer, name;
  std::string qml;  // as QGIS writes it
};

// The layer that rows of this type go to.
template <class Row>
constexpr std::string_view layer_name = "";
template <>
inline constexpr std::string_view layer_name<SampleRow> = "samples";
template <>
inline constexpr std::string_view layer_name<EventRow> = "events";
template <>
inline constexpr std::string_view layer_name<PhaseRow> = "phases";
template <>
inline constexpr std::string_view layer_name<JointRow> = "joints";
template <>
inline constexpr std::string_view layer_name<PairRow> = "pairs";
template <>
inline constexpr std::string_view layer_name<SightIntervalRow> = "sight_intervals";
template <>
inline constexpr std::string_view layer_name<PanelRow> = "panels";
template <>
inline constexpr std::string_view layer_name<ResourceRow> = "resources";
template <>
inline constexpr std::string_view layer_name<PlannedPathRow> = "planned_paths";
template <>
inline constexpr std::string_view layer_name<NoteRow> = "notes";
template <>
inline constexpr std::string_view layer_name<RunRow> = "run";
template <>
inline constexpr std::string_view layer_name<OrderRow> = "standing_orders";

// The place of a row's point; absent if the row has none.
template <class Row>
std::optional<Geodetic> place_of(const Row& row) {
  if constexpr (requires { row.place; }) return row.place;
  return std::nullopt;
}

}  // namespace lsos
