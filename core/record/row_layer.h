// Writing of the log's rows, layer by layer. Only for use in this folder.
#pragma once

#include <cstdint>

#include "record/columns.h"
#include "record/gpkg.h"

namespace lsos::gpkg {

// Writes the rows of one layer, fids counted from 1.
template <class Row>
class RowLayer {
 public:
  void open(OGRLayer& layer) {
    layer_ = &layer;
    feature_ = Feature(OGRFeature::CreateFeature(layer.GetLayerDefn()));
  }

  bool append(const Row& row, Instant start) {
    fill(row, start, ++last_fid_);
    return layer_->CreateFeature(feature_.get()) == OGRERR_NONE;
  }

  bool update(std::int64_t fid, const Row& row, Instant start) {
    fill(row, start, fid);
    return layer_->SetFeature(feature_.get()) == OGRERR_NONE;
  }

  std::int64_t last_fid() const { return last_fid_; }
  void set_last_fid(std::int64_t fid) { last_fid_ = fid; }

  // Writes the layer's extent into the file's table of contents; map viewers zoom to it.
  bool sync() { return layer_->SyncToDisk() == OGRERR_NONE; }

 private:
  void fill(const Row& row, Instant start, std::int64_t fid) {
    feature_->SetFID(fid);
    int field = 0;
    for (const Column<Row>& column : columns<Row>()) {
      set_value(*feature_, field++, column.value(row, start));
    }
    if constexpr (requires { row.line; }) {
      set_line(*feature_, row.line);
    } else if (layer_->GetGeomType() != wkbNone) {
      set_point(*feature_, place_of(row));
    }
  }

  OGRLayer* layer_ = nullptr;
  Feature feature_;
  std::int64_t last_fid_ = 0;
};

}  // namespace lsos::gpkg
