// Writing of the log's rows, layer by layer. Only for use in this folder.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "record/columns.h"
#include "record/gpkg.h"
#include "record/stored_value.h"

namespace lsos::gpkg {

struct LostNumbers {
  std::size_t count = 0;
  std::string first;  // "layer 'samples': load_j = inf"
};

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

  // Numbers that were left out, NULL in their place, as their columns cannot hold them.
  const LostNumbers& lost() const { return lost_; }

  // Writes the layer's extent into the file's table of contents; map viewers zoom to it.
  bool sync() { return layer_->SyncToDisk() == OGRERR_NONE; }

 private:
  void fill(const Row& row, Instant start, std::int64_t fid) {
    feature_->SetFID(fid);
    int field = 0;
    for (const Column<Row>& column : columns<Row>()) {
      ColumnValue value = column.value(row, start);
      if (!hold_to(column.limits, value)) note_lost(column, column.value(row, start));
      set_value(*feature_, field++, value);
    }
    if constexpr (requires { row.line; }) {
      set_line(*feature_, row.line);
    } else if (layer_->GetGeomType() != wkbNone) {
      set_point(*feature_, place_of(row));
    }
  }

  // A column that cannot be NULL makes the writing fail.
  void note_lost(const Column<Row>& column, const ColumnValue& value) {
    const std::string number =
        fmt::format("layer '{}': {} = {}", layer_name<Row>, column.name, to_text(value));
    if (column.limits.is_required) {
      CPLError(CE_Failure, CPLE_AppDefined, "%s: a number from %g to %g is allowed", number.c_str(),
               column.limits.least, column.limits.greatest);
    }
    if (lost_.count++ == 0) lost_.first = number;
  }

  OGRLayer* layer_ = nullptr;
  Feature feature_;
  std::int64_t last_fid_ = 0;
  LostNumbers lost_;
};

}  // namespace lsos::gpkg
