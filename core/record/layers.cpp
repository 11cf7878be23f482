#include "record/layers.h"

#include "base/error.h"

namespace lsos {

namespace {

template <class Row>
LayerSpec filled(LayerGeometry geometry) {
  LayerSpec layer{layer_name<Row>, geometry, {}};
  for (const Column<Row>& column : columns<Row>()) {
    layer.columns.push_back({column.name, column.type, column.limits});
  }
  return layer;
}

std::vector<LayerSpec> make_layers() {
  return {
      filled<SampleRow>(LayerGeometry::point),       filled<EventRow>(LayerGeometry::point),
      filled<PhaseRow>(LayerGeometry::none),         filled<PairRow>(LayerGeometry::none),
      filled<SightIntervalRow>(LayerGeometry::none), filled<PanelRow>(LayerGeometry::none),
      filled<JointRow>(LayerGeometry::none),         filled<ResourceRow>(LayerGeometry::none),
      filled<PlannedPathRow>(LayerGeometry::line),   filled<NoteRow>(LayerGeometry::point),
      filled<RunRow>(LayerGeometry::none),
  };
}

}  // namespace

const std::vector<LayerSpec>& contract_layers() {
  static const std::vector<LayerSpec> layers = make_layers();
  return layers;
}

const LayerSpec& order_layer() {
  static const LayerSpec layer = filled<OrderRow>(LayerGeometry::none);
  return layer;
}

const LayerSpec& layer_spec(std::string_view name) {
  for (const LayerSpec& layer : contract_layers()) {
    if (layer.name == name) return layer;
  }
  LSOS_ASSERT(order_layer().name == name);
  return order_layer();
}

}  // namespace lsos
